# The manufactured square.
square() { name=$1; shift; run square-$name mms_square --points gauss --cells 8,16,32,64 --records 10 "$@"; }
for shape in hat cubic bernstein; do
    ppc=2; [ $shape = bernstein ] && ppc=3
    square $shape-1e-4 --shape $shape --ppc $ppc --G 1e-4 --cfl 0.2325
    square $shape-0.05 --shape $shape --ppc $ppc --G 0.05 --cfl 0.2765
    square printed-$shape --shape $shape --ppc $ppc --G 0.05 --cfl 0.2765 --force nodes --alpha 0.99
done
