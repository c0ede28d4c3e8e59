/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'paper', which recomputes numbers and figures of the paper. */
#include "explain/paper.h"
#include "language/quad.h"

const struct column paper_columns[] = {
    {"where", "", "the figure, the equation or the section of the paper", 13},
    {"what", "", "the quantity that the paper gives in its text or shows in a figure", 34},
    {"q", "", "mass exponent: 3 for hollow dominoes, 4 for solid ones", 4},
    {"s", "h", "separation", 0},
    {"paper", "", "the value with the paper's closed form of the fuel (25; c7); for J(0), the printed value",
     0},
    {"exact", "", "the value with the fuel from the energy balance", 0},
    {"difference", "share", "paper / exact - 1", 0},
    {"why", "", "why the two numbers differ", 30},
    {NULL, NULL, NULL, 0},
};

/* The data that all rows of the table share. `train` is the paper's train, with d = 7/48. */
struct table {
    struct answer *answer;
    struct domq_train train;
    struct any_compute compute;
    enum dom_status status;
};

static const char weights[] = "(25; c7) leaves out the weights r^(-q i)";

/* Writes a row, unless the computation of an earlier row has failed. */
static void paper_row(struct table *t, const char *where, const char *what, domq_real s, domq_real paper,
                      domq_real exact, const char *why)
{
    domq_real difference = paper / exact - 1;
    bool differs = quad(fabs)(difference) > (domq_real)1e-9;
    if (t->status == DOM_OK && !answer_lost(t->answer))
        answer_row(t->answer,
                   ROW(cell_word(where), cell_word(what), cell_real(t->train.q), cell_real(s),
                       cell_without_error(paper), cell_without_error(exact),
                       cell_without_error(differs ? difference : 0), cell_word(differs ? why : "")),
                   NULL);
}

/* Returns r_max at a separation with one of the two formulas for the fuel, and what limits r_max. */
static struct domq_limit limit_at(struct table *t, domq_real s, enum dom_fuel fuel)
{
    struct domq_limit limit = {.r_max = DOMQ_NAN, .ends = DOM_END_NONE};
    t->train.s = s;
    t->train.fuel = fuel;
    if (t->status == DOM_OK)
        t->status = any_limit_rmax(&t->train, &t->compute, &limit);
    return limit;
}

/* Finds the smallest separation at which the growth is limited by the reach, r = 1/s. */
static domq_real crossing_find(struct table *t, enum dom_fuel fuel)
{
    domq_real low = (domq_real)3 / 10, high = (domq_real)9 / 10;
    while (high - low > high * quad_larger(t->compute.tol, (domq_real)1e-9) && t->status == DOM_OK) {
        domq_real middle = (low + high) / 2;
        *(limit_at(t, middle, fuel).ends == DOM_END_REACH ? &high : &low) = middle;
    }
    return high;
}

/* Writes the rows for the paper's growth figure: points of the curve, the maximum, and the separation at
 * which the growth begins to fall as 1/s. */
static void growth_rows(struct table *t)
{
    struct domq_best best[2] = {{.s = DOMQ_NAN}, {.s = DOMQ_NAN}};
    for (int k = 1; k <= 9; k++) {
        const domq_real s = (domq_real)k / 10;
        const struct domq_limit paper = limit_at(t, s, DOM_FUEL_PAPER),
                                exact = limit_at(t, s, DOM_FUEL_EXACT);
        paper_row(t, "Fig. growth",
                  paper.ends == DOM_END_REACH ? "largest growth: the reach 1/s" : "largest growth", s,
                  paper.r_max, exact.r_max, weights);
    }
    for (int fuel = 0; fuel < 2 && t->status == DOM_OK; fuel++) {
        t->train.fuel = fuel == 0 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        t->status = any_limit_best(&t->train, &t->compute, &best[fuel]);
    }
    paper_row(t, "Fig. growth", "maximum of the curve: growth", DOMQ_NAN, best[0].r_max, best[1].r_max,
              weights);
    paper_row(t, "Fig. growth", "maximum of the curve: separation", DOMQ_NAN, best[0].s, best[1].s, weights);
    const domq_real paper = crossing_find(t, DOM_FUEL_PAPER), exact = crossing_find(t, DOM_FUEL_EXACT);
    paper_row(t, "Fig. growth", "start of the curve 1/s: separation", DOMQ_NAN, paper, exact, weights);
}

/* Writes rows for the paper's figure about two dominoes, in which the fuel plays no part. */
static void pair_rows(struct table *t)
{
    for (int k = 2; k <= 9; k++) {
        struct domq_limit pair = {.r_max = DOMQ_NAN};
        t->train.s = (domq_real)k / 10;
        if (t->status == DOM_OK)
            t->status = any_limit_pair(&t->train, &t->compute, &pair);
        paper_row(t, "Fig. marginal",
                  pair.ends == DOM_END_REACH ? "two dominoes: the reach 1/s" : "two dominoes: largest growth",
                  t->train.s, pair.r_max, pair.r_max, "");
    }
}

/* Writes rows for the numbers that the paper prints about one train. */
static void cycle_rows(struct table *t)
{
    struct domq_fuels fuels = {.exact = DOMQ_NAN};
    struct domq_launch launch = {.J0 = DOMQ_NAN};
    t->train.s = (domq_real)4 / 10;
    t->train.r = (domq_real)3 / 2;
    t->train.fuel = DOM_FUEL_EXACT;
    if (t->status == DOM_OK)
        t->status = any_fuel_find(&t->train, &t->compute, &fuels);
    if (t->status == DOM_OK)
        t->status = any_launch_find(&t->train, &t->compute, &launch);
    paper_row(t, "(25; c7)", "the fuel P for r = 1.5", t->train.s, fuels.paper, fuels.exact, weights);
    paper_row(t, "(50; d8)", "J(0) for r = 1.5, as printed", t->train.s,
              1 + quad(pow)(t->train.r, -(t->train.q + 1)), launch.J0,
              "the factor J(theta_c) was lost in print");
}

/* Writes rows for the quiz: how many dominoes are needed to topple the Domtoren, a tower of 112 m. */
static void quiz_rows(struct table *t)
{
    const struct domq_scale scale = domq_scale_default();
    struct domq_count count = {.dominoes = DOMQ_NAN};
    struct domq_count most[2] = {{.dominoes = DOMQ_NAN}, {.dominoes = DOMQ_NAN}};
    if (t->status == DOM_OK)
        t->status = any_count_find(scale.h, 112, (domq_real)3 / 2, &t->compute, &count);
    paper_row(t, "Introduction", "112 m tower: dominoes, r = 1.5", DOMQ_NAN, count.dominoes, count.dominoes,
              "");
    for (int fuel = 0; fuel < 2 && t->status == DOM_OK; fuel++) {
        struct domq_best best;
        t->train.fuel = fuel == 0 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        t->status = any_limit_best(&t->train, &t->compute, &best);
        if (t->status == DOM_OK)
            t->status = any_count_find(scale.h, 112, best.r_max, &t->compute, &most[fuel]);
    }
    paper_row(t, "Introduction", "112 m tower: dominoes, largest r", DOMQ_NAN, most[0].dominoes,
              most[1].dominoes, weights);
}

bool run_paper(const struct query *query, struct answer *a, struct problem *problem)
{
    struct table t = {.answer = a, .train = domq_train_default(), .compute = query->scene->compute};
    answer_announce(a, "difference", 1);
    if (answer_for_people(a))
        answer_leave_out(a, "why");
    for (int q = 3; q <= 4; q++) {
        t.train.q = q;
        growth_rows(&t);
        cycle_rows(&t);
        quiz_rows(&t);
        if (q == 3)
            pair_rows(&t);
    }
    if (t.status != DOM_OK)
        return problem_status(problem, query->scene, t.status);
    answer_say(a,
               "The numbers differ because the paper's closed form of the fuel leaves out the weights of the "
               "dominoes (25; c7), and because (50; d8) lost a factor in print.");
    answer_detail(
        a, "The numbers differ for two reasons. First, the closed form of the fuel, the second equality "
           "of (25; c7), leaves out the weights r^(-q i) of the dominoes. These weights are 1 only for r "
           "= 1. Second, (50; d8) lost its factor J(theta_c) in print. A rigid-body engine agrees with "
           "the exact values. If the growth is limited by the reach, it does not depend on the fuel.");
    answer_detail(a, "All numbers are for the paper's dominoes, d = 7/48, without effects. 'recipe' compares "
                     "the paper's method with this program for the dominoes of the session.");
    return true;
}
