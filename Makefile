# thermoroll: from the chapters in paper/ to the program, the data, the figures and the report.
# `make help` lists the goals. Everything generated is in build/, but for src/, which is tangled and
# committed, figures/golden/, which only `make golden` writes, and figures/measured/, that of `make study`, `make soak`,
# `make sweep-bench`, `make live-bench` and `make certify`.

MAKEFLAGS += --no-builtin-rules
.DELETE_ON_ERROR:
.DEFAULT_GOAL := all
export LC_ALL := C.UTF-8

# --- Packages -------------------------------------------------------------------------------------
# The one list of Debian packages, by goal; appendix H of the report gives the reason for each.

build_packages := g++ cmake make pandoc libeigen3-dev libgsl-dev libcli11-dev nlohmann-json3-dev
data_packages := $(build_packages) libbenchmark-dev
figure_packages := $(data_packages) gnuplot-nox
live_packages := clang lld wasi-libc libc++-dev-wasm32 libclang-rt-dev-wasm32
report_packages := $(figure_packages) fonts-lmodern libharfbuzz-bin woff2 xz-utils
check_packages := $(data_packages) libgtest-dev clang-format clang-tidy libpng-dev python3 groff-base
python_packages := python3-numpy python3-matplotlib python3-venv python3-wheel
fortran_packages := gfortran
certify_packages := libflint-dev libflint-arb-dev
test_packages := $(report_packages) $(live_packages) $(check_packages) $(python_packages) $(fortran_packages) libxml2-utils chromium parallel poppler-utils

packages_for_all := $(build_packages)
packages_for_install := $(build_packages)
packages_for_golden := $(figure_packages)
packages_for_data := $(data_packages)
packages_for_figures := $(figure_packages)
packages_for_report := $(report_packages)
packages_for_reproduce := $(report_packages)
packages_for_live := $(report_packages) $(live_packages)
packages_for_check := $(check_packages)
packages_for_test := $(test_packages)
packages_for_test-release := $(test_packages)
packages_for_debug := $(build_packages) libgtest-dev
packages_for_asan := $(build_packages) libgtest-dev
packages_for_tsan := $(build_packages) libgtest-dev
packages_for_valgrind := $(build_packages) valgrind
packages_for_sweep-bench := $(build_packages)
packages_for_live-bench := $(report_packages) $(live_packages) python3 chromium
packages_for_soak := $(build_packages)
packages_for_certify := $(build_packages) $(certify_packages)
packages_for_mutants := $(test_packages)
packages_for_fuzz := $(build_packages) clang libclang-rt-dev
packages_for_coverage := $(build_packages) libgtest-dev
packages_for_bench := $(data_packages)
packages_for_draft := $(build_packages)
packages_for_where := $(build_packages)
packages_for_pdf := $(report_packages) chromium
packages_for_clean :=
packages_for_help :=

# The command or file by which a package shows that it is there; CMake looks for the libraries.
MATH_FONT ?= /usr/share/texmf/fonts/opentype/public/lm-math/latinmodern-math.otf
file_of_fonts-lmodern := $(MATH_FONT)
command_of_libharfbuzz-bin := hb-subset
command_of_woff2 := woff2_compress
command_of_xz-utils := xz
command_of_g++ := $(firstword $(CXX))
command_of_cmake := cmake
command_of_pandoc := pandoc
command_of_gnuplot-nox := gnuplot
command_of_clang-format := clang-format
command_of_clang-tidy := clang-tidy
command_of_libxml2-utils := xmllint
command_of_groff-base := groff
command_of_chromium := chromium
command_of_parallel := parallel
command_of_poppler-utils := pdftotext
command_of_clang := clang++
command_of_lld := wasm-ld
file_of_wasi-libc := /usr/include/wasm32-wasi/stdio.h
file_of_libc++-dev-wasm32 := /usr/lib/wasm32-wasi/libc++.a
file_of_libclang-rt-dev-wasm32 := $(firstword $(wildcard /usr/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a) none)
command_of_valgrind := valgrind

needs = $(if $(filter undefined,$(origin packages_for_$1)),$(packages_for_reproduce),$(packages_for_$1))
other_goals := $(filter-out setup,$(MAKECMDGOALS))

ifneq ($(filter setup,$(MAKECMDGOALS)),)
# --- make setup GOAL...: install what the goals need, then make them ------------------------------

known := $(patsubst packages_for_%,%,$(filter packages_for_%,$(.VARIABLES)))
unknown := $(filter-out $(known),$(other_goals))
ifneq ($(unknown),)
$(error no goal $(unknown): 'make help' lists them)
endif

packages := $(sort $(foreach goal,$(or $(other_goals),reproduce),$(call needs,$(goal))))

.PHONY: setup $(other_goals)
$(other_goals): setup ; @:

setup:
	@command -v apt-get >/dev/null && command -v dpkg-query >/dev/null || { \
	  echo "setup: no apt-get here; install the like of: $(packages); then leave 'setup' out" >&2; exit 1; }; \
	missing=; for package in $(packages); do \
	  [ "$$(dpkg-query -W -f '$${db:Status-Status}' $$package 2>/dev/null)" = installed ] || \
	    missing="$$missing $$package"; \
	done; \
	[ -n "$$missing" ] || exit 0; \
	if [ "$$(id -u)" = 0 ]; then sudo=; elif command -v sudo >/dev/null; then sudo=sudo; else \
	  echo "setup: not root; ask for: apt-get install --no-install-recommends$$missing" >&2; exit 1; fi; \
	echo "setup: installing$$missing"; \
	$$sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq update && \
	$$sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o Dpkg::Use-Pty=0 \
	  install --no-install-recommends $$missing >/dev/null
	$(if $(other_goals),+@$(MAKE) --no-print-directory $(other_goals))

else
# --- Every other goal stops at once without its commands ------------------------------------------

packages := $(sort $(foreach goal,$(or $(MAKECMDGOALS),all),$(call needs,$(goal))))
lacks_command = $(if $(command_of_$1),$(if $(shell command -v '$(command_of_$1)' 2>/dev/null),,$1))
lacks_file = $(if $(file_of_$1),$(if $(wildcard $(file_of_$1)),,$1))
missing := $(strip $(foreach package,$(packages),$(call lacks_command,$(package)) $(call lacks_file,$(package))))
ifneq ($(missing),)
$(error $(foreach package,$(missing),$(command_of_$(package))$(file_of_$(package))) not found: \
  run 'make setup $(or $(MAKECMDGOALS),all)' or 'apt-get install $(missing)')
endif

# --- One make at a time in a folder -----------------------------------------------------------------

goals := $(or $(MAKECMDGOALS),all)
dry_run := $(findstring n,$(filter-out -%,$(firstword $(MAKEFLAGS))))
lock := $(if $(dry_run),,$(if $(filter-out help,$(goals)),$(shell command -v flock 2>/dev/null)))
ifneq ($(lock),)
ifneq ($(value THERMOROLL_LOCKED),$(CURDIR))
waits := yes
endif
endif

ifdef waits
.PHONY: locked $(goals)
$(goals): locked ; @:

# The lock is on the folder itself, so that there is no file to make and remove, and it goes with the
# last process of this make.
locked: export THERMOROLL_LOCKED := $(CURDIR)
locked:
	+@exec 9<.; flock --nonblock --conflict-exit-code 75 9; [ $$? -ne 75 ] || { \
	  echo "Waiting for another make in this folder" >&2; flock 9; }; \
	$(MAKE) --no-print-directory $(goals)

else
# --- What there is to make ------------------------------------------------------------------------

chapters := $(wildcard paper/*.md)
sources := $(wildcard src/*/*.?pp src/*/*/*.?pp src/include/*.h)
live_sources := $(filter-out src/studies/% src/program/% src/bench/% src/c/% %.h,$(sources)) $(wildcard src/program/live/*.?pp)
live_scripts := src/program/live/engine.js src/program/live/page.js
figures := $(filter-out style,$(patsubst figures/%.gp,%,$(wildcard figures/*.gp)))
tables := claims resolution coincident bands iteration-steps random-scenes stated-errors survival materials deflation hot-steel contact-cases reference-values no-slip

# Those that take longest come first, lest one is alone at the end.
data_files := build/data/survival.csv build/data/values.json \
  $(patsubst %,build/data/%.csv,$(filter-out estimates sign evaluations recipe-%,$(figures)) $(filter-out survival,$(tables)))
study_files := build/data/estimates.csv build/data/study.csv build/data/study-kinds.csv build/data/study-values.json
kept_files := $(study_files) build/data/sign.csv
counted_files := build/data/evaluations.csv build/data/evaluations.json
recipe_files := $(patsubst %,build/data/%.csv,$(filter recipe-%,$(figures)))
timed_files := $(patsubst %,build/data/%.csv,times shares contact) build/data/speed.json
figure_files := $(patsubst %,build/figures/%.svg,$(figures))

# Without the compiler's target for WebAssembly, or its libraries, the report has no solver in it.
with_live := $(if $(shell echo 'int main() {}' | clang++ --target=wasm32-wasi --sysroot=/usr -x c++ - -o /dev/null 2>/dev/null && echo yes),build/live.html)

# A step is announced by its place among all steps and the seconds since the start.
steps := build/tangle.stamp build/colours build/built $(addprefix build/live/,$(if $(with_live),solver.wasm)) build/data/claims.txt $(data_files) $(recipe_files) $(kept_files) build/benches-built build/data/evaluations.csv \
  build/data/times.json $(timed_files) $(figure_files) build/report.html build/paper.html
ifndef THERMOROLL_STARTED
export THERMOROLL_STARTED := $(shell date +%s)
endif
up_to = $(firstword $2) $(if $(filter $1,$(firstword $2)),,$(call up_to,$1,$(wordlist 2,$(words $2),$2)))
step = @printf '[%2d/%d %4d s] %s\n' $(words $(call up_to,$@,$(steps))) $(words $(steps)) \
  $$(($$(date +%s) - $(THERMOROLL_STARTED))) '$1'

# This make, CMake and CTest, each apart from the others' job slots, take every processor unless told; CTest
# takes one job more, as a fifth of the tests' time is waiting, for a browser or a clock.
# (Below another make, -j is found in the environment only.)
processors := $(shell nproc 2>/dev/null || echo 2)
ifeq ($(filter -j% --job%,$(MAKEFLAGS) $(shell echo "$$MAKEFLAGS")),)
MAKEFLAGS += -j$(processors)
endif
export CMAKE_BUILD_PARALLEL_LEVEL ?= $(processors)
export CTEST_PARALLEL_LEVEL ?= $(shell echo $$(($(CMAKE_BUILD_PARALLEL_LEVEL) + 1)))
apart := env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u THERMOROLL_STARTED
compile := $(apart) cmake --build
ctest := $(apart) ctest --output-on-failure
configure = @$(apart) cmake --preset $1 >build/$1.log || { cat build/$1.log; exit 1; }

.PHONY: all where data figures report live draft reproduce verify check test test-release bench golden pdf coverage debug asan tsan valgrind soak mutants fuzz study sweep-bench live-bench certify install clean help

## all: build the program build/thermoroll (the default)
all: build/thermoroll

## setup: install the Debian packages that the goals named beside it need

## reproduce: everything: program, data, figures, report, and the table of claims
# The benchmarks are compiled and counted first, beside what computes the data.
reproduce: build/colours build/data/evaluations.csv build/data/claims.txt build/report.html build/paper.html
	@cat build/data/claims.txt
	@echo "The report is build/report.html, its short version build/paper.html"

## data: compute every table
data: $(data_files) $(kept_files) $(counted_files) $(timed_files)

## figures: draw every figure
## build/figures/NAME.svg: draw one figure, that of figures/NAME.gp
figures: $(figure_files)

## report: write build/report.html, and its short version without code, build/paper.html
report: build/report.html build/paper.html

## live: the report with the solver in it, which needs a compiler for WebAssembly
live: build/live.html build/report.html

## verify: make the report once more in another folder, locale and time zone, and compare every byte
verify:
	+@bash tests/verify.sh $(packages_for_reproduce)

# --- Program --------------------------------------------------------------------------------------

build build/data build/figures:
	@mkdir -p $@

# The tangler touches a file in src/ only when its content changes, so prose alone compiles nothing.
tangle = pandoc --preserve-tabs -f paper/tangle.lua -t plain -o /dev/null $(chapters)
build/tangle.stamp: paper/tangle.lua $(chapters) | build
	$(call step,tangling the chapters)
	@$(tangle)
	@touch $@

## where: the line of a chapter that is AT=src/solver/coupled.cpp:120
where: | build
	@TANGLE_ROOT=build/where TANGLE_LINES=1 $(tangle)
	@awk -v file='$(AT)' 'BEGIN { split(file, at, ":"); ARGV[1] = "build/where/" at[1]; ARGC = 2 } \
	  /^#line / { source = $$3; number = $$2 - 1; next } \
	  { ++number } ++lines >= at[2] && lines > 1 { gsub(/"/, "", source); print source ":" number; exit }'

build/release/Makefile: CMakeLists.txt CMakePresets.json | build/tangle.stamp
	$(call configure,release)
	@touch $@

build/built: build/tangle.stamp build/release/Makefile $(sources)
	$(call step,compiling the program)
	@$(compile) build/release --target program
	@ln -sf release/thermoroll build/thermoroll
	@touch $@

# An empty recipe: what follows is made again only when the program itself is newer.
build/thermoroll: build/built ;

# --- Data, figures, report: written aside, then renamed -------------------------------------------

$(data_files): build/thermoroll | build/data
	$(call step,computing $@)
	@build/thermoroll figure-data $(basename $(@F)) --output $@

# The recipes of appendix L, as a reader would run them.
$(recipe_files): build/data/recipe-%.csv: src/program/recipes/%.sh src/program/recipes/locomotive.toml build/thermoroll | build/data
	$(call step,computing $@)
	@rm -rf build/recipes/$* && mkdir -p build/recipes/$* && cp src/program/recipes/locomotive.toml build/recipes/$*
	@cd build/recipes/$* && PATH="$(CURDIR)/build:$$PATH" ROWS=100 sh ../../../src/program/recipes/$*.sh
	@mv build/recipes/$*/$*.csv $@

$(study_files): build/data/%: figures/measured/study/% | build/data
build/data/sign.csv: figures/measured/sign.csv | build/data
$(kept_files):
	$(call step,copying $@)
	@cp $< $@.tmp
	@mv $@.tmp $@

# Nothing else is computed while the benchmarks run, and they run again only when they are others.
build/benches-built: build/built | build/release/with-bench
	$(call step,compiling the benchmarks)
	@$(compile) build/release --target thermoroll-bench thermoroll-count
	@ln -sf release/thermoroll-bench build/thermoroll-bench
	@touch $@

build/thermoroll-bench build/release/thermoroll-count: build/benches-built ;

# One run of the program writes both.
build/data/evaluations.json: build/data/evaluations.csv ;
build/data/evaluations.csv: build/release/thermoroll-count | build/data
	$(call step,counting the evaluations of kernels)
	@mkdir -p build/count && $< build/count
	@mv build/count/evaluations.json build/count/evaluations.csv build/data

drawn_from_times := $(filter build/figures/cost.svg build/figures/speed.svg build/figures/speed-%,$(figure_files))
build/data/times.json: build/thermoroll-bench | build/data/claims.txt $(data_files) $(counted_files) $(recipe_files) \
    $(filter-out $(drawn_from_times),$(figure_files))
	$(call step,timing the methods)
	@build/thermoroll-bench --benchmark_min_time=0.01 --benchmark_repetitions=3 \
	  --benchmark_format=json >$@.tmp 2>build/bench.log || { cat build/bench.log; exit 1; }
	@mv $@.tmp $@

$(timed_files): build/data/times.json build/thermoroll
	$(call step,computing $@)
	@build/thermoroll figure-data $(basename $(@F)) --times $< --output $@

$(drawn_from_times): build/data/times.csv
build/figures/speed.svg: figures/measured/certified-tables.csv
build/figures/iteration-b.svg: figures/iteration-a.gp

build/data/claims.txt: build/thermoroll | build/data
	$(call step,writing $@)
	@build/thermoroll claims --format text >$@.tmp
	@mv $@.tmp $@

build/figures/%.svg: figures/%.gp figures/style.gp build/data/%.csv | build/figures
	$(call step,drawing $@)
	@gnuplot -e "data='build/data/$*.csv'; output='$@.tmp'" figures/$*.gp
	@mv $@.tmp $@

# The characters of formulas from Latin Modern Math, with its table of how brackets stretch.
build/math.woff2: paper/math-characters.txt | build
	@hb-subset --unicodes-file=$< --output-file=build/math.tmp.otf '$(MATH_FONT)'
	@woff2_compress build/math.tmp.otf >build/math.log 2>&1 || { cat build/math.log; exit 1; }
	@mv build/math.tmp.woff2 $@
	@rm build/math.tmp.otf build/math.log

# The revision, its day and, if nothing was changed since, Software Heritage's identifier of its tree.
date = $(shell git show -s --format=%cs HEAD 2>/dev/null)
revision = $(shell git describe --always --dirty 2>/dev/null)
tree = $(if $(filter-out %-dirty,$(revision)),$(shell git rev-parse 'HEAD^{tree}'))
weave = pandoc $(chapters) -f markdown-implicit_figures -t html5 --wrap=none --mathml \
  --lua-filter paper/weave.lua --citeproc --bibliography paper/references.bib --template paper/template.html
# The solver for the page, and with its scripts, to stand at the page's end.
build/live/solver.wasm: CMakeLists.txt CMakePresets.json $(live_sources)
	$(call step,compiling the solver for the page)
	@$(apart) cmake --preset live >build/live.log 2>&1 && $(compile) build/live >>build/live.log 2>&1 || { cat build/live.log; exit 1; }
	@touch $@

build/live.html: build/live/solver.wasm $(live_scripts)
	@{ echo '<script type="application/octet-stream" id="solver">'; gzip -9nc $< | base64 -w0; echo '</script>'; \
	  echo '<script>//<![CDATA['; cat $(live_scripts); echo 'live_page(engine);'; echo '//]]></script>'; } >$@.tmp
	@mv $@.tmp $@
$(live_sources) $(live_scripts): build/tangle.stamp ;

# The colours of the code need neither data nor figures: they are made while a compiler is alone. The filter
# reads the chapters itself, so the plainest reader does.
build/colours: $(chapters) paper/weave.lua paper/tangle.lua | build
	$(call step,colouring the code)
	@nice -n 19 pandoc $(chapters) -f commonmark -t plain --lua-filter paper/weave.lua -M colours=yes -o $@

build/report.html: as := $(addprefix -M live=yes --include-after-body=,$(with_live))
build/report.html: $(with_live) build/colours
build/paper.html: as := -M paper=yes
build/report.html build/paper.html: $(chapters) $(wildcard paper/*.lua paper/*.html paper/*.css paper/*.bib paper/*.sed) \
    $(wildcard figures/measured/*.csv tests/*/*.cpp tests/*/*.sh tests/*/*.py tests/*/CMakeLists.txt) build/math.woff2 $(data_files) $(kept_files) $(counted_files) $(timed_files) $(figure_files)
	$(call step,writing $@)
	@$(weave) $(as) --fail-if-warnings $(addprefix -M revision=,$(revision)) $(addprefix -M date=,$(date)) $(addprefix -M tree=swh:1:dir:,$(tree)) -o $@.tmp
	@sed -zi -f paper/report.sed $@.tmp
	@mv $@.tmp $@

drafted = $(wildcard paper/$(CHAPTER)-*.md)
## draft: write CHAPTER=12 of the report alone to build/draft.html, with the data and figures that are there
draft: | build
	@[ "$(words $(drafted))" = 1 ] || { \
	  echo "draft: there is no paper/$(CHAPTER)-*.md; say, for example, CHAPTER=01" >&2; exit 1; }
	@$(weave) -M draft=$(drafted) -o build/draft.html.tmp
	@mv build/draft.html.tmp build/draft.html
	@echo "The draft is build/draft.html"

# --- Tests and checks -----------------------------------------------------------------------------

# The tests and the benchmarks are switched on in the tree that has the program, before it is
# compiled and one after the other. What needs data needs the benchmarks.
with_test := $(if $(filter check test test-release,$(MAKECMDGOALS)),build/release/with-test)
with_bench := $(if $(filter-out all where draft install valgrind soak mutants sweep-bench certify,$(MAKECMDGOALS)),build/release/with-bench)
with_soak := $(if $(filter soak,$(MAKECMDGOALS)),build/release/with-soak)
with_certify := $(if $(filter certify,$(MAKECMDGOALS)),build/release/with-certify)
build/built: | $(with_test) $(with_bench) $(with_soak) $(with_certify)
build/release/with-bench: | $(with_test)
build/release/with-soak: | $(with_test) $(with_bench)
build/release/with-certify: | $(with_test) $(with_bench) $(with_soak)
bench: | $(filter test,$(MAKECMDGOALS))
soak: | $(filter test bench,$(MAKECMDGOALS))
test test-release: | $(filter check,$(MAKECMDGOALS))
test-release: | $(filter test,$(MAKECMDGOALS))

# A program that is compiled for the tests is compiled with -Werror, unless that would be twice.
build/release/with-test: strict := $(if $(wildcard build/built),,-DTHERMOROLL_WERROR=ON)
build/release/with-test: option := THERMOROLL_TESTS
build/release/with-bench: option := THERMOROLL_BENCH
build/release/with-soak: option := THERMOROLL_SOAK
build/release/with-certify: option := THERMOROLL_CERTIFY
build/release/with-%: | build/release/Makefile
	@$(apart) cmake -D$(option)=ON $(strict) build/release >build/release.log || { cat build/release.log; exit 1; }
	@touch $@

## check: the tests that find a mistake in an edit, within a minute once the rest is compiled
check: build/built
	@echo "Building the quick tests"
	@$(compile) build/release --target unit-tests thermoroll-bench thermoroll-count thermoroll-study >build/check.log || { cat build/check.log; exit 1; }
	@$(ctest) --preset check

# The tests are compiled while the report is written, but not while the benchmarks run.
.PHONY: test-programs
test-programs: build/built | build/data/times.json $(filter check,$(MAKECMDGOALS))
	@echo "Building the tests"
	@$(compile) build/release
tested := build/data/claims.txt build/report.html build/paper.html test-programs

## test: every test but those of test-release
test: $(tested)
	@$(ctest) --test-dir build/release -LE release

## test-release: the unit tests under the sanitizers, and the rarest and longest tests
test-release: $(tested)
	@$(compile) build/release --target release-tests
	@$(ctest) --test-dir build/release -L release

# These builds compile their own tangled copy, with #line.

## debug: build/debug, where errors and the debugger name the chapter
debug: | build
	$(call configure,debug)
	@$(compile) build/debug

## asan: the unit tests under the address and undefined-behaviour sanitizers
asan: | build
	$(call configure,asan-ubsan)
	@$(compile) build/asan-ubsan --target unit-tests
	@$(ctest) --test-dir build/asan-ubsan -L unit

## coverage: the share of each chapter's code that the tests and the data run
coverage: | build
	$(call configure,coverage)
	@$(compile) build/coverage --target unit-tests thermoroll-cli
	@find build/coverage -name '*.gcda' -delete
	@$(ctest) --test-dir build/coverage -L 'unit|command' >build/coverage.log || \
	  { cat build/coverage.log; exit 1; }
	@for name in $$(build/coverage/thermoroll figure-data --list); do \
	  build/coverage/thermoroll figure-data $$name --output build/coverage/data || exit 1; done
	@bash tests/coverage.sh build/coverage

## tsan: sweeps, and the library called from several threads, under the thread sanitizer
tsan: | build
	$(call configure,tsan)
	@$(compile) build/tsan --target thermoroll-cli interface-test
	@for case in SameBytesWithAnyNumberOfJobs BadRowsGiveTheirError ClosedPipe InterruptedLeavesWholeRows \
	    OutputIsWholeOrAbsent ResumesWhereItWasStopped; do \
	  bash tests/program/sweep_test.sh $$case build/tsan/thermoroll || exit 1; echo "$$case: no race"; done
	@$(ctest) --test-dir build/tsan --no-tests=error -R '^Interface\.(AnyNumberOfThreads|LawsOfSeveralThreads)$$'

## valgrind: solves and a sweep under memcheck
valgrind: build/thermoroll
	@bash tests/valgrind.sh build/thermoroll

SOAK_SCENES ?= 1000000
SOAK_SEED ?= 1
ESTIMATES ?= build/estimates.csv
## soak: a million random scenes (SOAK_SCENES), or as many as fit into MINUTES
soak: build/thermoroll
	@$(compile) build/release --target soak
	@build/release/tests/soak/soak $(SOAK_SCENES) $$((60 * $(or $(MINUTES),0))) $(SOAK_SEED) \
	  $(ESTIMATES) >build/soak.log; status=$$?; sed -n '1p; /compared with/p; /^FAILED/p' build/soak.log; exit $$status

## mutants: which mutations of the sources no test notices; ONLY=sweep.cpp or ONLY=20-29 tries some
mutants: build/tangle.stamp
	@$(apart) bash tests/mutants/run.sh $(ONLY)

fuzz_targets := arguments file table scene law interface
## fuzz: look for inputs that break a way in, each for its share of MINUTES (4; needs clang)
fuzz: | build
	$(call configure,fuzz)
	@$(compile) build/fuzz --target $(addprefix fuzz-,$(fuzz_targets))
	@bash tests/fuzz/run.sh $(or $(MINUTES),4) $(CMAKE_BUILD_PARALLEL_LEVEL) $(fuzz_targets)

STUDY_SCENES ?= 12000
## study: compare stated with true errors in STUDY_SCENES random scenes, for chapter 13 (minutes)
study: build/benches-built
	@$(compile) build/release --target thermoroll-study
	@mkdir -p build/study figures/measured/study
	@build/release/thermoroll-study $(STUDY_SCENES) build/study
	@mv build/study/* figures/measured/study/
	@echo "Now make golden: a figure of these data has a digest"

## bench: how long the solvers take
bench: build/thermoroll-bench
	@build/thermoroll-bench --benchmark_repetitions=9 --benchmark_report_aggregates_only=true

SWEEP_ROWS ?= 10000 100000 1000000
## sweep-bench: rows per second and memory of sweeps of SWEEP_ROWS rows, for appendix D
sweep-bench: build/thermoroll
	@mkdir -p figures/measured
	@bash tests/sweep-bench.sh build/thermoroll figures/measured/sweep.csv $(SWEEP_ROWS)

## live-bench: how soon a slider of the solver in the page has its picture, for appendix J
live-bench: build/report.html
	@PYTHONDONTWRITEBYTECODE=1 python3 tests/live/live_bench.py $< figures/measured/live.csv

## certify: enclose results by ball arithmetic, for the appendix on certified results (minutes; needs Arb)
certify: build/thermoroll
	@$(compile) build/release --target thermoroll-certify >build/certify.log || { cat build/certify.log; exit 1; }
	@mkdir -p figures/measured
	@for part in temperatures tables first-order; do \
	  build/release/thermoroll-certify $$part '$(revision)' "$$(date -u +%F)" >build/certified.csv || exit 1; \
	  mv build/certified.csv figures/measured/certified-$$part.csv; done

## golden: take today's data and figures as the golden ones of the tests, and the README's picture
golden: $(data_files) $(kept_files) $(counted_files) $(filter-out $(drawn_from_times),$(figure_files))
	@bash tests/figures/update-golden.sh

# --- The rest -------------------------------------------------------------------------------------

browser := chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run \
  --disable-background-networking --disable-component-update --disable-sync \
  --no-pdf-header-footer

## pdf: print the report to build/report.pdf, its short version to build/paper.pdf (needs chromium)
pdf: build/report.pdf build/paper.pdf
build/report.pdf: browser += --disable-pdf-tagging # which would make it more than twice as large
build/paper.pdf: browser += --generate-pdf-document-outline
build/report.pdf build/paper.pdf: build/%.pdf: build/%.html
	@profile=$$(mktemp -d); trap 'rm -rf "$$profile"' EXIT; \
	$(browser) --user-data-dir="$$profile" --print-to-pdf=$@.tmp \
	  $< 2>$@.log || { cat $@.log; exit 1; }
	@mv $@.tmp $@
	@echo "The PDF is $@"

PREFIX ?= /usr/local
## install: program, libraries, CMake package, Python module, manual page, completion for bash to PREFIX (/usr/local); DESTDIR is heeded
install: build/thermoroll
	@$(compile) build/release --target thermoroll-manual >build/manual.log || { cat build/manual.log; exit 1; }
	@cmake --install build/release --prefix "$(PREFIX)"

ifneq ($(filter clean,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif
## clean: remove build/
clean:
	@rm -rf build

## help: this list
help:
	@sed -n 's/^## \([a-zA-Z./-]*\): \(.*\)/make \1\t\2/p' Makefile | expand -t 29

endif
endif
