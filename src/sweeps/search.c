/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/terminal.h"
#include "language/quad.h"
#include "language/text.h"
#include "parallel/workers.h"
#include "sweeps/sweeps.h"
#include <math.h>
#include <string.h>

void search_begin(struct search *s, const struct sweep *sweep, struct probe probe, double sign)
{
    s->sweep = sweep;
    s->probe = probe;
    s->sign = sign;
    for (int i = 0; i < sweep->grid.axes; i++) {
        const struct axis *axis = &sweep->grid.axis[i];
        s->line[i] = (struct line){.search = s,
                                   .axis = i,
                                   .from = (double)axis->from,
                                   .to = (double)axis->to,
                                   .whole = axis->parameter->value->whole};
        struct line *l = &s->line[i];
        l->grain = l->whole ? 0.5 : (l->to - l->from) * (i == 0 && sweep->grid.axes == 2 ? 2e-6 : 1e-10);
    }
}

double search_ask(struct search *s)
{
    struct assigned assigned[SEARCHED_MOST];
    if (dom_raised(s->probe.query->scene->compute.interrupt))
        return (double)NAN;
    for (int i = 0; i < s->sweep->grid.axes; i++)
        assigned[i] = (struct assigned){.parameter = s->sweep->grid.axis[i].parameter,
                                        .value = quad_decimal(s->place[i])};
    s->answer = probe_ask(&s->probe, assigned, s->sweep->grid.axes);
    if (s->probe.wrong)
        s->fault = s->probe.problem;
    return s->sign * (double)(s->answer - s->sweep->value.value);
}

double line_at(double x, void *context)
{
    struct line *l = context;
    struct search *s = l->search;
    s->place[l->axis] = l->whole ? round(x) : x;
    return l->axis + 1 < s->sweep->grid.axes ? s->along(l + 1) : search_ask(s);
}

double line_above(double x, void *context)
{
    const struct line *l = context;
    return line_at(x, context) - l->level;
}

void line_place(struct line *l)
{
    const size_t most = l->search->sweep->grid.axes == 2 ? POINTS_OF_TWO : POINTS;
    const double span = l->to - l->from;
    l->count = l->whole && span < (double)most ? (size_t)span + 1 : most;
    for (size_t k = 0; k < l->count; k++) {
        const double part = (double)k / (double)(l->count - 1), x = (1 - part) * l->from + part * l->to;
        l->point[k].x = l->whole ? round(x) : x;
    }
}

/* A dom_task, which computes the answer at point k. Each task has its own copy of the search. */
static void point_task(size_t k, void *context)
{
    struct search *s = context;
    struct search mine = {.along = s->along};
    search_begin(&mine, s->sweep, s->probe, s->sign);
    s->line->point[k].value = line_at(s->line->point[k].x, mine.line);
    s->is_wrong[k] = mine.fault.kind != PROBLEM_NONE;
}

bool search_points(struct search *s, struct problem *problem)
{
    const struct scene *scene = s->probe.query->scene;
    struct task_pool pool = {.threads = s->probe.query->state->settings.threads,
                             .progress = true,
                             .interrupt = scene->compute.interrupt};
    struct line *l = s->line;
    line_place(l);
    const enum dom_status status = workers_tasks(l->count, point_task, s, &pool);
    progress_end();
    if (status != DOM_OK)
        return problem_status(problem, scene, status);
    for (size_t k = 0; k < l->count; k++) {
        const bool is_first = isnan(l->point[k].value) && s->missing++ == 0;
        if (!is_first && !s->is_wrong[k])
            continue;
        (void)line_at(l->point[k].x, l);
        if (s->is_wrong[k]) {
            *problem = s->fault;
            return false;
        }
        snprintf(s->reason, sizeof s->reason, "%.*s", (int)sizeof s->reason - 1, s->probe.problem.text);
    }
    return true;
}

const char *search_ranges(const struct search *s, char text[RANGES_TEXT])
{
    *text = '\0';
    for (int i = 0; i < s->sweep->grid.axes; i++) {
        const struct axis *axis = &s->sweep->grid.axis[i];
        const char *unit = axis->parameter->value->unit;
        const bool has_unit = *unit && strcmp(unit, "h") != 0;
        text_add(text, RANGES_TEXT, "%s%s = %s .. %s%s%s", i ? " and " : "", axis->parameter->name,
                 quad_text(axis->from, 10), quad_text(axis->to, 10), has_unit ? " " : "",
                 has_unit ? unit : "");
    }
    return text;
}

bool search_constant(const struct search *s, domq_real answer, struct problem *problem)
{
    char text[RANGES_TEXT];
    return problem_no_answer(
        problem, "%s does not change: it is %s everywhere in %s; 'sensitivity' shows what it depends on",
        s->sweep->answer->name, quad_text(answer, 10), search_ranges(s, text));
}
