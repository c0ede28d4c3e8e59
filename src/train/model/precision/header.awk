# SPDX-License-Identifier: GPL-3.0-or-later
# Makes <domino_float.h> and <domino_quad.h> from the headers in include/, so that all precisions share one source: the
# text after the marker line of a header, "==== From here on", is written again with domf_ or domq_ instead of dom_, and
# likewise in capitals. Names that are declared before the marker, or in a header without a marker, are common to all.
# The headers are read twice: first for the names, then for the text. The letter is f or q.
#   awk -v letter=q -f header.awk HEADER... write=1 HEADER...             prints domino_quad.h
#   awk -v letter=q -v names=1 -f header.awk HEADER... write=1 HEADER...  prints '#define dom_train domq_train' and so on

# Collects the names in a line of code. Names before the marker are common to both headers; macros after it are renamed.
function learn(line) {
    if (line ~ /^( \*|\/\*)/)
        return
    gsub(/\/\*.*/, "", line)
    if (typed && line ~ /^#define DOM_/)
        macro[substr(line, 9, match(substr(line, 9) " ", /[^A-Za-z0-9_]/) - 1)] = 1
    while (!typed && match(line, /dom_[a-z_]+/)) {
        common[substr(line, RSTART, RLENGTH)] = 1
        line = substr(line, RSTART + RLENGTH)
    }
}

function prefixed(name) { return substr(name, 1, 3) (name ~ /^dom/ ? letter : toupper(letter)) substr(name, 4) }

# Returns the line with the names of the other precision. With `names`, prints a #define for each name when it first occurs.
function renamed(line,   name, own, done) {
    while (match(line, /(dom|DOM)_[A-Za-z0-9_]+/)) {
        name = substr(line, RSTART, RLENGTH)
        own = name ~ /^dom/ ? !(name in common) : name in macro
        if (own && names && !(name in seen)) print (name ~ /^dom/ ? "" : "#undef " name "\n") "#define " name " " prefixed(name)
        seen[name] = 1
        done = done substr(line, 1, RSTART - 1) (own ? prefixed(name) : name)
        line = substr(line, RSTART + RLENGTH)
    }
    return done line
}

FNR == 1 || /^#ifdef __cplusplus/ { typed = after = 0 }
/^\/\* ==== / { after = typed; typed = !typed }
!write { if (!after) learn($0); next }
!typed || /^\/\* ==== / { next }
!begun++ && !names {
    print "/* SPDX-License-Identifier: GPL-3.0-or-later */"
    arithmetic = letter == "f" ? "float" : "quad"
    print "/* libdomino in " (letter == "f" ? "float" : "the widest arithmetic") ". Generated from domino.h and domino_row.h, which document it. */"
    print "#ifndef DOMINO_" toupper(arithmetic) "_H\n#define DOMINO_" toupper(arithmetic) "_H\n\n#include \"domino_row.h\"\n"
    print "#ifdef __cplusplus\nextern \"C\" {\n#endif"
}
/^typedef double dom_real;/ && letter == "f" && !names {
    print "typedef float domf_real;"
    next
}
/^typedef double dom_real;/ && !names {
    print "#if defined __SIZEOF_FLOAT128__ && defined __GLIBC__ && !defined DOM_NO_FLOAT128"
    print "__extension__ typedef __float128 domq_real;\n#define DOMQ_REAL_FLOAT128"
    print "#else\ntypedef long double domq_real;\n#endif"
    next
}
{ line = renamed($0); if (!names) print line }
END { if (!names) print "\n#ifdef __cplusplus\n}\n#endif\n\n#endif" }
