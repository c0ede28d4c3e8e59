# SPDX-License-Identifier: GPL-3.0-or-later
# Reads the typed part of the headers of libdomino, and prints lists and functions for any.h. For each structure without
# arrays, its members that are numbers, pointers and others; none of them is a structure:
#   #define DOM_MEMBERS_limit(NUMBER, POINTER, OTHER) NUMBER(r_max) OTHER(ends) OTHER(why) NUMBER(open)
# The functions that ask about a train, by the type of the answer, and by whether they take a number:
#   #define DOM_FINDS(X) X(angles_find, angles) ...       DOM_FINDS_AT(X): the same, at a tilt
#   #define DOM_NUMBERS(X) X(cycle_duration) ...             DOM_NUMBERS_AT(X): the same, at a tilt or a time
# The prototypes of any_angles_find and the like. With ASKS_NARROW, the functions that convert a question to a narrow
# precision, ask the library and convert the answer back; with ASKS_ANY, those that choose the precision.
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
    if (members !~ /[[(]|\*const/) print "#define DOM_MEMBERS_" structure "(NUMBER, POINTER, OTHER)" list_of(members)
    if (members !~ /[[(*]/) structures = structures " X(" structure ")"
    structure = ""
}
structure { members = members " " code; next }

/^typedef bool dom_[a-z_]*visit\(|^enum dom_status dom_/ { prototype = "" ; open = 1 }
open { prototype = prototype " " code }
open && /;/ {
    gsub(/ +/, " ", prototype)
    if (prototype ~ /typedef/) visitor(prototype)
    else ask(prototype)
    open = 0
}

function list_of(members,   declaration, count, i, word, words, k, first, kind, list) {
    count = split(members, declaration, ";")
    for (i = 1; i < count; i++) {
        gsub(/const|volatile/, "", declaration[i])
        words = split(declaration[i], word, /[ ,]+/)
        first = word[1] == "" ? 2 : 1
        first += word[first] == "struct" || word[first] == "enum"
        kind = word[first] == "dom_real" ? "NUMBER" : "OTHER"
        for (k = first + 1; k <= words; k++)
            list = list " " (word[k] ~ /^\*/ ? "POINTER(" substr(word[k], 2) : kind "(" word[k]) ")"
    }
    return list
}

# The parameters of a prototype, their names, and the structures to which some of them point.
function parse(prototype,   count, i) {
    sub(/^[^(]*\(/, "", prototype)
    sub(/\).*/, "", prototype)
    count = split(prototype, parameter, / *, */)
    for (i = 1; i <= count; i++) {
        name[i] = parameter[i]
        sub(/.*[ *]/, "", name[i])
        pointed[i] = match(parameter[i], /struct dom_[a-z_]+ \*/) ? substr(parameter[i], RSTART + 11, RLENGTH - 13) : ""
    }
    return count
}

function join(list, text) { return list (list == "" ? "" : ", ") text }

# Converts the structures that a function of the library visits, such as a link, for the visitor of the caller.
function visitor(prototype,   type, count, i, before, arguments, parameters) {
    match(prototype, /dom_[a-z_]*visit/)
    type = substr(prototype, RSTART + 4, RLENGTH - 4)
    visitors = visitors " X(" type ")"
    count = parse(prototype)
    for (i = 1; i < count; i++) {
        parameters = parameters "const struct NARROW(" pointed[i] ") *" name[i] ", "
        before = before "    struct domq_" pointed[i] " " name[i] "_;\n    if (" name[i] ")\n        OWN(" pointed[i] "_out)(&" name[i] "_, " name[i] ");\n"
        arguments = join(arguments, name[i] " ? &" name[i] "_ : NULL")
    }
    narrow = narrow "static bool OWN(" type ")(" parameters "void *context)\n{\n    const struct visitor *v = context;\n" before "    return v->" type "(" arguments ", v->context);\n}\n"
}

# Makes the functions for a question that the library answers in each precision.
function ask(prototype,   find, count, i, p, v, at, signature, own, quad, before, arguments, after, needs, given) {
    match(prototype, /dom_[a-z_]+\(/)
    find = substr(prototype, RSTART + 4, RLENGTH - 5)
    count = parse(prototype)
    if (find != "count_find" && (name[2] != "compute" || pointed[1] !~ /^(train|row)$/)) return
    at = parameter[3] ~ /^dom_real [a-z]+$/ ? "_AT" : ""
    if (name[1] == "train" && count == (at ? 4 : 3) && name[count] != "context")
        lists[(pointed[count] ? "FINDS" : "NUMBERS") at] = lists[(pointed[count] ? "FINDS" : "NUMBERS") at] " X(" find (pointed[count] ? ", " pointed[count] : "") ")"
    given = "status == DOM_OK || status == DOM_NO_FUEL || status == DOM_STOPS || status == DOM_OPEN"
    for (i = 1; i <= count; i++) {
        p = parameter[i]
        v = name[i]
        if (find == "count_find" && i == count) { # the library counts without options
            signature = join(signature, "const struct any_compute *compute")
            own = join(own, "compute")
        }
        gsub(/dom_/, "domq_", p)
        gsub(/enum domq_/, "enum dom_", p)
        gsub(/struct domq_compute/, "struct any_compute", p)
        signature = join(signature, p)
        own = join(own, v)
        quad = join(quad, v == "compute" ? "&compute_" : v)
        if (v == "train" || v == "compute" || v == "row") {
            before = before "    const struct NARROW(" v ") " v "_ = OWN(" v "_in)(" v ");\n"
            arguments = join(arguments, "&" v "_")
        }
        if (v == "row") {
            needs = needs "row_.domino && "
            after = after "    free((void *)row_.domino);\n"
        } else if (p ~ /_visit|domq_visit/) {
            sub(/^domq_/, "", p)
            sub(/ .*/, "", p)
            before = before "    struct visitor visitor_ = {." p " = visit, .context = context};\n"
            arguments = join(arguments, "visit ? OWN(" p ") : NULL, &visitor_")
        } else if (v == "events") {
            before = before "    struct NARROW(event) events_[DOM_EVENTS_MAX];\n"
            arguments = join(arguments, "events_")
            after = after "    for (int k = 0; k < *count; k++)\n        OWN(event_out)(&events[k], &events_[k]);\n"
        } else if (i > 1 && pointed[i] && v != "compute") {
            before = before "    struct NARROW(" pointed[i] ") " v "_;\n    memset(&" v "_, " (v == "verdict" ? "0" : "0xff") ", sizeof " v "_);\n"
            arguments = join(arguments, "&" v "_")
            after = after "    if (" (v == "verdict" ? "status == DOM_OK || verdict_.domino > 0" : given) ")\n        OWN(" pointed[i] "_out)(" v ", &" v "_);\n"
        } else if (p ~ /^domq_real \*/) {
            before = before "    NARROW(real) " v "_ = (NARROW(real))NAN;\n"
            arguments = join(arguments, "&" v "_")
            after = after "    *" v " = " v "_;\n"
        } else if (p ~ /^domq_real/)
            arguments = join(arguments, "(NARROW(real))" v)
        else if (v != "train" && v != "compute" && v != "context")
            arguments = join(arguments, v)
    }
    arguments = "NARROW(" find ")(" arguments ")"
    if (needs) arguments = substr(needs, 1, length(needs) - 4) " ? " arguments " : DOM_NO_MEMORY"
    prototypes = prototypes "enum dom_status any_" find "(" signature ");\n"
    narrow = narrow "static enum dom_status OWN(" find ")(" signature ")\n{\n" (find == "count_find" ? "    (void)compute;\n" : "") \
        before "    enum dom_status status = " arguments ";\n" after "    return status;\n}\n"
    any = any "enum dom_status any_" find "(" signature ")\n{\n    const enum precision in = " (name[1] == "row" ? "row->engine ? IN_DOUBLE : " : "") "compute->precision;\n" \
        (quad ~ /compute_/ ? "    const struct domq_compute compute_ = quad_compute(compute);\n" : "") \
        "    return in == IN_FLOAT ? float_" find "(" own ") : in == IN_DOUBLE ? double_" find "(" own ") : domq_" find "(" quad ");\n}\n"
}

END {
    for (of in lists) print "#define DOM_" of "(X)" lists[of]
    print "#define DOM_STRUCTURES(X)" structures
    print "#define DOM_VISITORS(X)" visitors
    print "#ifdef ASKS_NARROW\n" narrow "#elif defined ASKS_ANY\n" any "#elif defined ASKS_PROTOTYPES\n" prototypes "#endif"
}
