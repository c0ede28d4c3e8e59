/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/planning/inquiry.h"
#include "language/quad.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- Reading ---- */

/* Returns the length of a word that may be a command, with a dot and a key after it. */
static size_t word_length(const char *c)
{
    return strspn(c, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.");
}

/* Finds the command and the key that a word names; false if it names none. */
static bool command_named(const char *word, size_t length, struct inquiry *q)
{
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)(length < sizeof name ? length : sizeof name - 1), word);
    char *dot = strchr(name, '.');
    if (dot)
        *dot = '\0';
    const struct command *c = command_find(name);
    if (!c || !c->columns || !c->columns->key)
        return false;
    q->command = c;
    q->key = dot ? names_exact(command_keys, c, dot + 1) : c->principal ? command_principal(c) : -1;
    return true;
}

/* Keeps what was typed, without blanks at its end. */
static void name_keep(struct inquiry *q, const char *begin, const char *end)
{
    char typed[NAMES_SHOWN];
    while (end > begin && isspace((unsigned char)end[-1]))
        end--;
    int length = end - begin < NAMES_SHOWN ? (int)(end - begin) : NAMES_SHOWN - 1;
    snprintf(typed, sizeof typed, "%.*s", length, begin);
    names_shown(typed, q->name);
}

static bool key_missing(struct problem *problem, const struct inquiry *q)
{
    char keys[256] = "";
    const struct column *c = q->command->columns;
    for (int n = 0; c->key && n < (int)sizeof keys; c++)
        n += snprintf(keys + n, sizeof keys - (size_t)n, "%s%s.%s", n ? ", " : "", q->command->name, c->key);
    return problem_error(problem, "which number of '%s'? One of %s", q->command->name, keys);
}

bool inquiry_read(struct reader *r, struct inquiry *q)
{
    const char *begin = r->at, *end = text_end(begin, ";>");
    size_t length = word_length(begin);
    const char *next = skip_blanks(begin + length);
    bool ends = next >= end || (next > begin + length && !strchr("+-*/^)", *next));
    *q = (struct inquiry){.text = r->text, .at = begin};
    name_keep(q, begin, end);
    if (ends && command_named(begin, length, q)) {
        if (q->command->unswept)
            return problem_error(r->problem, "'%s' is not varied: %s", q->command->name, q->command->unswept);
        if (q->key < 0 || q->key >= ANSWER_CELLS)
            return key_missing(r->problem, q);
        q->at = begin + length;
    }
    r->at = end;
    return true;
}

const char *inquiry_names(const void *context, int k)
{
    const char *name;
    for (int i = 0; (name = command_names(context, i)) != NULL; i++) {
        const struct command *c = command_find(name);
        if ((c->principal || c->holds) && !c->unswept && k-- == 0)
            return name;
    }
    return NULL;
}

bool inquiry_read_left(struct reader *r, struct inquiry *q)
{
    const char *end = text_end(r->at, "=;>");
    *q = (struct inquiry){.text = r->text, .at = r->at, .stops = "="};
    name_keep(q, r->at, end);
    r->at = end;
    return true;
}

/* ---- Asking ---- */

/* Runs the command; false: no answer. */
static bool ask_command(const struct query *at, struct probe *p, struct quantity *value)
{
    const struct inquiry *q = p->inquiry;
    const struct command *c = q->command;
    struct cell kept[ANSWER_CELLS] = {{.kind = CELL_NONE}};
    struct answer answer = {.style = state_style(at->state),
                            .columns = c->columns,
                            .rows = c->rows,
                            .kept = p->verdict ? NULL : kept};
    struct arguments given = {.count = 0};
    struct query query = *at;
    struct reader r = {.query = at, .problem = &p->problem, .text = q->text, .at = q->at};
    query.given = &given;
    p->problem.command = c->name;
    bool done = command_allowed(at->means, c, &p->problem) && read_arguments(&r, c, &given) &&
                c->run(&query, &answer, &p->problem);
    arguments_free(&given);
    *value = (struct quantity){.value = answer.holds == ANSWER_YES ? 1 : -1};
    if (!done || p->verdict)
        return done && (answer.holds != ANSWER_OPEN || problem_no_answer(&p->problem, "nothing is decided"));
    struct cell cell = kept[q->key];
    if (cell.kind == CELL_WORD || cell.kind == CELL_FLAG)
        return problem_error(&p->problem, "%s.%s is a word, and not a number", c->name,
                             c->columns[q->key].key);
    if (cell.kind == CELL_NONE)
        return problem_no_answer(&p->problem, "%s.%s does not exist here: '%s' says why", c->name,
                                 c->columns[q->key].key, c->name);
    *value = expression_unit(c->columns[q->key].unit);
    value->value *= cell.number;
    return true;
}

/* Evaluates the expression. */
static bool ask_expression(const struct query *at, struct probe *p, struct quantity *value)
{
    const struct inquiry *q = p->inquiry;
    domq_real number;
    struct reader r = {.query = at,
                       .problem = &p->problem,
                       .text = q->text,
                       .at = q->at,
                       .stops = q->stops,
                       .last = q->stops == NULL};
    p->problem.place = reader_column(&r, r.at);
    if (!read_quantity(&r, &(struct argument){.name = "ANSWER", .kind = ARGUMENT_ANY}, value, &number))
        return false;
    r.at = skip_blanks(r.at);
    return command_ends(r.at) || *r.at == '>' || (q->stops && strchr(q->stops, *r.at)) ||
           problem_error(&p->problem,
                         "ANSWER is a command with its arguments, or an expression such as "
                         "'rmax(0.3)'; it ends before '%.20s'",
                         r.at);
}

/* Gives a copy of the state the value; false: the value is not in the range, or its effect not possible. */
static bool probe_put(struct state *point, const struct parameter *p, domq_real value,
                      struct problem *problem)
{
    if (value != EFFECT_OFF && !parameter_check(point, p, 0, value, problem))
        return false;
    if (p->effect && value != EFFECT_OFF && !effect_needs(&point->scene, p->which, problem))
        return false;
    parameter_put(point, p, value);
    return true;
}

domq_real probe_at(struct probe *p, domq_real value)
{
    struct state point = *p->query->state;
    struct means means = *p->query->means;
    struct query at = *p->query;
    at.state = &point;
    at.scene = &point.scene;
    at.means = &means;
    at.next = NULL;
    means.shard.parts = 0;
    point.settings.threads = 1;
    p->problem = (struct problem){.command = p->query_command};
    p->wrong = false;
    struct quantity answer = {.value = 0};
    bool put = !p->parameter || probe_put(&point, p->parameter, value, &p->problem);
    bool done = put && (p->inquiry->command ? ask_command(&at, p, &answer) : ask_expression(&at, p, &answer));
    p->wrong = put && !done && p->problem.kind != PROBLEM_NO_ANSWER;
    if (!done)
        return DOMQ_NAN;
    p->unit = answer;
    return isfinite(answer.value) ? answer.value : DOMQ_NAN;
}

bool probe_report(const struct probe *p, struct problem *problem)
{
    if (dom_raised(p->query->scene->compute.interrupt))
        return problem_status(problem, p->query->scene, DOM_INTERRUPTED);
    *problem = p->problem;
    return false;
}
