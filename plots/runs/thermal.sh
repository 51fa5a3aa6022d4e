# Heat: the bar of figure 51 and the plate of figure 52, line 10 as printed and mended; thermo-mechanics.
for form in printed mended; do
    run heat-bar-$form heat_bar --form $form --ppc 2 --dt 8e-5 --frames 20 --records 50
    run heat-bar-$form-cells heat_bar --form $form --ppc 2 --cells 10,20,40,80,160 --records 10
done
run heat-bar heat_bar --dt 8e-5 --frames 20 --records 50
run heat-plate heat_plate --dt 1e-4 --frames 1 --records 50
run heat-plate-cells heat_plate --cells 10,20,40 --records 10
run heat-plate-cells-printed heat_plate --form printed --cells 10,20,40 --records 10
run thermal-bar thermal_bar_clamped --records 500
run thermal-plate thermal_expansion --records 200
run thermal-plate-rest thermal_expansion --start rest --records 200
for H in 0 500e6; do run adiabatic-$H adiabatic_shear --H $H --cells 3 --cfl 0.5 --records 100; done
