/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'paper' and 'recipe', which compare the paper's numbers with those of the program. Each row of
 * their tables is an expression that is evaluated twice. */
#include "domino_proof.h"
#include "explain/derivation.h"
#include "language/quad.h"
#include "train/train.h"
#include <stdlib.h>
#include <string.h>

static const char weights[] = "(25; c7) leaves out the weights r^(-q i)";

/* The state in which expressions are evaluated. */
struct table {
    struct answer *answer;
    struct query query;
    struct state state;
    struct domq_train *train; /* that of the state */
    struct problem *problem;  /* its kind is PROBLEM_NONE until an evaluation fails */
};

/* Begins a table about a copy of the state of the query or, if `is_default` is true, about the paper's own
 * dominoes. Returns NULL if memory runs out. */
static struct table *table_begin(const struct query *query, bool is_default, struct answer *a,
                                 struct problem *problem)
{
    struct table *t = malloc(sizeof *t);
    if (!t || !query_with(query, NULL, 0, &t->state, &t->query, problem)) {
        if (!t)
            problem_status(problem, query->scene, DOM_NO_MEMORY);
        free(t);
        return NULL;
    }
    if (is_default) {
        state_init(&t->state);
        t->state.scene.compute = query->scene->compute;
    }
    t->state.variables = (struct variables){.list = NULL}; /* a variable must not hide a command */
    t->state.settings.style.angle = ANGLE_RAD;
    t->answer = a;
    t->train = &t->state.scene.train;
    t->problem = problem;
    return t;
}

/* Returns the value of an expression with one of the two formulas for the fuel, or NaN if it has none. */
static domq_real value_at(struct table *t, enum dom_fuel fuel, const char *expression)
{
    domq_real value = DOMQ_NAN;
    t->train->fuel = fuel;
    if (t->problem->kind == PROBLEM_NONE)
        (void)expression_value(&t->query, expression, &value, t->problem);
    return value;
}

/* ---- paper ---- */

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

static void paper_row(struct table *t, const char *where, const char *what, domq_real s, domq_real paper,
                      domq_real exact, const char *why)
{
    domq_real difference = paper / exact - 1;
    bool differs = quad(fabs)(difference) > (domq_real)1e-9;
    if (t->problem->kind == PROBLEM_NONE && !answer_lost(t->answer))
        answer_row(t->answer,
                   ROW(cell_word(where), cell_word(what), cell_real(t->train->q), cell_real(s),
                       cell_without_error(paper), cell_without_error(exact),
                       cell_without_error(differs ? difference : 0), cell_word(differs ? why : "")),
                   NULL);
}

/* Writes a row for an expression, with both formulas for the fuel. */
static void fuels_row(struct table *t, const char *where, const char *what, domq_real s,
                      const char *expression)
{
    const domq_real paper = value_at(t, DOM_FUEL_PAPER, expression);
    paper_row(t, where, what, s, paper, value_at(t, DOM_FUEL_EXACT, expression), weights);
}

/* Returns true if the reach limits this growth. */
static bool is_reach(const struct table *t, domq_real r)
{
    return r * t->train->s >= 1 - (domq_real)1e-12;
}

/* Writes the rows for one kind of domino: the paper's figures, its equations, and the quiz: how many dominoes
 * are needed to topple the Domtoren, a tower of 112 m. */
static void paper_rows(struct table *t)
{
    const char *figure = "Fig. growth";
    for (int k = 1; k <= 9; k++) {
        const domq_real s = t->train->s = (domq_real)k / 10;
        fuels_row(t, figure,
                  is_reach(t, value_at(t, DOM_FUEL_PAPER, "rmax")) ? "largest growth: the reach 1/s"
                                                                   : "largest growth",
                  s, "rmax");
    }
    fuels_row(t, figure, "maximum of the curve: growth", DOMQ_NAN, "best.r_max");
    fuels_row(t, figure, "maximum of the curve: separation", DOMQ_NAN, "best.s");
    t->train->s = (domq_real)4 / 10;
    fuels_row(t, "(25; c7)", "the fuel P for r = 1.5", t->train->s, "fuel");
    paper_row(t, "(50; d8)", "J(0) for r = 1.5, as printed", t->train->s,
              value_at(t, DOM_FUEL_EXACT, "1 + r^-(q + 1)"), value_at(t, DOM_FUEL_EXACT, "launch.J0"),
              "the factor J(theta_c) was lost in print");
    fuels_row(t, "Introduction", "112 m tower: dominoes, r = 1.5", DOMQ_NAN, "count(112 m)");
    fuels_row(t, "Introduction", "112 m tower: dominoes, largest r", DOMQ_NAN, "count(112 m, best.r_max)");
    for (int k = 2; k <= 9 && t->train->q == 3; k++) { /* for two dominoes the fuel plays no part */
        const domq_real s = t->train->s = (domq_real)k / 10, pair = value_at(t, DOM_FUEL_EXACT, "pair");
        paper_row(t, "Fig. marginal",
                  is_reach(t, pair) ? "two dominoes: the reach 1/s" : "two dominoes: largest growth", s, pair,
                  pair, "");
    }
}

bool run_paper(const struct query *query, struct answer *a, struct problem *problem)
{
    struct table *t = table_begin(query, true, a, problem);
    answer_announce(a, "difference", 1);
    if (answer_for_people(a))
        answer_leave_out(a, "why");
    for (int q = 3; t && q <= 4; q++) {
        t->train->q = q;
        paper_rows(t);
    }
    free(t);
    if (problem->kind != PROBLEM_NONE)
        return false;
    answer_say(a,
               "The numbers differ because the paper's closed form of the fuel leaves out the weights of the "
               "dominoes (25; c7), and because (50; d8) lost a factor in print.");
    answer_detail(
        a, "A rigid-body engine agrees with the exact values. If the growth is limited by the reach, it "
           "does not depend on the fuel. All numbers are for the paper's dominoes, d = 7/48, without "
           "effects; 'recipe' compares the methods for the dominoes of the session.");
    return true;
}

/* ---- recipe ---- */

const struct column recipe_columns[] = {
    {"step", "", "the step of the recipe, from 1 to 5", 4},
    {"quantity", "", "what the step finds", 31},
    {"paper", "",
     "the number from the paper's recipe, which raises theta and r in steps and uses the closed form of the "
     "fuel; the recipe does not say how to choose s, so step 5 uses the program's search",
     0},
    {"program", "", "the number from this program", 0},
    {"why", "", "why the two numbers differ, or where the program works differently", 40},
    {NULL, NULL, NULL, 0},
};

/* The tolerance of the recipe, which determines the steps in which theta and r are raised, and the largest
 * relative difference between two values that count as equal. */
#define RECIPE_TOL  1e-6
#define RECIPE_SAME ((domq_real)1e-4)

/* Steps 2 to 5. The train arrives at theta_m with tau^2 omega^2 = (K - B) / J(theta_m). */
static const struct {
    int step;
    const char *quantity;
    const char *program; /* the expression for the program's number */
    const char *why;     /* why the numbers differ, if they do; may be NULL */
} recipe[] = {
    {2, "J(0) (20; c2)", "launch.J0", NULL},
    {2, "J(0) as printed in (50; d8)", "launch.J0", "the printed relation lacks its last factor, J(theta_c)"},
    {2, "P (25; c7)", "fuel", weights},
    {2, "tau^2 omega(0)^2 (24; c6)", "launch.omega0sq", "this number is proportional to the fuel"},
    {3, "theta_m (19; c1)", "barrier.theta_m", NULL},
    {3, "H(theta_m) - H(0) (26; c8)", "barrier.barrier",
     "the paper takes the first maximum of H, and the program the largest one"},
    {3, "tau^2 omega(theta_m)^2 (21; c3)", "barrier.margin / energy(barrier.theta_m).J",
     "the two numbers differ because the fuels differ; a number below 0 means that the train stops"},
    {4, "r_max at this s", "rmax", weights},
    {5, "s at which r_max is largest", "best.s", weights},
    {5, "the largest growth", "best.r_max", NULL},
};
enum { RECIPE_ROWS = sizeof recipe / sizeof *recipe };

static void recipe_row(struct answer *a, int step, const char *quantity, domq_real paper, domq_real program,
                       const char *why)
{
    struct cell of_paper = cell_without_error(paper);
    /* most steps are computed in double */
    of_paper.in_double = a->style.precision == IN_QUAD && paper == (domq_real)(double)paper;
    answer_row(a,
               ROW(cell_count(step), cell_word(quantity), of_paper, cell_without_error(program),
                   cell_word(why ? why : "")),
               NULL);
    if (why)
        answer_detail(a, "      %s.", why);
}

/* Follows the paper's steps. A number is NaN if they do not converge. The recipe does not say how to find J,
 * or how to choose s. */
static void recipe_follow(struct table *t, domq_real paper[RECIPE_ROWS])
{
    const struct any_compute *ours = &t->state.scene.compute;
    struct dom_compute compute = compute_in_double(ours);
    compute.tol = RECIPE_TOL;
    t->train->fuel = DOM_FUEL_PAPER;
    const struct dom_train train = train_in_double(t->train);
    struct dom_launch l;
    struct dom_barrier b;
    struct dom_limit limit;
    struct domq_energy at = {.J = DOMQ_NAN};
    if (dom_paper_launch(&train, &compute, &l) != DOM_OK)
        l.J0 = l.fuel = l.omegasq = (double)NAN;
    const enum dom_status climbed = dom_paper_barrier(&train, &compute, &b);
    if (climbed != DOM_OK && climbed != DOM_STOPS)
        b.theta_m = b.barrier = b.margin = (double)NAN;
    else if (any_energy_find(t->train, ours, (domq_real)b.theta_m, &at) != DOM_OK)
        at.J = DOMQ_NAN;
    if (dom_paper_rmax(&train, &compute, &limit) != DOM_OK)
        limit.r_max = (double)NAN;
    const domq_real found[RECIPE_ROWS] = {(domq_real)l.J0,
                                          value_at(t, DOM_FUEL_PAPER, "1 + r^-(q + 1)"),
                                          (domq_real)l.fuel,
                                          (domq_real)l.omegasq,
                                          (domq_real)b.theta_m,
                                          (domq_real)b.barrier,
                                          (domq_real)(b.margin / (double)at.J),
                                          (domq_real)limit.r_max,
                                          value_at(t, DOM_FUEL_PAPER, "best.s"),
                                          value_at(t, DOM_FUEL_PAPER, "best.r_max")};
    memcpy(paper, found, sizeof found);
    if (dom_raised(ours->interrupt))
        (void)query_status(&t->query, t->problem, DOM_INTERRUPTED);
}

bool run_recipe(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct domq_train *train = &query->scene->train;
    const struct domq_effect *effect = domq_first_effect(train);
    struct domq_angles angles;
    if (effect)
        return problem_no_answer(problem, "the paper's recipe does not include %s; first enter 'set %s off'",
                                 effect->name, effect->name);
    if (train->r == 1)
        return problem_no_answer(problem,
                                 "the recipe needs r > 1: for equal dominoes, its energy sums do not "
                                 "converge; first enter a larger r, for example 'set r 1.5'");
    if (!query_status(query, problem, any_angles_find(train, &query->scene->compute, &angles)))
        return false;
    struct table *t = table_begin(query, false, a, problem);
    if (!t)
        return false;
    answer_say(a, "The recipe of the paper (section 'A general domino train') at s = %.6g, r = %.6g:",
               (double)train->s, (double)train->r);
    if (answer_for_people(a))
        answer_leave_out(a, "why");
    recipe_row(a, 1, angles.detaches ? "theta_f (42; A18)" : "theta_inf (40; A16)", angles.theta_f,
               angles.theta_f,
               angles.detaches
                   ? "the paper ends the chain where x_i exceeds x_f. This never happens, because theta_f is "
                     "the largest tilt. The program ends the chain where the leader reaches theta_leave"
                   : NULL);
    domq_real paper[RECIPE_ROWS];
    recipe_follow(t, paper);
    for (int k = 0; k < RECIPE_ROWS; k++) {
        const domq_real program = value_at(t, DOM_FUEL_EXACT, recipe[k].program);
        const bool differs = quad(fabs)(paper[k] - program) > RECIPE_SAME * quad(fabs)(program);
        if (problem->kind == PROBLEM_NONE)
            recipe_row(a, recipe[k].step, recipe[k].quantity, paper[k], program,
                       differs ? recipe[k].why : NULL);
    }
    free(t);
    return problem->kind == PROBLEM_NONE;
}
