/* SPDX-License-Identifier: GPL-3.0-or-later */
/* assert: another command, and an error unless what it decides is true. */
#include "commands/planning/planning.h"
#include "interpreter/arguments.h"
#include <stdlib.h>

/* The command that is asked, with its arguments. */
struct asserted {
    const struct command *command;
    struct call call;
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
    call_free(&a->call);
    free(a);
}

bool assert_read(struct reader *r, struct call *call)
{
    struct session *session = r->session;
    struct asserted *a = calloc(1, sizeof *a);
    char all[128] = "";
    if (!a)
        return session_status(session, DOM_NO_MEMORY);
    call->own = a;
    call->own_free = asserted_free;
    a->command = read_command(r);
    if (!a->command)
        return false;
    for (int k = 0, n = 0; assert_names(NULL, k) && n < (int)sizeof all; k++)
        n += snprintf(all + n, sizeof all - (size_t)n, "%s%s", k ? ", " : "", assert_names(NULL, k));
    if (!a->command->holds)
        return session_error(session, "'%s' decides nothing; commands that do: %s", a->command->name, all);
    return command_allowed(session, a->command) && read_arguments(r, a->command, &a->call);
}

bool run_assert(struct session *session, const struct call *call)
{
    struct asserted *a = call->own;
    const struct command *c = a->command;
    struct answer *answer = call->answer;
    answer->columns = c->columns;
    answer->rows = c->rows;
    a->call.answer = answer;
    session->command = c->name;
    bool done = c->run(session, &a->call);
    a->call.answer = NULL;
    session->command = "assert";
    session->column = 0;
    session->answered = session->answered || done;
    return done && (answer->holds == ANSWER_YES || session_error(session, "not true: %s", c->holds));
}
