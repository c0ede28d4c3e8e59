/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/command_read.h"
#include "language/landmarks.h"
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

/* A names_list (see names.h) of the words that have a meaning in expressions. They cannot be names of
 * variables or functions. */
static const char *language_words(const void *context, int k)
{
    static const char *const words[] = {"to", "with", "and", "or", "not", NULL};
    (void)context;
    return words[k];
}

bool name_free(struct problem *problem, const char *name)
{
    const char *is = parameter_find(name)                             ? "a parameter"
                     : command_find(name)                             ? "a command"
                     : names_exact(expression_units, NULL, name) >= 0 ? "a unit"
                     : names_exact(value_names, NULL, name) >= 0      ? "a built-in value"
                     : names_exact(language_words, NULL, name) >= 0   ? "a word of the expression language"
                                                                      : NULL;
    return !is || problem_error(problem, "'%s' is %s; choose another name, such as 'my_%s'", name, is, name);
}

/* ---- Shorthands ---- */

/* The name at the beginning of a line, and the command or variable with this name. */
struct head {
    /* `next` points to the first character after the name and the blanks that follow it */
    const char *begin, *end, *next;
    char name[VARIABLE_NAME]; /* "" if the line does not begin with a name, or if the name is too long */
    const struct command *command;
    const struct variable *variable;
    bool is_alone; /* the name is the whole command */
};

static struct head head_read(const struct reader *r)
{
    struct head h = {.begin = r->at};
    h.end = h.begin + (name_start(*h.begin) ? name_length(h.begin) : 0);
    h.next = skip_blanks(h.end);
    if (!name_copy(h.begin, (size_t)(h.end - h.begin), h.name, sizeof h.name))
        *h.name = '\0';
    h.command = command_find(h.name);
    h.is_alone = h.end > h.begin && (command_ends(h.next) || *h.next == '>');
    return h;
}

static bool word_ends(const char *c)
{
    return isspace((unsigned char)*c) || command_ends(c) || *c == '>';
}

bool goes_on(const char *c)
{
    bool is_apart = isspace((unsigned char)c[-1]);
    return (*c && strchr("*/^<", *c)) || ((*c == '>' || *c == '!' || *c == '=') && c[1] == '=') ||
           (strncmp(c, "and", 3) == 0 && isspace((unsigned char)c[3])) ||
           (strncmp(c, "or", 2) == 0 && isspace((unsigned char)c[2])) ||
           ((*c == '+' || *c == '-') && (!is_apart || isspace((unsigned char)c[1]))) ||
           (strncmp(c, "to", 2) == 0 && isspace((unsigned char)c[2]));
}

/* Returns true if the line is meant as an expression, even one with errors. */
static bool is_expression(const struct state *state, const struct head *h)
{
    const char *c = h->begin, *end;
    int fewest;
    if (h->end == c)
        return *c && (isdigit((unsigned char)*c) || strchr("(.+-", *c));
    if (!word_ends(h->end))
        return strchr("(*/^+-.", *h->end) != NULL;
    if (h->command)
        return command_arity(h->command, &fewest) >= 0 && goes_on(h->next);
    if (strcmp(h->name, "not") == 0)
        return h->next > h->end;
    if (!h->variable && landmark_scan(h->begin, &end)) {
        end = skip_blanks(end);
        return command_ends(end) || *end == '>' || goes_on(end);
    }
    return names_exact(value_names, state, h->name) >= 0 &&
           ((h->is_alone && !parameter_find(h->name)) || goes_on(h->next));
}

/* Returns the command that the line "NAME = VALUE" stands for. This command is 'set' if NAME is a parameter,
 * and 'let' if it is a variable. If NAME is unknown, reports a problem and returns NULL. */
static const struct command *assignment_read(struct reader *r, const struct variable *v)
{
    char message[NAMES_MESSAGE];
    const struct parameter *p = parameter_find(v->name);
    reader_place(r, r->at);
    if (p && v->count == 0)
        return command_find("set");
    if (variable_find(&r->query->state->variables, v->name))
        return command_find("let");
    if (!name_free(r->problem, v->name))
        return NULL;
    int k = v->count ? NAMES_UNKNOWN : names_find(parameter_names, NULL, "parameter", v->name, message);
    if (k == NAMES_CLOSE)
        problem_error(r->problem, "%s 'let %s = VALUE' defines a variable", message, v->name);
    else if (v->count == 0 && (p = parameter_by_synonym(v->name, true)) != NULL)
        problem_error(r->problem,
                      "'%s' is not a parameter; did you mean '%s'? 'let %s = VALUE' defines a variable",
                      v->name, p->name, v->name);
    else
        problem_error(r->problem, "'%s' is not a parameter; 'let %s%s = VALUE' defines a %s", v->name,
                      v->name, v->count ? "(...)" : "", v->count ? "function" : "variable");
    return NULL;
}

/* If the line is a shorthand, returns the command that it stands for, such as 'print' for "2+3". If the line
 * is a command with a number, such as 'rmax 0.4', returns this command. Returns NULL for other lines and
 * after an error. */
static const struct command *shorthand_read(struct reader *r)
{
    struct head h = head_read(r);
    struct variable v;
    /* Most lines of a script consist of a command and a number, so they skip the tests for shorthands. */
    const bool is_called = h.command && h.command->is_print && *h.end == '('; /* as in "print(2)" */
    if (is_called || (h.command && h.next > h.end && isdigit((unsigned char)*h.next))) {
        reader_place(r, h.begin);
        reader_named(r, h.begin, h.end);
        r->at = h.end;
        return h.command;
    }
    if (*h.begin == '?') {
        r->at += strspn(r->at, "?");
        return command_find("help");
    }
    if (h.end > h.begin && *h.next == '?' && command_ends(skip_blanks(h.next + strspn(h.next, "?"))))
        return command_find("help");
    if (definition_head(h.begin, &v))
        return assignment_read(r, &v);
    if (h.end > h.begin && strncmp(h.next, "==", 2) == 0)
        return command_find("print");
    h.variable = *h.name ? variable_find(&r->query->state->variables, h.name) : NULL;
    if (h.is_alone && h.variable && h.variable->body)
        return command_find("show");
    if (is_expression(r->query->state, &h))
        return command_find("print");
    return h.is_alone && !h.command && parameter_find(h.name) ? command_find("show") : NULL;
}

/* ---- Names of commands ---- */

/* `name` is an abbreviation that fits several commands. If the abbreviation is reserved for one of these
 * commands (see command.typed.shortest), returns the index of this command. If it is not, returns
 * NAMES_SEVERAL. */
static int reserved_command(const char *name)
{
    const struct command *c;
    for (int k = 0; (c = command_at(k)) != NULL; k++)
        if (c->typed.shortest && strlen(name) >= strlen(c->typed.shortest) &&
            strncmp(c->name, name, strlen(name)) == 0)
            return k;
    return NAMES_SEVERAL;
}

/* Returns the first command with this synonym, or NULL. A word of one or two letters is not looked up. */
static const char *synonym_command(const char *word)
{
    const struct command *c;
    for (int k = 0; strlen(word) > 2 && (c = command_at(k)) != NULL; k++)
        if (names_index(c->synonyms, ' ', word) >= 0)
            return c->name;
    return NULL;
}

/* Reports an unknown command, with a suggestion. `k` and `message` are the results of names_find. */
static void command_unknown(struct reader *r, const char *name, int k, const char *message)
{
    const char *command = k == NAMES_UNKNOWN ? synonym_command(name) : NULL, *shown = names_shown(name);
    const struct parameter *named = parameter_find(name), *valued = parameter_by_value(name),
                           *p = parameter_by_synonym(name, !command && k == NAMES_UNKNOWN);
    if (variable_find(&r->query->state->variables, name))
        problem_error(r->problem, "'%s' is a variable; '%s = VALUE' changes it, '%s' shows it", name, name,
                      name);
    else if (!command && names_exact(expression_names, NULL, name) >= 0 && strcmp(name, "pi") != 0)
        problem_error(r->problem, "'%s' is a function; write its arguments in parentheses, as in '%s(2)'",
                      name, name);
    else if (valued)
        problem_error(r->problem, "'%s' is a value of %s; enter 'set %s %s'", shown, valued->name,
                      valued->name, shown);
    else if (named)
        problem_error(r->problem, "'%s' is %s; enter 'set %s%s'", name,
                      named->effect ? "an effect" : "a parameter",
                      named->effect ? effect_usage(named->which) : name, named->effect ? "" : " VALUE");
    else if (p && p->effect)
        problem_error(r->problem, "unknown command '%s'; did you mean 'set %s'?", shown,
                      effect_usage(p->which));
    else if (p)
        problem_error(r->problem,
                      "unknown command '%s'; did you mean the parameter '%s'? '%s = VALUE' sets it", shown,
                      p->name, p->name);
    else if (command)
        problem_error(r->problem, "%s; did you mean '%s'?", message, command);
    else
        problem_error(r->problem, k == NAMES_UNKNOWN ? "%s; 'help' lists the commands" : "%s", message);
}

/* A word after the name of a command may choose another command, as in 'step back' (see
 * command.typed.phrase). */
static const struct command *phrase_read(struct reader *r, const struct command *command)
{
    struct reader next = *r;
    next.at = skip_blanks(r->at);
    for (const struct command *c = command + 1; !command->typed.phrase && c->typed.phrase; c++)
        if (reader_takes(&next, c->typed.phrase + strlen(command->name) + 1)) {
            r->at = next.at;
            return c;
        }
    return command;
}

/* Reads the name of a command, which may be abbreviated. If there is no such command, reports a problem and
 * returns NULL. */
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
        if (k == NAMES_SEVERAL)
            k = reserved_command(name);
        command = k < 0 ? NULL : command_find(command_names(NULL, k));
        if (command && !command->argument[0].kind && parameter_find(name))
            command = NULL;
        if (!command)
            command_unknown(r, name, k, message);
    }
    if (!command)
        return NULL;
    reader_named(r, begin, r->at);
    return phrase_read(r, command);
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
