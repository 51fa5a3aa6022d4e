# Gases and liquids: the shock tube as in the review, with smooth functions, refined, in motion; water.
run sod-hat-plain shock_tube --c0 0 --c1 0 --frames 1
for s in hat cpgimp; do run sod-$s shock_tube --shape $s --frames 1; done
for s in hat cpgimp cubic; do run sod-order-$s shock_tube --shape $s --cells 100,200,400,800,1200 --records 20; done
run sod-cpgimp-film shock_tube --shape cpgimp --frames 40
run dam dam_break --frames 85
run dam-barrier dam_break --barrier 0.5 --frames 34
for s in hat cubic; do
    run dam-front-$s dam_break --length 1 --height 2 --box 5 --cells 40 --t-end 0.7 --shape $s
    run dam-front-$s-stiff dam_break --length 1 --height 2 --box 5 --cells 40 --t-end 0.7 --shape $s --kappa 1.2e8
done
for flow in couette poiseuille; do
    run channel-$flow channel --flow $flow --cells 16 --t-end 0.2 --frames 4
    for s in hat cubic; do run channel-$flow-$s channel --flow $flow --shape $s --cells 4,8,16,32; done
done
run column hydrostatic --frames 1
run column-cubic hydrostatic --shape cubic --frames 1
