/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sensitivity: how much an answer changes with each parameter. */
#include "commands/planning/inquiry.h"
#include "commands/planning/planning.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

const struct column sensitivity_columns[] = {
    {"parameter", "", "what is changed", 9},
    {"value", "", "its value now; 0 for an effect that is off", 0},
    {"step", "", "by how much it is changed", 8},
    {"less", "share", "change of the answer with a smaller value", 0},
    {"more", "share", "change of the answer with a larger value", 0},
    {NULL, NULL, NULL, 0},
};

bool sensitivity_parse(struct reader *r, struct question *q)
{
    struct question *asked = q->own = arena_take(r->arena, sizeof *asked);
    if (!asked)
        return problem_error(r->problem, "out of memory");
    return question_parse_any(r, asked, true);
}

/* A parameter, its step, and the changes of the answer. */
struct influence {
    const struct parameter *parameter;
    domq_real value, step, less, more;
    char text[24];
};

enum { INFLUENCES_MOST = 32 };

/* Chooses the step: 1 % of a value; of friction 0.01 and of a slope 1 degree, also from 0. False: none. */
static bool step_choose(const struct query *query, const struct parameter *p, struct influence *i)
{
    domq_real value = parameter_get(query->state, p);
    bool dynamic = p->effect && (int)p->which < DOM_DYNAMICS_COUNT && !p->effect->cancels,
         angle = strcmp(p->value->unit, "rad") == 0;
    *i = (struct influence){.parameter = p, .value = value == EFFECT_OFF ? 0 : value};
    if (p->setting || p->words_only || p->value->whole || strcmp(p->name, "tol") == 0)
        return false;
    if (value == EFFECT_OFF && !dynamic)
        return false;
    if (dynamic) {
        i->step = angle ? QUAD_PI / 180 : (domq_real)1 / 100;
        snprintf(i->text, sizeof i->text, angle ? "1 deg" : "0.01");
        return true;
    }
    i->step = quad(fabs)(i->value) / 100;
    snprintf(i->text, sizeof i->text, "1 %%");
    return i->step > 0; /* masses that are not known */
}

/* Returns the larger of the two changes that exist; -1: neither does. */
static domq_real size_of(const struct influence *i)
{
    domq_real less = isfinite(i->less) ? quad(fabs)(i->less) : -1,
              more = isfinite(i->more) ? quad(fabs)(i->more) : -1;
    return quad_larger(less, more);
}

/* Sorts the largest change first, then by name. */
static int compare(const void *one, const void *other)
{
    const struct influence *a = one, *b = other;
    domq_real sa = size_of(a), sb = size_of(b);
    return sa > sb ? -1 : sa < sb ? 1 : strcmp(a->parameter->name, b->parameter->name);
}

/*
 * Returns the change of the answer at a value, as a share, or where it is 0 now as a difference. What the
 * tolerance of the answers leaves open is 0.
 */
static domq_real change(struct probe *p, domq_real value, domq_real now)
{
    domq_real by = probe_at(p, value) - now, size = quad(fabs)(now);
    by /= size > 0 ? size : 1;
    return quad(fabs)(by) <= 10 * p->query->scene->compute.tol ? 0 : by;
}

/* Fills the list with the parameters that can be changed; false after an error. */
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

static struct cell change_cell(domq_real value)
{
    struct cell cell = cell_bound(value, DOMQ_NAN);
    cell.digits = 3;
    return cell;
}

bool run_sensitivity(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct question *q = query->given->own;
    struct probe probe = {.query = query, .command = problem->command, .question = q};
    struct influence list[INFLUENCES_MOST];
    char without[256] = "";
    int count;
    domq_real now = probe_at(&probe, 0);
    if (isnan(now))
        return probe_report(&probe, problem);
    if (!influences_find(query, problem, &probe, now, list, &count))
        return false;
    if (now == 0) { /* there is no share of 0 */
        struct column *columns = answer_columns(a, sensitivity_columns);
        columns[3].unit = columns[4].unit = "";
    }
    bool people = answer_for_people(a);
    answer_largest(a, "less", 1);
    for (int k = 0, n = 0; k < count && !answer_lost(a); k++) {
        const struct influence *i = &list[k];
        if (people && size_of(i) == 0) {
            if (n < (int)sizeof without)
                n += snprintf(without + n, sizeof without - (size_t)n, "%s%s", n ? ", " : "",
                              i->parameter->name);
            continue;
        }
        struct cell value = cell_real(i->value);
        value.digits = 6;
        answer_cells(a, cell_word(i->parameter->name), value, cell_word(i->text), change_cell(i->less),
                     change_cell(i->more));
    }
    if (*without)
        answer_say(a, "%s does not depend on %s.", q->name, without);
    return true;
}
