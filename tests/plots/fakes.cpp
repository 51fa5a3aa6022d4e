#include "tests/plots/fakes.hpp"

#include <algorithm>
#include <fstream>

namespace mpm::test {
namespace {

constexpr const char* script = R"script(#!/bin/sh
name=$(basename "$0") bin=$(dirname "$0")
if [ "$1" = --describe ]; then
    echo 'name,type,default,unit,low,high,choices,help'
    echo 'mode,integer,1,-,1,1000,,"number, of the mode"'
    echo 'shape,choice,hat,-,,,hat|cubic,weighting function'
    [ "$name" = gridless ] || echo 'cells,integers,50,cells,1,,,cells'
    echo 'dt,number,0,time,0,,,time step'
    echo 'quiet,flag,false,-,,,,say nothing'
    echo 'out,text,,-,,,,folder'
    case $name in strict | hangs) echo 'dry-run,flag,false,-,,,,run nothing' ;; esac
    exit 0
fi
cells=50 out=. dt=0.001 mode=1
while [ $# -gt 0 ]; do
    case $1 in
        --cells) cells=$2; shift ;;
        --out) out=$2; shift ;;
        --dt) dt=$2; shift ;;
        --mode) mode=$2; shift ;;
        --dry-run) [ "$mode" != 7 ] || { echo 'strict: --mode 7: not this one' >&2; exit 2; }; exit 0 ;;
    esac
    shift
done
echo "$name $cells" >>"$bin/log"
mkdir -p "$out"
header=program,case,scheme,shape,transfer,options,dim,cells,h,ppc,particles,dt,cfl,steps,t_end,threads,error_name,error,order,reference
header=$header,energy_drift,momentum_drift,wall_s,cpu_s,ns_per_particle_step,peak_rss_kb,bytes_per_particle,bytes_per_node,verdict,t_fail,reason
case $name in
    fails) echo 'first line' >&2; echo 'no good, at all' >&2; exit 1 ;;
    crashes) kill -SEGV $$ ;;
    killed) kill -KILL $$ ;;
    hangs) echo $$ >"$bin/pid"; exec sleep 60 ;;
    silent) exit 0 ;;
    half) printf '%s\nhalf,bar,' "$header" >"$out/summary.csv"; exit 0 ;;
    strange) printf 'a,b\n1,2\n' >"$out/summary.csv"; exit 0 ;;
esac
power=2 verdict=ok t_fail=nan reason= code=0
[ "$name" != better ] || power=3
fine=0 fast=0
[ "$name" != unstable ] || fine=$cells
[ "$name" != limited ] || fast=$dt
if awk "BEGIN { exit !($fine >= 100 || $fast > 0.007) }"; then
    verdict=unstable:energy-growth t_fail=0.5 reason='"energy grew from 1 to 2, twice"' code=3
fi
awk -v n="$cells" -v p="$power" -v head="$header" -v name="$name" -v dt="$dt" -v verdict="$verdict" -v end=",$t_fail,$reason" 'BEGIN {
    print head
    row = "%s,bar,scheme,hat,flip,\"cells=%d;mode=1,2\",1,%d,%.17g,1,%d,%s,%.17g,10,1,1,%s,%s,nan,exact,0,0,%.17g,%.17g,1,1234,64,48,%s%s\n"
    for (i = 1; i <= 2; ++i)
        printf row, name, n, n, 1 / n, n, dt, dt / 0.01, i == 1 ? "size" : "shape", verdict == "ok" ? sprintf("%.17g", n ^ -p / i) : "nan", n / 1000, n / 1000, verdict, end
}' >"$out/summary.csv"
printf 't,v_cm,v_cm_exact\n0,1,1\n0.5,-0.9,-1\n1,0.8,1\n' >"$out/history.csv"
exit $code
)script";

const Words names{"good",  "better", "limited", "unstable", "fails",  "crashes", "killed",
                  "hangs", "silent", "half",    "strange",  "strict", "gridless"};

}  // namespace

Fakes::Fakes() {
    namespace fs = std::filesystem;
    fs::create_directory(path("bin"));
    std::ofstream list(path("bin/programs.txt"));
    for (const std::string& name : names) {
        std::ofstream(path("bin/" + name)) << script;
        fs::permissions(path("bin/" + name), fs::perms::owner_all);
        list << name << "\n";
    }
    list << "not_built\n";
}

Words Fakes::told(const Words& words) const {
    Words all{"--programs", "bin", "--plot", "none"};
    all.insert(all.end(), words.begin(), words.end());
    return all;
}

int Fakes::runs() const {
    const std::string log = has("bin/log") ? read("bin/log") : "";
    return static_cast<int>(std::count(log.begin(), log.end(), '\n'));
}

}  // namespace mpm::test
