# SPDX-License-Identifier: GPL-3.0-or-later
#
#   make deps run     install what is missing (Debian), build, open the calculator
#   make deps test    the same, and run the tests
#   make              .build/domino and .build/libdomino.a
#   make install      program, library, man page, examples; PREFIX= and DESTDIR= as usual
#   make lint         compilers, formatter and checkers; make sanitize: the tests under ASan and UBSan;
#                     make race: what runs on threads under ThreadSanitizer

VERSION := $(shell sed -n 's/^\#define DOM_VERSION "\(.*\)"/\1/p' include/domino.h)
PREFIX  ?= /usr/local
DESTDIR ?=
B       ?= .build

CC      ?= gcc
OBJCOPY ?= objcopy
OPTIM   ?= -O2 -g
WARN    := -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes -Wvla
CFLAGS  ?= $(OPTIM)
# Every digit is to be the same on every machine: no contraction, never -ffast-math.
C_FLAGS := -std=c17 $(WARN) -ffp-contract=off -D_GNU_SOURCE -Iinclude -Isrc/model $(CFLAGS)
GSL     := -lgsl -lgslcblas -lm -pthread

# The other files of src/model are the source of the kernels, which precision/*.c include.
MODEL   := src/model/model.c src/model/train.c src/model/placement.c src/model/quiet.c \
           $(wildcard src/model/effects/*.c src/model/precision/*.c src/model/methods/*.c)
SHELL_C := $(wildcard src/shell/*.c)
UNIT    := $(wildcard tests/unit/test_*.c)
# 'make V=1' shows the commands.
Q        = $(if $(V),,@)
SAY      = @$(if $(V),:,echo '  $(1)  $(2)')
OBJ      = $(patsubst %.c,$(B)/obj/%.o,$(1))

.PHONY: all run test unit hard sessions sanitize race fuzz bench deps lint format install uninstall clean
all: $(B)/domino $(B)/libdomino.a $(B)/domino.pc $(B)/domino-effects.7

# ---- Dependencies: only what the goals of this call need ----

DEPS_RUN  := libgsl-dev libreadline-dev
DEPS_TEST := libcmocka-dev bats expect tmux libmpfr-dev gnuplot-nox parallel
DEPS_LINT := clang clang-format clang-tidy cppcheck mandoc shellcheck
DEPS_FUZZ := clang libclang-rt-dev
NEEDED    := $(DEPS_RUN) $(if $(filter test unit hard sessions sanitize race,$(MAKECMDGOALS)),$(DEPS_TEST)) \
             $(if $(filter lint,$(MAKECMDGOALS)),$(DEPS_LINT) libcmocka-dev libmpfr-dev) \
             $(if $(filter fuzz,$(MAKECMDGOALS)),$(DEPS_FUZZ)) $(if $(filter bench,$(MAKECMDGOALS)),bc)

deps:
	@missing=; for p in $(NEEDED); do \
	  dpkg-query -W -f='$${Status}\n' $$p 2>/dev/null | grep -q 'ok installed' || missing="$$missing $$p"; \
	done; \
	[ -z "$$missing" ] && exit 0; \
	echo "installing:$$missing"; \
	command -v apt-get >/dev/null || { echo "make deps knows Debian's apt-get only; install:$$missing" >&2; exit 1; }; \
	if [ "$$(id -u)" = 0 ]; then as=; elif command -v sudo >/dev/null; then as=sudo; \
	else echo "make deps needs root or sudo to install:$$missing" >&2; exit 1; fi; \
	$$as apt-get update -qq && \
	$$as env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $$missing >/dev/null

# In 'make deps test' nothing is compiled before the headers are there.
FIRST := $(filter deps,$(MAKECMDGOALS))

# ---- Program and library ----

$(B)/obj/%.o: %.c | $(FIRST)
	@mkdir -p $(@D)
	$(call SAY,CC,$<)
	$(Q)$(CC) $(C_FLAGS) -MMD -MP -c $< -o $@

# The library shows no other names than dom_*.
$(B)/libdomino.a: $(call OBJ,$(MODEL))
	$(call SAY,AR,$@)
	$(Q)rm -f $@
	$(Q)$(LD) -r -o $(B)/domino.o $^
	$(Q)$(OBJCOPY) --wildcard --keep-global-symbol='dom_*' $(B)/domino.o
	$(Q)$(AR) rcs $@ $(B)/domino.o

$(B)/domino: $(call OBJ,$(SHELL_C)) $(B)/libdomino.a
	$(call SAY,LD,$@)
	$(Q)$(CC) $(C_FLAGS) $(LDFLAGS) $^ $(GSL) -lreadline -o $@

# The manual of effects comes from the effects themselves.
$(B)/domino-effects.7: $(B)/domino
	@$(B)/domino -n -e manual > $@

$(B)/domino.pc: include/domino.h Makefile
	@mkdir -p $(@D)
	@printf '%s\n' 'prefix=$(PREFIX)' 'includedir=$${prefix}/include' 'libdir=$${prefix}/lib' '' \
	  'Name: domino' 'Description: How far can a domino train grow?' 'Version: $(VERSION)' \
	  'Requires: gsl' 'Libs: -L$${libdir} -ldomino -pthread' 'Cflags: -I$${includedir}' > $@

run: all
	@$(B)/domino

# ---- Tests ----

UNIT_MORE := $(filter-out $(UNIT),$(wildcard tests/unit/*.c))
$(B)/unit/%: $(B)/obj/tests/unit/%.o $(call OBJ,$(UNIT_MORE)) $(B)/libdomino.a
	@mkdir -p $(@D)
	$(call SAY,LD,$@)
	$(Q)$(CC) $(C_FLAGS) $(LDFLAGS) $^ $(GSL) -lcmocka -o $@

# How the shell writes numbers is tested as a unit, too.
$(B)/unit/test_decimal: $(call OBJ,$(addprefix src/shell/,decimal.c wide.c cell.c))

UNIT_BIN := $(patsubst tests/unit/%.c,$(B)/unit/%,$(UNIT))
# Tests compare in double what the library gives in its widest type.
$(B)/obj/tests/%: C_FLAGS += -Wno-float-conversion -Wno-implicit-float-conversion -Wno-conversion
.SECONDARY: $(call OBJ,$(wildcard tests/unit/*.c tests/hard/*.c))

# Hard cases and sweeps against a reference in MPFR: what test_*.c there share is linked into each.
HARD     := $(wildcard tests/hard/*.c)
HARD_BIN := $(patsubst tests/hard/%.c,$(B)/hard/%,$(wildcard tests/hard/test_*.c))
$(B)/hard/%: $(B)/obj/tests/hard/%.o $(call OBJ,$(filter-out tests/hard/test_%,$(HARD))) $(B)/libdomino.a
	@mkdir -p $(@D)
	$(call SAY,LD,$@)
	$(Q)$(CC) $(C_FLAGS) $(LDFLAGS) $^ $(GSL) -lmpfr -lgmp -lcmocka -o $@

test: all $(UNIT_BIN) $(HARD_BIN)
	@tests/run $(B) $(UNIT_BIN) $(HARD_BIN) tests/shell/*.bats

unit: $(UNIT_BIN)
	@tests/run $(B) $(UNIT_BIN)

hard: $(HARD_BIN)
	@tests/run $(B) $(HARD_BIN)

sessions: all
	@tests/run $(B) tests/shell/*.bats

# Leaks are looked for too; Readline's and GSL's own are none of ours, and there are none.
sanitize: | $(FIRST)
	@$(MAKE) --no-print-directory B=$(B)/sanitize \
	  CFLAGS='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer' test

# What runs on many threads, under ThreadSanitizer, which knows no other order than what the program makes.
race: | $(FIRST)
	@$(MAKE) --no-print-directory B=$(B)/race CFLAGS='-O1 -g -fsanitize=thread' all
	@TSAN_OPTIONS=halt_on_error=1 tests/run $(B)/race tests/shell/sweep.bats

# ---- Fuzzing and speed ----

# The line interpreter under libFuzzer, ASan and UBSan, from a seeded corpus.
FUZZ_SECONDS ?= 600
FUZZ_FLAGS   := -O1 -g -Wno-double-promotion -fsanitize=address,undefined -fno-sanitize-recover=all
fuzz: | $(FIRST)
	$(Q)$(MAKE) --no-print-directory B=$(B)/fuzz CC=clang CFLAGS='$(FUZZ_FLAGS) -fsanitize=fuzzer-no-link' \
	  $(B)/fuzz/fuzz_line
	$(Q)rm -rf $(B)/fuzz/corpus && cp -r tests/fuzz/corpus $(B)/fuzz/corpus
	$(B)/fuzz/fuzz_line -seed=1 -max_total_time=$(FUZZ_SECONDS) -max_len=400 -timeout=10 -rss_limit_mb=2048 \
	  -close_fd_mask=3 -dict=tests/fuzz/words.dict -artifact_prefix=$(B)/fuzz/ -print_final_stats=1 $(B)/fuzz/corpus

$(B)/fuzz_line: $(B)/obj/tests/fuzz/fuzz_line.o $(filter-out %/main.o,$(call OBJ,$(SHELL_C))) $(B)/libdomino.a
	$(call SAY,LD,$@)
	$(Q)$(CC) $(C_FLAGS) -fsanitize=fuzzer $^ $(GSL) -lreadline -o $@

# Ratios, side by side in one run.
bench: all $(B)/bench_start $(B)/bench_rows
	@$(B)/bench_start $(B)/domino
	@$(B)/bench_rows

$(B)/bench_rows: $(B)/obj/tests/bench/bench_rows.o $(B)/libdomino.a
	$(call SAY,LD,$@)
	$(Q)$(CC) $(C_FLAGS) $(LDFLAGS) $^ $(GSL) -o $@

$(B)/bench_start: $(B)/obj/tests/bench/bench_start.o
	$(call SAY,LD,$@)
	$(Q)$(CC) $(C_FLAGS) $(LDFLAGS) $^ -o $@

# ---- Checks ----

C_FILES := $(wildcard src/*/*.c src/*/*/*.c tests/unit/*.c) $(HARD) $(wildcard tests/bench/*.c tests/fuzz/*.c)
H_FILES := $(wildcard include/*.h src/*/*.h src/*/*/*.h tests/unit/*.h tests/hard/*.h)

# To clang the exact widening to the widest type, by which answers leave a kernel, is a promotion; gcc looks
# for those from float to double.
lint: | $(FIRST)
	clang-format --dry-run -Werror $(C_FILES) $(H_FILES)
	$(MAKE) --no-print-directory B=$(B)/gcc CC=gcc CFLAGS='-O2 -Werror' all $(patsubst $(B)/%,$(B)/gcc/%,$(UNIT_BIN)) $(patsubst $(B)/%,$(B)/gcc/%,$(HARD_BIN))
	$(MAKE) --no-print-directory B=$(B)/clang CC=clang CFLAGS='-O2 -Werror -Wno-double-promotion' all $(patsubst $(B)/%,$(B)/clang/%,$(UNIT_BIN)) $(patsubst $(B)/%,$(B)/clang/%,$(HARD_BIN))
	clang-tidy --quiet $(MODEL) $(SHELL_C) -- -std=c17 -D_GNU_SOURCE -Iinclude -Isrc/model
	@# cppcheck takes the order of the series in one precision for that in another.
	cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 \
	  --suppress=missingIncludeSystem --suppress=ctuArrayIndex:src/model/numerics/linear.c -Iinclude -Isrc/model src
	mandoc -T lint man/domino.1
	mandoc -T lint -W warning $(B)/gcc/domino-effects.7
	shellcheck tests/run .ci/run tests/shell/*.bash src/shell/domino.bash examples/cluster/*.sh

format:
	clang-format -i $(C_FILES) $(H_FILES)

# ---- Installation ----

install: all
	install -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(PREFIX)/include $(DESTDIR)$(PREFIX)/lib/pkgconfig \
	  $(DESTDIR)$(PREFIX)/share/man/man1 $(DESTDIR)$(PREFIX)/share/man/man7 \
	  $(DESTDIR)$(PREFIX)/share/doc/domino/examples/cluster \
	  $(DESTDIR)$(PREFIX)/share/bash-completion/completions
	install -m 644 src/shell/domino.bash $(DESTDIR)$(PREFIX)/share/bash-completion/completions/domino
	install -m 755 $(B)/domino $(DESTDIR)$(PREFIX)/bin/domino
	install -m 644 include/domino.h $(DESTDIR)$(PREFIX)/include/domino.h
	install -m 644 $(B)/libdomino.a $(DESTDIR)$(PREFIX)/lib/libdomino.a
	install -m 644 man/domino.1 $(DESTDIR)$(PREFIX)/share/man/man1/domino.1
	install -m 644 $(B)/domino-effects.7 $(DESTDIR)$(PREFIX)/share/man/man7/domino-effects.7
	install -m 644 README.md $(DESTDIR)$(PREFIX)/share/doc/domino/README.md
	install -m 755 examples/*.dom $(DESTDIR)$(PREFIX)/share/doc/domino/examples
	install -m 644 examples/*.csv $(DESTDIR)$(PREFIX)/share/doc/domino/examples
	install -m 755 examples/cluster/* $(DESTDIR)$(PREFIX)/share/doc/domino/examples/cluster
	sed 's|^prefix=.*|prefix=$(PREFIX)|' $(B)/domino.pc > $(DESTDIR)$(PREFIX)/lib/pkgconfig/domino.pc
	chmod 644 $(DESTDIR)$(PREFIX)/lib/pkgconfig/domino.pc

uninstall:
	rm -f $(DESTDIR)$(PREFIX)/bin/domino $(DESTDIR)$(PREFIX)/include/domino.h \
	  $(DESTDIR)$(PREFIX)/lib/libdomino.a $(DESTDIR)$(PREFIX)/lib/pkgconfig/domino.pc \
	  $(DESTDIR)$(PREFIX)/share/man/man1/domino.1 $(DESTDIR)$(PREFIX)/share/man/man7/domino-effects.7 \
	  $(DESTDIR)$(PREFIX)/share/bash-completion/completions/domino
	rm -rf $(DESTDIR)$(PREFIX)/share/doc/domino

clean:
	rm -rf $(B)

-include $(shell find $(B)/obj -name '*.d' 2>/dev/null)
