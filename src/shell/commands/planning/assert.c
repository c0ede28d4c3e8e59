/* SPDX-License-Identifier: GPL-3.0-or-later */
/* assert: another command, and an error unless what it decides is true. */
#include "commands/planning/planning.h"
#include "interpreter/command_read.h"
#include <string.h>

const char *assert_names(const void *context, int k)
{
    (void)context;
    for (const struct command_group *g = command_groups(); g->title; g++)
        for (const struct command *c = g->commands; c->name; c++)
            if (c->holds && k-- == 0)
                return c->name;
    return NULL;
}

bool assert_parse(struct reader *r, struct question *q)
{
    struct question *asked = q->own = arena_take(r->arena, sizeof *asked);
    const char *begin = r->at;
    char all[128] = "";
    if (!asked)
        return problem_error(r->problem, "out of memory");
    asked->key = -1;
    asked->command = command_read_inner(r, assert_names);
    if (!asked->command)
        return false;
    bool is_condition = strcmp(asked->command->name, "print") == 0;
    for (int k = 0, n = 0; assert_names(NULL, k) && n < (int)sizeof all; k++)
        n += snprintf(all + n, sizeof all - (size_t)n, "%s%s", k ? ", " : "", assert_names(NULL, k));
    if (!is_condition && !asked->command->holds)
        return problem_error(
            r->problem, "'%s' decides nothing; commands that do: %s; or compare, as in 'assert rmax < 1.7'",
            asked->command->name, all);
    bool good = question_parse(r, asked);
    asked->name = question_name(r, begin, r->at);
    return good;
}

bool run_assert(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct question *asked = query->given->own;
    const struct command *c = asked->command;
    struct quantity value;
    if (!c->holds) { /* a condition */
        if (!question_value(asked, query, &value, problem))
            return false;
        return value.value != 0 || problem_error(problem, "not true: %s", asked->name);
    }
    a->columns = c->columns;
    a->rows = c->rows;
    if (!question_ask(asked, query, a, problem))
        return false;
    a->told = true;
    return a->holds == ANSWER_YES || problem_error(problem, "not true: %s", c->holds);
}
