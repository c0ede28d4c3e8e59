/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'recipe', which compares the steps of the paper's recipe with the results of the program. */
#include "explain/paper.h"
#include "interpreter/feature.h"
#include "language/quad.h"
#include "train/falling.h"
#include "train/train.h"

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

/* The tolerance of the recipe, which determines the steps in which theta and r are raised. */
#define RECIPE_TOL ((domq_real)1e-6)

/* The largest relative difference between two values that count as equal. */
#define RECIPE_SAME ((domq_real)1e-4)

/* The results of the recipe or of the program. A number that does not exist is NaN. */
struct results {
    domq_real J0, P, w0, theta_m, barrier, wm, r_max, best_s, best_r;
    struct domq_limit limit;
};

/* Finds the hardest moment of a cycle: the tilt theta_m, at which the potential energy is largest. The
 * barrier B is the energy that the train needs to get there. If the train has the kinetic energy K after the
 * collision, it arrives with tau^2 omega^2 = (K - B) / J(theta_m). */
static enum dom_status highest_find(const struct domq_train *train, const struct any_compute *compute,
                                    const struct any_compute *ours, struct results *f)
{
    struct domq_barrier b;
    struct domq_energy e;
    enum dom_status status = any_barrier_find(train, compute, &b);
    if (status == DOM_NO_FUEL)
        return DOM_OK;
    if (status != DOM_OK && status != DOM_STOPS)
        return status;
    f->theta_m = b.theta_m;
    f->barrier = b.barrier;
    status = any_energy_find(train, ours, b.theta_m, &e);
    if (status == DOM_OK)
        f->wm = b.margin / e.J;
    return status;
}

/* Carries out the steps of the recipe for one train. */
static enum dom_status results_find(struct domq_train train, const struct any_compute *compute,
                                    const struct any_compute *ours, struct results *f)
{
    struct domq_launch launch;
    struct domq_best best;
    *f = (struct results){DOMQ_NAN, DOMQ_NAN, DOMQ_NAN, DOMQ_NAN, DOMQ_NAN,
                          DOMQ_NAN, DOMQ_NAN, DOMQ_NAN, DOMQ_NAN, {.r_max = DOMQ_NAN}};
    enum dom_status status = any_launch_find(&train, compute, &launch);
    if (status == DOM_OK) {
        f->J0 = launch.J0;
        f->P = launch.fuel;
        f->w0 = launch.omegasq;
        status = highest_find(&train, compute, ours, f);
    }
    if (status != DOM_OK && status != DOM_NO_FUEL)
        return status;
    status = any_limit_rmax(&train, compute, &f->limit);
    if (status == DOM_OK && f->limit.ends != DOM_END_NONE)
        f->r_max = f->limit.r_max;
    /* The recipe does not say how to choose s, so the program's search is used. */
    if (status == DOM_OK || status == DOM_NOT_CONVERGED)
        status = any_limit_best(&train, ours, &best);
    if (status == DOM_OK) {
        f->best_s = best.s;
        f->best_r = best.r_max;
    }
    return status == DOM_NO_GROWTH ? DOM_OK : status;
}

static bool differs(domq_real paper, domq_real program)
{
    return !(quad(fabs)(paper - program) <= RECIPE_SAME * quad(fabs)(program));
}

/* Says `why` if the values differ, or if `always` is true. */
static void recipe_row(struct answer *a, int step, const char *quantity, domq_real paper, domq_real program,
                       const char *why, bool always)
{
    bool says = why && (always || (isfinite(paper) && isfinite(program) && differs(paper, program)));
    answer_row(a,
               ROW(cell_count(step), cell_word(quantity), cell_without_error(paper),
                   cell_without_error(program), cell_word(says ? why : "")),
               NULL);
    if (says)
        answer_detail(a, "      %s.", why);
}

static void steps_write(struct answer *a, const struct domq_train *t, const struct domq_angles *angles,
                        const struct results *paper, const struct results *ours)
{
    const char *weights =
        "the paper's closed form of the fuel leaves out the weights r^(-q i) of the dominoes (25; c7)";
    recipe_row(a, 1, angles->detaches ? "theta_f (42; A18)" : "theta_inf (40; A16)", angles->theta_f,
               angles->theta_f,
               angles->detaches
                   ? "the paper ends the chain where x_i exceeds x_f. This never happens, because theta_f is "
                     "the largest tilt. The program ends the chain where the leader reaches theta_leave"
                   : NULL,
               true);
    recipe_row(a, 2, "J(0) (20; c2)", paper->J0, ours->J0, NULL, false);
    recipe_row(a, 2, "J(0) as printed in (50; d8)", 1 + quad(pow)(t->r, -(t->q + 1)), ours->J0,
               "the printed relation lacks its last factor, J(theta_c)", false);
    recipe_row(a, 2, "P (25; c7)", paper->P, ours->P, weights, false);
    recipe_row(a, 2, "tau^2 omega(0)^2 (24; c6)", paper->w0, ours->w0,
               "this number is proportional to the fuel", false);
    recipe_row(a, 3, "theta_m (19; c1)", paper->theta_m, ours->theta_m, NULL, false);
    recipe_row(a, 3, "H(theta_m) - H(0) (26; c8)", paper->barrier, ours->barrier,
               "the paper takes the first maximum of H, and the program the largest one", false);
    recipe_row(a, 3, "tau^2 omega(theta_m)^2 (21; c3)", paper->wm, ours->wm,
               "the two numbers differ because the fuels differ; a number below 0 means that the train stops",
               false);
    recipe_row(a, 4, "r_max at this s", paper->r_max, ours->r_max, weights, false);
    recipe_row(a, 5, "s at which r_max is largest", paper->best_s, ours->best_s, weights, false);
    recipe_row(a, 5, "the largest growth", paper->best_r, ours->best_r, NULL, false);
}

bool run_recipe(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_train train = query->scene->train;
    const struct any_compute *compute = &query->scene->compute;
    struct any_compute steps = *compute;
    struct domq_angles angles;
    struct results paper, ours = {.limit.r_max = DOMQ_NAN};
    if (domq_first_effect(&train))
        return problem_no_answer(problem, "the paper's recipe does not include %s; first enter 'set %s off'",
                                 domq_first_effect(&train)->name, domq_first_effect(&train)->name);
    steps.method = DOM_METHOD_PAPER;
    steps.precision = IN_DOUBLE;
    steps.tol = RECIPE_TOL;
    enum dom_status status = any_angles_find(&train, compute, &angles);
    train.fuel = DOM_FUEL_EXACT;
    if (status == DOM_OK)
        status = results_find(train, compute, compute, &ours);
    train.fuel = DOM_FUEL_PAPER;
    if (status == DOM_OK)
        status = results_find(train, &steps, compute, &paper);
    if (status == DOM_TOO_LONG)
        return problem_no_answer(problem,
                                 "the recipe needs r > 1: for equal dominoes, its energy sums do not "
                                 "converge; first enter a larger r, for example 'set r 1.5'");
    if (status != DOM_OK)
        return problem_limit(problem, query->scene, status,
                             isnan(ours.limit.open) ? &paper.limit : &ours.limit);
    answer_say(a, "The recipe of the paper (section 'A general domino train') at s = %.6g, r = %.6g:",
               (double)train.s, (double)train.r);
    if (answer_for_people(a))
        answer_leave_out(a, "why");
    steps_write(a, &train, &angles, &paper, &ours);
    return true;
}
