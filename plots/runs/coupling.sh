# MPM and finite elements in one system: a wave crosses a joint, a disk rolls down a plate, one bounces; explicit contact beside it.
# Table 3's correction of the receding contact gains energy: that run ends as unstable.
for bodies in coupled fem mpm; do run coupled-bar-$bodies coupled_bar --bodies $bodies --cells 50,100,200 --records 10; done
run coupled-bar-stiff coupled_bar --contrast 4 --frames 2
run coupled-bar-soft coupled_bar --contrast 0.1 --from mpm --frames 2
for n in 40 80; do run coupled-rolling-$n coupled_rolling_disk --E 4.2e7 --around 80 --layers 7 --cells $n --frames 2; done
bounce() { name=$1; shift; run bouncing-$name bouncing_disk --around 100 --layers 8 --cells 32 "$@" --watch warn || [ $? -eq 3 ]; }
bounce free --receding 0 --t-end 1.28 --frames 32
bounce table --t-end 1.28
bounce impact --receding 0 --t-end 0.561 --frames 1
run bouncing-explicit bouncing_disk_contact --t-end 1.28 --watch warn || [ $? -eq 3 ]
