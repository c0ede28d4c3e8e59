/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plot 'growth': the largest growth of trains and of pairs, plotted against the separation. */
#include "io/terminal.h"
#include "language/quad.h"
#include "pictures/plots/plots.h"

enum { SAMPLES = 193, LIMITS = 4 };
#define S_LOW  ((domq_real)2 / 100)
#define S_STEP ((domq_real)5 / 1000)

/* Finds the largest growth at the separation s: of a train or, if `is_pair`, of two dominoes. Stores NaN if
 * no growth is possible. */
static enum dom_status limit_find(const struct query *query, domq_real q, bool is_pair, domq_real s,
                                  domq_real *r)
{
    struct domq_train train = query->scene->train;
    const struct any_compute *compute = &query->scene->compute;
    struct domq_limit limit;
    train.s = s;
    train.r = 1;
    train.q = q;
    *r = DOMQ_NAN;
    enum dom_status status =
        is_pair ? any_limit_pair(&train, compute, &limit) : any_limit_rmax(&train, compute, &limit);
    if (status == DOM_OK && limit.ends != DOM_END_NONE)
        *r = limit.r_max;
    return status == DOM_OPEN ? DOM_OK : status; /* the curve has a gap where a limit is open */
}

static domq_real reach_at(struct domq_train train, domq_real s)
{
    train.s = s;
    return domq_train_reach(&train);
}

/* Sets the axes and marks the growth of the session. The y axis includes this growth, unless it is far above
 * all curves. */
static void limits_chart(const struct domq_train *t, double top, struct chart *chart)
{
    double r = (double)t->r;
    top = r > top && r < 2 * top ? r : top;
    top = top > 1 ? 1 + 1.15 * (top - 1) : 2;
    snprintf(chart->x.label, sizeof chart->x.label, "gap over height, s (thickness over height is d = %.4g)",
             (double)t->d);
    chart->x.low = 0;
    chart->x.high = chart->y.low = 1;
    chart->y.high = top;
    struct chart_curve *reach = &chart->curve[chart->curves - 1];
    snprintf(reach->title, sizeof reach->title, "reach: r = %.4g/s", (double)reach_at(*t, 1));
    struct chart_curve *now = chart_curve(chart, CHART_POINTS, INK_TEXT, 0, "now: s = %.4g, r = %.4g%s",
                                          (double)t->s, r, r <= top ? "" : " (above)");
    chart_point(chart, now, (double)t->s, fmin(r, top));
}

static bool plot_growth(const struct query *query, struct answer *a, struct chart *chart,
                        struct problem *problem)
{
    const struct domq_train *train = &query->scene->train;
    domq_real top = 1;
    for (int k = 0; k < SAMPLES && !answer_lost(a); k++) {
        domq_real s = S_LOW + (domq_real)k * S_STEP, r;
        struct cell row[LIMITS + 2] = {cell_real(s)};
        for (int i = 0; i < LIMITS; i++) {
            enum dom_status status = limit_find(query, i % 2 ? 3 : 4, i >= LIMITS / 2, s, &r);
            if (status != DOM_OK)
                return problem_status(problem, query->scene, status);
            top = isfinite(r) ? quad_larger(top, r) : top;
            row[i + 1] = cell_real(r);
        }
        row[LIMITS + 1] = cell_real(reach_at(*train, s));
        answer_row(a, row, NULL);
        progress_show((k + 1.0) / SAMPLES);
    }
    if (chart)
        limits_chart(train, (double)top, chart);
    return true;
}

static const struct column growth_columns[] = {
    {"s", "h", "separation", 0},
    {"solid", "", "r_max of trains of solid dominoes, q = 4", 0},
    {"hollow", "", "r_max of trains of hollow dominoes, q = 3", 0},
    {"solid_pair", "", "r_max of two solid dominoes", 0},
    {"hollow_pair", "", "r_max of two hollow dominoes", 0},
    {"reach", "", "largest growth at which a domino reaches the next one (1/s, or less with rounded edges)",
     0},
    {NULL, NULL, NULL, 0},
};

const struct plot limit_plots[] = {
    {"growth", plot_growth, "the largest growth of trains, and of two dominoes", growth_columns,
     .title = "A train below its curve keeps falling", .x = {"s", ""}, .y = {NULL, "growth r"},
     .curve = {{"solid", "solid train", CHART_LINE, INK_BLUE, 0},
               {"hollow", "hollow train", CHART_LINE, INK_RED, 1},
               {"solid_pair", "solid pair", CHART_LINE, INK_SKY, 3},
               {"hollow_pair", "hollow pair", CHART_LINE, INK_ORANGE, 4},
               {"reach", "", CHART_LINE, INK_GREY, 2}}},
    {.name = NULL},
};
