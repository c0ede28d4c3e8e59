/* SPDX-License-Identifier: GPL-3.0-or-later */
/* assert: another command, and an error unless what it decides is true. */
#include "commands/planning/planning.h"
#include "interpreter/arguments.h"
#include <stdlib.h>

/* The command that is asked, with its arguments. */
struct asserted {
    const struct command *command;
    struct arguments given;
};

const char *assert_names(const void *context, int k)
{
    (void)context;
    for (const struct command_group *g = command_groups(); g->title; g++)
        for (const struct command *c = g->commands; c->name; c++)
            if (c->holds && k-- == 0)
                return c->name;
    return NULL;
}

static void asserted_free(void *own)
{
    struct asserted *a = own;
    arguments_free(&a->given);
    free(a);
}

bool assert_read(struct reader *r, struct arguments *given)
{
    struct asserted *a = calloc(1, sizeof *a);
    char all[128] = "";
    if (!a)
        return problem_status(r->problem, r->query->scene, DOM_NO_MEMORY);
    given->own = a;
    given->own_free = asserted_free;
    a->command = read_command(r);
    if (!a->command)
        return false;
    for (int k = 0, n = 0; assert_names(NULL, k) && n < (int)sizeof all; k++)
        n += snprintf(all + n, sizeof all - (size_t)n, "%s%s", k ? ", " : "", assert_names(NULL, k));
    if (!a->command->holds)
        return problem_error(r->problem, "'%s' decides nothing; commands that do: %s", a->command->name, all);
    return command_allowed(r->query->means, a->command, r->problem) &&
           read_arguments(r, a->command, &a->given);
}

bool run_assert(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct asserted *asserted = query->given->own;
    const struct command *c = asserted->command;
    struct query asked = *query;
    asked.given = &asserted->given;
    a->columns = c->columns;
    a->rows = c->rows;
    problem->command = c->name;
    bool done = c->run(&asked, a, problem);
    if (!done)
        return false;
    a->told = true;
    problem->command = "assert";
    return a->holds == ANSWER_YES || problem_error(problem, "not true: %s", c->holds);
}
