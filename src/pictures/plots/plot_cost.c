/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plot 'cost': the error of an answer, plotted against the time that its computation takes, for each
 * method and precision. */
#include "language/quad.h"
#include "pictures/plots/plots.h"
#include "train/train.h"

/* Adds a curve. Its colour and style depend only on method and precision, so charts can be compared. */
static struct chart_curve *curve_add(struct chart *chart, const struct cost_row *row)
{
    static const enum ink inks[] = {INK_SKY, INK_BLUE, INK_PURPLE};
    if (row->method == DOM_METHOD_PAPER)
        return chart_curve(chart, CHART_MARKED, INK_RED, 1, "the paper's recipe");
    if (row->method == DOM_METHOD_GSL)
        return chart_curve(chart, CHART_MARKED, INK_GREEN, 2, "solvers of GSL");
    return chart_curve(chart, CHART_MARKED, inks[row->precision], row->precision == IN_DOUBLE ? 0 : 3,
                       "this program, %s", any_arithmetic(row->precision).name);
}

static void cost_chart(const struct query *query, const char *name, const struct cost *cost,
                       struct chart *chart)
{
    const struct domq_train *train = &query->scene->train;
    struct chart_curve *curve = NULL;
    snprintf(chart->title, sizeof chart->title,
             "What accuracy costs: %s at s = %.6g, r = %.6g, d = %.4g, q = %.4g", name, (double)train->s,
             (double)train->r, (double)train->d, (double)train->q);
    snprintf(chart->x.label, sizeof chart->x.label, "time per answer in seconds");
    snprintf(chart->y.label, sizeof chart->y.label, "relative error");
    chart->x.logarithmic = chart->y.logarithmic = true;
    for (const struct cost_row *row = cost->row; row < cost->row + cost->rows; row++) {
        if (!curve || row->method != row[-1].method || row->precision != row[-1].precision)
            curve = curve_add(chart, row);
        /* An error smaller than a quarter of the machine epsilon is luck, and an error of 0 cannot be drawn
         * on a logarithmic axis. Such errors are drawn as a quarter of the machine epsilon. */
        double least = any_arithmetic(row->precision).epsilon / 4;
        if (row->status == DOM_OK)
            chart_point(chart, curve, row->seconds, (double)quad_larger(row->error, (domq_real)least));
    }
}

static bool plot_cost(const struct query *query, struct answer *a, struct chart *chart,
                      struct problem *problem)
{
    struct cost cost;
    if (query->given->count < 2)
        return problem_error(problem,
                             "'plot cost' needs the NAME of an answer: fuel, launch, barrier, duration, "
                             "rmax or pair");
    int which = (int)query->given->number[1];
    if (!chart) { /* as csv or json, the answer is the same as that of the command 'cost' */
        const struct command *command = command_find("cost");
        const struct arguments given = {.count = 1, .number = {query->given->number[1]}};
        struct query cost_query = *query;
        cost_query.given = &given;
        a->columns = command->columns;
        return command->run(&cost_query, a, problem);
    }
    if (!cost_measure(query, which, &cost, problem))
        return false;
    cost_chart(query, cost_names(NULL, which), &cost, chart);
    return true;
}

static const struct column cost_columns[] = {{NULL, NULL, NULL, 0}};
static const struct argument answer_argument = {
    .name = "NAME", .kind = ARGUMENT_CHOICE, .noun = "command with a tolerance", .choices = cost_names};

const struct plot cost_plots[] = {
    {"cost", plot_cost, "what accuracy costs, as in 'plot cost rmax'; the columns are those of 'cost'",
     cost_columns, .title = "", .argument = &answer_argument},
    {.name = NULL},
};
