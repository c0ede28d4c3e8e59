/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/arguments.h"
#include "language/quad.h"
#include "session/meant.h"
#include <ctype.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* The text of a message until names_find writes one: there was no word to find. */
#define NO_MEMORY "out of memory"

/* Returns true for a name that expressions know. */
static bool is_value_name(const struct state *state, const char *word)
{
    return names_exact(value_names, state, word) >= 0;
}

/* Returns true if the word after a value is a value itself. If not, the word is meant as a unit. */
static bool known_word(struct reader *r, const char *at)
{
    struct reader behind = {.query = r->query, .text = r->text, .at = at};
    char *word = read_word(&behind, false), shown[NAMES_SHOWN];
    size_t name = word ? strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") : 0;
    if (word)
        word[name] = '\0';
    bool known = word && (is_value_name(r->query->state, word) || strcmp(word, "to") == 0);
    if (!known && word) {
        const char *close = names_closest(expression_units, NULL, word);
        r->problem->place = reader_column(r, at);
        names_shown(word, shown);
        if (strcmp(word, "in") == 0)
            problem_error(r->problem,
                          "the unit 'in' must follow a number; 'to' converts, as in '4.8 cm to mm'");
        else if (close && strcmp(close, word) == 0)
            problem_error(r->problem, "the unit '%s' must follow a number or a ')', as in '4.8 cm'", shown);
        else if (close)
            problem_error(r->problem, "'%s' is not a unit; did you mean '%s'?", shown, close);
        else
            problem_error(r->problem, "'%s' is not a unit and has no value", shown);
    }
    free(word);
    return known;
}

/* Returns true for a value of a parameter in whose unit there is a mass. */
static bool weighs(const struct argument *a)
{
    const struct parameter *p = a->kind == ARGUMENT_OF ? parameter_find(a->of) : NULL;
    return p && expression_unit(p->value[a->which].unit).mass != 0;
}

bool read_quantity(struct reader *r, const struct argument *a, struct quantity *q, domq_real *number)
{
    struct lookup lookup = {.query = r->query, .problem = r->problem};
    struct expression e = {.text = r->at,
                           .lookup = query_lookup,
                           .context = &lookup,
                           .angle = r->query->state->settings.style.angle == ANGLE_DEG ? QUAD_PI / 180 : 1,
                           /* A grid goes on with these parameters; grams are what its masses have. */
                           .no_unit = !r->stops   ? NULL
                                      : weighs(a) ? "s"
                                                  : "sg"};
    int begin = r->problem->place;
    if (!expression_evaluate(&e, q)) {
        r->problem->place = reader_column(r, e.end);
        if (r->problem->kind != PROBLEM_NONE)
            return false;
        char shown[NAMES_SHOWN], word[NAMES_SHOWN];
        snprintf(word, sizeof word, "%.*s", (int)strcspn(e.end, " \t;"), e.end);
        return problem_report(r->problem, e.of_value ? PROBLEM_NO_ANSWER : PROBLEM_WRONG,
                              *word ? "%s at '%s': %s" : "%s%s: %s", a->name, names_shown(word, shown),
                              e.message);
    }
    bool ended = isspace((unsigned char)*e.end) || (command_ends(e.end) && *e.end != '#') || *e.end == '>' ||
                 (r->stops && strchr(r->stops, *e.end));
    const char *compared = skip_blanks(e.end);
    if (strncmp(compared, "==", 2) == 0) {
        r->problem->place = reader_column(r, compared);
        return problem_error(r->problem, "values are not compared by '=='; 'r = 2' gives r a value, and "
                                         "'assert verdict' or 'solve r: rmax = 1.6' asks");
    }
    if (!ended) {
        char shown[NAMES_SHOWN];
        r->problem->place = reader_column(r, e.end);
        if (*e.end == ',' && isdigit((unsigned char)e.end[1]))
            return problem_error(r->problem, "%s ends before '%s'; decimals have a point, as in 0.5", a->name,
                                 names_shown(e.end, shown));
        if (*e.end == '%')
            return problem_error(r->problem, "%s ends before '%s'; write a share as 0.95 or 95/100", a->name,
                                 names_shown(e.end, shown));
        return problem_error(r->problem, "%s ends before '%s'; here an operator or a blank is missing",
                             a->name, names_shown(e.end, shown));
    }
    const char *next = skip_blanks(e.end);
    if (r->last && isalpha((unsigned char)*next) && next > e.end && !known_word(r, next))
        return false;
    r->at = e.end;
    r->problem->place = begin;
    return argument_check(r->query, a, *q, number, r->problem);
}

bool read_value(struct reader *r, const struct parameter *p, int i, const char *name, domq_real *number)
{
    const char *begin = r->at;
    char message[NAMES_MESSAGE] = "", what[32];
    char *word = read_word(r, false);
    int k = -1;
    /* A word for a number may not hide a name: 'set q h' is the parameter h. */
    bool wordlike = word && word[strspn(word, "abcdefghijklmnopqrstuvwxyz")] == '\0' && *word;
    if (word && p->words && i == 0) {
        snprintf(what, sizeof what, "value of %s", p->name);
        k = p->words_only || (wordlike && !is_value_name(r->query->state, word))
                ? names_find(parameter_words, p, what, word, message)
                : names_exact(parameter_words, p, word);
    }
    free(word);
    if (k >= 0) {
        *number = p->words[k].value;
        return true;
    }
    if (*message) {
        char range[64];
        parameter_range(r->query->state, p, 0, range, sizeof range);
        return problem_error(r->problem, p->words_only ? "%s (%s is one of %s)" : "%s (%s is a number in %s)",
                             message, p->name, range);
    }
    r->at = begin;
    struct quantity q = {.value = 0};
    return read_quantity(r, &(struct argument){.name = name, .kind = ARGUMENT_OF, .of = p->name, .which = i},
                         &q, number);
}

/* 'help sin', 'help cm', 'help units' are about expressions. */
static bool is_expression_topic(const char *word)
{
    static const char *const topics[] = {"ans",         "unit",     "units",    "expression",
                                         "expressions", "function", "functions"};
    for (size_t i = 0; i < sizeof topics / sizeof *topics; i++)
        if (strcmp(topics[i], word) == 0)
            return true;
    return is_value_name(NULL, word) || names_exact(expression_units, NULL, word) >= 0;
}

bool read_choice(struct reader *r, const struct argument *a, char **word, domq_real *number)
{
    char message[NAMES_MESSAGE] = NO_MEMORY, shown[NAMES_SHOWN], all[128] = "";
    *word = read_word(r, false);
    int k = *word ? names_find(a->choices, NULL, a->of, *word, message) : -1;
    *number = k;
    if (k >= 0)
        return true;
    const char *name;
    for (int n = 0; (name = a->choices(NULL, n)) != NULL; n++) {
        size_t used = strlen(all);
        snprintf(all + used, sizeof all - used, "%s%s", n ? ", " : "", name);
    }
    if (*word && !a->of)
        return problem_error(r->problem, "'%s' has no value; %s is an angle in [0, theta_c], or one of: %s",
                             names_shown(*word, shown), a->name, all);
    bool usual;
    const struct parameter *meant =
        *word && a->kind == ARGUMENT_EFFECT ? parameter_meant(*word, &usual) : NULL;
    if (meant && meant->effect && k != NAMES_CLOSE)
        return problem_error(r->problem, "unknown %s '%s'; did you mean '%s'?", a->of,
                             names_shown(*word, shown), meant->name);
    if (*word && k != NAMES_CLOSE)
        return problem_error(r->problem, "unknown %s '%s'; use one of: %s", a->of, names_shown(*word, shown),
                             all);
    return problem_error(r->problem, "%s", message);
}

/* Reads one of the names, as -1 - its number, or an angle. */
static bool read_place(struct reader *r, const struct argument *a, struct arguments *given, int i)
{
    char message[NAMES_MESSAGE] = NO_MEMORY;
    const char *begin = r->at;
    char *name = read_word(r, false);
    bool letters = name && *name && name[strspn(name, "abcdefghijklmnopqrstuvwxyz")] == '\0' &&
                   !is_value_name(r->query->state, name);
    int place = !name     ? -1
                : letters ? names_find(a->choices, NULL, a->of, name, message)
                          : names_exact(a->choices, NULL, name);
    r->at = place >= 0 ? r->at : begin;
    free(name);
    if (place >= 0) {
        given->number[i] = -1 - place;
        return true;
    }
    if (letters && read_choice(r, a, &given->word[i], &given->number[i]))
        return true;
    return !letters && read_quantity(r, a, &given->quantity[i], &given->number[i]);
}

/* Returns true if a word is a file's name, and not the beginning of an expression. */
static bool names_file(const struct state *state, const char *word)
{
    size_t length = strlen(word);
    return strchr("\"./~", *word) || (length > 4 && strcmp(word + length - 4, ".csv") == 0) ||
           (isalpha((unsigned char)*word) && !strchr(word, '(') && !is_value_name(state, word));
}

/* Skips what can be between a parameter and its value: 'set r = 2', 'set r to 2'. */
static void skip_equals(struct reader *r, struct arguments *given, int i)
{
    size_t n = *r->at == '=' ? 1 : strncmp(r->at, "to", 2) == 0 && isspace((unsigned char)r->at[2]) ? 2 : 0;
    r->at = skip_blanks(r->at + n);
    r->problem->place = given->column[i] = reader_column(r, r->at);
}

/* Reads a value for the parameter that the call names, or the file instead of its first value. */
static bool read_setting(struct reader *r, const struct command *c, struct arguments *given, int i)
{
    const struct parameter *p = given->parameter;
    const struct domq_effect_argument *of = parameter_value(p, i - 1);
    char usage[USAGE_SIZE], shown[NAMES_SHOWN], word[PATH_MAX];
    if (i == 1)
        skip_equals(r, given, i);
    snprintf(word, sizeof word, "%.*s", (int)strcspn(r->at, " \t;>#"), r->at);
    if (!of || given->word[1] || (i > 1 && parameter_word(p, given->number[1])))
        return problem_error(r->problem, "'%s' is one argument too many; usage: %s%s",
                             names_shown(word, shown), p->effect ? "effect " : "",
                             p->effect ? effect_usage(p->which, usage) : command_usage(c, usage));
    if (of->or_file && names_file(r->query->state, word) && names_exact(parameter_words, p, word) < 0) {
        given->word[i] = read_file(r);
        return given->word[i] || problem_error(r->problem, "%s", unclosed);
    }
    r->last = !parameter_value(p, i);
    return read_value(r, p, i - 1, of->name, &given->number[i]);
}

/* Reads the name of a parameter or topic, which also ends before this letter; a '?' after it is skipped. */
static char *read_name(struct reader *r, const char *end)
{
    const char *stops = r->stops;
    r->stops = end;
    char *word = read_word(r, false);
    r->stops = stops;
    const char *next = skip_blanks(r->at);
    if (*next == '?')
        r->at = next + strspn(next, "?");
    return word;
}

/* Reads the name of an effect, which also ends before a '='. */
static bool read_effect(struct reader *r, const struct argument *a, struct arguments *given, int i)
{
    const char *stops = r->stops;
    r->stops = "=";
    bool done = read_choice(r, a, &given->word[i], &given->number[i]);
    r->stops = stops;
    return done;
}

/* Reads the name of a parameter or a topic; a variable of the session is one where no value follows. */
static bool read_topic(struct reader *r, const struct argument *a, struct arguments *given, int i)
{
    char message[NAMES_MESSAGE] = NO_MEMORY;
    bool topic = a->kind == ARGUMENT_TOPIC, valued = i + 1 < ARGUMENTS_MAX && a[1].kind == ARGUMENT_VALUE;
    char *word = given->word[i] = read_name(r, valued ? "=" : "?");
    const struct variable *v = word ? variable_find(&r->query->state->variables, word) : NULL;
    if (v && valued)
        return problem_error(r->problem, "'%s' is a variable; '%s = VALUE' changes it", word, word);
    if (v) {
        given->variable = v;
        return true;
    }
    int k = word ? names_find(a->choices, NULL, a->of, word, message) : -1;
    if (k < 0 && topic && word && is_expression_topic(word))
        k = names_exact(a->choices, NULL, "print");
    given->number[i] = k;
    if (k < 0 && topic && word && topic_meant(word, 0))
        return true;
    given->parameter = k >= 0 && !topic ? &session_parameters[k] : NULL;
    bool usual;
    const struct parameter *meant = k < 0 && word ? parameter_meant(word, &usual) : NULL;
    if (meant && (usual || k == NAMES_UNKNOWN))
        return problem_error(r->problem, "unknown %s '%s'; did you mean '%s'?", a->of, word, meant->name);
    return k >= 0 || problem_error(r->problem, "%s", message);
}

static bool read_argument(struct reader *r, const struct command *c, struct arguments *given)
{
    int i = given->count;
    const struct argument *a = &c->argument[i];
    r->problem->place = given->column[i] = reader_column(r, r->at);
    r->last = i + 1 == ARGUMENTS_MAX || !c->argument[i + 1].kind || c->argument[i + 1].kind == ARGUMENT_UNIT;
    switch (a->kind) {
    case ARGUMENT_OF:
        return read_value(r, parameter_find(a->of), 0, a->name, &given->number[i]);
    case ARGUMENT_VALUE:
        return read_setting(r, c, given, i);
    case ARGUMENT_PARAMETER:
    case ARGUMENT_TOPIC:
        return read_topic(r, a, given, i);
    case ARGUMENT_CHOICE:
        return read_choice(r, a, &given->word[i], &given->number[i]);
    case ARGUMENT_PLACE:
        return read_place(r, a, given, i);
    case ARGUMENT_EFFECT:
        if (!read_effect(r, a, given, i))
            return false;
        given->parameter = parameter_find(a->choices(NULL, (int)given->number[i]));
        return true;
    case ARGUMENT_WORD:
    case ARGUMENT_FILE:
        given->word[i] = a->kind == ARGUMENT_FILE ? read_file(r) : read_word(r, true);
        return given->word[i] ? *given->word[i] || problem_error(r->problem, "%s is missing", a->name)
                              : problem_error(r->problem, "%s", unclosed);
    case ARGUMENT_GRID:
    case ARGUMENT_COMMAND:
    case ARGUMENT_WORDS:
    case ARGUMENT_UNIT:
        return a->read(r, given);
    case ARGUMENT_REST:
        given->word[i] = strdup(r->at);
        r->at += strlen(r->at);
        return given->word[i] != NULL;
    default:
        return read_quantity(r, a, &given->quantity[i], &given->number[i]);
    }
}

/* Reports an error where '--check' is here: a command with a verdict has 'assert' for that. */
static bool no_check(const struct reader *r, const struct command *c)
{
    char usage[USAGE_SIZE];
    return !c->holds || strncmp(r->at, "--check", 7) != 0 ||
           problem_error(r->problem, "commands have no options; 'assert %s' is an error unless it is true",
                         command_usage(c, usage));
}

bool read_arguments(struct reader *r, const struct command *c, struct arguments *given)
{
    char usage[USAGE_SIZE], shown[NAMES_SHOWN];
    for (given->count = 0; given->count < ARGUMENTS_MAX && c->argument[given->count].kind; given->count++) {
        const struct argument *a = &c->argument[given->count];
        r->at = skip_blanks(r->at);
        if (a->kind != ARGUMENT_REST && (command_ends(r->at) || *r->at == '>' || *r->at == '|'))
            break;
        if (!no_check(r, c) || !read_argument(r, c, given))
            return false;
    }
    r->at = skip_blanks(r->at);
    r->problem->place = reader_column(r, r->at);
    if (!no_check(r, c))
        return false;
    if (*r->at == '|')
        return problem_error(r->problem, "pipes are not supported; 'COMMAND > FILE' writes a file");
    if (given->count < ARGUMENTS_MAX && c->argument[given->count].kind && !c->argument[given->count].optional)
        return problem_error(r->problem, "%s is missing; usage: %s", c->argument[given->count].name,
                             command_usage(c, usage));
    if (!command_ends(r->at) && *r->at != '>') {
        char *word = read_word(r, false);
        problem_error(r->problem, "'%s' is one argument too many; usage: %s",
                      names_shown(word ? word : "", shown), command_usage(c, usage));
        free(word);
        return false;
    }
    return true;
}

void arguments_free(struct arguments *given)
{
    for (int i = 0; i < ARGUMENTS_MAX; i++)
        free(given->word[i]);
    if (given->own_free)
        given->own_free(given->own);
}
