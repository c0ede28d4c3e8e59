/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'assert', which reports an error unless a condition or a verdict is true. */
#include "sweeps/sweeps.h"

const char *assert_names(const void *context, int k)
{
    const struct command *c;
    (void)context;
    for (int i = 0; (c = command_at(i)) != NULL; i++)
        if (c->holds && k-- == 0)
            return c->name;
    return NULL;
}

bool assert_parse(struct reader *r, struct question *q)
{
    struct question *asserted = q->parsed = reader_memory(r, sizeof *asserted);
    if (!asserted || !question_parse_any(r, asserted, false, assert_names))
        return false;
    if (asserted->command->holds)
        return true;
    if (*skip_blanks(r->at) == '>')
        return problem_error(r->problem,
                             "here '>' would write the answer to a file, but a condition has no answer; put "
                             "a comparison in parentheses, as in 'assert (rmax(0.4) > 1.6)'");
    return asserted->command->is_print ||
           problem_error(r->problem,
                         "'%s' has no verdict; enter a command that answers yes or no, such as barrier, or a "
                         "comparison, as in 'assert rmax < 1.7'",
                         asserted->command->name);
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
