# Particles of regions, meshes and images.
for case in cells bounds mesh voronoi image; do
    run fill-$case fill_demo --case $case --plot png
    cp "$figures/data/fill-$case/fill_$case.png" "$figures"
done
