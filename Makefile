# Touchstone: the only makefile. Everything is built in build/<variant>/.
# `make help` lists the targets.
# SPDX-License-Identifier: GPL-3.0-or-later

VERSION  := 0.1.0
VARIANT  ?= release
BUILD    := build/$(VARIANT)
PREFIX   ?= /usr/local
CC       := $(if $(filter default,$(origin CC)),gcc,$(CC))

# ---------------------------------------------------------------- toolchain
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion \
            -Wstrict-prototypes -Wmissing-prototypes -Wvla -Wswitch-enum $(if $(WERROR),-Werror)
FLAGS_release := -O3
FLAGS_debug   := -O0 -g3
FLAGS_asan    := -O1 -g -fsanitize=address -fno-omit-frame-pointer
FLAGS_ubsan   := -O1 -g -fsanitize=undefined -fno-sanitize-recover=all
FLAGS_tsan    := -O1 -g -fsanitize=thread
FLAGS_cov     := -O0 -g --coverage
$(if $(filter undefined,$(origin FLAGS_$(VARIANT))),$(error VARIANT=$(VARIANT): allowed are release debug asan ubsan tsan cov))

# Contraction is off so that every compiler and SIMD level gives the same bits.
CODE_FLAGS := -std=c11 -D_POSIX_C_SOURCE=200809L $(FLAGS_$(VARIANT)) -ffp-contract=off -fopenmp $(EXTRA_FLAGS)

PACKAGES_SOLVER := hdf5 libcyaml yaml-0.1 muparser glib-2.0 jansson
PACKAGES_SUITE  := gsl libcmark-gfm
PACKAGES_TESTS  := check
pkg_cflags = $(patsubst -I%,-isystem %,$(shell pkg-config --cflags $(1)))
pkg_libs   = $(shell pkg-config --libs $(1))

INCLUDES := -Isolver -I$(BUILD)/generated $(call pkg_cflags,$(PACKAGES_SOLVER) $(PACKAGES_SUITE) $(PACKAGES_TESTS))
LIBS_SOLVER := $(call pkg_libs,$(PACKAGES_SOLVER)) -lm
LIBS_SUITE  := $(call pkg_libs,$(PACKAGES_SUITE)) -lcmark-gfm-extensions
LIBS_TESTS  := $(call pkg_libs,$(PACKAGES_TESTS))

# ------------------------------------------------------------------ sources
SOLVER_SOURCES := $(wildcard solver/base/*.c solver/model/*.c solver/method/*.c solver/simulation/*.c solver/io/*.c)
CLI_SOURCES    := $(wildcard solver/cli/*.c)
VERIFY_SOURCES := $(wildcard verification/exact/*.c verification/measures/*.c verification/suite/*.c)
VERIFY_MAIN    := verification/suite/main.c
TEST_SOURCES   := $(wildcard tests/*.c tests/support/*.c)
objects = $(patsubst %.c,$(BUILD)/objects/%.o,$(1))

LIBRARY  := $(BUILD)/libmpm.a
PROGRAMS := $(BUILD)/bin/mpm $(if $(wildcard $(VERIFY_MAIN)),$(BUILD)/bin/mpm-verify)
TESTER   := $(BUILD)/bin/mpm-tests

.PHONY: all
all: $(PROGRAMS) $(LIBRARY)

$(LIBRARY): $(call objects,$(SOLVER_SOURCES))
	@mkdir -p $(@D)
	@rm -f $@
	ar rcs $@ $^

$(BUILD)/bin/mpm: $(call objects,$(CLI_SOURCES)) $(LIBRARY)
	@mkdir -p $(@D)
	$(CC) $(CODE_FLAGS) -o $@ $^ $(LIBS_SOLVER)

$(BUILD)/bin/mpm-verify: $(call objects,$(VERIFY_SOURCES)) $(LIBRARY)
	@mkdir -p $(@D)
	$(CC) $(CODE_FLAGS) -o $@ $^ $(LIBS_SUITE) $(LIBS_SOLVER)

$(TESTER): $(call objects,$(TEST_SOURCES) $(filter-out $(VERIFY_MAIN),$(VERIFY_SOURCES))) $(LIBRARY)
	@mkdir -p $(@D)
	$(CC) $(CODE_FLAGS) -o $@ $^ $(LIBS_TESTS) $(LIBS_SUITE) $(LIBS_SOLVER)

$(BUILD)/objects/%.o: %.c $(BUILD)/generated/flags.txt
	@mkdir -p $(@D)
	$(CC) $(CODE_FLAGS) $(WARNINGS) $(INCLUDES) $(INCLUDES_$(firstword $(subst /, ,$*))) -MMD -MP -c -o $@ $<

INCLUDES_verification := -I.
INCLUDES_tests        := -I. -Itests

-include $(shell find $(BUILD)/objects -name '*.d' 2>/dev/null)

# Facts recorded in the binary: rewritten only when they change; never a date.
REVISION := $(shell git describe --always --dirty --abbrev=12 2>/dev/null || echo unknown)
FACTS := CC=$(CC) $(CODE_FLAGS) $(WARNINGS)
$(BUILD)/generated/flags.txt: FORCE
	@mkdir -p $(@D)
	@echo '$(FACTS)' | cmp -s - $@ || echo '$(FACTS)' > $@
$(BUILD)/generated/build_facts.h: FORCE
	@mkdir -p $(@D)
	@printf '#define BUILD_VERSION "%s"\n#define BUILD_REVISION "%s"\n#define BUILD_FLAGS "%s"\n' \
	  '$(VERSION)' '$(REVISION)' '$(CODE_FLAGS)' > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@
$(BUILD)/objects/solver/io/build_info.o: $(BUILD)/generated/build_facts.h
.PHONY: FORCE
FORCE:

# -------------------------------------------------------------------- tests
.PHONY: test
test: $(TESTER) $(PROGRAMS)
	MPM_BIN=$(BUILD)/bin $(TESTER)

# ------------------------------------------------------------- verification
.PHONY: verify verify-full
verify: all
	$(BUILD)/bin/mpm-verify run --tier ci --output build/reports/verify
verify-full: all
	$(BUILD)/bin/mpm-verify run --tier full --output build/reports/verify

.PHONY: clean
clean:
	rm -rf build
