# SPDX-License-Identifier: GPL-3.0-or-later
# Makes <domino_quad.h> from the headers in include/, so that double and quad share one source: the text after the
# marker line of a header, "==== From here on everything is also", is written again with domq_ and DOMQ_ instead of dom_
# and DOM_, up to the marker "==== From here on everything exists only". Names that are declared before the first marker,
# or in a header without a marker, are common to both. The headers are read twice: first for the names, then for the text.
#   awk -f quad.awk HEADER... write=1 HEADER...             prints domino_quad.h
#   awk -v names=1 -f quad.awk HEADER... write=1 HEADER...  prints '#define dom_train domq_train' and so on

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

function in_quad(name) { return substr(name, 1, 3) (name ~ /^dom/ ? "q" : "Q") substr(name, 4) }

# Returns the line, renamed for quad. With `names`, prints a #define for each name when it first occurs.
function renamed(line,   name, own, done) {
    while (match(line, /(dom|DOM)_[A-Za-z0-9_]+/)) {
        name = substr(line, RSTART, RLENGTH)
        own = name ~ /^dom/ ? !(name in common) : name in macro
        if (own && names && !(name in seen)) print (name ~ /^dom/ ? "" : "#undef " name "\n") "#define " name " " in_quad(name)
        seen[name] = 1
        done = done substr(line, 1, RSTART - 1) (own ? in_quad(name) : name)
        line = substr(line, RSTART + RLENGTH)
    }
    return done line
}

FNR == 1 || /^#ifdef __cplusplus/ { typed = single = 0 }
/^\/\* ==== / { single = typed; typed = !typed }
single { next }
!write { learn($0); next }
!typed || /^\/\* ==== / { next }
!begun++ && !names {
    print "/* SPDX-License-Identifier: GPL-3.0-or-later */"
    print "/* libdomino in the widest arithmetic. Generated from domino.h and domino_row.h, which document it. */"
    print "#ifndef DOMINO_QUAD_H\n#define DOMINO_QUAD_H\n\n#include \"domino_row.h\"\n"
    print "#ifdef __cplusplus\nextern \"C\" {\n#endif"
}
/^typedef double dom_real;/ && !names {
    print "#if defined __SIZEOF_FLOAT128__ && defined __GLIBC__ && !defined DOM_NO_FLOAT128"
    print "__extension__ typedef __float128 domq_real;\n#define DOMQ_REAL_FLOAT128"
    print "#else\ntypedef long double domq_real;\n#endif"
    next
}
{ line = renamed($0); if (!names) print line }
END { if (!names) print "\n#ifdef __cplusplus\n}\n#endif\n\n#endif" }
