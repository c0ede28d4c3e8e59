/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plots 'maximize' and 'minimize': an answer against the parameter that is varied, with the best place.
 */
#include "language/text.h"
#include "pictures/plots/plots.h"
#include "sweeps/optimum.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Draws the curve, and marks the best place. With two parameters, the curve shows the best answer over the
 * second one. */
static void optimum_draw(const struct hunt *h, struct chart *chart)
{
    const struct optimum *o = h->optimum;
    const struct ranged *range = o->range;
    const char *unit = range->parameter->value->unit, *best = o->is_minimum ? "smallest" : "largest";
    const bool has_unit = *unit && strcmp(unit, "h") != 0;
    const double sign = o->is_minimum ? -1 : 1;
    struct chart_curve *line = chart_curve(chart, CHART_LINE, INK_BLUE, 0, "%s", "");
    for (size_t k = 0; k < h->count; k++)
        chart_point(chart, line, peak_point(&h->slope[0], h->count, k), sign * h->value[k]);
    struct chart_curve *mark = chart_curve(chart, CHART_POINTS, INK_RED, 0, "%s: %.5g, at %s = %.5g", best,
                                           (double)h->best, range->parameter->name, h->peak[0].x);
    chart_point(chart, mark, h->peak[0].x, (double)h->best);
    if (o->axes == 2)
        text_add(mark->title, sizeof mark->title, ", %s = %.5g", range[1].parameter->name, h->peak[1].x);
    snprintf(chart->title, sizeof chart->title, "%.120s against %s", o->question->name,
             range->parameter->name);
    if (o->axes == 2)
        snprintf(chart->note, sizeof chart->note, "For each %s, %s is chosen so that the answer is %s.",
                 range->parameter->name, range[1].parameter->name, best);
    else if (h->missing > 0)
        snprintf(chart->note, sizeof chart->note, "%zu of %zu points have no answer.", h->missing, h->count);
    snprintf(chart->x.label, sizeof chart->x.label, "%s, %.90s%s%s", range->parameter->name,
             parameter_meaning(range->parameter), has_unit ? ", in " : "", has_unit ? unit : "");
    snprintf(chart->y.label, sizeof chart->y.label, "%.80s%s%.30s", o->question->name,
             *h->probe.unit_text ? " in " : "", h->probe.unit_text);
    chart->x.low = (double)range->from;
    chart->x.high = (double)range->to;
}

static bool plot_optimum(const struct query *query, struct answer *a, struct chart *chart,
                         struct problem *problem)
{
    if (query->given->count < 2 || !query->given->bound)
        return problem_error(problem,
                             "a parameter and an answer are missing; enter, for example, 'plot maximize "
                             "s : duration.speed'");
    struct hunt *h = optimum_find(query->given->bound, query, problem);
    if (!h)
        return false;
    const domq_real sign = h->optimum->is_minimum ? -1 : 1;
    if (chart)
        optimum_draw(h, chart);
    else
        answer_cells(a, cell_real(h->peak[0].x), cell_real(h->best), cell_flag(true));
    for (size_t k = 0; k < h->count && !chart && !answer_lost(a); k++)
        answer_cells(a, cell_real((domq_real)peak_point(&h->slope[0], h->count, k)),
                     cell_real(sign * (domq_real)h->value[k]), cell_flag(false));
    free(h);
    return true;
}

static bool whole_maximize(struct reader *r, struct question *q)
{
    return maximize_parse(r, q) && optimum_parse_answer(r, q);
}

static bool whole_minimize(struct reader *r, struct question *q)
{
    return minimize_parse(r, q) && optimum_parse_answer(r, q);
}

/* The warning about missing initializers is off, because the entries leave out members. */
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

static const struct column optimum_plot_columns[] = {
    {"value", "", "value of the (first) parameter", 0},
    {"answer", "", "the answer", 0},
    {"best", "", "yes for the best place, which is the first row", 5},
    {NULL, NULL, NULL, 0},
};

static const struct argument maximum_argument = {.name = "NAMES",
                                                 .kind = ARGUMENT_GRID,
                                                 .parse = whole_maximize,
                                                 .bind = optimum_bind,
                                                 .choices = optimum_names},
                             minimum_argument = {.name = "NAMES",
                                                 .kind = ARGUMENT_GRID,
                                                 .parse = whole_minimize,
                                                 .bind = optimum_bind,
                                                 .choices = optimum_names};

const struct plot optimum_plots[] = {
    {"maximize", plot_optimum, "where an answer is largest, as in 'plot maximize s : duration.speed'",
     optimum_plot_columns, .title = "", .argument = &maximum_argument},
    {"minimize", plot_optimum, "where an answer is smallest, as in 'plot minimize r : count(20 m)'",
     optimum_plot_columns, .title = "", .argument = &minimum_argument},
    {.name = NULL},
};
