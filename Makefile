# Touchstone: the only makefile. Everything is built in build/<variant>/.
# `make help` lists the targets.
# SPDX-License-Identifier: GPL-3.0-or-later

# The version stands in the header that programs of others include.
version_of = $(shell sed -n 's/^\#define MPM_VERSION_$(1) \([0-9]*\)$$/\1/p' solver/mpm_api.h)
INTERFACE := $(call version_of,MAJOR).$(call version_of,MINOR)
VERSION   := $(INTERFACE).$(call version_of,PATCH)
VARIANT ?= release
PREFIX  ?= /usr/local

.DEFAULT_GOAL := all
.DELETE_ON_ERROR:
JOBS := $(or $(shell nproc 2>/dev/null || getconf _NPROCESSORS_ONLN),1)
# All processors, unless -j is given on the command line.
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(JOBS)
endif
MAKEFLAGS += --no-print-directory

# Several goals run one after the other, each in a make of its own: `make deps verify` looks
# for compilers and libraries after deps has run, and `make clean all` keeps what it builds.
# Nothing below may need a package to be read: `make deps` starts with make alone.
ifneq ($(word 2,$(MAKECMDGOALS)),)
.PHONY: $(sort $(MAKECMDGOALS)) one-by-one
$(sort $(MAKECMDGOALS)): one-by-one ; @:
one-by-one:
	+@for goal in $(MAKECMDGOALS); do $(MAKE) $$goal || exit; done
else

# ---------------------------------------------------------------- toolchain
# macOS calls clang gcc: there, Homebrew's newest.
DEFAULT_CC := $(or $(notdir $(lastword $(sort $(wildcard /opt/homebrew/bin/gcc-[0-9][0-9] \
                /usr/local/Cellar/gcc/*/bin/gcc-[0-9][0-9])))),gcc)
ifeq ($(origin CC),default)
CC := $(DEFAULT_CC)
endif
# Compilers do not share objects: the default one has build/<variant>, others a suffix.
BUILD ?= build/$(VARIANT)$(if $(filter gcc $(DEFAULT_CC),$(CC)),,-$(notdir $(lastword $(CC))))

WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion \
            -Wstrict-prototypes -Wmissing-prototypes -Wvla -Wswitch-enum $(if $(WERROR),-Werror)
FLAGS_release := -O3
FLAGS_debug   := -O0 -g3
FLAGS_asan    := -O1 -g -fsanitize=address -fno-omit-frame-pointer
FLAGS_ubsan   := -O1 -g -fsanitize=undefined -fno-sanitize-recover=all
FLAGS_san     := -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer \
                 -DMPM_FAULTS
FLAGS_tsan    := -O1 -g -fsanitize=thread
FLAGS_cov     := -O0 -g --coverage
FLAGS_fuzz    := -O1 -g1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all \
                 -fno-omit-frame-pointer
FLAGS_faults  := -O1 -g -DMPM_FAULTS
ifeq ($(origin FLAGS_$(VARIANT)),undefined)
$(error VARIANT=$(VARIANT): allowed are release debug asan ubsan san tsan cov fuzz faults)
endif

# Contraction is off so that every compiler and SIMD level gives the same bits.
CODE_FLAGS := -std=c11 -D_POSIX_C_SOURCE=200809L $(FLAGS_$(VARIANT)) -ffp-contract=off -pthread \
              $(EXTRA_FLAGS)
# Objects of the library go into libmpm.a and libmpm.so alike. No symbol of the library is replaced
# by a program's, so its functions call each other as directly as in a program.
SHARED_FLAGS := -fPIC -fvisibility=hidden -fno-semantic-interposition

# pkg-config is asked when a recipe first needs the answer, and once.
# hdf5-serial before hdf5: where MPI builds are installed too, hdf5 may be one of them.
PKG_CONFIG      ?= pkg-config
PACKAGES_SOLVER  = $(HDF5) yaml-0.1 muparser glib-2.0 jansson
PACKAGES_SUITE  := gsl libcmark-gfm
PACKAGES_TESTS  := check
remember = $(eval $(1) := $$(shell $(2)))$($(1))
missing  = $(shell for p in $(1); do $(PKG_CONFIG) --exists $$p 2>/dev/null || echo $$p; done)
found    = $(1)$(if $(missing),$(error $(firstword $(PKG_CONFIG)) does not find $(missing): \
             `make deps` installs what is needed))
HDF5            = $(call remember,HDF5,$(PKG_CONFIG) --exists hdf5-serial 2>/dev/null && \
                    echo hdf5-serial || echo hdf5)
PACKAGE_FLAGS   = $(call remember,PACKAGE_FLAGS,$(PKG_CONFIG) --cflags $(call found,$(strip \
                    $(PACKAGES_SOLVER) $(PACKAGES_SUITE) $(PACKAGES_TESTS))) | sed 's/-I/-isystem /g')
LIBS_SOLVER     = $(call remember,LIBS_SOLVER,$(PKG_CONFIG) --libs $(PACKAGES_SOLVER); echo -lm)
LIBS_SUITE      = $(call remember,LIBS_SUITE,$(PKG_CONFIG) --libs $(PACKAGES_SUITE); \
                    echo -lcmark-gfm-extensions)
LIBS_TESTS      = $(call remember,LIBS_TESTS,$(PKG_CONFIG) --libs $(PACKAGES_TESTS))

INCLUDES_solver       := -Isolver
INCLUDES_verification := -Isolver -I.
INCLUDES_benchmarks   := -Isolver -I.
INCLUDES_tests        := -Isolver -I. -Itests
comma   := ,
room     = $(firstword $(subst /, ,$(1)))
includes = $(INCLUDES_$(call room,$(1))) -I$(BUILD)/generated $(PACKAGE_FLAGS)

# ------------------------------------------------------------------ sources
# Fast kernels are compiled for each shape family and level of SIMD, their laws for each level.
FAST_SOURCE    := solver/method/fast/fast_kernels.c
FAST_LAWS      := solver/method/fast/fast_laws.c
# File calls that fail on purpose.
FAULTS_SOURCE  := solver/io/files/faults.c
SOLVER_SOURCES := $(filter-out $(FAST_SOURCE) $(FAST_LAWS) $(if $(filter faults san,$(VARIANT)),,$(FAULTS_SOURCE)),\
                    $(sort $(wildcard $(foreach room,base model method simulation io,\
                      solver/$(room)/*.c solver/$(room)/*/*.c))))
CLI_SOURCES    := $(sort $(wildcard solver/cli/*.c))
VERIFY_MAIN    := $(wildcard verification/cli/main.c)
VERIFY_SOURCES := $(filter-out $(VERIFY_MAIN),$(sort $(wildcard verification/*/*.c \
                    verification/*/*/*.c)))
BENCH_MAIN     := $(wildcard benchmarks/cli/main.c)
BENCH_SOURCES  := $(filter-out $(BENCH_MAIN),$(sort $(wildcard benchmarks/*/*.c)))
TEST_SOURCES   := $(sort $(wildcard tests/*.c $(foreach room,support benchmarks solver/* \
                    verification/*,tests/$(room)/*.c)))
PROBE_MAIN     := tests/scene_generator/nodes.c
FUZZ_SOURCES   := $(sort $(wildcard tests/fuzz/*.c))
SOURCES := $(sort $(SOLVER_SOURCES) $(FAULTS_SOURCE)) $(FAST_SOURCE) $(FAST_LAWS) $(CLI_SOURCES) $(VERIFY_SOURCES) $(VERIFY_MAIN) \
           $(BENCH_SOURCES) $(BENCH_MAIN) $(TEST_SOURCES) $(PROBE_MAIN) $(FUZZ_SOURCES)
HEADERS := $(sort $(wildcard $(foreach depth,* */* */*/* */*/*/*,$(patsubst %,%/$(depth).h,\
             solver verification benchmarks tests))))
objects  = $(patsubst %.c,$(BUILD)/objects/%.o,$(1))

# -O3 is for what runs in steps, and for exact solutions and measures. The rooms that read, write
# and draw take a third less to compile with -O1, and give the same bits.
COLD_ROOMS := $(addprefix solver/,cli io) $(addprefix benchmarks/,budget cli common groups report) \
              $(addprefix verification/,cases cli common pages programs records report score study suite)
flags_of    = $(if $(filter-out cli,$(word 2,$(subst /, ,$(filter solver/%,$(1))))),$(SHARED_FLAGS)) \
              $(if $(filter $(addsuffix /%,$(COLD_ROOMS)),$(1)),$(patsubst -O3,-O1,$(CODE_FLAGS)),\
                $(CODE_FLAGS))

# Levels of SIMD differ in instructions, not in what is written: builds that look for faults or for
# lines not covered have one.
FAST_LEVELS  := baseline $(if $(filter release,$(VARIANT)),$(if $(findstring x86_64,\
                  $(shell $(CC) -dumpmachine 2>/dev/null)),v3))
# They take longest to compile: first in every list, and the longest of them before the others.
FAST_OBJECTS := $(foreach family,cpdi bspline3 ugimp bspline2 classic,$(foreach level,$(FAST_LEVELS),\
                  $(BUILD)/objects/fast/$(family).$(level).o))
LAW_OBJECTS  := $(foreach level,$(FAST_LEVELS),$(BUILD)/objects/fast/laws.$(level).o)
# Square roots never set errno here: without that, lanes would be taken one by one. No vector
# crosses a call, so its convention is nothing to be told of: gcc's note heeds this flag alone.
# gcc looks for predictive commoning for a quarter of its time; with -g (sanitizers), it follows
# variables through these long functions for minutes. Neither is worth it. Nor is, with sanitizers,
# a search for registers loop by loop, which takes half of the time.
FAST_FLAGS    = -fno-math-errno -Wno-psabi \
                $(if $(findstring clang,$(CC)),,-fno-predictive-commoning -fno-var-tracking \
                  $(if $(filter release,$(VARIANT)),,-fira-region=one)) \
                $(FAST_FLAGS_$(1)) $(FAST_PLAIN_$(VARIANT)) -DFAST_LEVEL=$(1)
# Instrumented by clang, they take more than five minutes each; harnesses run the reference kernels.
FAST_PLAIN_fuzz := -fno-sanitize=all -O0
FAST_NAMES    = -DFAST_FAMILY=$(1) \
                -DFAST_SHAPE=MPM_$(shell echo $(1) | tr a-z A-Z) $(if $(filter cpdi,$(1)),,-DFAST_AFFINE)
# Where there is another level, the baseline is for old machines: a third less to compile counts
# more than -O3, and than two searches of gcc for equal expressions (1 % of the instructions).
FAST_FLAGS_baseline := $(if $(filter v3,$(FAST_LEVELS)),-O2 \
                         $(if $(findstring clang,$(CC)),,-fno-tree-fre -fno-gcse))
FAST_FLAGS_v3       := -march=x86-64-v3
# Manufactured solutions are evaluated for each particle and step: for v3 as well.
WIDE_OBJECTS := $(if $(filter v3,$(FAST_LEVELS)),$(patsubst verification/exact/%.c,\
                  $(BUILD)/objects/wide/%.o,$(filter verification/exact/manufactured/field_%.c \
                  verification/exact/manufactured/manufactured_motion.c,$(VERIFY_SOURCES))))
VERIFY_OBJECTS = $(call objects,$(VERIFY_SOURCES)) $(WIDE_OBJECTS)

ifneq ($(filter v3,$(FAST_LEVELS)),)
$(BUILD)/objects/solver/method/fast/fast.o $(BUILD)/objects/verification/exact/manufactured/manufactured.o: \
  CODE_FLAGS += -DMPM_FAST_V3
endif

LIBRARY  := $(BUILD)/libmpm.a
# macOS: another suffix, and the version before it.
MACOS    := $(filter Darwin,$(shell uname -s))
SONAME   := libmpm.$(if $(MACOS),$(INTERFACE).dylib,so.$(INTERFACE))
SHARED   := $(BUILD)/libmpm.$(if $(MACOS),$(VERSION).dylib,so.$(VERSION))
PROGRAMS := $(if $(CLI_SOURCES),$(BUILD)/bin/mpm) $(if $(VERIFY_MAIN),$(BUILD)/bin/mpm-verify) \
            $(if $(BENCH_MAIN),$(BUILD)/bin/mpm-bench)
TESTER   := $(BUILD)/bin/mpm-tests
PROBE    := $(BUILD)/bin/mpm-nodes

# What sources include and the makefile writes.
GENERATED := $(addprefix $(BUILD)/generated/,build_facts.h scenes.inc plots.inc)

# Commands are shown in short; V=1 shows them whole.
short = $(if $(V),,@echo '  $(1) $(2)';)

.PHONY: all
all: $(FAST_OBJECTS) $(PROGRAMS) $(LIBRARY) $(SHARED) ## build the programs, libmpm.a and libmpm.so in build/release (the default)

$(LIBRARY): $(call objects,$(SOLVER_SOURCES)) $(FAST_OBJECTS) $(LAW_OBJECTS)
	@rm -f $@
	$(call short,AR,$@)ar rcs $@ $(filter %.o,$^)

# All that a program of others can call is in the headers: what they do not declare stays hidden.
$(SHARED): $(LIBRARY)
	$(call short,LINK,$@)$(CC) $(CODE_FLAGS) -shared -o $@ \
	  $(if $(MACOS),-Wl$(comma)-install_name$(comma)@rpath/$(SONAME) -Wl$(comma)-all_load $<,\
	    -Wl$(comma)-soname$(comma)$(SONAME) \
	    $(if $(filter release debug,$(VARIANT)),-Wl$(comma)--no-undefined) \
	    -Wl$(comma)--whole-archive $< -Wl$(comma)--no-whole-archive) $(LIBS_SOLVER)

link = $(call short,LINK,$@)$(CC) $(CODE_FLAGS) -o $@ $(filter %.o %.a,$^)
$(BUILD)/bin/mpm: $(call objects,$(CLI_SOURCES)) $(LIBRARY)
	$(link) $(LIBS_SOLVER)
$(BUILD)/bin/mpm-verify: $(call objects,$(VERIFY_MAIN)) $(VERIFY_OBJECTS) $(LIBRARY)
	$(link) $(LIBS_SUITE) $(LIBS_SOLVER)
$(BUILD)/bin/mpm-bench: $(call objects,$(BENCH_MAIN) $(BENCH_SOURCES)) $(VERIFY_OBJECTS) $(LIBRARY)
	$(link) $(LIBS_SUITE) $(LIBS_SOLVER)
$(PROBE): $(call objects,$(PROBE_MAIN)) $(LIBRARY)
	$(link) $(LIBS_SOLVER)
$(TESTER): $(call objects,$(TEST_SOURCES) $(BENCH_SOURCES)) $(VERIFY_OBJECTS) $(LIBRARY)
	$(link) $(LIBS_TESTS) $(LIBS_SUITE) $(LIBS_SOLVER)

.PHONY: objects
objects: $(FAST_OBJECTS) $(LAW_OBJECTS) $(WIDE_OBJECTS) \
         $(call objects,$(filter-out $(FAST_SOURCE) $(FAST_LAWS),$(SOURCES)))
# Without code: a quarter of the time of `objects`.
.PHONY: warnings
warnings: $(GENERATED)
	@printf '%s\n' $(filter-out $(SOLVER_SOURCES) $(FAST_SOURCE) $(FAST_LAWS) $(CLI_SOURCES),$(SOURCES)) | \
	  xargs -P $(JOBS) -n 8 $(CC) -fsyntax-only $(CODE_FLAGS) $(WARNINGS) -I. -Isolver -Itests \
	  -I$(BUILD)/generated $(PACKAGE_FLAGS)
$(BUILD)/objects/%.o: %.c $(BUILD)/generated/flags.txt | $(GENERATED)
	@mkdir -p $(@D)
	$(call short,CC,$<)$(CC) $(call flags_of,$<) $(WARNINGS) $(call includes,$<) -MMD -MP -c -o $@ $<

$(FAST_OBJECTS): $(BUILD)/objects/fast/%.o: $(FAST_SOURCE) $(BUILD)/generated/flags.txt
	@mkdir -p $(@D)
	$(call short,CC,$< ($*))$(CC) $(CODE_FLAGS) $(SHARED_FLAGS) $(WARNINGS) \
	  $(call FAST_FLAGS,$(patsubst .%,%,$(suffix $*))) $(call FAST_NAMES,$(basename $*)) -Isolver \
	  -MMD -MP -c -o $@ $<

$(LAW_OBJECTS): $(BUILD)/objects/fast/laws.%.o: $(FAST_LAWS) $(BUILD)/generated/flags.txt
	@mkdir -p $(@D)
	$(call short,CC,$< ($*))$(CC) $(CODE_FLAGS) $(SHARED_FLAGS) $(WARNINGS) $(call FAST_FLAGS,$*) -Isolver \
	  -MMD -MP -c -o $@ $<

$(WIDE_OBJECTS): $(BUILD)/objects/wide/%.o: verification/exact/%.c $(BUILD)/generated/flags.txt
	@mkdir -p $(@D)
	$(call short,CC,$< (v3))$(CC) $(CODE_FLAGS) $(WARNINGS) -fno-math-errno $(FAST_FLAGS_v3) \
	  -DMANUFACTURED_LEVEL=v3 -Isolver -I. -MMD -MP -c -o $@ $<

-include $(patsubst %.o,%.d,$(call objects,$(SOURCES)) $(FAST_OBJECTS) $(LAW_OBJECTS) $(WIDE_OBJECTS))

# Facts recorded in the binary: rewritten only when they change; never a date. The
# revision is this tree's own, not that of a repository that it was unpacked into.
REVISION = $(shell test -e .git && git describe --always --dirty --abbrev=12 2>/dev/null || echo unknown)
# Two makes at work in one folder (`make check` starts one in CI) do not share the new file:
# $$$$ is the shell's number.
replace_if_changed = > $@.$$$$; cmp -s $@.$$$$ $@ && rm $@.$$$$ || mv $@.$$$$ $@
$(BUILD)/generated/flags.txt: FORCE
	@mkdir -p $(@D) $(BUILD)/bin
	@echo '$(CC) $(CODE_FLAGS) $(SHARED_FLAGS) $(WARNINGS) $(PACKAGE_FLAGS)' $(replace_if_changed)
$(BUILD)/generated/build_facts.h: FORCE
	@mkdir -p $(@D)
	@printf '#define BUILD_%s "%s"\n' VERSION '$(VERSION)' REVISION '$(REVISION)' \
	  FLAGS '$(CODE_FLAGS)' $(replace_if_changed)
# Texts that programs carry with them: scenes of `mpm new`, scripts of `mpm plot`. A row each: name,
# first line without its mark, lines.
TEXT_FILES := $(sort $(wildcard solver/cli/scenes/*.yaml solver/io/plot/*.gp))
as_rows = awk 'FNR == 1 { if (NR > 1) print "NULL}},"; name = FILENAME; sub(/.*\//, "", name); \
    sub(/\.[a-z]*$$/, "", name); first = $$0; sub(/^\# */, "", first); gsub(/["\\]/, "\\\\&", first); \
    printf "{\"%s\", \"%s\", (const char *const[]){\n", name, first } \
  { gsub(/["\\]/, "\\\\&"); print "\"" $$0 "\\n\"," } END { print "NULL}}," }'
$(BUILD)/generated/scenes.inc $(BUILD)/generated/plots.inc: FORCE
	@mkdir -p $(@D)
	@$(as_rows) $(filter $(if $(findstring scenes,$@),%.yaml,%.gp),$(TEXT_FILES)) $(replace_if_changed)
# A source that goes away must leave the library and the programs too.
$(LIBRARY) $(PROGRAMS) $(TESTER) $(PROBE): $(BUILD)/generated/sources.txt
$(BUILD)/generated/sources.txt: FORCE
	@mkdir -p $(@D)
	@echo '$(SOURCES)' $(replace_if_changed)
.PHONY: FORCE
FORCE:

# -------------------------------------------------------------------- tests
# Sanitizers slow a test down: Check's time-out is multiplied.
# GLib is not built for the thread sanitizer, and tests fork.
TEST_ENVIRONMENT_asan := CK_TIMEOUT_MULTIPLIER=5 ASAN_OPTIONS=detect_leaks=1:$(ASAN_OPTIONS)
TEST_ENVIRONMENT_san  := $(TEST_ENVIRONMENT_asan)
TEST_ENVIRONMENT_tsan := CK_TIMEOUT_MULTIPLIER=10 TSAN_OPTIONS=ignore_noninstrumented_modules=1:die_after_fork=0:$(TSAN_OPTIONS)
TEST_ENVIRONMENT_cov  := CK_TIMEOUT_MULTIPLIER=5

# Programs of others are tested from an installed copy.
INSTALLED := $(abspath $(BUILD)/installed)
.PHONY: test installed
test: $(FAST_OBJECTS) $(TESTER) $(PROGRAMS) installed ## unit tests; also VARIANT=debug|asan|ubsan|san|tsan|cov
	@MPM_TEST_PROCESSES=$(JOBS) MPM_BIN=$(abspath $(BUILD)/bin) MPM_INSTALLED=$(INSTALLED) \
	  MPM_VARIANT=$(VARIANT) MPM_CC='$(CC)' $(TEST_ENVIRONMENT_$(VARIANT)) $(TESTER)
installed: all
	@rm -rf $(INSTALLED)
	+@$(MAKE) install DESTDIR= PREFIX=$(INSTALLED) > $(BUILD)/installed.log 2>&1 || \
	  { cat $(BUILD)/installed.log; false; }

# The short tier of these two is in `make test`.
.PHONY: test-kernels
test-kernels: $(TESTER) $(PROGRAMS) ## fast kernels against reference: whole runs, all combinations
	@MPM_TEST_LONG=1 CK_RUN_SUITE=kernels $(TEST_ENVIRONMENT_$(VARIANT)) $(TESTER)
	@MPM_TEST_LONG=1 CK_RUN_SUITE=kernel_table $(TEST_ENVIRONMENT_$(VARIANT)) $(TESTER)

# Python of the system: that is what the packages of `make deps` are for.
.PHONY: test-scenes
SECONDS_OF_SCENES ?= 60
test-scenes: $(BUILD)/bin/mpm $(PROBE) ## random scenes against invariants, for SECONDS_OF_SCENES (60) or SCENES of them
	@/usr/bin/python3 -B tests/scene_generator/search.py --programs $(BUILD)/bin \
	  $(if $(SCENES),--scenes $(SCENES),--seconds $(SECONDS_OF_SCENES)) --jobs $(JOBS) \
	  $(if $(SEED),--seed $(SEED)) --output $(BUILD)/scenes

.PHONY: test-kill
KILLS ?= 60
RACES ?= 12
test-kill: $(BUILD)/bin/mpm ## runs that are killed at KILLS (60) random moments go on to the same bytes; RACES (12) of two runs into one folder
	@/usr/bin/python3 -B tests/interruption/kill.py --mpm $(BUILD)/bin/mpm --kills $(KILLS) \
	  --races $(RACES) $(if $(SEED),--seed $(SEED)) $(wildcard tests/interruption/*.yaml)

# Harnesses of libFuzzer, which is clang's. Each is linked with what its readers need of the suite.
FUZZ_SECONDS ?= 60
FUZZ_CC      ?= clang
FUZZ_TARGETS := $(patsubst tests/fuzz/fuzz_%.c,%,$(filter-out %_runs.c,\
                  $(filter tests/fuzz/fuzz_%,$(FUZZ_SOURCES))))
FUZZ_SUITE   := $(filter-out verification/programs/% verification/cli/% verification/suite/%,\
                  $(VERIFY_SOURCES)) verification/programs/table_file.c \
                $(filter benchmarks/common/% benchmarks/measuring/% benchmarks/budget/%,$(BENCH_SOURCES))
.PHONY: fuzz fuzz-programs test-fuzz
fuzz: ## harnesses of libFuzzer, with clang: build/fuzz/bin/fuzz-<target>
	+@$(MAKE) VARIANT=fuzz CC='$(FUZZ_CC)' BUILD=build/fuzz fuzz-programs
fuzz-programs: $(BUILD)/bin/mpm $(addprefix $(BUILD)/bin/fuzz-,$(FUZZ_TARGETS))
$(BUILD)/libsuite.a: $(call objects,$(FUZZ_SUITE))
	@rm -f $@
	$(call short,AR,$@)ar rcs $@ $^
$(BUILD)/bin/fuzz-%: $(BUILD)/objects/tests/fuzz/fuzz_%.o \
  $(call objects,tests/fuzz/fuzz.c tests/fuzz/fuzz_runs.c) $(BUILD)/libsuite.a $(LIBRARY)
	$(link) -fsanitize=fuzzer $(LIBS_SUITE) $(LIBS_SOLVER)
test-fuzz: ## readers of files: each harness for FUZZ_SECONDS (60) over its corpus; also FUZZ_ONLY=<target>
	+@tests/fuzz/fuzz.py check '$(FUZZ_CC)' || exit 0; $(MAKE) fuzz && \
	  tests/fuzz/fuzz.py run --seconds $(FUZZ_SECONDS) --jobs $(JOBS) $(addprefix --only ,$(FUZZ_ONLY))

# Programs whose calls on files fail as they are told to: of the build with sanitizers, or of one
# for it alone, which is quicker.
.PHONY: test-faults
FAULTS_STRIDE  ?= 1
FAULTS_VARIANT ?= faults
test-faults: ## every FAULTS_STRIDE-th (1) call on a file fails, one after the other; also FAULTS_VARIANT=san
	+@$(MAKE) VARIANT=$(FAULTS_VARIANT) BUILD=build/$(FAULTS_VARIANT) all
	@$(TEST_ENVIRONMENT_$(FAULTS_VARIANT)) /usr/bin/python3 -B tests/faults/faults.py \
	  --programs build/$(FAULTS_VARIANT)/bin \
	  --stride $(FAULTS_STRIDE) --jobs $(JOBS) $(addprefix --only ,$(SCENARIOS))

.PHONY: test-kill-suite
test-kill-suite: $(BUILD)/bin/mpm-verify ## runs of the suite that are killed at SUITE_KILLS (16) random moments go on to the same report; races
	@/usr/bin/python3 -B tests/interruption/kill_suite.py --verify $(BUILD)/bin/mpm-verify \
	  --kills $(or $(SUITE_KILLS),16) --races $(or $(SUITE_RACES),4) $(if $(SEED),--seed $(SEED))

.PHONY: test-slurm
test-slurm: $(BUILD)/bin/mpm-verify ## a part of the catalogue on a real Slurm on this machine, with kills; skipped without slurm-wlm
	@/usr/bin/python3 -B tests/slurm/campaign.py --verify $(BUILD)/bin/mpm-verify --folder $(BUILD)/slurm

.PHONY: coverage
coverage: ## unit tests with VARIANT=cov, then lines and branches covered, by gcovr
	@find build/cov -name '*.gcda' -delete 2>/dev/null || true
	+@$(MAKE) VARIANT=cov CC=gcc test
	gcovr --root . --filter solver/ --filter verification/ --filter benchmarks/ \
		  --exclude-throw-branches build/cov

# ------------------------------------------------------------- verification
# Pages of the headers go into the report where `make docs` made them and no source is newer.
API_PAGES = build/docs/html/index.html
API = $(shell [ -e $(API_PAGES) ] && \
  [ -z "$$(find $(PUBLIC_HEADERS) docs/library.md docs/Doxyfile docs/doxygen_* -newer $(API_PAGES))" ] && \
  echo --api $(dir $(API_PAGES)))
.PHONY: verify verify-full
verify: all ## the catalogue at CI size; report in build/reports/verify; V=1: a line for each check
	$(BUILD)/bin/mpm-verify run --tier ci $(if $(V),--verbose) $(API) --output build/reports/verify
verify-full: all ## the catalogue at full size; report in build/reports/verify-full
	$(BUILD)/bin/mpm-verify run --tier full $(if $(V),--verbose) $(API) --output build/reports/verify-full

.PHONY: test-browser
test-browser: all ## the report of `make verify` in headless Chromium: links, sorting, layout, axe
	@.ci/test-browser build/reports/verify $(BUILD)/bin/mpm-verify

# ------------------------------------------------------------------ mutants
.PHONY: mutants
mutants: all ## plant small bugs, one after the other: which test or check finds each; build/mutants
	tests/mutants/mutants.py run
	@if [ -e build/reports/verify/checks.jsonl ]; then \
	  $(BUILD)/bin/mpm-verify report build/reports/verify --mutants build/mutants/mutants.json; fi

# ----------------------------------------------------------------- headroom
# The catalogue with other compilers, levels of SIMD and kernels, and under sanitizers; how far each
# value keeps from the ends of its band is a page of the report. Sanitizers and the reference kernels
# take ten times as long: they run the quick variants. A check that is red somewhere ends no run: the
# judgement at the end does. The build of the baseline level has the objects that the release keeps
# for old processors.
HEADROOM := build/reports/headroom
HEADROOM_BUILDS = clang baseline $(if $(WIDE),wide) reference san
.PHONY: headroom
headroom: all ## how far values keep from their bands over builds (half an hour); a page of build/reports/verify
	+@$(MAKE) VARIANT=release BUILD=build/check/clang CC=clang build/check/clang/bin/mpm-verify
	+@$(MAKE) VARIANT=release BUILD=build/check/gcc-baseline CC=gcc FAST_LEVELS=baseline \
	  FAST_FLAGS_baseline='$(FAST_FLAGS_baseline)' build/check/gcc-baseline/bin/mpm-verify
	+@$(if $(WIDE),$(MAKE) VARIANT=release BUILD=build/check/gcc-wide CC=gcc \
	  EXTRA_FLAGS=-march=$(WIDE) build/check/gcc-wide/bin/mpm-verify)
	+@$(MAKE) VARIANT=san BUILD=build/san CC=gcc build/san/bin/mpm-verify
	@rm -rf $(HEADROOM) && mkdir -p $(HEADROOM)
	-$(BUILD)/bin/mpm-verify run --output build/reports/verify
	.ci/quick-variants build/reports/verify 0.2 2 > $(HEADROOM)/quick
	-build/check/clang/bin/mpm-verify run --output $(HEADROOM)/clang
	-build/check/gcc-baseline/bin/mpm-verify run --output $(HEADROOM)/baseline
	$(if $(WIDE),-build/check/gcc-wide/bin/mpm-verify run --output $(HEADROOM)/wide)
	-$(BUILD)/bin/mpm-verify run --kernels reference --only $(HEADROOM)/quick --output $(HEADROOM)/reference
	-$(TEST_ENVIRONMENT_san) build/san/bin/mpm-verify run --only $(HEADROOM)/quick --output $(HEADROOM)/san
	$(BUILD)/bin/mpm-verify report build/reports/verify \
	  $(foreach build,$(HEADROOM_BUILDS),--headroom $(build)=$(HEADROOM)/$(build))
	$(BUILD)/bin/mpm-verify headroom build/reports/verify

# --------------------------------------------------------------- benchmarks
.PHONY: bench
bench: all ## speed, memory, scaling, error against run time (9 to 14 min); build/reports/bench
	$(BUILD)/bin/mpm-bench run --output build/reports/bench

# ------------------------------------------------------------------- checks
CLANG_FORMAT ?= $(or $(shell command -v clang-format-14),clang-format)
CLANG_TIDY   ?= $(or $(shell command -v clang-tidy-14),clang-tidy)
CHECKS := check-format check-source check-includes check-warnings check-cppcheck check-tidy \
          check-bits check-budget check-reference check-mutants check-runner check-docs check-equations
.PHONY: check check-all $(CHECKS) format
check: ## format, lint, include directions, warnings and bits of both compilers, checksums
	+@$(MAKE) --keep-going check-all
	@echo 'make check: all passed'

check-all: $(CHECKS)
check-format:
	@$(CLANG_FORMAT) --dry-run -Werror $(SOURCES) $(HEADERS)
check-source:
	@.ci/check-source $(SOURCES) $(HEADERS)
check-includes: $(GENERATED)
	@mkdir -p build/check; : > build/check/includes
	@for file in $(SOURCES) $(HEADERS); do \
	  $(CC) $(CODE_FLAGS) -I. -Isolver -Itests -I$(BUILD)/generated $(PACKAGE_FLAGS) \
	    -x c -M -MT $$file $$file >> build/check/includes || exit 1; done
	@.ci/check-includes --self-test && .ci/check-includes < build/check/includes
# Where warnings are errors anyway (CI), the build of tests and programs is this one too.
GCC_BUILD := build/$(if $(WERROR),release,check/gcc)
.PHONY: check-gcc
check-gcc:
	+@$(MAKE) VARIANT=release BUILD=$(GCC_BUILD) CC=gcc WERROR=1 all objects
check-warnings: check-gcc
	+@$(MAKE) VARIANT=release BUILD=build/check/clang CC=clang WERROR=1 warnings build/check/clang/bin/mpm
# The file of fast kernels is read as one of those that it stands for.
LINT_FLAGS = -D_POSIX_C_SOURCE=200809L -DFAST_LEVEL=baseline $(call FAST_NAMES,ugimp)
# POSIX makes NULL a void pointer, so it may end a list of arguments: no varFuncNullUB.
check-cppcheck: $(GENERATED)
	@mkdir -p build/check/cppcheck
	@cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr \
	  --error-exitcode=1 --suppress=missingIncludeSystem \
	  --suppress=varFuncNullUB $(LINT_FLAGS) \
	  --cppcheck-build-dir=build/check/cppcheck -Isolver -I. -Itests -I$(BUILD)/generated $(SOURCES)
# States that the static analyzer follows in a function: it takes nine tenths of the time of
# clang-tidy. Its own default is 225000, for three times as long: `.ci/nightly` has it.
ANALYZER_NODES ?= 75000
check-tidy: $(GENERATED)
	@printf '%s\n' $(SOURCES) | xargs -P $(JOBS) -n 1 .ci/check-tidy $(CLANG_TIDY) \
	  -std=c11 -Xclang -analyzer-config -Xclang max-nodes=$(ANALYZER_NODES) $(LINT_FLAGS) \
	  -I. -Isolver -Itests -I$(BUILD)/generated $(PACKAGE_FLAGS) --
# The compilers and, where this machine runs it, another level of SIMD.
WIDE := $(shell grep -qsw avx2 /proc/cpuinfo && echo x86-64-v3)
check-bits: check-warnings
	+@$(if $(WIDE),$(MAKE) VARIANT=release BUILD=build/check/gcc-wide CC=gcc WERROR=1 \
	  EXTRA_FLAGS=-march=$(WIDE) build/check/gcc-wide/bin/mpm)
	@.ci/check-bits $(addsuffix /bin/mpm,$(GCC_BUILD) build/check/clang \
	  $(if $(WIDE),build/check/gcc-wide))
# Always the gcc release build, whatever compiler and variant are asked for.
check-budget: check-gcc ## instructions, branches and bytes of small runs against their budget
	@$(GCC_BUILD)/bin/mpm-bench budget
check-reference:
	@$(if $(wildcard reference_data),cd reference_data && sha256sum --quiet -c MANIFEST.sha256)

# A mutant whose lines have changed no longer applies: whoever changes them mends it.
check-mutants:
	@tests/mutants/mutants.py check

# The table of MathML is made with blahtexml and committed, so that a report needs no converter.
.PHONY: equations
equations: ## reports/equations.json: MathML of the TeX in the cases' texts
	@.ci/equations
check-equations:
	@.ci/equations --check

# The unit tests' own runner, with suites that crash, hang, leak, leave and fail.
check-runner:
	@.ci/check-runner $(CC)

check-docs: docs

format: ## rewrite the sources in the house format
	$(CLANG_FORMAT) -i $(SOURCES) $(HEADERS)

# ------------------------------------------------------------ install, help
SHARE := $(DESTDIR)$(PREFIX)/share/touchstone
# Where the shells look for completion, below share/.
COMPLETIONS := bash-completion/completions zsh/site-functions fish/vendor_completions.d
LIB   := $(DESTDIR)$(PREFIX)/lib
# Command lines, calls on files and gnuplot are for the project's own programs: no interface for others.
PUBLIC_HEADERS := $(filter-out $(patsubst %,solver/mpm_%.h,commands expression file gnuplot hdf5 words),$(sort $(wildcard solver/mpm*.h)))
.PHONY: install help
install: all ## programs, headers, libmpm (static, shared, touchstone.pc), man pages, completion, catalogue, examples into PREFIX (/usr/local), under DESTDIR
	install -d $(addprefix $(DESTDIR)$(PREFIX)/,bin include lib/pkgconfig share/man/man1) \
	  $(SHARE)/benchmarks
	install $(PROGRAMS) $(DESTDIR)$(PREFIX)/bin
	install -m 644 $(wildcard docs/man/*.1) $(DESTDIR)$(PREFIX)/share/man/man1
	install -m 644 $(PUBLIC_HEADERS) $(DESTDIR)$(PREFIX)/include
	install -m 644 $(LIBRARY) $(LIB)
	install $(SHARED) $(LIB)
	ln -sf $(notdir $(SHARED)) $(LIB)/$(SONAME)
	ln -sf $(SONAME) $(LIB)/libmpm.$(if $(MACOS),dylib,so)
	sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' -e 's|@PACKAGES@|$(PACKAGES_SOLVER)|' \
	  solver/touchstone.pc.in > $(LIB)/pkgconfig/touchstone.pc
	install -d $(addprefix $(DESTDIR)$(PREFIX)/share/,$(COMPLETIONS))
	$(foreach name,$(notdir $(PROGRAMS)),\
	  $(BUILD)/bin/$(name) completion bash > $(DESTDIR)$(PREFIX)/share/bash-completion/completions/$(name) && \
	  $(BUILD)/bin/$(name) completion zsh > $(DESTDIR)$(PREFIX)/share/zsh/site-functions/_$(name) && \
	  $(BUILD)/bin/$(name) completion fish > $(DESTDIR)$(PREFIX)/share/fish/vendor_completions.d/$(name).fish &&) true
	$(foreach folder,$(wildcard verification/catalogue reports reference_data examples),cp -R $(folder) $(SHARE)/ &&) true
	cp -R benchmarks/scenes benchmarks/budget.json $(SHARE)/benchmarks/

# Pages of the public headers. A function without a comment and a reference that leads nowhere are
# errors; members, constants and structs may speak for themselves.
PLAIN_NAMES := [(](variable|enumeration|enumvalue|macro definition)[)] of|Compound .* is not documented
DOXYGEN ?= doxygen
.PHONY: docs
docs: ## pages of the library's headers, by Doxygen; build/docs/html; `make verify` takes them into its report
	@if command -v $(DOXYGEN) >/dev/null; then rm -rf build/docs && mkdir -p build/docs && \
	  { cat docs/Doxyfile; echo 'INPUT += $(PUBLIC_HEADERS)'; echo 'OUTPUT_DIRECTORY = build/docs'; \
	    echo 'PROJECT_NUMBER = $(VERSION)'; } | $(DOXYGEN) - && ! grep -Ev '$(PLAIN_NAMES)' build/docs/warnings && \
	  echo 'build/docs/html/index.html'; \
	else echo 'make docs: skipped, no $(DOXYGEN) here (make deps installs it)'; fi

help: ## this list
	@awk -F ': .*## |: ## ' '/^[a-z-]+: .*## /{printf "make %-12s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

.PHONY: deps clean
deps: ## install the system packages (Debian, Ubuntu, Fedora, Homebrew)
	@.ci/install-packages
clean: ## remove everything built
	rm -rf build

endif
