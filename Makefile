# SPDX-License-Identifier: GPL-3.0-or-later
#
#   make deps run     install what is missing (Debian), build, open the calculator
#   make deps test    the same, and run the tests
#   make              .build/domino and .build/libdomino.a
#   make install      program, library, man page, examples; PREFIX= and DESTDIR= as usual
#   make lint         compilers, formatter and checkers; make sanitize: the tests under ASan and UBSan

VERSION := $(shell sed -n 's/^\#define DOM_VERSION "\(.*\)"/\1/p' include/domino.h)
PREFIX  ?= /usr/local
DESTDIR ?=
B       ?= .build

CC      ?= gcc
OPTIM   ?= -O2 -g
WARN    := -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes -Wvla
CFLAGS  ?= $(OPTIM)
# Every digit is to be the same on every machine: no contraction, never -ffast-math.
C_FLAGS := -std=c17 $(WARN) -ffp-contract=off -D_GNU_SOURCE -Iinclude -Isrc/model $(CFLAGS)
GSL     := -lgsl -lgslcblas -lm

MODEL   := $(wildcard src/model/*.c src/model/*/*.c)
SHELL_C := $(wildcard src/shell/*.c)
UNIT    := $(wildcard tests/unit/test_*.c)
# 'make V=1' shows the commands.
Q        = $(if $(V),,@)
SAY      = @$(if $(V),:,echo '  $(1)  $(2)')
OBJ      = $(patsubst %.c,$(B)/obj/%.o,$(1))

.PHONY: all run test unit sessions sanitize deps lint format install uninstall clean
all: $(B)/domino $(B)/libdomino.a $(B)/domino.pc

# ---- Dependencies: only what the goals of this call need ----

DEPS_RUN  := libgsl-dev libreadline-dev
DEPS_TEST := libcmocka-dev bats expect
DEPS_LINT := clang clang-format clang-tidy cppcheck mandoc shellcheck
NEEDED    := $(DEPS_RUN) $(if $(filter test unit sessions sanitize,$(MAKECMDGOALS)),$(DEPS_TEST)) \
             $(if $(filter lint,$(MAKECMDGOALS)),$(DEPS_LINT) libcmocka-dev)

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

$(B)/libdomino.a: $(call OBJ,$(MODEL))
	$(call SAY,AR,$@)
	$(Q)rm -f $@
	$(Q)$(AR) rcs $@ $^

$(B)/domino: $(call OBJ,$(SHELL_C)) $(B)/libdomino.a
	$(call SAY,LD,$@)
	$(Q)$(CC) $(C_FLAGS) $(LDFLAGS) $^ $(GSL) -lreadline -o $@

$(B)/domino.pc: include/domino.h Makefile
	@mkdir -p $(@D)
	@printf '%s\n' 'prefix=$(PREFIX)' 'includedir=$${prefix}/include' 'libdir=$${prefix}/lib' '' \
	  'Name: domino' 'Description: How far can a domino train grow?' 'Version: $(VERSION)' \
	  'Requires: gsl' 'Libs: -L$${libdir} -ldomino' 'Cflags: -I$${includedir}' > $@

run: all
	@$(B)/domino

# ---- Tests ----

$(B)/unit/%: $(B)/obj/tests/unit/%.o $(B)/libdomino.a
	@mkdir -p $(@D)
	$(call SAY,LD,$@)
	$(Q)$(CC) $(C_FLAGS) $(LDFLAGS) $^ $(GSL) -lcmocka -o $@

UNIT_BIN := $(patsubst tests/unit/%.c,$(B)/unit/%,$(UNIT))
.SECONDARY: $(call OBJ,$(UNIT))

test: all $(UNIT_BIN)
	@tests/run $(B) $(UNIT_BIN) tests/shell/*.bats

unit: $(UNIT_BIN)
	@tests/run $(B) $(UNIT_BIN)

sessions: all
	@tests/run $(B) tests/shell/*.bats

# Leaks are looked for too; Readline's and GSL's own are none of ours, and there are none.
sanitize: | $(FIRST)
	@$(MAKE) --no-print-directory B=$(B)/sanitize \
	  CFLAGS='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer' test

# ---- Checks ----

C_FILES := $(MODEL) $(SHELL_C) $(UNIT)
H_FILES := $(wildcard include/*.h src/*/*.h src/*/*/*.h tests/unit/*.h)

lint: | $(FIRST)
	clang-format --dry-run -Werror $(C_FILES) $(H_FILES)
	$(MAKE) --no-print-directory B=$(B)/gcc CC=gcc CFLAGS='-O2 -Werror' all $(patsubst $(B)/%,$(B)/gcc/%,$(UNIT_BIN))
	$(MAKE) --no-print-directory B=$(B)/clang CC=clang CFLAGS='-O2 -Werror' all $(patsubst $(B)/%,$(B)/clang/%,$(UNIT_BIN))
	clang-tidy --quiet $(MODEL) $(SHELL_C) -- -std=c17 -D_GNU_SOURCE -Iinclude -Isrc/model
	cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 \
	  --suppress=missingIncludeSystem -Iinclude -Isrc/model src
	mandoc -T lint -W warning man/domino.1
	shellcheck tests/run .ci/run tests/shell/*.bash

format:
	clang-format -i $(C_FILES) $(H_FILES)

# ---- Installation ----

install: all
	install -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(PREFIX)/include $(DESTDIR)$(PREFIX)/lib/pkgconfig \
	  $(DESTDIR)$(PREFIX)/share/man/man1 $(DESTDIR)$(PREFIX)/share/doc/domino/examples
	install -m 755 $(B)/domino $(DESTDIR)$(PREFIX)/bin/domino
	install -m 644 include/domino.h $(DESTDIR)$(PREFIX)/include/domino.h
	install -m 644 $(B)/libdomino.a $(DESTDIR)$(PREFIX)/lib/libdomino.a
	install -m 644 man/domino.1 $(DESTDIR)$(PREFIX)/share/man/man1/domino.1
	install -m 644 README.md $(DESTDIR)$(PREFIX)/share/doc/domino/README.md
	install -m 755 examples/*.dom $(DESTDIR)$(PREFIX)/share/doc/domino/examples
	sed 's|^prefix=.*|prefix=$(PREFIX)|' $(B)/domino.pc > $(DESTDIR)$(PREFIX)/lib/pkgconfig/domino.pc
	chmod 644 $(DESTDIR)$(PREFIX)/lib/pkgconfig/domino.pc

uninstall:
	rm -f $(DESTDIR)$(PREFIX)/bin/domino $(DESTDIR)$(PREFIX)/include/domino.h \
	  $(DESTDIR)$(PREFIX)/lib/libdomino.a $(DESTDIR)$(PREFIX)/lib/pkgconfig/domino.pc \
	  $(DESTDIR)$(PREFIX)/share/man/man1/domino.1
	rm -rf $(DESTDIR)$(PREFIX)/share/doc/domino

clean:
	rm -rf $(B)

-include $(shell find $(B)/obj -name '*.d' 2>/dev/null)
