# The generalized vortex as printed and better, and one setting after the other.
vortex() { name=$1; shift; run vortex-$name vortex --points gauss --cfl 0.93 --records 10 "$@"; }
printed='--force nodes --cut whole --start whole --alpha 0.99'
vortex printed-hat --shape hat --cells 50,100,200 $printed
vortex printed-bernstein --shape bernstein --ppc 3 --cells 50,100 $printed
vortex bernstein --shape bernstein --ppc 3 --cells 50,100
vortex ring --shape bernstein --ppc 3 --cells 76 --t-end 0.5 --frames 1
vortex printed-cubic --shape cubic --cells 50,100,200 $printed
vortex cubic --shape cubic --cells 50,100,200
vortex particles --shape cubic --cells 50,100 --cut whole --start whole --alpha 0.99
vortex fmpm --shape cubic --cells 50,100 --transfer fmpm --order 5
run vortex-steps vortex --shape cubic --points gauss --cfl 0.465 --records 10 --cells 50,100 $printed
