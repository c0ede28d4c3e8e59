/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/forms.h"
#include "session/parameters.h"
#include <ctype.h>
#include <string.h>

/* Returns true for blanks, and what else ends a word that is a whole command. */
static bool word_ends(const char *c)
{
    return isspace((unsigned char)*c) || command_ends(c) || *c == '>';
}

/* Reads one name of a definition, with the blanks around it; returns the place after it, or NULL. */
static const char *definition_name(const char *c, char name[VARIABLE_NAME])
{
    c = skip_blanks(c);
    size_t n = name_start(*c) ? name_length(c) : 0;
    if (n == 0 || n >= VARIABLE_NAME)
        return NULL;
    name_copy(c, n, name, VARIABLE_NAME);
    return skip_blanks(c + n);
}

const char *definition_head(const char *c, struct variable *v)
{
    *v = (struct variable){.body = NULL};
    c = definition_name(c, v->name);
    for (const char *sep = "("; c && *c == *sep; sep = ",") {
        if (v->count == EXPRESSION_ARGUMENTS)
            return NULL;
        c = definition_name(c + 1, v->argument[v->count++]);
    }
    if (c && v->count > 0)
        c = *c == ')' ? skip_blanks(c + 1) : NULL;
    return c && c[0] == '=' && c[1] != '=' ? c + 1 : NULL;
}

bool goes_on(const char *c)
{
    bool blank = isspace((unsigned char)c[-1]);
    return (*c && strchr("*/^<", *c)) || ((*c == '>' || *c == '!' || *c == '=') && c[1] == '=') ||
           (strncmp(c, "and", 3) == 0 && isspace((unsigned char)c[3])) ||
           (strncmp(c, "or", 2) == 0 && isspace((unsigned char)c[2])) ||
           ((*c == '+' || *c == '-') && (!blank || isspace((unsigned char)c[1]))) ||
           (strncmp(c, "to", 2) == 0 && isspace((unsigned char)c[2]));
}

/* Returns true if the line is an expression, perhaps a wrong one. */
static bool is_expression(const struct state *state, const char *c)
{
    char name[VARIABLE_NAME];
    size_t n = name_start(*c) ? name_length(c) : 0;
    const char *next = skip_blanks(c + n);
    if (n == 0)
        return *c && (isdigit((unsigned char)*c) || strchr("(.+-", *c));
    if (!word_ends(c + n))
        return strchr("(*/^+-.", c[n]) != NULL;
    name_copy(c, n, name, sizeof name);
    const struct command *command = command_find(name);
    int fewest;
    if (command)
        return command_values(command, &fewest) >= 0 && goes_on(next);
    if (strcmp(name, "not") == 0)
        return next > c + n;
    bool alone = !parameter_find(name) && (command_ends(next) || *next == '>');
    return names_exact(value_names, state, name) >= 0 && (alone || goes_on(next));
}

/* Returns the command that is called as a function, "quit()" or "print(2)", where it has no value; or NULL.
 */
static const struct command *called(struct reader *r, const char *c, size_t n)
{
    char name[VARIABLE_NAME];
    int fewest;
    if (n == 0 || n >= VARIABLE_NAME || c[n] != '(')
        return NULL;
    name_copy(c, n, name, sizeof name);
    const struct command *command = command_find(name);
    bool empty = c[n + 1] == ')' && word_ends(c + n + 2);
    if (!command || command_values(command, &fewest) >= 0 || (!empty && strcmp(name, "print") != 0))
        return NULL;
    reader_named(r, c, c + n);
    r->at = c + n + (empty ? 2 : 0);
    return command;
}

/* Returns true for what other calculators call their last values: '_', '%', '%1', 'ans2'. */
static bool is_history(const struct state *state, const char *c, size_t n)
{
    size_t name = n ? n : *c == '%' || *c == '$' ? 1 : 0;
    bool digits = n > 3 && strncmp(c, "ans", 3) == 0 && strspn(c + 3, "0123456789") == n - 3;
    char word[VARIABLE_NAME];
    name_copy(c, n, word, sizeof word);
    return name > 0 && (digits || n == 0 || strspn(c, "_") == n) && !variable_find(&state->variables, word);
}

/* Returns the command that an assignment means, or NULL after an error: there is nothing of this name. */
static const struct command *assignment(struct reader *r, const struct variable *v)
{
    char message[NAMES_MESSAGE];
    bool usual;
    const struct parameter *p = parameter_find(v->name);
    if (p && v->count == 0)
        return command_find("set");
    if (variable_find(&r->query->state->variables, v->name))
        return command_find("let");
    int k = v->count ? NAMES_UNKNOWN : names_find(parameter_names, NULL, "parameter", v->name, message);
    if (k == NAMES_CLOSE)
        problem_error(r->problem, "%s 'let %s = VALUE' defines a variable", message, v->name);
    else if (v->count == 0 && (p = parameter_by_synonym(v->name, &usual)) != NULL)
        problem_error(r->problem,
                      "'%s' is no parameter; did you mean '%s'? 'let %s = VALUE' defines a variable", v->name,
                      p->name, v->name);
    else
        problem_error(r->problem, "'%s' is no parameter; 'let %s%s = VALUE' defines a %s", v->name, v->name,
                      v->count ? "(...)" : "", v->count ? "function" : "variable");
    return NULL;
}

/*
 * Returns the command whose whole name begins the line, if a digit comes after it, as in nearly every line of
 * a file: no form has one there. Else returns NULL.
 */
static const struct command *plain_command(struct reader *r, const char *c, size_t n)
{
    char name[VARIABLE_NAME];
    const char *next = skip_blanks(c + n);
    if (next == c + n || !isdigit((unsigned char)*next) || !name_copy(c, n, name, sizeof name))
        return NULL;
    const struct command *command = command_find(name);
    if (command) {
        r->problem->place = reader_column(r, c);
        r->at = c + n;
        reader_named(r, c, r->at);
    }
    return command;
}

const struct command *read_form(struct reader *r)
{
    struct variable v;
    const char *c = r->at;
    size_t n = name_start(*c) ? name_length(c) : 0;
    const struct command *plain = n > 0 ? plain_command(r, c, n) : NULL;
    if (plain)
        return plain;
    if (*c == '?') {
        r->at = c + strspn(c, "?");
        return command_find("help");
    }
    const char *next = skip_blanks(c + n);
    if (n > 0 && *next == '?' && command_ends(skip_blanks(next + strspn(next, "?"))))
        return command_find("help");
    if (definition_head(c, &v)) {
        r->problem->place = reader_column(r, c);
        return assignment(r, &v);
    }
    if (n > 0 && strncmp(next, "==", 2) == 0)
        return command_find("print"); /* whose value says that there are no comparisons */
    if (is_history(r->query->state, c, n)) {
        r->problem->place = reader_column(r, c);
        problem_error(r->problem,
                      "the last value is 'ans', as in '2*ans'; 'let x = ans' keeps it for later lines");
        return NULL;
    }
    if ((*c == '.' || *c == '\\') && name_start(c[1])) {
        r->problem->place = reader_column(r, c);
        problem_error(r->problem,
                      "commands have no '%c' before their names; 'help' lists them, 'apropos WORD' finds one",
                      *c);
        return NULL;
    }
    const struct command *command = called(r, c, n);
    if (command)
        return command;
    bool name = n < VARIABLE_NAME && definition_name(c, v.name) && (command_ends(next) || *next == '>');
    const struct variable *known = name ? variable_find(&r->query->state->variables, v.name) : NULL;
    if (known && known->body)
        return command_find("show");
    if (is_expression(r->query->state, c))
        return command_find("print");
    if (name && !command_find(v.name) && parameter_find(v.name))
        return command_find("show");
    return NULL;
}
