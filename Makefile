# The thin front door. `make figures` sets up, builds and draws; `make check` passes the tests.
MAKEFLAGS += --no-print-directory
JOBS ?= $(shell nproc)
.PHONY: all setup configure build check mutants figures atlas atlas-quick extremes extremes-quick reliability sanitize bench clean
.DEFAULT_GOAL := all

all: build
setup:
	@./plots/setup.sh
configure: setup
	@cmake --preset release >build.log 2>&1 || { cat build.log; exit 1; }
	@rm -f build.log
build: configure
	cmake --build build -j$(JOBS)
check: build
	cd build && ctest --output-on-failure -j$(JOBS)
# Breaks one line of a scheme at a time; every break must be noticed by a test. A few minutes.
mutants: setup
	./tests/mutants/run.sh $(JOBS)
figures: configure
	cmake --build build -j$(JOBS) --target programs
	./plots/figures.sh build figures
# Every case with a known solution, all its variants, error against run time; quick: on coarser grids. The gallery tells the findings.
atlas: figures
	./plots/atlas.sh build figures
atlas-quick: figures
	./plots/atlas.sh build figures quick
# Stiff and extreme cases and the largest stable steps, as tables; quick: without the longest cases. What has ended is not run again.
extremes extremes-quick: configure
	cmake --build build -j$(JOBS) --target programs
	mkdir -p figures/data
	./build/extremes --table plots/extremes.txt --jobs $(JOBS) --out figures/data/extremes $(if $(findstring quick,$@),--quick)
	cp figures/data/extremes/*.png figures
# Every program with random settings, right, wrong and stopped, under the sanitizers.
RUNS ?= 200
reliability: setup
	cmake --preset debug
	cmake --build build-debug -j$(JOBS) --target programs reliability
	./build-debug/reliability --runs $(RUNS) --out build-debug/reliability-runs
# Without the resolutions that tell accuracy alone: they take long here, and shorter runs visit the same code.
accuracy = ConvergesWithOrderTwo|ApproachesLame|SwingsAsFar|CpdiVortexConforming|ReboundAlike|DepthSettles|ReachesItsFloor
sanitize: setup
	cmake --preset debug
	cmake --build build-debug -j$(JOBS)
	cd build-debug && ctest --output-on-failure -j$(JOBS) -E '$(accuracy)'
bench: build
	cmake --build build --target benchmark_step
	./build/benchmark_step
%: configure
	cmake --build build -j$(JOBS) --target $@ || { echo "no such program: $@"; exit 2; }
clean:
	rm -rf build build-native build-debug figures
Makefile: ;
