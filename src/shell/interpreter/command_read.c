/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/question.h"
#include "session/parameters.h"
#include <ctype.h>
#include <string.h>

/* ---- Definitions ---- */

/* Reads a name. Blanks may stand before and after the name. Returns the position after the name and the
 * blanks that follow it, or NULL if there is no name. */
static const char *definition_name(const char *c, char name[VARIABLE_NAME])
{
    c = skip_blanks(c);
    size_t n = name_start(*c) ? name_length(c) : 0;
    return n > 0 && name_copy(c, n, name, VARIABLE_NAME) ? skip_blanks(c + n) : NULL;
}

const char *definition_head(const char *c, struct variable *v)
{
    *v = (struct variable){.body = NULL};
    c = definition_name(c, v->name);
    for (const char *separator = "("; c && *c == *separator; separator = ",") {
        if (v->count == EXPRESSION_ARGUMENTS)
            return NULL;
        c = definition_name(c + 1, v->argument[v->count++]);
    }
    if (c && v->count > 0)
        c = *c == ')' ? skip_blanks(c + 1) : NULL;
    return c && c[0] == '=' && c[1] != '=' ? c + 1 : NULL;
}

bool name_free(struct problem *problem, const char *name)
{
    const char *is = parameter_find(name)                                ? "a parameter"
                     : command_find(name)                                ? "a command"
                     : names_exact(expression_units, NULL, name) >= 0    ? "a unit"
                     : names_exact(value_names, NULL, name) >= 0         ? "a built-in value"
                     : names_index("to with and or not", ' ', name) >= 0 ? "a word of the expression language"
                                                                         : NULL;
    return !is || problem_error(problem, "'%s' is %s; choose another name, such as 'my_%s'", name, is, name);
}

/* ---- Shorthands ---- */

/* Returns the command that the line "NAME = VALUE" stands for. This command is 'set' if NAME is a parameter,
 * and 'let' if it is a variable. If NAME is unknown, reports a problem and returns NULL. */
static const struct command *assignment_read(struct reader *r, const struct variable *v)
{
    reader_place(r, r->at);
    if (v->count == 0 && parameter_find(v->name))
        return command_find("set");
    if (variable_find(&r->query->state->variables, v->name))
        return command_find("let");
    if (name_free(r->problem, v->name))
        problem_error(r->problem, "'%s' is not a parameter; 'let %s%s = VALUE' defines a %s", v->name,
                      v->name, v->count ? "(...)" : "", v->count ? "function" : "variable");
    return NULL;
}

static const struct command *print_if(bool is_expression)
{
    return is_expression ? command_find("print") : NULL;
}

/* If the line is a shorthand, returns the command that it stands for, such as 'print' for "2+3". If the line
 * is a command with a number, such as 'rmax 0.4', returns this command. Returns NULL for other lines and
 * after an error. */
static const struct command *shorthand_read(struct reader *r)
{
    const char *begin = r->at, *end = begin + (name_start(*begin) ? name_length(begin) : 0),
               *next = skip_blanks(end), *value_end, *value_name;
    struct variable v;
    struct quantity value;
    char name[VARIABLE_NAME];
    int fewest;
    if (!name_copy(begin, (size_t)(end - begin), name, sizeof name))
        *name = '\0';
    const struct command *command = command_find(name);
    const bool is_alone = end > begin && (command_ends(next) || *next == '>');
    /* Most lines of a script consist of a command and a number, so they skip the tests for shorthands. */
    const bool is_called = command && command->is_print && *end == '('; /* as in "print(2)" */
    if (is_called || (command && next > end && isdigit((unsigned char)*next))) {
        reader_place(r, begin);
        r->at = end;
        return command;
    }
    if (end == begin) /* an expression, perhaps one with errors */
        return print_if(isdigit((unsigned char)*begin) || (*begin && strchr("(.+-", *begin)));
    if (*next == '?' && command_ends(skip_blanks(next + strspn(next, "?"))))
        return command_find("help");
    if (definition_head(begin, &v))
        return assignment_read(r, &v);
    if (strncmp(next, "==", 2) == 0 || (end == next && !is_alone))
        return print_if(*next == '=' || strchr("(*/^+-.", *end));
    if (command)
        return print_if(command_arity(command, &fewest) >= 0 && goes_on(next));
    if (strcmp(name, "not") == 0)
        return print_if(next > end);
    const struct variable *variable = variable_find(&r->query->state->variables, name);
    if (is_alone && variable && variable->body)
        return command_find("show");
    if (!variable && feature_value(begin, &value_name, &value_end, &value))
        next = skip_blanks(value_end);
    const bool has_value = next > skip_blanks(end) || is_value_name(r->query->state, name),
               ends = command_ends(next) || *next == '>', is_parameter = parameter_find(name) != NULL;
    return is_alone && is_parameter ? command_find("show")
                                    : print_if(has_value && (goes_on(next) || (ends && !is_parameter)));
}

/* ---- Names of commands ---- */

/* Reports an unknown command, with a suggestion. `k` and `message` are the results of names_find. */
static void command_unknown(struct reader *r, const char *name, int k, char message[NAMES_MESSAGE])
{
    const char *synonym = NULL, *shown = names_shown(name);
    const struct command *c;
    for (int i = 0; k == NAMES_UNKNOWN && !synonym && strlen(name) > 2 && (c = command_at(i)) != NULL; i++)
        synonym = names_index(c->synonyms, ' ', name) >= 0 ? c->name : NULL;
    const struct parameter *named = parameter_find(name),
                           *p = parameter_by_synonym(name, !synonym && k == NAMES_UNKNOWN);
    const char *value = skip_blanks(r->at);
    size_t length = strcspn(value, ";>#");
    while (length > 0 && isspace((unsigned char)value[length - 1]))
        length--;
    const char *copy = reader_copy(r, value, length);
    if (variable_find(&r->query->state->variables, name))
        problem_error(r->problem, "'%s' is a variable; '%s = VALUE' changes it, '%s' shows it", name, name,
                      name);
    else if (k == NAMES_ABSENT || parameter_by_value(name, message))
        problem_error(r->problem, "%s", message);
    else if (named)
        problem_error(r->problem, "'%s' is %s; enter 'set %s%s%s'", name,
                      named->effect ? "an effect" : "a parameter",
                      copy && *copy ? name : parameter_usage(named), copy && *copy ? " " : "",
                      copy ? names_shown(copy) : "");
    else if (p)
        problem_error(r->problem, "unknown command '%s'; did you mean 'set %s'?", shown, parameter_usage(p));
    else if (synonym)
        problem_error(r->problem, "%s; did you mean '%s'?", message, synonym);
    else
        problem_error(r->problem, k == NAMES_UNKNOWN ? "%s; 'help' lists the commands" : "%s", message);
}

/* Reads the name of a command, which may be abbreviated. A word after it may choose another command, as in
 * 'step back' (see command.typed.phrase). If there is no such command, reports a problem and returns NULL. */
static const struct command *name_read(struct reader *r, names_list *offered)
{
    char message[NAMES_MESSAGE], exact[VARIABLE_NAME];
    const char *begin = r->at;
    size_t length = strcspn(begin, r->stops ? " \t\r\f\v;>,=" : " \t\r\f\v;>");
    const struct command *command =
        name_copy(begin, length, exact, sizeof exact) ? command_find(exact) : NULL;
    offer_names(r, offered, NULL);
    reader_place(r, begin);
    r->at += length;
    if (!command) {
        const char *name = reader_copy(r, begin, length);
        if (!name)
            return NULL;
        int k = names_find(command_names, NULL, "command", name, message);
        command = command_at(k);
        /* 'h rmax' is help, but 'h 5 cm' is not */
        const bool has_number = strspn(skip_blanks(r->at), "0123456789.") > 0;
        if (!command || ((!command->argument[0].kind || has_number) && parameter_find(name))) {
            command_unknown(r, name, k, message);
            return NULL;
        }
    }
    struct reader next = *r;
    next.at = skip_blanks(r->at);
    for (const struct command *c = command + 1; !command->typed.phrase && c->typed.phrase; c++)
        if (reader_takes(&next, c->typed.phrase + strlen(command->name) + 1)) {
            r->at = next.at;
            return c;
        }
    return command;
}

const struct command *command_read(struct reader *r)
{
    const struct command *command = shorthand_read(r);
    if (command || r->problem->kind != PROBLEM_NONE)
        return command;
    offer_kind(r, OFFER_VARIABLE);
    return name_read(r, offered_commands);
}

const struct command *command_read_inner(struct reader *r, names_list *offered)
{
    const char *begin = r->at;
    const struct command *command = shorthand_read(r);
    if (command && command->is_print)
        return command;
    r->at = begin;
    return r->problem->kind == PROBLEM_NONE ? name_read(r, offered) : NULL;
}
