# SPDX-License-Identifier: GPL-3.0-or-later
# Tests, checks, fuzzing and measurements. The Makefile includes this file.

# What each goal needs, besides what the program needs.
DEPS_test     := dpkg-dev lintian libcmocka-dev bats expect tmux libmpfr-dev gnuplot-nox pkgconf libxml2-utils poppler-utils jq python3 python3-numpy python3-pandas
$(foreach goal,quick unit hard sessions sanitize race removable,$(eval DEPS_$(goal) := $(DEPS_test)))
DEPS_faults   := bats expect gnuplot-nox binutils util-linux
DEPS_valgrind := valgrind libc6-dbg
DEPS_cross    := python3 qemu-user gcc-aarch64-linux-gnu libc6-dev-arm64-cross gcc-i686-linux-gnu libc6-dev-i386-cross
DEPS_fuzz     := clang libclang-rt-dev
DEPS_bench    := bc gnuplot-nox binutils
DEPS_guard    := valgrind
DEPS_verify   := libchipmunk-dev
DEPS_atlas    := python3
DEPS_abi      := python3
DEPS_lint     := python3 musl-tools clang clang-format clang-tidy mandoc shellcheck hunspell hunspell-en-gb libcmocka-dev libmpfr-dev $(DEPS_verify)

# ---- Tests ----

# In a build without some features, tests that need them are left out: programs with a line 'Needs: NAMES', and sessions
# with a tag. The tag 'whole' is for sessions that need every feature.
NAMED   := $(sort $(shell sed -nE 's|^# bats .*_tags=||p; s|^/\* Needs: (.*) \*/|\1|p' tests/*/*.bats tests/*/*.c | tr ',' ' '))
GONE    := $(filter-out $(BUILT) $(JOINT) whole,$(sort $(NAMED) $(EVERY) $(PART)))
LACK     = $(if $(GONE),$(shell grep -lE 'Needs:.*\<(whole|$(subst $(eval) ,|,$(GONE)))\>' $(1)))
WITHOUT := $(if $(GONE),$(subst $(eval) ,$(,),!whole $(GONE:%=!%)))
export WITHOUT
UNIT    := $(filter-out $(call LACK,$(wildcard tests/unit/test_*.c)),$(wildcard tests/unit/test_*.c))

# Tests of the library ask it in each precision, as the shell does.
ANY       := src/shell/precision/any.c
UNIT_MORE := $(filter-out tests/unit/test_%,$(wildcard tests/unit/*.c))
$(P)/unit/%: $(B)/obj/tests/unit/%.o $(call OBJ,$(UNIT_MORE) $(ANY)) $(P)/libdomino.a
	$(call LINK,$(GSL) -lcmocka)

# These tests include the sources of the model in double, beside those in the library.
$(addprefix $(P)/unit/test_,chain numerics study verdicts): LDFLAGS += -Wl,-z,muldefs
$(addprefix $(B)/obj/tests/unit/test_,chain.o numerics.o proof.o study.o verdicts.o): C_FLAGS += -include $(B)/library.h
# This test can make allocations and threads fail.
$(P)/unit/test_corners: LDFLAGS += -Wl,--wrap=malloc,--wrap=calloc,--wrap=pthread_create
# This test counts the checks for an interrupt.
$(P)/unit/test_interrupt: LDFLAGS += -Wl,--wrap=dom_interrupted
# So does this one, for the shell.
$(P)/unit/test_stops: LDFLAGS += -Wl,--wrap=dom_interrupted,--wrap=domq_lean_limits
# Unit tests of the shell: numbers.
$(P)/unit/test_digits: $(call OBJ,$(addprefix src/shell/,language/quad.c answer/cell.c))
# Completion and other functions that need the tables of commands. The library starts no threads, so the thread pool of
# the shell runs its tasks in the tests 'corners' and 'workers'.
SHELL_UNIT := $(addprefix $(P)/unit/test_,complete corners csv errors lines stage stops workers)
$(SHELL_UNIT): $(filter-out %/src/main.o,$(call OBJ,$(SHELL_C) $(ENGINE_C))) $(P)/features.o
$(SHELL_UNIT): GSL := $(P)/libdomino.a $(GSL) -lreadline
# Rows in the rigid-body engine.
$(P)/unit/test_engine: $(call OBJ,$(ENGINE_C))

UNIT_BIN := $(patsubst tests/unit/%.c,$(P)/unit/%,$(UNIT))
# Tests convert results of the widest type to double to compare them, so warnings about such conversions are off.
$(B)/obj/tests/%: C_FLAGS += -Wno-float-conversion -Wno-implicit-float-conversion -Wno-conversion
.SECONDARY: $(call OBJ,$(wildcard tests/unit/*.c tests/hard/*.c tests/verify/*.c)) $(UNIT_BIN)

# Hard cases and sweeps, compared with a reference in MPFR. The other files of tests/hard are linked into each
# test_*.c.
HARD     := $(wildcard tests/hard/*.c)
HARD_BIN := $(patsubst tests/hard/%.c,$(P)/hard/%,$(filter-out $(call LACK,$(HARD)),$(wildcard tests/hard/test_*.c)))
$(P)/hard/%: $(B)/obj/tests/hard/%.o $(call OBJ,tests/unit/suite.c $(ANY) $(filter-out tests/hard/test_%,$(HARD))) $(P)/libdomino.a
	$(call LINK,$(GSL) -lmpfr -lgmp -lcmocka)

# Each suite is a target that always runs the suite and writes its counts: suites run in parallel, the
# longest first. A suite that fails does not stop the others. The counts are added up at the end.
COUNTS_OF   = $(patsubst %,$(P)/tap/%.count,$(patsubst tests/%,%,$(patsubst $(P)/%,%,$(1))))
BATS       := $(foreach name,package terminal prompt,tests/shell/$(name).bats)
BATS       += $(filter-out $(BATS),$(wildcard $(patsubst %,tests/%/*.bats,shell $(BUILT))))
UNIT_RUN    = $(call COUNTS_OF,$(UNIT_BIN))
HARD_RUN    = $(call COUNTS_OF,$(HARD_BIN))
.SECONDARY: $(HARD_BIN)
SHELL_RUN   = $(call COUNTS_OF,$(BATS))
$(P)/tap/unit/%.count: $(P)/unit/% FORCE
	@tests/run --suite $(P) $<
$(P)/tap/hard/%.count: $(P)/hard/% FORCE
	@tests/run --suite $(P) $<
$(P)/tap/shell/package.bats.count $(P)/tap/shell/python.bats.count: $(if $(PART),,python)
$(P)/tap/%.bats.count: tests/%.bats all FORCE
	@tests/run --suite $(P) $<

# Runs the quick tests: the unit tests, the short sessions, and a twentieth of the points of the sweeps.
QUICK_HARD := $(filter %/test_sweep %/test_properties,$(HARD_BIN))
QUICK_BATS := $(filter $(patsubst %,tests/%.bats,shell/output train/count train/growth train/effects rows/rows train/precision pictures/draw train/cycle),$(BATS))
QUICK_RUN   = $(call COUNTS_OF,$(QUICK_HARD) $(QUICK_BATS)) $(UNIT_RUN)

quick: export SWEEP_SIZE := 0.05
quick: $(QUICK_RUN)
test: $(HARD_RUN) $(SHELL_RUN) $(UNIT_RUN)
unit: $(UNIT_RUN)
hard: $(HARD_RUN)
sessions: $(SHELL_RUN)
quick test unit hard sessions:
	@tests/run --sum $^

# Takes each feature away, with what needs it, and runs the tests that are left. 'make removable REMOVED="centre fit"'
# tests only these; 'centre' takes all away, and 'turn' the feature whose turn it is: the number of commits modulo the
# number of features says which. With LEFT=all, no tests run.
REMOVABLE := $(filter-out $(JOINT) train,$(EVERY))
REMOVED   ?= centre $(REMOVABLE)
LEFT      ?= unit sessions
left_by    = $(foreach f,$(REMOVABLE),$(if $(filter centre,$(1))$(filter $(1),$(call with_needs,$f)),,$f))
TURN       = $(word $(shell echo $$(($$(git rev-list --count HEAD 2>/dev/null || echo 0) % $(words $(REMOVABLE)) + 1))),$(REMOVABLE))
removable: $(patsubst %,without-%,$(patsubst turn,$(TURN),$(REMOVED)))
# Two builds at a time share the objects of tests, which are therefore compiled first.
without-%: all $(if $(filter unit,$(LEFT)),$(call OBJ,$(wildcard tests/unit/*.c)))
	@echo '  WITHOUT  $*'
	+@$(MAKE) --no-print-directory P=$(B)/without/$* FEATURES='$(call left_by,$*)' $(LEFT)
	@tests/names $(P)/domino $(B)/without/$*/domino

# Compares rows with Chipmunk, a rigid-body engine. Fails if they differ.
VERIFY := $(wildcard tests/verify/*.c)
$(B)/verify_rows: $(call OBJ,$(VERIFY) $(ENGINE_C) $(ANY) tests/hard/workers.c) $(P)/libdomino.a
	$(call LINK,$(GSL))

verify: $(B)/verify_rows
	@$(B)/verify_rows

# Makes the table of proved growths. Then tests/atlas checks the table by other means, which
# takes a minute. Every run gives the same bytes.
atlas: all
	@echo '  ATLAS  examples/atlas.csv'
	@{ sed -n '/^# Proved/,/^$$/p' examples/atlas.dom | grep '^#' && $(P)/domino -n -f examples/atlas.dom; } > $(B)/atlas.csv
	@tests/atlas $(B)/atlas.csv
	@cp $(B)/atlas.csv examples/atlas.csv

# Runs the unit tests and 300 answers on other processors, under qemu.
CROSS := aarch64-linux-gnu i686-linux-gnu
cross: | $(FIRST)
	+@for machine in $(CROSS); do tests/cross $(B)/cross $$machine || exit 1; done

# Tests what happens when memory runs out, disks are full, streams are closed, readers or writers are missing, and
# signals arrive at the wrong moment.
FAULTS := $(wildcard tests/faults/*.bats)
faults: all $(B)/faults/fail_alloc.so
	@tests/run $(B) $(FAULTS)

$(B)/faults/%.so: tests/faults/%.c | $(FIRST)
	@mkdir -p $(@D)
	$(call SAY,LD,$@)
	$(Q)$(CC) -std=c17 -D_GNU_SOURCE $(WARN) -O2 -fPIC -shared $< -o $@

# Runs the following under sanitizers: the unit tests, three suites of hard cases, and the sessions that read lines and
# files and store rows. A leak is a failure. The examples run in 'make valgrind' instead, and every command in 'make
# fuzz'. Then tests/coverage counts the lines of the model that the tests have run. With -g1, which records only lines,
# gcc takes half as long.
SANITIZED := $(patsubst %,tests/%.bats,pictures/draw rows/rowfiles $(addprefix shell/,prompt complete escape expressions files fifo lines \
  names options settings undo variables) save/save)
sanitize: | $(FIRST)
	@find $(B)/sanitize -name '*.gcda' -delete 2>/dev/null || :
	@LDFLAGS=--coverage $(MAKE) --no-print-directory B=$(B)/sanitize BATS='$(SANITIZED)' HARD_BIN='$(patsubst %,$(B)/sanitize/hard/test_%,proof properties sweep)' COVER=--coverage \
	  CC=gcc CFLAGS='-O1 -g1 -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer' test
	@tests/coverage $(B)/sanitize 95

valgrind: all
	@tests/valgrind $(B)
# Runs the parallel sessions under ThreadSanitizer.
race: | $(FIRST)
	@$(MAKE) --no-print-directory B=$(B)/race CFLAGS='-O1 -g -fsanitize=thread' all
	@TSAN_OPTIONS=halt_on_error=1 tests/run $(B)/race tests/sweeps/sweep.bats

# ---- Fuzzing and speed ----

# Runs the line interpreter under libFuzzer, ASan and UBSan, first on bytes from a seeded corpus, and then on
# grammatical lines that are generated from the tables of commands. Also runs the reader of csv files. FUZZ_SHOW=1
# shows the lines of an input for the grammar.
FUZZ_SECONDS ?= 600
FUZZ         := fuzz_line fuzz_grammar fuzz_csv
FUZZ_RUN     := -seed=1 -timeout=60 -rss_limit_mb=2048 -close_fd_mask=3 -artifact_prefix=$(abspath $(B))/fuzz/ \
                -print_final_stats=1
FUZZ_FLAGS   := -O1 -g1 -Wno-double-promotion -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all
fuzz: | $(FIRST)
	$(Q)$(MAKE) --no-print-directory B=$(B)/fuzz CC=clang CFLAGS='$(FUZZ_FLAGS) -fsanitize=fuzzer-no-link' \
	  $(FUZZ:%=$(B)/fuzz/%)
	$(Q)rm -rf $(B)/fuzz/corpus $(B)/fuzz/lines $(B)/fuzz/tables && cp -r tests/fuzz/corpus $(B)/fuzz/corpus && mkdir $(B)/fuzz/lines $(B)/fuzz/tables
	$(B)/fuzz/fuzz_line $(FUZZ_RUN) -max_total_time=$(FUZZ_SECONDS) -max_len=400 -dict=tests/fuzz/words.dict $(B)/fuzz/corpus
	$(B)/fuzz/fuzz_grammar $(FUZZ_RUN) -max_total_time=$(FUZZ_SECONDS) -max_len=300 -len_control=0 $(abspath $(B))/fuzz/lines
	$(B)/fuzz/fuzz_csv $(FUZZ_RUN) -max_total_time=$(FUZZ_SECONDS) -max_len=400 -dict=tests/fuzz/csv.dict $(abspath $(B))/fuzz/tables

$(FUZZ:%=$(B)/%): $(B)/%: $(B)/obj/tests/fuzz/%.o $(B)/obj/tests/fuzz/session.o $(filter-out %/src/main.o,$(call OBJ,$(ENGINE_C) $(SHELL_C)) $(P)/features.o) $(P)/libdomino.a
	$(call SAY,LD,$@)
	$(Q)$(CC) $(C_FLAGS) -fsanitize=fuzzer $^ $(GSL) -lreadline -o $@

# Times the main questions in one run, and compares their times with goals, most of which are ratios to other programs.
bench: all $(B)/bench
	@$(B)/bench $(B)

$(B)/bench: $(call OBJ,tests/bench/bench.c $(ANY)) $(P)/libdomino.a
	$(call LINK,$(GSL))

# Compares the numbers of instructions of questions with tests/bench/instructions.csv. 'make guard KEEP=1' writes that
# file again.
guard: all
	@echo '$(CFLAGS)' > $(B)/flags
	@KEEP=$(KEEP) tests/bench/guard $(B)

# ---- Checks ----

# Compares the binary interface with the interface of the first library that had this soname.
abi: $(B)/python/domino/_api.py
	@$(if $(KEEP),tests/abi/check $< > tests/abi/$(SONAME).txt)
	@tests/abi/check tests/abi/$(SONAME).txt $<

C_FILES := $(wildcard examples/*.c src/*.c src/*/*.c src/*/*/*.c src/*/*/*/*.c tests/unit/*.c) $(HARD) $(VERIFY) $(wildcard tests/bench/*.c tests/fuzz/*.c tests/faults/*.c)
PAGES   := $(wildcard man/*.[1-9])
H_FILES := $(wildcard include/*.h src/*/*.h src/*/*/*.h src/*/*/*/*.h tests/*/*.h)

LINT_BIN := $(UNIT_BIN) $(HARD_BIN) $(B)/bench $(B)/verify_rows

# Compiles everything with gcc, with warnings as errors. This takes a separate folder, since make does not know which
# objects were compiled with warnings, unless WERROR=1 is set. Clang then only checks the sources. Its warning about
# promotions is off, because results leave a kernel by an exact conversion to the widest type. gcc checks promotions
# from float to double.
STRICT_B   := $(B)$(if $(WERROR),,/strict)
CLANG_READ := clang -fsyntax-only $(STD) $(WARN) -Werror -Wno-double-promotion $(INCLUDES)
MUSL_READ  := musl-gcc -fsyntax-only $(STD) $(WARN) -Wno-conversion -Werror $(INCLUDES) -idirafter /usr/include
DOUBLE     := $(filter-out %/float.c %/quad.c,$(MODEL))
SHALLOW    := $(addprefix --extra-arg=,-Xclang -analyzer-config -Xclang mode=shallow)
CHECKED    := $(DOUBLE) $(ENGINE_C) $(SHELL_C) $(wildcard examples/*.c)
lint: $(HEADERS) | $(FIRST)
	clang-format --dry-run -Werror $(C_FILES) $(H_FILES)
	$(MAKE) --no-print-directory B=$(STRICT_B) WERROR=1 all $(patsubst $(B)/%,$(STRICT_B)/%,$(LINT_BIN))
	printf '%s\n' $(DOUBLE) $(ENGINE_C) $(SHELL_C) | xargs -P $$(nproc) -n 8 $(CLANG_READ)
	$(CLANG_READ) -DDOMF $(TRAIN)/precision/float.c
	$(CLANG_READ) -DDOMQ $(TRAIN)/precision/quad.c
	@# The library with the C library musl.
	printf '%s\n' $(DOUBLE) | xargs -P $$(nproc) -n 4 $(MUSL_READ)
	$(MUSL_READ) -DDOMF $(TRAIN)/precision/float.c
	$(MUSL_READ) -DDOMQ $(TRAIN)/precision/quad.c
	printf '%s\n' $(filter-out tests/fuzz/%,$(filter tests/%,$(C_FILES))) | xargs -P $$(nproc) -n 8 $(CLANG_READ) -Wno-conversion
	@# clang-tidy reads the source of the kernels once, as the kernel in double. The shallow mode of the analyzer takes a
	@# quarter of the time of the deep one, which is most of the time of 'make lint'.
	printf '%s\n' $(CHECKED) | xargs -P $$(nproc) -n 4 sh -c 'clang-tidy --quiet $(SHALLOW) "$$@" -- $(STD) $(INCLUDES)' clang-tidy
	$(MAKE) --no-print-directory abi KEEP=
	tests/layers $(STRICT_B)
	tests/equations
	mandoc -T lint -W warning $(PAGES)
	tests/spelling README.md src/README.md $(PAGES)
	grep -rlE '^#! ?/.*/(env )?(ba)?sh|^# shellcheck' .ci .packaging examples src tests | grep -v '\.bats$$' | xargs shellcheck

format:
	clang-format -i $(C_FILES) $(H_FILES)

