/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/question.h"

/* Makes call->query a copy of `query` in which the parameters after 'with' have their new values. The state
 * of the copy is stored in call->state. */
static bool with_bind(const struct question *q, const struct query *query, struct call *call,
                      struct problem *problem)
{
    struct assigned assigned[ASSIGNED_MAX];
    int count = 0;
    for (const struct assignment *a = q->with; a; a = a->next) {
        struct quantity typed;
        assigned[count] = (struct assigned){.parameter = a->parameter};
        if (!item_bind(&a->item, q->text, query, &typed, &assigned[count].value, problem))
            return false;
        assigned[count++].length = share_length(a->parameter, &typed);
    }
    return query_with(query, assigned, count, &call->state, &call->query, problem);
}

bool question_bind(const struct question *q, const struct query *query, struct call *call,
                   struct problem *problem)
{
    call->given = (struct arguments){.count = q->count,
                                     .parameter = q->parameter,
                                     .variable = q->variable,
                                     .details = q->details,
                                     .bound = q->parsed};
    call->query = *query;
    if (!command_allowed(query->run_context, q->command, problem) ||
        (q->with && !with_bind(q, query, call, problem)))
        return false;
    call->query.given = &call->given;
    for (int i = 0; i < q->count; i++) {
        const struct argument *a = &q->command->argument[i];
        const struct item *item = &q->item[i];
        call->given.word[i] = item->word;
        call->given.typed[i] = item->at;
        call->given.column[i] = item->at ? text_column(q->text, item->at) : 0;
        if (!item_bind(item, q->text, &call->query, &call->given.quantity[i], &call->given.number[i],
                       problem) ||
            (a->bind && !a->bind(q, &call->query, &call->given, problem)))
            return false;
    }
    return true;
}

void *arguments_take(struct arguments *given, size_t size, const struct query *query, struct problem *problem)
{
    given->bound = arena_take(&given->memory, size);
    if (!given->bound)
        problem_status(problem, query->scene, DOM_NO_MEMORY);
    return given->bound;
}
