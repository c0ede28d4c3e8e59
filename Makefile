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
# A stack protector and FORTIFY end the program after a buffer overflow. FORTIFY needs optimization. Tables of addresses
# are in memory that is read-only once they are filled. As in Debian, a function of a shared library is bound at its
# first call: to bind all 270 before main, with -z now, takes a quarter of the start-up time.
HARDEN  := -fstack-protector-strong $(if $(filter-out -O0,$(filter -O%,$(OPTIM))),-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
WARN    := -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes -Wvla
CFLAGS  ?= $(OPTIM) $(HARDEN)
# The linker and the archiver of macOS take other options than the GNU, LLVM and FreeBSD tools.
DARWIN  := $(filter Darwin,$(shell uname -s))
LDFLAGS ?= $(if $(DARWIN),,-Wl$(,)-z$(,)relro $(RELR))
# With this option the table of addresses that the dynamic linker adjusts is compact, which saves 140 KB. The option is
# used if the linker accepts it without a warning and a program linked with it runs here.
RELR     = $(if $(shell f=$(B)/relr.$$$$; echo 'int main(void) { return 0; }' | { $(CC) -x c - $(PACKED) -o $$f && $$f; } 2>&1 || echo no; rm -f $$f),,$(PACKED))
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
GSL     := -lgsl -lgslcblas -lm -pthread
# The program links GSL and Readline statically if their archives are installed, because loading the shared libraries
# takes a quarter of the start-up time.
THERE    = $(filter /%,$(shell $(CC) -print-file-name=$(1)))
PROGRAM := $(if $(call THERE,libgsl.a),-l:libgsl.a -l:libgslcblas.a,-lgsl -lgslcblas) \
           $(if $(and $(call THERE,libreadline.a),$(call THERE,libtinfo.a)),-l:libreadline.a -l:libtinfo.a,-lreadline) -lm -pthread

# ---- Features ----

# A feature is a folder with a feature.mk, which names what it needs. A folder within it that has a feature.mk, too, is
# what the feature does together with others, such as the charts of rows; it is built if all that it needs is built.
# 'make FEATURES="rows sweeps"' builds these two with what they need, and 'make FEATURES=' builds the shell and the train
# alone. The default is all.
FEATURE_MK := $(wildcard src/*/feature.mk src/*/*/feature.mk)
include $(FEATURE_MK)
EVERY    := $(subst /,_,$(patsubst src/%/feature.mk,%,$(FEATURE_MK)))
JOINT    := $(foreach f,$(EVERY),$(if $(findstring _,$f),$f))
# Each name once, after those that it needs.
with_needs = $(foreach f,$(1),$(call with_needs,$(NEEDS_$f)) $f)
once       = $(if $(1),$(firstword $(1)) $(call once,$(filter-out $(firstword $(1)),$(1))))
# A feature whose needs are not there is left out, unless FEATURES names it.
lacks      = $(filter-out $(EVERY),$(call with_needs,$(1)))
ifeq ($(origin FEATURES),undefined)
FEATURES := $(foreach f,$(filter-out $(JOINT),$(EVERY)),$(if $(call lacks,$f),$(info $f is left out, since it needs $(sort $(call lacks,$f))),$f))
endif
$(foreach f,$(call lacks,$(FEATURES)),$(error there is no feature '$f'; the features are $(filter-out $(JOINT) train,$(EVERY))))
BUILT    := $(call once,train $(call with_needs,$(FEATURES)))
BUILT    += $(foreach f,$(JOINT),$(if $(filter-out $(BUILT),$(NEEDS_$f)),,$f))
# Missing features that have a folder `model`. The headers in include/ declare their functions even if a whole feature
# is deleted.
PART     := $(filter-out $(BUILT),$(sort $(patsubst src/%/model,%,$(wildcard src/*/model)) chance explain pictures planning proof rows))
FOLDERS  := $(subst _,/,$(BUILT))

# src/train/model/precision compiles the model of trains and rows once for each precision. All other sources of the
# library are in double.
TRAIN   := src/train/model
MODEL   := $(addprefix $(TRAIN)/,texts.c many.c numerics/interrupt.c $(addprefix precision/,float.c double.c quad.c)) \
           $(wildcard $(TRAIN)/search/*.c $(patsubst %,src/%/model/*.c,$(filter-out train,$(BUILT))))
ENGINE_C := $(filter-out %/row_engine.c,$(wildcard $(patsubst %,src/%/*.c,$(filter engine,$(BUILT)))))
# The sources of a feature are in its folder, and in folders within it that are neither a model nor a feature.
SHELL_C := src/main.c $(wildcard src/shell/*/*.c) $(filter-out $(ENGINE_C) \
           $(foreach f,$(EVERY),$(if $(filter $f,$(BUILT)),,src/$(subst _,/,$f)/%)) src/train/model/% $(BUILT:%=src/%/model/%), \
           $(wildcard $(FOLDERS:%=src/%/*.c) $(FOLDERS:%=src/%/*/*.c)))
SHELL_C := $(sort $(SHELL_C))

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

.PHONY: all run python quick test unit hard sessions atlas faults sanitize race valgrind verify cross abi fuzz bench guard deps lint format removable \
        install uninstall deb dist clean
# A part of the library must not look like the whole.
all: $(P)/domino $(P)/libdomino.a $(if $(PART),,$(B)/libdomino.so $(B)/domino.pc)

# ---- Dependencies, but only those that the goals of this call need ----

DEPS_run      := libgsl-dev libreadline-dev $(if $(filter engine,$(BUILT)),libchipmunk-dev)
DEPS_deb      := dpkg-dev binutils

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

HEADERS := $(B)/include/domino_float.h $(B)/include/domino_quad.h $(B)/domf_names.h $(B)/domq_names.h $(B)/library.h $(B)/members.h $(B)/tutorial.h $(P)/feature_list.h # generated from other sources

$(B)/obj/%.o: %.c | $(FIRST)
	@mkdir -p $(@D)
	$(call SAY,CC,$<)
	$(Q)$(CC) $(C_FLAGS) -MMD -MP -c $< -o $@
$(call OBJ,$(MODEL) $(ENGINE_C) $(SHELL_C) $(wildcard tests/*/*.c)): | $(HEADERS)

# Writes the output of a command into the target if it differs. Tests run make in this folder at the same time, so the
# temporary file has a name of its own.
IF_CHANGED = > $@.$$$$ && { cmp -s $@.$$$$ $@ && rm $@.$$$$ || mv $@.$$$$ $@; }

# The features of this build, for src/features.c, and the names that belong to missing features, from the output of 'help
# features' in domino(1). What two features do together belongs to the missing one of the two.
$(P)/features.o: src/features.c $(P)/feature_list.h
	$(Q)$(CC) -I$(P) $(C_FLAGS) -c $< -o $@
$(P)/feature_list.h: FORCE
	@mkdir -p $(@D)
	@{ echo '#define FEATURES(X) $(foreach f,$(BUILT) shell,X($f))'; \
	  awk -v built=' $(BUILT) ' '/^\$$ domino .*help features/ { found = 1 } /^\.Ed/ { found = 0 } \
	  found && /^[a-z]/ { n = split($$1, part, "_"); for (k = 1; k < n && index(built, " " part[k] " "); k++); \
	    owner = part[k]; $$1 = "" } \
	  found && owner && !index(built, " " owner " ") { for (i = 1; i <= NF; i++) if ($$i != "") list = list " X(" $$i ", " owner ")" } \
	  END { print "#define ABSENT(X)" list }' man/domino.1; } $(IF_CHANGED)
FORCE:

# The names that the files of the library share. All files are compiled again if a name is added, but not after other
# changes.
SHARED_AWK := $(TRAIN)/precision/shared.awk
SHARED_OF  := $(wildcard $(TRAIN)/*/*.h src/*/model/*.h)
$(B)/library.h: $(SHARED_OF) $(SHARED_AWK)
	@mkdir -p $(@D)
	@awk -f $(SHARED_AWK) $(SHARED_OF) $(IF_CHANGED)

# The text of 'lesson', as numbers for a C array.
$(B)/tutorial.h: examples/tutorial.dom
	@mkdir -p $(@D)
	@od -An -v -td1 $< | sed 's/  */,/g; s/^,//; s/$$/,/' > $@

# <domino_float.h> and <domino_quad.h>, which are generated from these headers, and lists of their names and of the
# members of their structures, for the sources.
HEADER_AWK := $(TRAIN)/precision/header.awk
HEADER_OF  := include/domino_common.h include/domino.h include/domino_row.h
$(B)/include/domino_float.h $(B)/domf_names.h: LETTER := f
$(B)/include/domino_quad.h $(B)/domq_names.h: LETTER := q
$(B)/include/domino_float.h $(B)/include/domino_quad.h: $(HEADER_OF) $(HEADER_AWK)
	@mkdir -p $(@D)
	@awk -v letter=$(LETTER) -f $(HEADER_AWK) $(HEADER_OF) write=1 $(HEADER_OF) > $@
$(B)/domf_names.h $(B)/domq_names.h: $(HEADER_OF) $(HEADER_AWK)
	@mkdir -p $(@D)
	@awk -v letter=$(LETTER) -v names=1 -f $(HEADER_AWK) $(HEADER_OF) write=1 $(HEADER_OF) > $@
$(B)/members.h: $(HEADER_OF) src/shell/precision/lists.awk
	@mkdir -p $(@D)
	@awk -f src/shell/precision/lists.awk $(HEADER_OF) > $@

LIB_OBJ    := $(call OBJ,$(MODEL))
# With -flto the archive also has machine code, for programs that are linked without -flto.
LIB_FLAGS  := -fPIC -fvisibility=hidden -include $(B)/library.h $(if $(findstring -flto,$(CFLAGS)),-ffat-lto-objects) $(COVER)
$(LIB_OBJ): C_FLAGS += $(LIB_FLAGS)
$(call OBJ,$(TRAIN)/precision/float.c): C_FLAGS += -DDOMF
$(call OBJ,$(TRAIN)/precision/quad.c): C_FLAGS += -DDOMQ
# The sources that studies of rows run many times: the models in float and double, and FAST_x of each feature x.
FAST  := $(filter-out %/quad.c,$(filter $(TRAIN)/%,$(MODEL))) $(foreach f,$(BUILT),$(FAST_$f:%=src/$f/model/%))
# With -O1, compiling takes at most two thirds of the time. Code that calls these models is no slower with -O1, since the
# models take most of its time. Neither is the model in quad, in which library functions that multiply and add take most
# of the time. The models in float and double have the same options, because 'cost' compares their times.
WAITS := $(TRAIN)/precision/quad.c $(filter-out src/shell/commands/% src/shell/prompt/%,$(filter src/shell/%,$(SHELL_C)))
$(call OBJ,$(WAITS)): C_FLAGS += $(if $(filter -O2,$(CFLAGS)),-O1)
# With -Og, compiling takes even less time. Code that runs once per command executes as many instructions as with -O1.
# With -Og everywhere, a line would take 16 % more instructions, and quad with friction 10 % more.
ONCE  := $(filter-out $(FAST) $(WAITS),$(SHELL_C) $(MODEL))
$(call OBJ,$(ONCE)): C_FLAGS += $(if $(filter -O2,$(CFLAGS)),-Og)

$(LIB_OBJ): $(B)/library.h
# Objects from different folders may have the same name, so 'ar q' appends them. 'ar r' would replace one with the other.
$(P)/libdomino.a: $(LIB_OBJ) $(P)/feature_list.h
	$(call SAY,AR,$@)
	$(Q)rm -f $@
	$(Q)$(AR) $(if $(DARWIN),qcs,qcsD) $@ $(LIB_OBJ)

# If a structure or a function changes, the major version must increase. It is the number in the soname.
MAJOR  := $(firstword $(subst ., ,$(VERSION)))
SONAME := libdomino.so.$(MAJOR)
# The library exports the functions that begin with dom_, domf_ or domq_.
ifeq ($(DARWIN),)
EXPORTS  = 'DOMINO_$(MAJOR) { global: dom_*; domf_*; domq_*; local: *; };'
SHARED   = -shared -Wl,-soname,$(SONAME) -Wl,--version-script=$(B)/libdomino.map
else
EXPORTS  = '_dom_*' '_domf_*' '_domq_*'
SHARED   = -dynamiclib -Wl,-install_name,$(LIBDIR)/$(SONAME) -Wl,-exported_symbols_list,$(B)/libdomino.map
endif
$(B)/$(SONAME): $(LIB_OBJ)
	$(call SAY,LD,$@)
	@printf '%s\n' $(EXPORTS) > $(B)/libdomino.map
	$(Q)$(CC) $(C_FLAGS) $(LDFLAGS) $(SHARED) $^ $(GSL) -o $@
$(B)/libdomino.so: $(B)/$(SONAME)
	@ln -sf $(SONAME) $@

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
# The module declares every function of the headers, so it needs the whole library.
$(B)/python/domino/_api.py: src/python/header.py $(wildcard include/*.h) $(PYTHON_PY) Makefile
	$(if $(PART),$(error the Python module needs all features: $(PART)))
	@mkdir -p $(@D)
	$(Q)cp $(PYTHON_PY) $(@D)
	$(call SAY,PY,$@)
	$(Q)$(PYTHON3) src/python/header.py $(SONAME) '$(CC)' include/domino_study.h include/domino_proof.h > $@.$$$$ && mv $@.$$$$ $@

run: all
	@$(P)/domino

# ---- Tests, checks, fuzzing, speed ----

-include tests/tests.mk # the program is built without it, too

# All that the goals of this call need, for 'deps'.
NEEDED := $(sort $(DEPS_run) $(foreach goal,$(MAKECMDGOALS),$(DEPS_$(goal))))

# ---- Installation ----

# The folder under PREFIX for Python modules, preferably one that Python searches. Empty without Python, and for a part of the library.
PYTHONDIR ?= $(if $(PART),,$(shell $(PYTHON3) -c 'import sys; \
  print(next((d[len(sys.argv[1]) + 1:] for d in sys.path if d.startswith(sys.argv[1] + "/lib") and d.endswith("-packages")), \
             "lib/python%d.%d/site-packages" % sys.version_info[:2]))' '$(PREFIX)' 2>/dev/null))

# Folders with their GNU names.
BINDIR     ?= $(PREFIX)/bin
LIBDIR     ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
DATADIR    ?= $(PREFIX)/share
MANDIR     ?= $(DATADIR)/man
DOCDIR     ?= $(DATADIR)/doc/domino

# Each installed file and its folder, as shell words. A part of the library has no shared library and no Python module.
EXAMPLES  := $(wildcard examples/*.* examples/*/*)
IN         = $(foreach file,$(1),'$(file)' "$(2)")
INSTALLED  = $(call IN,$(P)/domino,$(BINDIR)) $(call IN,$(P)/libdomino.a $(if $(PART),,$(B)/$(SONAME) $(B)/libdomino.so),$(LIBDIR)) \
  $(call IN,$(wildcard include/*.h) $(B)/include/domino_float.h $(B)/include/domino_quad.h,$(INCLUDEDIR)) \
  $(if $(PART),,$(call IN,$(B)/domino.pc,$(LIBDIR)/pkgconfig)) \
  $(foreach page,$(PAGES),$(call IN,$(page),$(MANDIR)/man$(subst .,,$(suffix $(page))))) \
  $(call IN,README.md,$(DOCDIR)) $(foreach file,$(EXAMPLES),$(call IN,$(file),$(DOCDIR)/$(patsubst %/,%,$(dir $(file))))) \
  $(if $(PYTHONDIR),$(call IN,$(addprefix $(B)/python/domino/,$(notdir $(PYTHON_PY)) _api.py),$(PREFIX)/$(PYTHONDIR)/domino))
MANIFEST   = "$(DOCDIR)/installed"

# domino.pc is written again for the folders of this installation.
install: all $(if $(filter install,$(MAKECMDGOALS)),$(if $(PYTHONDIR),python))
	@printf '%s\t%s\n' $(INSTALLED) | DESTDIR="$(DESTDIR)" .packaging/install $(MANIFEST)
	$(if $(PART),,@$(PC_TEXT) > "$(DESTDIR)$(LIBDIR)/pkgconfig/domino.pc")

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

-include $(shell find $(B)/obj -name '*.d' 2>/dev/null)
