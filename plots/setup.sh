#!/bin/sh
# Installs what is missing of the packages the kit is built with; says what to install when it may not.
set -eu
packages="g++ make cmake libeigen3-dev libboost-program-options-dev libcgal-dev libpng-dev libgnuplot-iostream-dev gnuplot-nox libgtest-dev libbenchmark-dev tidy"
missing=""
for p in $packages; do
    dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q "ok installed" || missing="$missing $p"
done
[ "$missing" = " gnuplot-nox" ] && command -v gnuplot >/dev/null 2>&1 && missing=""
[ -z "$missing" ] && exit 0
echo "missing packages:$missing"
if [ "$(id -u)" != 0 ]; then
    echo "install them as root:  apt-get update && apt-get install$missing" >&2
    exit 1
fi
apt-get update -qq
DEBIAN_FRONTEND=noninteractive apt-get install -y -qq $missing
