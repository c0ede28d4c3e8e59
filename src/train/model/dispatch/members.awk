# SPDX-License-Identifier: GPL-3.0-or-later
# Prints a macro for each structure that exists in double and in quad, and has no pointers and no arrays:
#   #define DOM_MEMBERS_limit(NUMBER, OTHER, PART) NUMBER(r_max) OTHER(ends) OTHER(why) PART(error, limit_error)
# NUMBER is applied to members of the type dom_real, PART to structures, OTHER to all other members.
#   awk -f members.awk HEADER...

FNR == 1 { typed = 0 }
/^\/\* ==== / { typed = !typed }

typed && /^struct dom_[a-z_]+ \{/ {
    structure = substr($2, 5)
    members = ""
    next
}

# Appends the code of the line, without comments, to the members.
structure && !/^};/ {
    for (line = $0; line != "";) {
        at = index(line, comment ? "*/" : "/*")
        if (!comment) members = members " " (at ? substr(line, 1, at - 1) : line)
        if (at) comment = !comment
        line = at ? substr(line, at + 2) : ""
    }
}

structure && /^};/ {
    if (members !~ /[*[(]/) {
        list = ""
        count = split(members, declaration, ";")
        for (i = 1; i < count; i++) {
            words = split(declaration[i], word, /[ ,]+/)
            first = word[1] == "" ? 2 : 1
            tagged = word[first] == "struct" || word[first] == "enum"
            for (k = first + 1 + tagged; k <= words; k++)
                list = list (word[first] == "dom_real" ? " NUMBER(" : word[first] == "struct" ? " PART(" : " OTHER(") word[k] \
                    (word[first] == "struct" ? ", " substr(word[first + 1], 5) : "") ")"
        }
        print "#define DOM_MEMBERS_" structure "(NUMBER, OTHER, PART)" list
    }
    structure = ""
}
