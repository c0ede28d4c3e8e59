/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The name at the beginning of a command: beginnings of names, synonyms, and what was meant. */
#include "interpreter/forms.h"
#include "session/parameters.h"
#include <string.h>

/* Returns the command that has a right to this ambiguous beginning, as an index of command_names; or that
 * there are several. */
static int shortest_command(const char *name)
{
    const char *all;
    for (int k = 0; (all = command_names(NULL, k)) != NULL; k++) {
        const char *shortest = command_find(all)->shortest;
        if (shortest && strlen(name) >= strlen(shortest) && strncmp(all, name, strlen(name)) == 0)
            return k;
    }
    return NAMES_SEVERAL;
}

/* Returns the first command that has the word among its synonyms; NULL: none. */
static const char *synonym_command(const char *word)
{
    const char *name;
    size_t length = strlen(word);
    for (int k = 0; length > 2 && (name = command_names(NULL, k)) != NULL; k++)
        for (const char *s = command_find(name)->synonyms; s && *s; s += strspn(s, " ")) {
            size_t n = strcspn(s, " ");
            if (n == length && strncmp(s, word, n) == 0)
                return name;
            s += n;
        }
    return NULL;
}

/* Reports that there is no such command, with what was meant as far as that is known. */
static void command_unknown(struct reader *r, const char *name, int k, char message[NAMES_MESSAGE])
{
    const char *meant = k == NAMES_UNKNOWN ? synonym_command(name) : NULL;
    bool usual;
    const struct parameter *p = parameter_by_synonym(name, &usual);
    char plain[2 * NAMES_MESSAGE], shown[NAMES_SHOWN];
    snprintf(plain, sizeof plain, "unknown command '%s'", names_shown(name, shown));
    if (variable_find(&r->query->state->variables, name))
        problem_error(r->problem, "'%s' is a variable; '%s = VALUE' changes it, '%s' shows it", name, name,
                      name);
    else if (!meant && names_exact(expression_names, NULL, name) >= 0 && strcmp(name, "pi") != 0)
        problem_error(r->problem, "'%s' is a function; its values are in parentheses, as in '%s(2)'", name,
                      name);
    else if (p && (usual || (!meant && !p->setting && k == NAMES_UNKNOWN)) && !effect_hint(name, message) &&
             parameter_hint(name, plain, sizeof plain))
        problem_error(r->problem, "%s", plain);
    else if (effect_hint(name, message) || (!meant && k != NAMES_UNKNOWN))
        problem_error(r->problem, "%s", message);
    else if (meant)
        problem_error(r->problem, "%s; did you mean '%s'?", message, meant);
    else
        problem_error(r->problem, "%s; 'help' lists the commands", message);
}

const struct command *read_command(struct reader *r, names_list *offered)
{
    char message[NAMES_MESSAGE] = "out of memory";
    const char *begin = r->at;
    offer_names(r, offered, NULL);
    r->problem->place = reader_column(r, begin);
    size_t length = strcspn(r->at, r->stops ? " \t\r\f\v;>,=" : " \t\r\f\v;>");
    char exact[VARIABLE_NAME];
    const struct command *typed = name_copy(r->at, length, exact, sizeof exact) ? command_find(exact) : NULL;
    if (typed) { /* as in nearly every line */
        r->at += length;
        reader_named(r, begin, r->at);
        return typed;
    }
    const char *name = arena_text(r->arena, r->at, length);
    r->at += length;
    int k = name ? names_find(command_names, NULL, "command", name, message) : -1;
    if (k == NAMES_SEVERAL)
        k = shortest_command(name);
    const struct parameter *p = name ? parameter_find(name) : NULL;
    bool bare = k >= 0 && !command_find(command_names(NULL, k))->argument[0].kind;
    if (p && !p->effect && (k < 0 || (bare && !command_find(name)))) {
        k = NAMES_CLOSE;
        snprintf(message, sizeof message, "'%s' is a parameter; '%s = VALUE' gives it a value, '%s' shows it",
                 name, name, name);
    }
    if (k < 0 && !name)
        problem_error(r->problem, "%s", message);
    else if (k < 0)
        command_unknown(r, name, k, message);
    if (k >= 0)
        reader_named(r, begin, r->at);
    return k < 0 ? NULL : command_find(command_names(NULL, k));
}
