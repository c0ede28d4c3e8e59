/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/planning/inquiry.h"

/* Asks whether what the command decides is true. */
static bool verdict_ask(const struct probe *p, const struct query *at, struct quantity *value,
                        struct problem *problem)
{
    const struct command *c = p->question->command;
    struct answer answer = {.style = state_style(at->state), .columns = c->columns, .rows = c->rows};
    if (!question_ask(p->question, at, &answer, problem))
        return false;
    *value = (struct quantity){.value = answer.holds == ANSWER_YES ? 1 : -1};
    return answer.holds != ANSWER_OPEN || problem_no_answer(problem, "nothing is decided");
}

domq_real probe_at(struct probe *p, domq_real value)
{
    struct state point = *p->query->state;
    struct means means = *p->query->means;
    struct query at = *p->query;
    const struct assigned assigned = {p->parameter, value};
    at.state = &point;
    at.scene = &point.scene;
    at.means = &means;
    at.next = NULL;
    means.shard.parts = 0;
    point.settings.threads = 1;
    problem_begin(&p->problem, p->command);
    struct quantity answer = {.value = 0};
    bool put = !p->parameter || state_assign(&point, &assigned, 1, &p->problem);
    bool done = put && (p->verdict ? verdict_ask(p, &at, &answer, &p->problem)
                                   : question_value(p->question, &at, &answer, &p->problem));
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
