# Tables of extreme cases and of largest stable steps, without the longest cases (`make extremes` has them all). A cell to look into is exit
# code 3.
run extremes extremes --table "$plots/extremes.txt" --quick || [ $? -eq 3 ]
cp "$figures/data/extremes/"*.png "$figures"
