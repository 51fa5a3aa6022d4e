# The cantilever with and without F-bar for Poisson's ratios up to 0.49999, and the pressure of Cook's membrane.
for nu in 0.3 0.49 0.499 0.4999 0.49999; do
    run locking-off-$nu fbar_cantilever --fbar off --nu $nu --records 200 --watch warn || [ $? -eq 3 ]
    run locking-moving-$nu fbar_cantilever --nu $nu --records 200
    run locking-tlmpm-$nu fbar_cantilever --scheme tlmpm --nu $nu --records 200
done
run locking-grid-0.499 fbar_cantilever --fbar grid --watch warn --records 200 || [ $? -eq 3 ]
for fbar in off grid moving; do
    run cook-$fbar fbar_block --fbar $fbar --shape ugimp --t-end 14.8 --frames 1 --records 100 --watch warn || [ $? -eq 3 ]
done
