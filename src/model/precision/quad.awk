# SPDX-License-Identifier: GPL-3.0-or-later
# Makes <domino_quad.h> of domino.h, so that both have one text: what follows the marker line, "==== From here on", is
# written again with domq_ and DOMQ_ instead of dom_ and DOM_; names that are declared before it are common to both.
#   awk -f quad.awk domino.h domino.h             prints domino_quad.h
#   awk -v names=1 -f quad.awk domino.h domino.h  prints '#define dom_train domq_train' and so on, for the sources

# Collects the names in a line of code: those before the marker are common, macros after it are not.
function learn(line) {
    if (line ~ /^( \*|\/\*)/)
        return
    gsub(/\/\*.*/, "", line)
    if (typed && line ~ /^#define DOM_/)
        macro[substr(line, 9, match(substr(line, 9) " ", /[^A-Za-z0-9_]/) - 1)] = 1
    for (rest = line; names && !typed && match(rest, /X\([a-z]+/); rest = substr(rest, RSTART + RLENGTH)) {
        effect = substr(rest, RSTART + 2, RLENGTH - 2) # of a list of effects: dom_effect_NAME is put together
        print "#define dom_effect_" effect " domq_effect_" effect
    }
    while (!typed && match(line, /dom_[a-z_]+/)) {
        common[substr(line, RSTART, RLENGTH)] = 1
        line = substr(line, RSTART + RLENGTH)
    }
}

function in_quad(name) { return substr(name, 1, 3) (name ~ /^dom/ ? "q" : "Q") substr(name, 4) }

# Returns the line with the names of quad; with `names`, prints each of them once.
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

FNR == 1 { typed = 0; file++ }
/^\/\* ==== / { typed = 1 }
file == 1 { learn($0); next }
FNR == 1 && !names {
    print "/* SPDX-License-Identifier: GPL-3.0-or-later */"
    print "/* libdomino in the widest arithmetic of the machine: made of domino.h, which says the rest. */"
    print "#ifndef DOMINO_QUAD_H\n#define DOMINO_QUAD_H\n\n#include \"domino.h\"\n"
    print "#ifdef __cplusplus\nextern \"C\" {\n#endif"
}
!typed || /^\/\* ==== / { next }
/^typedef double dom_real;/ && !names {
    print "#if defined __SIZEOF_FLOAT128__ && defined __GLIBC__ && !defined DOM_NO_FLOAT128"
    print "__extension__ typedef __float128 domq_real;\n#define DOMQ_REAL_FLOAT128"
    print "#else\ntypedef long double domq_real;\n#endif"
    next
}
{ line = renamed($0); if (!names) print line }
