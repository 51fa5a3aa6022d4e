# Weighting functions.
run basis-hat basis_functions --shape hat --cells 3
for l in 1 0.5 0.25 0.1; do run basis-gimp-$l basis_functions --shape ugimp --l $l; done
run basis-cubic basis_functions --shape cubic --cells 5
run basis-bernstein basis_functions --shape bernstein --cells 3
run basis-bernstein-1 basis_functions --shape bernstein --cells 1
