#!/bin/sh
# readme.sh FIGURES: draws the three pictures of the README, plots/readme/*.png, from what `make figures` has left in FIGURES. Where ImageMagick is
# installed, they are stored in 48 colours, a third of the size.
set -eu
recipes=$(cd "$(dirname "$0")" && pwd)/readme; cd "$1"
for recipe in "$recipes"/*.gp; do
    name=readme_$(basename "$recipe" .gp).png
    gnuplot "$recipe"
    if command -v convert >/dev/null 2>&1; then convert "$name" -colors 48 "PNG8:$name"; fi
    mv "$name" "${recipe%.gp}.png"
done
