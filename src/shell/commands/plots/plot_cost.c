/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot cost: the error of an answer against its time, a line for each method and precision. */
#include "commands/costs.h"
#include "commands/plots/plots.h"
#include "language/quad.h"

static bool same_series(const struct cost_row *a, const struct cost_row *b)
{
    return a->method == b->method && a->precision == b->precision;
}

/* Returns the curve of a method and precision, which looks the same in every picture. */
static struct chart_curve *series(struct chart *chart, const struct cost_row *row)
{
    if (row->method == DOM_METHOD_PAPER)
        return chart_curve(chart, CHART_MARKED, INK_RED, 1, "the paper's recipe");
    if (row->method == DOM_METHOD_GSL)
        return chart_curve(chart, CHART_MARKED, INK_GREEN, 2, "solvers of GSL");
    static const enum ink inks[] = {INK_SKY, INK_BLUE, INK_PURPLE};
    return chart_curve(chart, CHART_MARKED, inks[row->precision], row->precision == DOM_DOUBLE ? 0 : 3,
                       "this program, %s", domq_arithmetic(row->precision)->name);
}

/* The rows of 'cost', as that command answers them. */
static bool cost_rows(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct command *cost = command_find("cost");
    const struct arguments given = {.count = 1, .number = {query->given->number[1]}};
    struct query asked = *query;
    asked.given = &given;
    a->columns = cost->columns;
    return cost->run(&asked, a, problem);
}

static bool cost_chart(const struct query *query, struct answer *a, struct problem *problem,
                       const struct costed *answer, const struct cost *cost)
{
    struct chart chart = chart_make();
    const struct domq_train *train = &query->scene->train;
    struct chart_curve *curve = NULL;
    snprintf(chart.title, sizeof chart.title,
             "What accuracy costs: %s at s = %.6g, r = %.6g, d = %.4g, q = %.4g", answer->name,
             (double)train->s, (double)train->r, (double)train->d, (double)train->q);
    snprintf(chart.x.label, sizeof chart.x.label, "time of one answer in s");
    snprintf(chart.y.label, sizeof chart.y.label, "relative error");
    chart.x.logarithmic = chart.y.logarithmic = true;
    for (int k = 0; k < cost->rows; k++) {
        const struct cost_row *row = &cost->row[k];
        if (!curve || !same_series(row, row - 1))
            curve = series(&chart, row);
        /* A logarithm has no 0: below a unit of its precision nothing is known. */
        if (row->status == DOM_OK)
            chart_point(
                &chart, curve, row->seconds,
                (double)quad_larger(row->error, (domq_real)domq_arithmetic(row->precision)->epsilon / 4));
    }
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

bool plot_cost(const struct query *query, struct answer *a, struct problem *problem)
{
    struct cost cost;
    if (query->given->count < 2)
        return problem_error(problem,
                             "'plot cost' needs the NAME of an answer: fuel, launch, barrier, duration, "
                             "rmax or pair");
    if (!answer_for_people(a))
        return cost_rows(query, a, problem);
    const struct costed *answer = &cost_answers[(int)query->given->number[1]];
    return picture_ready(a, problem) && cost_of(query, problem, answer, &cost) &&
           cost_chart(query, a, problem, answer, &cost);
}
