/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plots 'growth' and 'marginal': the largest growth, plotted against the separation. */
#include "io/terminal.h"
#include "language/quad.h"
#include "pictures/plots/plots.h"

enum { SAMPLES = 193, LIMITS = 4 };
#define S_LOW  ((domq_real)2 / 100)
#define S_STEP ((domq_real)5 / 1000)

/* The dominoes whose largest growth is shown in one column: a train or a pair with mass exponent q. */
struct limit {
    double q;
    bool pair;
    enum dom_fuel fuel;
};

/* The limits with the paper's fuel come last, because only 'plot growth paper' shows them. */
static const struct limit growth_limits[LIMITS] = {
    {.q = 4}, {.q = 3}, {.q = 4, .fuel = DOM_FUEL_PAPER}, {.q = 3, .fuel = DOM_FUEL_PAPER}};
static const struct limit marginal_limits[LIMITS] = {
    {.q = 4, .pair = true}, {.q = 4}, {.q = 3, .pair = true}, {.q = 3}};

/* Finds the largest growth at the separation s and stores it in *r. Stores NaN if no growth is possible, or
 * if the paper's formula for the fuel does not apply. */
static enum dom_status limit_find(const struct query *query, const struct limit *of, domq_real s,
                                  domq_real *r)
{
    struct domq_train train = query->scene->train;
    const struct any_compute *compute = &query->scene->compute;
    struct domq_limit limit;
    train.s = s;
    train.r = 1;
    train.q = (domq_real)of->q;
    train.fuel = of->fuel;
    *r = DOMQ_NAN;
    /* The paper's formula for the fuel does not cover friction, slopes, walls or rounded edges. */
    if (domq_first_effect(&train) && train.fuel == DOM_FUEL_PAPER)
        return DOM_OK;
    enum dom_status status =
        of->pair ? any_limit_pair(&train, compute, &limit) : any_limit_rmax(&train, compute, &limit);
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

static bool limits_plot(const struct query *query, struct answer *a, struct chart *chart,
                        struct problem *problem, const struct limit *limits, int count)
{
    const struct domq_train *train = &query->scene->train;
    domq_real top = 1;
    for (int k = 0; k < SAMPLES && !answer_lost(a); k++) {
        domq_real s = S_LOW + (domq_real)k * S_STEP, r;
        struct cell row[LIMITS + 2] = {cell_real(s)};
        for (int i = 0; i < count; i++) {
            enum dom_status status = limit_find(query, &limits[i], s, &r);
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

static bool plot_growth(const struct query *query, struct answer *a, struct chart *chart,
                        struct problem *problem)
{
    bool paper = query->given->count > 1;
    if (!paper)
        answer_leave_out(a, "solid_paper hollow_paper");
    return limits_plot(query, a, chart, problem, growth_limits, paper ? LIMITS : LIMITS / 2);
}

static bool plot_marginal(const struct query *query, struct answer *a, struct chart *chart,
                          struct problem *problem)
{
    return limits_plot(query, a, chart, problem, marginal_limits, LIMITS);
}

#define SEPARATION COLUMN("s", "h", "separation", 0)
#define REACH                                                                                                \
    COLUMN("reach", "",                                                                                      \
           "largest growth at which a domino reaches the next one (1/s, or less with rounded edges)", 0)
static const struct column growth_columns[] = {
    SEPARATION,
    {"solid", "", "r_max of solid dominoes, q = 4", 0},
    {"hollow", "", "r_max of hollow dominoes, q = 3", 0},
    {"solid_paper", "", "growth paper: r_max of solid dominoes with the paper's fuel", 0},
    {"hollow_paper", "", "growth paper: r_max of hollow dominoes with the paper's fuel", 0},
    REACH,
    {NULL, NULL, NULL, 0},
};
static const struct column marginal_columns[] = {
    SEPARATION,
    {"solid_pair", "", "r_max of two solid dominoes", 0},
    {"solid_train", "", "r_max of a train of solid dominoes", 0},
    {"hollow_pair", "", "r_max of two hollow dominoes", 0},
    {"hollow_train", "", "r_max of a train of hollow dominoes", 0},
    REACH,
    {NULL, NULL, NULL, 0},
};

static const char *paper_names(const void *context, int k)
{
    (void)context;
    return k == 0 ? "paper" : NULL;
}

static const struct argument paper_argument = {
    .name = "paper", .kind = ARGUMENT_CHOICE, .noun = "word after 'plot growth'", .choices = paper_names};

const struct plot limit_plots[] = {
    {"growth", plot_growth,
     "the largest growth of trains; 'plot growth paper' compares it with the growth that the paper's fuel "
     "gives",
     growth_columns, .title = "A train below its curve keeps falling", .x = {"s", ""},
     .y = {NULL, "growth r"},
     .curve = {{"solid", "solid dominoes", CHART_LINE, INK_BLUE, 0},
               {"hollow", "hollow dominoes", CHART_LINE, INK_RED, 1},
               {"solid_paper", "solid, the paper's fuel", CHART_LINE, INK_SKY, 3},
               {"hollow_paper", "hollow, the paper's fuel", CHART_LINE, INK_ORANGE, 4},
               {"reach", "", CHART_LINE, INK_GREY, 2}},
     .argument = &paper_argument},
    {"marginal", plot_marginal, "the largest growth of trains, and of two dominoes", marginal_columns,
     .title = "Growth below a pair's curve: a domino that barely tips over topples the next", .x = {"s", ""},
     .y = {NULL, "growth r"},
     .curve = {{"solid_pair", "solid pair", CHART_LINE, INK_SKY, 3},
               {"solid_train", "solid train", CHART_LINE, INK_BLUE, 0},
               {"hollow_pair", "hollow pair", CHART_LINE, INK_ORANGE, 4},
               {"hollow_train", "hollow train", CHART_LINE, INK_RED, 1},
               {"reach", "", CHART_LINE, INK_GREY, 2}}},
    {.name = NULL},
};
