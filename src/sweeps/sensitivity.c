/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'sensitivity', which shows how much an answer changes with each parameter. */
#include "language/quad.h"
#include "sweeps/sweeps.h"
#include "train/falling.h"
#include <stdlib.h>
#include <string.h>

const struct column sensitivity_columns[] = {
    {"parameter", "", "the parameter that is changed", 9},
    {"value", "", "the current value of the parameter, or 0 for an effect that is off", 0},
    {"step", "", "by how much the parameter is changed", 8},
    {"less", "share", "change in the answer if the value decreases by the step", 0},
    {"more", "share", "change in the answer if the value increases by the step", 0},
    {NULL, NULL, NULL, 0},
};

bool sensitivity_parse(struct reader *r, struct question *q)
{
    q->parsed = reader_memory(r, sizeof(struct question));
    return q->parsed && question_parse_any(r, q->parsed, true);
}

/* How much the answer changes if a parameter is made smaller or larger by a step. */
struct influence {
    const struct parameter *parameter;
    domq_real value, step, less, more;
    const char *step_text;
};

enum { INFLUENCES_MOST = 32 };

/* Returns false for a parameter that cannot be varied. */
static bool step_choose(const struct query *query, const struct parameter *p, struct influence *i)
{
    domq_real value = parameter_get(query->state, p);
    bool dynamic = p->effect && (int)p->which < DOM_DYNAMICS_COUNT && !p->effect->cancels,
         angle = strcmp(p->value->unit, "rad") == 0;
    *i = (struct influence){.parameter = p, .value = value == EFFECT_OFF ? 0 : value};
    if (p->setting || p->words_only || p->value->whole || p->of_precision ||
        (value == EFFECT_OFF && (!dynamic || p->effect->needs)))
        return false;
    i->step = dynamic && angle ? QUAD_PI / 180 : dynamic ? (domq_real)1 / 100 : quad(fabs)(i->value) / 100;
    i->step_text = dynamic && angle ? "1 deg" : dynamic ? "0.01" : "1 %";
    return i->step > 0; /* the step is 0 for a value of 0, such as a mass that is not known */
}

/* Returns the size of an influence: the larger of |less| and |more|. If one of them is unknown, returns the
 * other one, and if both are unknown, returns -1. */
static domq_real size_of(const struct influence *i)
{
    domq_real less = isfinite(i->less) ? quad(fabs)(i->less) : -1,
              more = isfinite(i->more) ? quad(fabs)(i->more) : -1;
    return quad_larger(less, more);
}

/* For qsort: the larger change comes first, and equal changes are sorted by name. */
static int compare(const void *one, const void *other)
{
    const struct influence *a = one, *b = other;
    domq_real sa = size_of(a), sb = size_of(b);
    return sa > sb ? -1 : sa < sb ? 1 : strcmp(a->parameter->name, b->parameter->name);
}

/* Returns the relative change of the answer if the parameter is set to `value`. If the answer is 0 now,
 * returns the change itself. A change of at most 10 times the tolerance counts as 0. */
static domq_real change(struct probe *p, domq_real value, domq_real now)
{
    domq_real by = probe_at(p, value) - now, size = quad(fabs)(now);
    by /= size > 0 ? size : 1;
    return quad(fabs)(by) <= 10 * p->query->scene->compute.tol ? 0 : by;
}

/* Lists the influences of all parameters that can be varied, the largest first. */
static bool influences_find(const struct query *query, struct problem *problem, struct probe *probe,
                            domq_real now, struct influence *list, int *count)
{
    *count = 0;
    for (const struct parameter *p = session_parameters; p->name && *count < INFLUENCES_MOST; p++) {
        struct influence *i = &list[*count];
        if (!step_choose(query, p, i))
            continue;
        probe->parameter = p;
        i->less = change(probe, i->value - i->step, now);
        i->more = change(probe, i->value + i->step, now);
        if (dom_raised(query->scene->compute.interrupt))
            return problem_status(problem, query->scene, DOM_INTERRUPTED);
        *count += size_of(i) >= 0;
    }
    qsort(list, (size_t)*count, sizeof *list, compare);
    return true;
}

bool run_sensitivity(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct question *q = query->given->bound;
    struct probe probe = {.query = query, .command = problem->command, .question = q};
    struct influence list[INFLUENCES_MOST];
    char without[256] = "";
    int count;
    domq_real now = probe_at(&probe, 0);
    if (isnan(now))
        return probe_report(&probe, problem);
    if (!influences_find(query, problem, &probe, now, list, &count))
        return false;
    if (now == 0) { /* if the answer is 0, its change cannot be given as a percentage */
        struct column *columns = answer_columns(a, sensitivity_columns);
        columns[3].unit = columns[4].unit = "";
    }
    for (int k = 0, n = 0; k < count && !answer_lost(a); k++) {
        const struct influence *i = &list[k];
        if (answer_for_people(a) && size_of(i) == 0) {
            if (n < (int)sizeof without)
                n += snprintf(without + n, sizeof without - (size_t)n, "%s%s", n ? ", " : "",
                              i->parameter->name);
            continue;
        }
        struct cell value = cell_real(i->value);
        value.digits = 6;
        answer_cells(a, cell_word(i->parameter->name), value, cell_word(i->step_text),
                     cell_narrow(i->less, 3), cell_narrow(i->more, 3));
    }
    if (*without)
        answer_say(a, "%s does not depend on %s.", q->name, without);
    return true;
}
