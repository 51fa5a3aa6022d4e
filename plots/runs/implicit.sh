# Implicit MPM: bar from 0.1 to 1000 h/c, flight through cells (the published form blows up, exit code 3), disk, cantilever, explicit beside it.
for mode in 1 10; do for beta in 0.25 0.3; do for cfl in 0.1 1 10 100 1000; do
    t_end=$(awk "BEGIN { print ($cfl > 1 ? 50 * $cfl : 50) }")
    run implicit-bar-$mode-$beta-$cfl implicit_bar --mode $mode --beta $beta --cfl $cfl --t-end $t_end --records 10
done; done; done
fly() { name=$1; shift; run crossing-$name implicit_crossing --watch warn "$@" || [ $? -eq 3 ]; }
fly particle --carry particle
fly particle-0.3 --beta 0.3
fly damped --beta 0.3025 --gamma 0.6
fly lumped --carry lumped
fly projected --carry projected --crossings 60 --cuts 0
for shape in hat quadratic cubic; do name=conserving-$shape; [ $shape = hat ] && name=conserving; fly $name --carry conserving --shape $shape; done
run implicit-column implicit_column --E 1e6 --newton
for n in 40 80; do run implicit-rolling-$n implicit_rolling_disk --E 4.2e8 --around 150 --layers 11 --cells $n --frames 2 --newton; done
for n in 8 16; do run implicit-cantilever-$n implicit_cantilever --layers 11 --cells $n --t-end 4 --frames 10; done
run implicit-cantilever-midpoint implicit_cantilever --layers 11 --cells 16 --t-end 4 --carry midpoint
