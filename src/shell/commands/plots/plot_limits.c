/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot growth, plot marginal: the largest growth over the separation. */
#include "commands/plots/plots.h"
#include "io/terminal.h"
#include "language/quad.h"
#include <string.h>

enum { SAMPLES = 193, LIMITS = 4 };
#define S_LOW  ((domq_real)2 / 100)
#define S_STEP ((domq_real)5 / 1000)

/* One of the curves: r against s. */
struct limit_curve {
    const char *title;
    double q;
    bool pair;
    enum dom_fuel fuel;
    enum ink ink;
    int dash;
};

/* Those without the paper's fuel come first. */
static const struct limit_curve growth_curves[LIMITS] = {
    {"solid dominoes", 4, false, DOM_FUEL_EXACT, INK_BLUE, 0},
    {"hollow dominoes", 3, false, DOM_FUEL_EXACT, INK_RED, 1},
    {"solid, the paper's fuel", 4, false, DOM_FUEL_PAPER, INK_SKY, 3},
    {"hollow, the paper's fuel", 3, false, DOM_FUEL_PAPER, INK_ORANGE, 4},
};
static const struct limit_curve marginal_curves[LIMITS] = {
    {"solid pair", 4, true, DOM_FUEL_EXACT, INK_SKY, 3},
    {"solid train", 4, false, DOM_FUEL_EXACT, INK_BLUE, 0},
    {"hollow pair", 3, true, DOM_FUEL_EXACT, INK_ORANGE, 4},
    {"hollow train", 3, false, DOM_FUEL_EXACT, INK_RED, 1},
};

/* r of each curve at each s; NaN where not even r = 1 goes on. */
struct limit_table {
    const struct limit_curve *curve;
    int curves;
    domq_real s[SAMPLES], r[SAMPLES][LIMITS];
};

static enum dom_status limit_point(struct domq_train train, const struct domq_compute *compute,
                                   const struct limit_curve *curve, domq_real s, domq_real *r)
{
    struct domq_limit limit;
    train.s = s;
    train.r = 1;
    train.q = (domq_real)curve->q;
    train.fuel = curve->fuel;
    *r = DOMQ_NAN;
    if (domq_dynamics(&train) && train.fuel == DOM_FUEL_PAPER) /* the closed form has no friction or slope */
        return DOM_OK;
    enum dom_status status =
        curve->pair ? domq_limit_pair(&train, compute, &limit) : domq_limit_rmax(&train, compute, &limit);
    *r = status == DOM_OK && limit.ends != DOM_END_NONE ? limit.r_max : DOMQ_NAN;
    return status;
}

static bool limits_find(const struct query *query, struct problem *problem, struct limit_table *table)
{
    struct progress progress = {0, 0};
    for (int k = 0; k < SAMPLES; k++) {
        enum dom_status status = DOM_OK;
        table->s[k] = S_LOW + (domq_real)k * S_STEP;
        for (int c = 0; c < table->curves && status == DOM_OK; c++)
            status = limit_point(query->scene->train, &query->scene->compute, &table->curve[c], table->s[k],
                                 &table->r[k][c]);
        progress_show(&progress, status == DOM_OK ? (k + 1.0) / SAMPLES : 1);
        if (status != DOM_OK)
            return problem_status(problem, query->scene, status);
    }
    return true;
}

static domq_real reach_at(struct domq_train train, domq_real s)
{
    train.s = s;
    return domq_train_reach(&train);
}

static bool limit_rows(const struct domq_train *train, struct answer *a, const struct limit_table *table)
{
    for (int k = 0; k < SAMPLES && !answer_lost(a); k++) {
        struct cell row[LIMITS + 2] = {cell_real(table->s[k])};
        for (int c = 0; c < table->curves; c++)
            row[c + 1] = cell_real(table->r[k][c]);
        row[LIMITS + 1] = cell_real(reach_at(*train, table->s[k]));
        answer_row(a, row, NULL);
    }
    return true;
}

/* The height of the picture: all curves, and the point of the session if it is not far above them. */
static double limit_top(const struct query *query, const struct limit_table *table)
{
    domq_real top = 1, r = query->scene->train.r;
    for (int k = 0; k < SAMPLES; k++)
        for (int c = 0; c < table->curves; c++)
            top = isfinite(table->r[k][c]) ? quad_larger(top, table->r[k][c]) : top;
    if (r > top && r < 2 * top)
        top = r;
    return top > 1 ? (double)(1 + (domq_real)1.15 * (top - 1)) : 2;
}

static bool limit_chart(const struct query *query, struct answer *a, struct problem *problem,
                        const char *title, const struct limit_table *table)
{
    struct chart chart = chart_make();
    const struct domq_train *t = &query->scene->train;
    double top = limit_top(query, table);
    snprintf(chart.title, sizeof chart.title, "%s", title);
    snprintf(chart.x.label, sizeof chart.x.label, "gap over height, s (thickness over height is d = %.4g)",
             (double)t->d);
    snprintf(chart.y.label, sizeof chart.y.label, "growth r");
    chart.x.low = 0;
    chart.x.high = chart.y.low = 1;
    chart.y.high = top;
    for (int c = 0; c < table->curves; c++) {
        const struct limit_curve *limit = &table->curve[c];
        struct chart_curve *curve =
            chart_curve(&chart, CHART_LINE, limit->ink, limit->dash, "%s", limit->title);
        for (int k = 0; k < SAMPLES; k++)
            chart_point(&chart, curve, (double)table->s[k], (double)table->r[k][c]);
    }
    struct chart_curve *reach =
        chart_curve(&chart, CHART_LINE, INK_GREY, 2, "reach: r = %.4g/s", (double)reach_at(*t, 1));
    for (int k = 0; k < SAMPLES; k++)
        chart_point(&chart, reach, (double)table->s[k], (double)reach_at(*t, table->s[k]));
    bool inside = (double)t->r <= top;
    struct chart_curve *now = chart_curve(&chart, CHART_POINTS, INK_TEXT, 0, "now: s = %.4g, r = %.4g%s",
                                          (double)t->s, (double)t->r, inside ? "" : " (above)");
    chart_point(&chart, now, (double)t->s, inside ? (double)t->r : top);
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

static bool plot_limits(const struct query *query, struct answer *a, struct problem *problem,
                        const char *title, const struct limit_curve *curves, int count)
{
    static struct limit_table table;
    table.curve = curves;
    table.curves = count;
    bool people = answer_for_people(a);
    if ((people && !picture_ready(a, problem)) || !limits_find(query, problem, &table))
        return false;
    return people ? limit_chart(query, a, problem, title, &table)
                  : limit_rows(&query->scene->train, a, &table);
}

bool plot_growth(const struct query *query, struct answer *a, struct problem *problem)
{
    if (query->given->count < 2) { /* without 'paper' */
        answer_leave_out(a, "solid_paper");
        answer_leave_out(a, "hollow_paper");
    }
    return plot_limits(query, a, problem, "Below its curve a train keeps falling", growth_curves,
                       query->given->count < 2 ? LIMITS / 2 : LIMITS);
}

bool plot_marginal(const struct query *query, struct answer *a, struct problem *problem)
{
    return plot_limits(query, a, problem,
                       "Below the curve of a pair, a domino that just tips over topples the next",
                       marginal_curves, LIMITS);
}
