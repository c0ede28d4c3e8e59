# SPDX-License-Identifier: GPL-3.0-or-later
# Makes library.h, which is included before each source of the library. The library shows only the functions of its
# public headers: visibility is on while a source includes them, and off otherwise. The functions and tables that its
# files share are hidden, and get names that begin with dom__, domf__ or domq__, so that they do not clash with functions
# of a program that links the archive.
#   awk -f shared.awk HEADER...     reads the headers of the folders model
BEGIN {
    print "#pragma GCC visibility push(default)"
    print "#include \"domino_float.h\"\n#include \"domino_quad.h\""
    print "#pragma GCC visibility pop"
    print "#if defined DOMF\n#define SHARED(name) domf__##name\n#elif defined DOMQ\n#define SHARED(name) domq__##name"
    print "#else\n#define SHARED(name) dom__##name\n#endif"
}

function share(name) { if (name !~ /^dom[fq]?_/ && !seen[name]++) print "#define " name " SHARED(" name ")" }

{ sub(/^KERNEL_SHARED /, "") }
/^extern const struct/ {
    gsub(/^extern const struct [a-z_]+|const |[][;*,]/, "")
    for (i = 1; i <= NF; i++) share($i)
}
/^[a-z][a-z_0-9 *]*[ *][a-z_0-9]+\(/ && !/^(static|typedef|extern) / {
    sub(/\(.*/, "")
    sub(/.*[ *]/, "")
    share($0)
}
