# The manufactured segment; a run that becomes unstable (exit code 3) is a row too.
segment() {
    variant=$1; cells=$2; shift 2
    for G in 1e-4 0.05; do run "segment-$variant-$G" mms_segment --G $G --cells $cells --ppc 2 --records 10 --watch warn "$@" || [ $? -eq 3 ]; done
}
for shape in hat cubic bernstein; do segment tlmpm-$shape 4,8,16,32,64,128,256 --scheme tlmpm --shape $shape; done
for scheme in musl usf; do segment $scheme-hat 4,8,16,32,64,128,256 --scheme $scheme; done
for shape in ugimp cubic; do segment usl-$shape 4,8,16,32,64,128,256 --scheme usl --shape $shape; done
for scheme in usl musl; do segment $scheme-cpgimp 4,8,16,32,64,128,256,512 --scheme $scheme --shape cpgimp; done
segment fem 4,8,16,32,64,128,256,512 --scheme fem
# Full order of the basis: consistent mass, steps so small that the leapfrog's error does not show.
for shape in hat bernstein cubic; do
    ppc=2; [ $shape = bernstein ] && ppc=3
    run order-$shape mms_segment --scheme tlmpm --shape $shape --transfer consistent --points gauss --ppc $ppc --cfl 0.0116 --cells 4,8,16,32
done
run order-lumped mms_segment --scheme tlmpm --shape cubic --points gauss --ppc 2 --cfl 0.0116 --cells 4,8,16,32
run order-fem mms_segment --scheme fem --ppc 2 --cfl 0.0116 --cells 4,8,16,32
