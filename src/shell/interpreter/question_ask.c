/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/question.h"

bool question_bind(const struct question *q, const struct query *query, struct call *call,
                   struct problem *problem)
{
    call->given = (struct arguments){.count = q->count,
                                     .parameter = q->parameter,
                                     .variable = q->variable,
                                     .details = q->details,
                                     .bound = q->parsed};
    call->query = *query;
    struct evaluation e = query_evaluation(query, problem);
    if (!command_allowed(query->run_context, q->command, problem) ||
        (q->with && !with_apply(&e, q->with, q->text, &call->state, &call->query)))
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
