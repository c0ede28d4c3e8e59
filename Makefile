# SPDX-License-Identifier: GPL-3.0-or-later
#
#   make deps run     install what is missing, build, open the calculator
#   make deps test    also run the tests, on all processors; make quick: a selection
#   make              .build/domino, .build/libdomino.a and .build/libdomino.so
#   make install      program, library, Python module, man pages, examples; PREFIX, LIBDIR, DESTDIR ... as usual
#
# src/README.md lists all goals.

VERSION := $(shell sed -n 's/^\#define DOM_VERSION "\(.*\)"/\1/p' include/domino.h)
, := ,
PREFIX  ?= /usr/local
DESTDIR ?=
B       ?= .build
# Objects are in B; programs and libraries, which depend on the features, in P.
P       ?= $(B)

CC      ?= gcc
# -g1 records lines and functions, and compiles faster than -g. For a debugger, use make OPTIM='-O0
# -g'.
OPTIM   ?= -O2 -g1
# A stack protector and FORTIFY end the program after a buffer overflow, and the addresses of functions are bound before
# main, in memory that is then read-only. FORTIFY needs optimization.
HARDEN  := -fstack-protector-strong $(if $(filter-out -O0,$(filter -O%,$(OPTIM))),-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
WARN    := -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes -Wvla
CFLAGS  ?= $(OPTIM) $(HARDEN)
# The linker and the archiver of macOS take other options than the GNU, LLVM and FreeBSD tools.
DARWIN  := $(filter Darwin,$(shell uname -s))
LDFLAGS ?= $(if $(DARWIN),,-Wl$(,)-z$(,)relro$(,)-z$(,)now $(RELR))
# With this option the table of addresses that the dynamic linker adjusts is compact, which saves 140 KB. The option is
# used if the linker accepts it without a warning and a program linked with it runs here.
RELR     = $(if $(shell echo 'int main(void) { return 0; }' | { $(CC) -x c - $(PACKED) -o $(B)/relr && $(B)/relr; } 2>&1 || echo no),,$(PACKED))
PACKED  := -Wl,-z,pack-relative-relocs
INCLUDES := -Iinclude -I$(B)/include -Isrc -Isrc/train/model -Isrc/shell -I$(B)
# POSIX and the usual extensions of C libraries. Only a file that uses more defines _GNU_SOURCE, because <math.h> is then
# three times as long.
STD     := -std=c17 -D_DEFAULT_SOURCE
# Large data are on the heap, since stacks may be small. 'make WERROR=1' treats warnings as errors.
STRICT  := $(if $(WERROR),-Werror -Wframe-larger-than=16384)
# Results must have the same digits on every machine, so there is no contraction and no -ffast-math. The code never
# reads errno after a square root, and without errno a square root is a single instruction.
C_FLAGS := $(STD) $(WARN) $(STRICT) -ffp-contract=off -fno-math-errno -fno-asynchronous-unwind-tables $(INCLUDES) $(CFLAGS) \
           "-ffile-prefix-map=$(CURDIR)=." # the same bytes in every folder
BSD     := $(if $(PORTABLE),-lbsd)
GSL     := -lgsl -lgslcblas -lm -pthread $(BSD)
# The program links GSL and Readline statically if their archives are installed, because loading the shared libraries
# takes a quarter of the start-up time.
THERE    = $(filter /%,$(shell $(CC) -print-file-name=$(1)))
PROGRAM := $(if $(call THERE,libgsl.a),-l:libgsl.a -l:libgslcblas.a,-lgsl -lgslcblas) \
           $(if $(and $(call THERE,libreadline.a),$(call THERE,libtinfo.a)),-l:libreadline.a -l:libtinfo.a,-lreadline) -lm -pthread $(BSD)

# ---- Features ----

# A feature is a folder with a feature.mk, which names what it needs. A folder within it that has a feature.mk, too, is
# what the feature does together with others, such as the charts of rows; it is built if all that it needs is built.
# 'make FEATURES="rows sweeps"' builds these two with what they need, and 'make FEATURES=' builds the shell and the train
# alone. The default is all.
FEATURE_MK := $(wildcard src/*/feature.mk src/*/*/feature.mk)
include $(FEATURE_MK)
EVERY    := $(subst /,_,$(patsubst src/%/feature.mk,%,$(FEATURE_MK)))
JOINT    := $(foreach f,$(EVERY),$(if $(findstring _,$f),$f))
FEATURES ?= $(filter-out $(JOINT),$(EVERY))
$(foreach f,$(filter-out $(EVERY),$(FEATURES)),$(error there is no feature '$f'; the features are $(filter-out $(JOINT) train,$(EVERY))))
# Each name once, after those that it needs.
with_needs = $(foreach f,$(1),$(call with_needs,$(NEEDS_$f)) $f)
once       = $(if $(1),$(firstword $(1)) $(call once,$(filter-out $(firstword $(1)),$(1))))
BUILT    := $(call once,train $(call with_needs,$(FEATURES)))
BUILT    += $(foreach f,$(JOINT),$(if $(filter-out $(BUILT),$(NEEDS_$f)),,$f))
PART     := $(filter-out $(BUILT),$(EVERY))
FOLDERS  := $(subst _,/,$(BUILT))

# src/train/model/precision includes the sources of the kernels. The kernel in double is compiled within compare/gsl.c,
# which includes precision/double.c. TYPED is compiled twice: once with the types of <domino.h>, and once with the types
# of <domino_quad.h>, which the kernels in float and quad use.
TRAIN   := src/train/model
MODELS  := $(wildcard $(patsubst %,src/%/model/*.c,$(filter-out train,$(BUILT))))
TYPED   := $(addprefix $(TRAIN)/,model.c many.c dynamics/train.c dispatch/dispatch.c) \
           $(filter-out %/choose.c,$(wildcard $(TRAIN)/effects/*.c $(TRAIN)/search/*.c)) $(filter-out $(wildcard $(IN_DOUBLE:%=src/%/model/*.c)),$(MODELS))
DOUBLE  := $(addprefix $(TRAIN)/,texts.c numerics/quiet.c numerics/interrupt.c dispatch/bridge.c) \
           $(wildcard $(TRAIN)/compare/*.c) $(filter $(wildcard $(IN_DOUBLE:%=src/%/model/*.c)),$(MODELS))
QUAD    := $(addprefix $(TRAIN)/precision/,float.c quad.c)
MODEL   := $(DOUBLE) $(TYPED) $(QUAD)
ENGINE_C := $(filter-out %/feature.c,$(wildcard $(patsubst %,src/%/*.c,$(filter engine,$(BUILT)))))
# The sources of a feature are in its folder, and in folders within it that are neither a model nor a feature.
SHELL_C := src/main.c $(wildcard src/shell/*/*.c) $(filter-out $(ENGINE_C) \
           $(foreach f,$(EVERY),$(if $(filter $f,$(BUILT)),,src/$(subst _,/,$f)/%)) src/train/model/% $(BUILT:%=src/%/model/%), \
           $(wildcard $(FOLDERS:%=src/%/*.c) $(FOLDERS:%=src/%/*/*.c)))
SHELL_C := $(sort $(SHELL_C))

# In a build without some features, tests that need them are left out: programs with a line 'Needs: NAMES', and sessions
# with a tag. The tag 'whole' is for sessions that need every feature.
LACK     = $(if $(PART),$(shell grep -lE 'Needs:.*\<($(subst $(eval) ,|,$(PART)))\>' $(1)))
WITHOUT := $(if $(PART),!whole$(foreach f,$(filter-out $(JOINT),$(PART)),$(,)!$f))
export WITHOUT
UNIT    := $(filter-out $(call LACK,$(wildcard tests/unit/test_*.c)),$(wildcard tests/unit/test_*.c))
# 'make V=1' shows the commands.
Q        = $(if $(V),,@)
SAY      = @$(if $(V),:,echo '  $(1)  $(2)')
OBJ      = $(patsubst %.c,$(B)/obj/%.o,$(1))
# Links a program with all that it depends on, and with these libraries.
define LINK
@mkdir -p $(@D)
$(call SAY,LD,$@)
$(Q)$(CC) $(C_FLAGS) $(LDFLAGS) $^ $(1) -o $@
endef

.PHONY: all run python quick test unit hard sessions atlas faults sanitize race valgrind verify portable cross abi fuzz bench guard deps lint format removable \
        install uninstall deb dist clean
# A part of the library must not look like the whole.
all: $(P)/domino $(P)/libdomino.a $(if $(PART),,$(B)/libdomino.so $(B)/domino.pc)

# ---- Dependencies, but only those that the goals of this call need ----

DEPS_run      := libgsl-dev libreadline-dev libchipmunk-dev
DEPS_test     := dpkg-dev lintian libcmocka-dev bats expect tmux libmpfr-dev gnuplot-nox pkgconf parallel libxml2-utils poppler-utils jq python3 python3-numpy python3-pandas
$(foreach goal,quick unit hard sessions sanitize race removable,$(eval DEPS_$(goal) := $(DEPS_test)))
DEPS_faults   := bats expect gnuplot-nox binutils util-linux
DEPS_valgrind := valgrind libc6-dbg
DEPS_portable := $(DEPS_test) libbsd-dev
DEPS_cross    := python3 qemu-user gcc-aarch64-linux-gnu libc6-dev-arm64-cross gcc-i686-linux-gnu libc6-dev-i386-cross
DEPS_fuzz     := clang libclang-rt-dev
DEPS_bench    := bc python3-scipy gnuplot-nox valgrind binutils
DEPS_guard    := valgrind
DEPS_verify   := libchipmunk-dev
DEPS_atlas    := python3
DEPS_deb      := dpkg-dev binutils
DEPS_abi      := python3
DEPS_lint     := python3 musl-tools clang clang-format clang-tidy mandoc shellcheck hunspell hunspell-en-gb libcmocka-dev libmpfr-dev $(DEPS_verify)
NEEDED        := $(sort $(DEPS_run) $(foreach goal,$(MAKECMDGOALS),$(DEPS_$(goal))))

deps:
	@.packaging/deps $(NEEDED)

# Tests use all processors unless -j is given.
ifneq ($(filter test quick unit hard sessions,$(MAKECMDGOALS)),)
ifeq ($(filter -j%,$(MAKEFLAGS)),)
MAKEFLAGS := $(MAKEFLAGS) -j$(shell nproc)
endif
endif

# 'make deps test' compiles nothing before the headers of other libraries are installed.
FIRST := $(filter deps,$(MAKECMDGOALS))

# ---- Program and library ----

HEADERS := $(B)/include/domino_quad.h $(B)/domq_names.h $(B)/domq_names_end.h $(B)/library.h $(B)/members.h $(B)/kernel_names.h $(B)/tutorial.h $(P)/feature_list.h \
           $(B)/system_features.h # generated from other sources

$(B)/obj/%.o: %.c | $(FIRST)
	@mkdir -p $(@D)
	$(call SAY,CC,$<)
	$(Q)$(CC) $(C_FLAGS) -MMD -MP -c $< -o $@
$(call OBJ,$(MODEL) $(ENGINE_C) $(SHELL_C) $(wildcard tests/*/*.c)) $(patsubst %.c,$(B)/objq/%.o,$(TYPED) $(QUAD)): | $(HEADERS)

# Finds which functions beyond POSIX this system has. 'make PORTABLE=1' uses none of them, except funopen of libbsd on
# Linux.
SYSTEM := src/shell/io/features
$(B)/portable/system_features.h: PORTABLE := 1
$(B)/system_features.h $(B)/portable/system_features.h: $(SYSTEM) | $(FIRST)
	@mkdir -p $(@D)
	@PORTABLE=$(PORTABLE) $(SYSTEM) $(CC) $(CFLAGS) > $@.new && mv $@.new $@

# The list of features, for src/features.c.
$(P)/features.o: src/features.c $(P)/feature_list.h
	$(Q)$(CC) -I$(P) $(C_FLAGS) -c $< -o $@
$(P)/feature_list.h: FORCE
	@mkdir -p $(@D)
	@echo '#define FEATURES(X) $(foreach f,$(BUILT) shell,X($f))' > $@.new
	@cmp -s $@.new $@ || mv $@.new $@

# Renames each function of the kernels after its precision, as in chain_sum_double, for debuggers.
KERNEL_C := $(filter-out $(MODEL),$(wildcard $(TRAIN)/*/*.c $(TRAIN)/*/*.h))
$(B)/kernel_names.h: $(KERNEL_C)
	@mkdir -p $(@D)
	@sed -nE 's/^(KERNEL|KERNEL_LOOP|static) .*[ *]([a-z][A-Za-z_0-9]*)\(.*/#define \2 KERNEL_NAME(\2)/p' $(KERNEL_C) | sort -u > $@.new
	@cmp -s $@.new $@ || cp $@.new $@

# The names that the files of the library share. All files are compiled again if a name is added, but not after other
# changes.
SHARED_AWK := $(TRAIN)/precision/shared.awk
SHARED_OF  := $(wildcard $(TRAIN)/*/*.h src/*/model/*.h)
$(B)/library.h: $(SHARED_OF) $(SHARED_AWK)
	@mkdir -p $(@D)
	@awk -f $(SHARED_AWK) $(SHARED_OF) > $@.new
	@cmp -s $@.new $@ || cp $@.new $@

# The text of 'lesson', as numbers for a C array.
$(B)/tutorial.h: examples/tutorial.dom
	@mkdir -p $(@D)
	@od -An -v -td1 $< | sed 's/  */,/g; s/^,//; s/$$/,/' > $@

# <domino_quad.h>, which is generated from these headers, and a list of its names for the sources.
QUAD_AWK := $(TRAIN)/precision/quad.awk
QUAD_OF  := include/domino_common.h include/domino.h include/domino_row.h
$(B)/include/domino_quad.h: $(QUAD_OF) $(QUAD_AWK)
	@mkdir -p $(@D)
	@awk -f $(QUAD_AWK) $(QUAD_OF) write=1 $(QUAD_OF) > $@
$(B)/domq_names.h: $(QUAD_OF) $(QUAD_AWK)
	@mkdir -p $(@D)
	@awk -v names=1 -f $(QUAD_AWK) $(QUAD_OF) write=1 $(QUAD_OF) > $@
$(B)/domq_names_end.h: $(B)/domq_names.h
	@sed -n 's/^#define \([^ ]*\).*/#undef \1/p' $< > $@

$(B)/members.h: $(QUAD_OF) $(TRAIN)/dispatch/members.awk
	@mkdir -p $(@D)
	@awk -f $(TRAIN)/dispatch/members.awk $(QUAD_OF) > $@

LIB_OBJ    := $(call OBJ,$(DOUBLE) $(TYPED)) $(patsubst %.c,$(B)/objq/%.o,$(TYPED) $(QUAD))
# With -flto the archive also has machine code, for programs that are linked without -flto.
LIB_FLAGS  := -fPIC -fvisibility=hidden -include $(B)/library.h $(if $(findstring -flto,$(CFLAGS)),-ffat-lto-objects) $(COVER)
$(LIB_OBJ): C_FLAGS += $(LIB_FLAGS)
# With -O1, compiling takes at most two thirds of the time. Code that waits for the kernels in float and double is as
# fast with -O1. The kernel in quad is as fast, too, because it waits for library functions that multiply and add. The
# kernels in float and double need the same options, because 'cost' compares their times.
QUICK := $(call OBJ,$(SHELL_C) $(TYPED) $(TRAIN)/dispatch/bridge.c) $(patsubst %.c,$(B)/objq/%.o,$(TYPED) $(TRAIN)/precision/quad.c)
$(QUICK): C_FLAGS += $(if $(filter -O2,$(CFLAGS)),-O1)
# With -Og, compiling takes even less time. Code that runs once per command executes as many instructions as with -O1.
# With -Og everywhere, a line would take 16 % more instructions, and quad with friction 10 % more.
ONCE  := $(filter-out src/shell/% $(TRAIN)/%,$(SHELL_C) $(TYPED)) $(filter src/shell/commands/% src/shell/prompt/% $(TRAIN)/effects/%,$(SHELL_C) $(TYPED))
$(call OBJ,$(ONCE)) $(patsubst %.c,$(B)/objq/%.o,$(ONCE)): C_FLAGS += $(if $(filter -O2,$(CFLAGS)),-Og)
$(B)/objq/%.o: %.c | $(FIRST)
	@mkdir -p $(@D)
	$(call SAY,CC,$< (quad))
	$(Q)$(CC) $(C_FLAGS) -DDOMQ -MMD -MP -c $< -o $@

$(LIB_OBJ): $(B)/library.h
# Objects from different folders may have the same name, so 'ar q' appends them. 'ar r' would replace one with the other.
$(P)/libdomino.a: $(LIB_OBJ) $(P)/feature_list.h
	$(call SAY,AR,$@)
	$(Q)rm -f $@
	$(Q)$(AR) $(if $(DARWIN),qcs,qcsD) $@ $(LIB_OBJ)

# If a structure or a function changes, the major version must increase. It is the number in the soname.
MAJOR  := $(firstword $(subst ., ,$(VERSION)))
SONAME := libdomino.so.$(MAJOR)
# The library exports the functions that begin with dom_ or domq_.
ifeq ($(DARWIN),)
EXPORTS  = 'DOMINO_$(MAJOR) { global: dom_*; domq_*; local: *; };'
SHARED   = -shared -Wl,-soname,$(SONAME) -Wl,--version-script=$(B)/libdomino.map
else
EXPORTS  = '_dom_*' '_domq_*'
SHARED   = -dynamiclib -Wl,-install_name,$(LIBDIR)/$(SONAME) -Wl,-exported_symbols_list,$(B)/libdomino.map
endif
$(B)/$(SONAME): $(LIB_OBJ)
	$(call SAY,LD,$@)
	@printf '%s\n' $(EXPORTS) > $(B)/libdomino.map
	$(Q)$(CC) $(C_FLAGS) $(LDFLAGS) $(SHARED) $^ $(GSL) -o $@
$(B)/libdomino.so: $(B)/$(SONAME)
	@ln -sf $(SONAME) $@

# The program with nothing beyond POSIX, for 'make portable'. Only one file differs.
$(B)/portable/system.o: src/shell/io/system.c src/shell/io/system.h $(B)/portable/system_features.h
	$(Q)$(CC) -I$(B)/portable $(C_FLAGS) -c $< -o $@
$(B)/portable/domino: $(filter-out %/io/system.o,$(call OBJ,$(ENGINE_C) $(SHELL_C)) $(P)/features.o) $(B)/portable/system.o $(P)/libdomino.a
	$(call LINK,$(PROGRAM) -lbsd)

$(B)/shared/domino: PROGRAM := $(GSL) -lreadline
$(P)/domino $(B)/shared/domino: $(call OBJ,$(ENGINE_C) $(SHELL_C)) $(P)/features.o $(P)/libdomino.a
	$(call LINK,$(PROGRAM))

# Programs find a shared library in /usr/lib without help. For other folders, domino.pc adds an rpath.
PC_PATH = "$(1)=$$(printf %s "$(2)" | sed 's/[[:blank:]]/\\&/g')"
PC_TEXT = printf '%s\n' $(call PC_PATH,libdir,$(LIBDIR)) $(call PC_PATH,includedir,$(INCLUDEDIR)) \
  'rpath=$(if $(filter-out /usr/lib /usr/lib/%,$(LIBDIR)),-Wl$(,)-rpath$(,)$${libdir})' '' \
  'Name: domino' 'Description: How far can a domino train grow?' 'Version: $(VERSION)' 'Requires.private: gsl' \
  'Libs: -L$${libdir} $${rpath} -ldomino' 'Libs.private: -lm -pthread' \
  'Cflags: -I$${includedir}$(patsubst %, %,$(filter -DDOM_NO_FLOAT128,$(CFLAGS)))'
$(B)/domino.pc: include/domino.h Makefile
	@mkdir -p $(@D)
	@$(PC_TEXT) > $@

# The Python module, with declarations that are generated from the headers.
PYTHON3   ?= python3
PYTHON_PY := $(wildcard src/python/domino/*)
python: $(B)/python/domino/_api.py $(B)/libdomino.so
$(B)/python/domino/_api.py: src/python/header.py $(wildcard include/*.h) $(PYTHON_PY) Makefile
	@mkdir -p $(@D)
	$(Q)cp $(PYTHON_PY) $(@D)
	$(call SAY,PY,$@)
	$(Q)$(PYTHON3) src/python/header.py $(SONAME) '$(CC)' include/domino_proof.h > $@.new && mv $@.new $@

run: all
	@$(P)/domino

# ---- Tests ----

UNIT_MORE := $(filter-out $(UNIT),$(wildcard tests/unit/*.c))
$(P)/unit/%: $(B)/obj/tests/unit/%.o $(call OBJ,$(UNIT_MORE)) $(P)/libdomino.a
	$(call LINK,$(GSL) -lcmocka)

# This test can make allocations and threads fail.
$(P)/unit/test_corners: LDFLAGS += -Wl,--wrap=malloc,--wrap=calloc,--wrap=pthread_create
# This test counts the checks for an interrupt.
$(P)/unit/test_interrupt: LDFLAGS += -Wl,--wrap=dom_interrupted
# So does this one, for the shell.
$(P)/unit/test_stops: LDFLAGS += -Wl,--wrap=dom_interrupted,--wrap=domq_lean_limits
# The library starts no threads, so the thread pool of the shell runs its tasks.
$(P)/unit/test_corners $(P)/unit/test_workers: $(call OBJ,$(addprefix src/shell/,parallel/workers.c io/io.c io/stream.c io/system.c io/terminal.c))
# Unit tests of the shell: numbers.
$(P)/unit/test_digits: $(call OBJ,$(addprefix src/shell/,language/quad.c answer/cell.c))
# The reader of csv files.
$(P)/unit/test_csv: $(call OBJ,src/shell/io/escape.c $(wildcard src/shell/language/*.c))
# Completion and other functions that need the tables of commands.
SHELL_UNIT := $(addprefix $(P)/unit/test_,complete errors lines stage stops)
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
$(P)/hard/%: $(B)/obj/tests/hard/%.o $(call OBJ,tests/unit/suite.c $(filter-out tests/hard/test_%,$(HARD))) $(P)/libdomino.a
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
$(P)/tap/shell/python.bats.count: python
$(P)/tap/%.bats.count: tests/%.bats all FORCE
	@tests/run --suite $(P) $<
FORCE:

# Runs the quick tests: the unit tests, the short sessions, and a twentieth of the points of the sweeps.
QUICK_HARD := $(P)/hard/test_sweep $(P)/hard/test_properties
QUICK_BATS := $(wildcard $(patsubst %,tests/%.bats,shell/output train/count train/growth train/effects rows/rows train/precision pictures/draw train/cycle))
QUICK_RUN   = $(call COUNTS_OF,$(QUICK_HARD) $(QUICK_BATS)) $(UNIT_RUN)

quick: export SWEEP_SIZE := 0.05
quick: $(QUICK_RUN)
test: $(HARD_RUN) $(SHELL_RUN) $(UNIT_RUN)
unit: $(UNIT_RUN)
hard: $(HARD_RUN)
sessions: $(SHELL_RUN)
quick test unit hard sessions:
	@tests/run --sum $^

# Takes each feature away in turn, with what needs it, and runs the sessions that are left. 'make removable
# REMOVED="centre fit"' tests only these; 'centre' takes all away. With LEFT=all, no sessions run.
REMOVABLE := $(filter-out $(JOINT) train,$(EVERY))
REMOVED   ?= centre $(REMOVABLE)
LEFT      ?= sessions
# One of them, another one after each commit, for CI.
TURN       = $(word $(shell expr $$(git rev-list --count HEAD) % $(words $(REMOVABLE)) + 1),$(REMOVABLE))
left_by    = $(foreach f,$(REMOVABLE),$(if $(filter centre,$(1))$(filter $(1),$(call with_needs,$f)),,$f))
removable: $(REMOVED:%=without-%)
without-%: all
	+@$(MAKE) --no-print-directory P=$(B)/without/$* FEATURES='$(call left_by,$*)' $(LEFT)
	@tests/names $(P)/domino $(B)/without/$*/domino

# Compares rows with Chipmunk, a rigid-body engine. Fails if they differ.
VERIFY := $(wildcard tests/verify/*.c)
$(B)/verify_rows: $(call OBJ,$(VERIFY) $(ENGINE_C) tests/hard/workers.c) $(P)/libdomino.a
	$(call LINK,$(GSL))

verify: $(B)/verify_rows
	@$(B)/verify_rows

# Makes the table of proved growths in parts, as on a cluster. Then tests/atlas checks the table by other means, which
# takes a minute. Every run gives the same bytes.
ATLAS_PARTS := 1 2 3 4
atlas: all
	@echo '  ATLAS  examples/atlas.csv'
	@{ sed -n '/^# Proved/,/^$$/p' examples/atlas.dom | grep '^#' && for part in $(ATLAS_PARTS); do \
	  $(P)/domino -n --shard $$part/$(words $(ATLAS_PARTS)) -f examples/atlas.dom || exit 1; done; } > $(B)/atlas.csv
	@tests/atlas $(B)/atlas.csv
	@cp $(B)/atlas.csv examples/atlas.csv

# Runs the sessions that use files and streams, with nothing beyond POSIX.
PORTABLE_BATS := $(patsubst %,tests/shell/%.bats,fifo files output)
portable: $(B)/portable/domino
	@tests/run $(B)/portable $(PORTABLE_BATS)

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
  names options save settings undo variables))
sanitize: | $(FIRST)
	@find $(B)/sanitize -name '*.gcda' -delete 2>/dev/null || :
	@LDFLAGS=--coverage $(MAKE) --no-print-directory B=$(B)/sanitize BATS='$(SANITIZED)' HARD_BIN='$(patsubst %,$(B)/sanitize/hard/test_%,proof search sweep)' COVER=--coverage \
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
FUZZ_RUN     := -seed=1 -timeout=10 -rss_limit_mb=2048 -close_fd_mask=3 -artifact_prefix=$(abspath $(B))/fuzz/ \
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

# Compares the times of this library and of other programs in one run. SciPy takes part if it is installed.
BENCH := bench compare curve floor front growth lengths lines measure rows start waits
bench: all $(B)/bench $(B)/answers python
	@$(B)/bench $(B)
	@$(PYTHON3) tests/bench/numpy_loop.py $(B)

$(B)/obj/tests/bench/bench.o: C_FLAGS += -DBENCH_FLAGS='"$(OPTIM)"'
$(B)/bench: $(BENCH:%=$(B)/obj/tests/bench/%.o) $(B)/obj/tests/unit/direct.o $(call OBJ,$(ENGINE_C)) $(P)/libdomino.a
	$(call LINK,$(GSL))

$(B)/answers: $(B)/obj/tests/bench/answers.o $(P)/libdomino.a
	$(call LINK,$(GSL))

# Compares the numbers of instructions of answers with tests/bench/instructions.csv. 'make guard KEEP=1' writes that
# file again.
guard: all $(B)/answers
	@echo '$(CFLAGS)' > $(B)/flags
	@KEEP=$(KEEP) tests/bench/guard $(B)

# ---- Checks ----

# Compares the binary interface with the interface of the first library that had this soname.
abi: $(B)/python/domino/_api.py
	@$(if $(KEEP),cp $< tests/abi/$(SONAME).py)
	@tests/abi/check tests/abi/$(SONAME).py $<

C_FILES := $(wildcard examples/*.c src/*/*.c src/*/*/*.c src/*/*/*/*.c tests/unit/*.c) $(HARD) $(VERIFY) $(wildcard tests/bench/*.c tests/fuzz/*.c tests/faults/*.c)
PAGES   := $(wildcard man/*.[1-9])
H_FILES := $(wildcard include/*.h src/*/*.h src/*/*/*.h src/*/*/*/*.h tests/*/*.h)

LINT_BIN := $(UNIT_BIN) $(HARD_BIN) $(B)/bench $(B)/answers $(B)/verify_rows

# Compiles everything with gcc, with warnings as errors. This takes a separate folder, since make does not know which
# objects were compiled with warnings, unless WERROR=1 is set. Clang then only checks the sources. Its warning about
# promotions is off, because results leave a kernel by an exact conversion to the widest type. gcc checks promotions
# from float to double.
STRICT_B   := $(B)$(if $(WERROR),,/strict)
CLANG_READ := clang -fsyntax-only $(STD) $(WARN) -Werror -Wno-double-promotion $(INCLUDES)
MUSL_READ  := musl-gcc -fsyntax-only $(STD) $(WARN) -Wno-conversion -Werror $(INCLUDES) -idirafter /usr/include
SHALLOW    := $(addprefix --extra-arg=,-Xclang -analyzer-config -Xclang mode=shallow)
CHECKED    := $(DOUBLE) $(TYPED) $(ENGINE_C) $(SHELL_C) $(wildcard examples/*.c)
lint: $(HEADERS) | $(FIRST)
	clang-format --dry-run -Werror $(C_FILES) $(H_FILES)
	$(MAKE) --no-print-directory B=$(STRICT_B) WERROR=1 all $(patsubst $(B)/%,$(STRICT_B)/%,$(LINT_BIN))
	printf '%s\n' $(DOUBLE) $(TYPED) $(ENGINE_C) $(SHELL_C) | xargs -P $$(nproc) -n 8 $(CLANG_READ)
	printf '%s\n' $(TYPED) $(QUAD) | xargs -P $$(nproc) -n 4 $(CLANG_READ) -DDOMQ
	@# The library with the C library musl.
	printf '%s\n' $(DOUBLE) | xargs -P $$(nproc) -n 4 $(MUSL_READ)
	printf '%s\n' $(TYPED) $(QUAD) | xargs -P $$(nproc) -n 4 $(MUSL_READ) -DDOMQ
	printf '%s\n' $(filter-out tests/fuzz/%,$(filter tests/%,$(C_FILES))) | xargs -P $$(nproc) -n 8 $(CLANG_READ) -Wno-conversion -DBENCH_FLAGS='""'
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

# ---- Installation ----

# The folder under PREFIX for Python modules, preferably one that Python searches. Empty without Python.
PYTHONDIR ?= $(shell $(PYTHON3) -c 'import sys; \
  print(next((d[len(sys.argv[1]) + 1:] for d in sys.path if d.startswith(sys.argv[1] + "/lib") and d.endswith("-packages")), \
             "lib/python%d.%d/site-packages" % sys.version_info[:2]))' '$(PREFIX)' 2>/dev/null)

# Folders with their GNU names.
BINDIR     ?= $(PREFIX)/bin
LIBDIR     ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
DATADIR    ?= $(PREFIX)/share
MANDIR     ?= $(DATADIR)/man
DOCDIR     ?= $(DATADIR)/doc/domino

# Each installed file and its folder, as shell words.
EXAMPLES  := $(wildcard examples/*.* examples/*/*)
COMPLETIONS := $(addprefix $(B)/completion/,domino _domino domino.fish)
IN         = $(foreach file,$(1),'$(file)' "$(2)")
INSTALLED  = $(call IN,$(P)/domino,$(BINDIR)) $(call IN,$(P)/libdomino.a $(B)/$(SONAME) $(B)/libdomino.so,$(LIBDIR)) \
  $(call IN,$(wildcard include/*.h) $(B)/include/domino_quad.h,$(INCLUDEDIR)) \
  $(call IN,$(B)/domino.pc,$(LIBDIR)/pkgconfig) \
  $(foreach page,$(PAGES),$(call IN,$(page),$(MANDIR)/man$(subst .,,$(suffix $(page))))) \
  $(call IN,$(B)/completion/domino,$(DATADIR)/bash-completion/completions) \
  $(call IN,$(B)/completion/_domino,$(DATADIR)/zsh/site-functions) \
  $(call IN,$(B)/completion/domino.fish,$(DATADIR)/fish/vendor_completions.d) \
  $(call IN,README.md,$(DOCDIR)) $(foreach file,$(EXAMPLES),$(call IN,$(file),$(DOCDIR)/$(patsubst %/,%,$(dir $(file))))) \
  $(if $(PYTHONDIR),$(call IN,$(addprefix $(B)/python/domino/,$(notdir $(PYTHON_PY)) _api.py),$(PREFIX)/$(PYTHONDIR)/domino))
MANIFEST   = "$(DOCDIR)/installed"

$(B)/completion/domino: src/shell/prompt/domino.bash
$(B)/completion/_domino: src/shell/prompt/domino.zsh
$(B)/completion/domino.fish: src/shell/prompt/domino.fish
$(COMPLETIONS):
	@mkdir -p $(@D) && cp $< $@

# domino.pc is written again for the folders of this installation.
install: all $(COMPLETIONS) $(if $(filter install,$(MAKECMDGOALS)),$(if $(PYTHONDIR),python))
	@printf '%s\t%s\n' $(INSTALLED) | DESTDIR="$(DESTDIR)" .packaging/install $(MANIFEST)
	@$(PC_TEXT) > "$(DESTDIR)$(LIBDIR)/pkgconfig/domino.pc"

uninstall:
	@DESTDIR="$(DESTDIR)" .packaging/install --remove $(MANIFEST)

# Debian packages in .build/deb. Their program links GSL and Readline dynamically.
deb: $(B)/shared/domino
	+@MAKE='$(MAKE)' .packaging/deb $(VERSION) $(SONAME) '$(abspath $(B))'

# Packs the tracked files or, in an unpacked archive, all files. The text of the licence comes from the system, and is
# added as COPYING. The same files give the same bytes, so an unpacked archive packs itself again.
LICENCE = $(firstword $(wildcard COPYING /usr/share/common-licenses/GPL-3))
DIST = domino-$(VERSION)
BY_GIT = [ -e .git ] && git rev-parse HEAD >/dev/null 2>&1
dist:
	@mkdir -p $(B)
	@if $(BY_GIT); then git ls-files; else find * .[!.]* \
	  -path .git -prune -o -path .build -prune -o -path '$(B)' -prune -o -type f -print; fi | grep -vx COPYING > $(B)/dist.files
	@$(if $(LICENCE),cp $(LICENCE) $(B)/COPYING,echo 'make dist: the archive has no COPYING, since this system has no text of the GPL' >&2)
	@date=$${SOURCE_DATE_EPOCH:-$$(if $(BY_GIT); then git log -1 --format=%ct; else stat -c %Y Makefile; fi)} && \
	LC_ALL=C sort $(B)/dist.files | tar -cf $(B)/$(DIST).tar --no-recursion --format=ustar --mtime="@$$date" \
	  --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX --transform='s|^|$(DIST)/|' -T - $(if $(LICENCE),-C $(B) COPYING) && \
	gzip -9 -n -f $(B)/$(DIST).tar && rm $(B)/dist.files && echo '  DIST  $(B)/$(DIST).tar.gz'

clean:
	rm -rf $(B)

-include $(shell find $(B)/obj $(B)/objq -name '*.d' 2>/dev/null)
