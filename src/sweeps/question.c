/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Questions inside other commands, such as 'sweep', and probes, which ask them at many values of parameters.
 */
#include "language/quad.h"
#include "sweeps/sweeps.h"
#include <ctype.h>
#include <string.h>

/*
 * Returns the command that is named in a word such as "rmax" or "rmax.r". The name after the dot is the key
 * of a column, whose index is stored in *key. Without a dot, *key becomes the index of the principal column.
 * If there is no such column, *key becomes -1. Returns NULL if the word names no command, or if the command
 * computes nothing.
 */
static const struct command *command_named(const char *word, size_t length, int *key)
{
    char name[64];
    if (!name_copy(word, length, name, sizeof name))
        return NULL;
    char *dot = strchr(name, '.');
    if (dot)
        *dot = '\0';
    const struct command *c = command_find(name);
    if (!c || !c->columns || !c->columns->key)
        return NULL;
    *key = dot ? names_exact(command_keys, c, dot + 1) : c->principal ? command_principal(c) : -1;
    return c;
}

const char *question_names(const void *context, int k)
{
    const struct command *c;
    (void)context;
    for (int i = 0; (c = command_at(i)) != NULL; i++)
        if ((c->principal || c->holds) && !c->sweep.refusal && k-- == 0)
            return c->name;
    return NULL;
}

const char *question_name(struct reader *r, const char *begin, const char *end)
{
    char typed[NAMES_SHOWN];
    while (end > begin && isspace((unsigned char)end[-1]))
        end--;
    name_copy(begin, (size_t)(end - begin), typed, sizeof typed);
    const char *shown = names_shown(typed);
    const char *name = reader_copy(r, shown, strlen(shown));
    return name ? name : "";
}

bool question_needs_number(const struct question *q, struct problem *problem)
{
    const struct command *c = q->command;
    if (q->key >= 0 || q->command->is_print)
        return true;
    char keys[NAMES_ALL], before[40];
    snprintf(before, sizeof before, "%s.", c->name);
    return problem_error(problem, "'%s' gives several numbers; use one of %s", c->name,
                         names_join(command_keys, c, before, keys));
}

bool question_parse_any(struct reader *r, struct question *q, bool is_number, names_list *offered)
{
    const char *begin = r->at;
    size_t length = strspn(begin, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.");
    int key = -1;
    const struct command *c = command_named(begin, length, &key);
    struct reader behind = *r;
    behind.at = begin + length;
    bool is_whole = isspace((unsigned char)*behind.at) || reader_ends(&behind);
    offer_names(r, offered, NULL);
    *q = (struct question){.command = command_find("print"), .key = -1};
    if (c && is_whole && !goes_on(skip_blanks(behind.at))) {
        q->command = c;
        q->key = key;
        r->at = begin + length;
        if (c->sweep.refusal)
            return problem_error(r->problem, "'%s' cannot be varied: %s", c->name, c->sweep.refusal);
        if ((is_number || !c->holds) && !question_needs_number(q, r->problem))
            return false;
    }
    bool good = question_parse(r, q);
    if (good && c && q->command != c && q->key >= 0) { /* a variant of the command has other columns */
        q->key = -1;
        good = !is_number || question_needs_number(q, r->problem);
    }
    q->name = question_name(r, begin, r->at);
    return good;
}

bool question_ask(const struct question *q, const struct query *query, struct answer *answer,
                  struct problem *problem)
{
    struct call call;
    const char *outer = problem->command;
    if (!q->command->is_print)
        problem->command = q->command->name;
    bool done = question_bind(q, query, &call, problem);
    if (done) {
        problem->place = 0;
        done = command_compute(q->command, &call.query, answer, problem);
    }
    arena_free(&call.given.memory);
    if (done)
        problem->command = outer;
    return done;
}

bool question_measure(const struct question *q, const struct query *query, struct quantity *value,
                      char unit[UNIT_TEXT], struct problem *problem)
{
    struct cell kept[ANSWER_CELLS];
    const struct command *c = q->command;
    struct answer answer = answer_kept(query, c, kept);
    if (!question_ask(q, query, &answer, problem))
        return false;
    *value = answer.value;
    unit_write(*value, " ", unit);
    if (answer.is_value)
        return true;
    if (!question_needs_number(q, problem))
        return false;
    struct cell cell = kept[q->key];
    const char *key = c->columns[q->key].key;
    if (cell.kind == CELL_WORD || cell.kind == CELL_FLAG)
        return problem_error(problem, "%s.%s is %s, not a number", c->name, key,
                             cell.kind == CELL_FLAG ? "'yes' or 'no'" : "a word");
    if (cell.kind == CELL_NONE && *answer.late_reason)
        return problem_no_answer(problem, "%s.%s has no value here: %s", c->name, key, answer.late_reason);
    if (cell.kind == CELL_NONE)
        return problem_no_answer(problem, "%s.%s has no value here; enter '%s' to see why", c->name, key,
                                 c->name);
    *value = expression_unit(c->columns[q->key].unit);
    value->value *= cell.number;
    for (const struct column *column = answer.columns; column->key; column++)
        if (strcmp(column->key, key) == 0)
            snprintf(unit, UNIT_TEXT, "%s", column->unit);
    return true;
}

/* ---- Probes ---- */

/* Runs the command and sets *value to 1 if its verdict is true, and to -1 if it is false. Fails if the
 * command has no verdict. */
static bool verdict_ask(const struct probe *p, const struct query *at, struct quantity *value,
                        struct problem *problem)
{
    const struct command *c = p->question->command;
    struct answer answer = {.style = state_style(at->state), .columns = c->columns, .rows = c->rows};
    if (!question_ask(p->question, at, &answer, problem))
        return false;
    *value = (struct quantity){.value = answer.verdict == ANSWER_YES ? 1 : -1};
    return answer.verdict != ANSWER_OPEN || problem_no_answer(problem, "the command has no verdict here");
}

domq_real probe_ask(struct probe *p, const struct assigned *assigned, int count)
{
    struct state point;
    struct query at;
    struct run_context run_context = *p->query->run_context;
    struct quantity answer = {.value = 0};
    problem_begin(&p->problem, p->command);
    bool put = query_with(p->query, assigned, count, &point, &at, &p->problem);
    at.run_context = &run_context;
    run_context.seeks_yes = p->seeks_yes;
    point.settings.threads = 1;
    bool done = put && (p->verdict ? verdict_ask(p, &at, &answer, &p->problem)
                                   : question_measure(p->question, &at, &answer, p->unit_text, &p->problem));
    p->wrong = put && !done && p->problem.kind != PROBLEM_NO_ANSWER;
    if (!done)
        return DOMQ_NAN;
    p->unit = answer;
    return isfinite(answer.value) ? answer.value : DOMQ_NAN;
}

domq_real probe_at(struct probe *p, domq_real value)
{
    const struct assigned assigned = {.parameter = p->parameter, .value = value};
    return probe_ask(p, &assigned, p->parameter != NULL);
}

bool probe_report(const struct probe *p, struct problem *problem)
{
    if (dom_raised(p->query->scene->compute.interrupt))
        return problem_status(problem, p->query->scene, DOM_INTERRUPTED);
    *problem = p->problem;
    return false;
}
