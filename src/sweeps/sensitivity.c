/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'sensitivity', which shows how much an answer changes with each parameter. */
#include "language/quad.h"
#include "language/text.h"
#include "sweeps/sweeps.h"
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
    return q->parsed && question_parse_any(r, q->parsed, true, question_names);
}

/* How much the answer changes if a parameter is made smaller or larger by a step. */
struct influence {
    const struct parameter *parameter;
    domq_real value, step, less, more;
    const char *step_text;
    domq_real size; /* the larger of |less| and |more|, or -1 if neither is known */
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

/* For qsort: the larger change comes first, and equal changes are sorted by name. */
static int compare(const void *one, const void *other)
{
    const struct influence *a = one, *b = other;
    return a->size > b->size ? -1 : a->size < b->size ? 1 : strcmp(a->parameter->name, b->parameter->name);
}

/* Returns the relative change of the answer if the parameter is set to `value`. If the answer is 0 now,
 * returns the change itself. A change of at most 10 times the tolerance counts as 0. Adds it to *size. */
static domq_real change(struct probe *p, domq_real value, domq_real now, domq_real *size)
{
    domq_real by = (probe_at(p, value) - now) / (now != 0 ? quad(fabs)(now) : 1);
    by = quad(fabs)(by) <= 10 * p->query->scene->compute.tol ? 0 : by;
    *size = isfinite(by) ? quad_larger(*size, quad(fabs)(by)) : *size;
    return by;
}

/* Lists the influences of all parameters that can be varied, the largest first. */
static bool influences_find(struct problem *problem, struct probe *probe, domq_real now,
                            struct influence *list, int *count)
{
    const struct query *query = probe->query;
    *count = 0;
    for (const struct parameter *p = session_parameters; p->name && *count < INFLUENCES_MOST; p++) {
        struct influence *i = &list[*count];
        if (!step_choose(query, p, i))
            continue;
        probe->parameter = p;
        i->size = -1;
        i->less = change(probe, i->value - i->step, now, &i->size);
        i->more = change(probe, i->value + i->step, now, &i->size);
        if (dom_raised(query->scene->compute.interrupt))
            return problem_status(problem, query->scene, DOM_INTERRUPTED);
        *count += i->size >= 0;
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
    if (!influences_find(problem, &probe, now, list, &count))
        return false;
    if (now == 0) { /* if the answer is 0, its change cannot be given as a percentage */
        struct column *columns = answer_columns(a, sensitivity_columns);
        columns[3].unit = columns[4].unit = "";
    }
    for (int k = 0; k < count && !answer_lost(a); k++) {
        const struct influence *i = &list[k];
        if (answer_for_people(a) && i->size == 0) {
            text_add(without, sizeof without, "%s%s", *without ? ", " : "", i->parameter->name);
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
