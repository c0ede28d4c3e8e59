/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'assert', which reports an error unless a condition or a verdict is true. */
#include "interpreter/question.h"
#include "sweeps/sweeps.h"

const char *assert_names(const void *context, int k)
{
    (void)context;
    for (const struct command_group *g = command_groups(); g->title; g++)
        for (const struct command *c = g->commands; c->name; c++)
            if (c->holds && k-- == 0)
                return c->name;
    return NULL;
}

/* Fails if a '>' follows, which would write the answer to a file. */
static bool comparison_ends(struct reader *r)
{
    return *skip_blanks(r->at) != '>' ||
           problem_error(r->problem,
                         "here '>' would write the answer to a file, but a condition has no answer; put a "
                         "comparison in parentheses, as in 'assert (rmax(0.4) > 1.6)'");
}

bool assert_parse(struct reader *r, struct question *q)
{
    struct question *asserted = q->parsed = reader_memory(r, sizeof *asserted);
    const char *begin = r->at, *name;
    char all[128] = "";
    if (!asserted)
        return false;
    asserted->key = -1;
    asserted->command = command_read_inner(r, assert_names);
    if (!asserted->command)
        return false;
    if (!asserted->command->holds && !asserted->command->is_print) {
        if (!comparison_ends(r))
            return false;
        for (int k = 0, n = 0; (name = assert_names(NULL, k)) && n < (int)sizeof all; k++)
            n += snprintf(all + n, sizeof all - (size_t)n, "%s%s", k ? ", " : "", name);
        return problem_error(
            r->problem, "'%s' has no verdict; enter one of %s, or a comparison, as in 'assert rmax < 1.7'",
            asserted->command->name, all);
    }
    bool good = question_parse(r, asserted);
    asserted->name = question_name(r, begin, r->at);
    return good && (asserted->command->holds || comparison_ends(r));
}

bool run_assert(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct question *asserted = query->given->bound;
    const struct command *c = asserted->command;
    struct quantity value;
    char unit[UNIT_TEXT];
    if (!c->holds) { /* the question is a condition such as rmax < 2, not a command with a verdict */
        if (!question_measure(asserted, query, &value, unit, problem))
            return false;
        return value.value != 0 || problem_error(problem, "not true: %s", asserted->name);
    }
    a->columns = c->columns;
    a->rows = c->rows;
    a->details.brief = c->brief;
    if (!question_ask(asserted, query, a, problem))
        return false;
    a->progress.wrote_text = true;
    return a->verdict == ANSWER_YES || problem_error(problem, "not true: %s", c->holds);
}
