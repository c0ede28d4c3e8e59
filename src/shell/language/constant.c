/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/expression.h"
#include "language/text.h"
#include <stdio.h>

/* Finds a name in a tree, or NULL. */
static const struct tree *name_in(const struct tree *t)
{
    const struct tree *found = t->kind == TREE_NAME ? t : NULL;
    for (const struct tree *child = t->child; child && !found; child = child->next)
        found = name_in(child);
    return found;
}

bool expression_constant(const char *text, struct quantity *q, char message[EXPRESSION_MESSAGE],
                         const char **end)
{
    struct arena arena;
    struct evaluation e = {.angle = 1};
    struct parse p = {.text = text, .arena = &arena};
    arena_begin(&arena);
    const struct tree *t = expression_parse(&p), *name = t ? name_in(t) : NULL;
    const char *at = skip_blanks(p.end);
    bool good = t && !name && *at == '\0' && expression_evaluate(&e, t, q);
    if (t && name)
        snprintf(message, EXPRESSION_MESSAGE, "'%s' has no value in a file", name->name);
    else if (!good)
        snprintf(message, EXPRESSION_MESSAGE, "%s", !t ? p.message : *at ? "" : e.message);
    if (end)
        *end = name ? name->at : !t ? p.end : *at || good ? at : e.at;
    arena_free(&arena);
    return good;
}
