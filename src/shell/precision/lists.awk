# SPDX-License-Identifier: GPL-3.0-or-later
# Reads the typed part of the headers of libdomino, and prints lists for any.h. For each structure without arrays, the
# members that are numbers, structures, pointers and others:
#   #define DOM_MEMBERS_limit(NUMBER, PART, POINTER, OTHER) NUMBER(r_max) OTHER(ends) OTHER(why) NUMBER(open)
# And the functions that ask a question about a train, by the type of the answer, and by whether they take a number:
#   #define DOM_FINDS(X) X(angles_find, angles) ...       DOM_FINDS_AT(X): the same, at a tilt
#   #define DOM_NUMBERS(X) X(cycle_duration) ...             DOM_NUMBERS_AT(X): the same, at a tilt or a time
#   awk -f lists.awk HEADER...

FNR == 1 { typed = 0 }
/^\/\* ==== / { typed = !typed }
!typed { next }

# Removes comments.
{
    code = ""
    for (line = $0; line != "";) {
        at = index(line, comment ? "*/" : "/*")
        if (!comment) code = code (at ? substr(line, 1, at - 1) : line)
        if (at) comment = !comment
        line = at ? substr(line, at + 2) : ""
    }
}

/^struct dom_[a-z_]+ \{/ { structure = substr($2, 5); members = ""; next }
structure && /^};/ {
    sub(/[a-z_]+ later\[DOM_LATER\];/, "", members) # room that a version does not use is not copied
    if (members !~ /[[(]|\*const/) print "#define DOM_MEMBERS_" structure "(NUMBER, PART, POINTER, OTHER)" list_of(members)
    structure = ""
}
structure { members = members " " code; next }

/^enum dom_status dom_/ { prototype = "" ; open = 1 }
open { prototype = prototype " " code }
open && /;/ { ask(prototype); open = 0 }

function list_of(members,   declaration, count, i, word, words, k, first, kind, type, list) {
    count = split(members, declaration, ";")
    for (i = 1; i < count; i++) {
        gsub(/const|volatile/, "", declaration[i])
        words = split(declaration[i], word, /[ ,]+/)
        first = word[1] == "" ? 2 : 1
        type = word[first] == "struct" || word[first] == "enum" ? word[++first] : ""
        kind = word[first] == "dom_real" ? "NUMBER" : word[first - 1] == "struct" ? "PART" : "OTHER"
        for (k = first + 1; k <= words; k++)
            list = list " " (word[k] ~ /^\*/ ? "POINTER(" substr(word[k], 2) : kind "(" word[k] (kind == "PART" ? ", " substr(type, 5) : "")) ")"
    }
    return list
}

function ask(prototype,   name, rest, at) {
    if (!match(prototype, /dom_[a-z_]+\(const struct dom_train \*train, const struct dom_compute \*compute, +/)) return
    rest = substr(prototype, RSTART + RLENGTH)
    name = substr(prototype, RSTART + 4, index(substr(prototype, RSTART), "(") - 5)
    at = sub(/^dom_real [a-z]+, +/, "", rest) ? "_AT" : ""
    if (rest ~ /^struct dom_[a-z_]+ \*[a-z]+\);/) {
        sub(/^struct dom_/, "", rest)
        sub(/ .*/, "", rest)
        lists["FINDS" at] = lists["FINDS" at] " X(" name ", " rest ")"
    } else if (rest ~ /^dom_real \*[a-z]+\);/)
        lists["NUMBERS" at] = lists["NUMBERS" at] " X(" name ")"
}

END { for (of in lists) print "#define DOM_" of "(X)" lists[of] }
