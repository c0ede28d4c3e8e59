/* SPDX-License-Identifier: GPL-3.0-or-later */
/* why: says what decides whether the train goes on. */
#include "commands/tables.h"
#include "commands/walk.h"
#include "language/quad.h"

const struct column why_columns[] = {
    {"verdict", "", "goes on, stops, or no fuel (no energy is set free)", 7},
    {"fuel", "mgh/2", "P, the energy that one cycle sets free (25; c7)", 0},
    {"J0", "", "inertia J(0): the collision takes the share 1/J(0) (22; c4)", 0},
    {"kinetic", "mgh/2", "K, the motion after the collision (24; c6)", 0},
    {"barrier", "mgh/2", "B, the energy that it needs to go on (26; c8)", 0},
    {"margin", "mgh/2", "K - B: what is left at the highest point", 0},
    {"r_max", "", "largest growth at this s: there K = B, or r is the reach", 0},
    {NULL, NULL, NULL, 0},
};

/* Holds the same columns for a train with friction. */
static const struct column why_rubbing_columns[] = {
    {"verdict", "", "goes on, stops, or no fuel (no energy is set free)", 7},
    {"fuel", "mgh/2", "P, the energy that one cycle sets free, less friction (25; c7)", 0},
    {"J0", "", "J(0), inertia of the train (50; d8, corrected)", 0},
    {"kinetic", "mgh/2", "K, the motion after the collision, of cycles that are alike", 0},
    {"barrier", "mgh/2", "B, the energy that it needs to go on, friction included", 0},
    {"margin", "mgh/2", "K - B: what is left at the highest point", 0},
    {"r_max", "", "largest growth at this s: there K = B", 0},
    {NULL, NULL, NULL, 0},
};

void verdict_train_say(const struct query *query, struct answer *a, enum dom_status verdict,
                       const struct domq_barrier *b)
{
    if (verdict == DOM_NO_FUEL)
        answer_say(a, "The train does not fall: falling sets no energy free.\n");
    else if (verdict == DOM_LOCKS)
        answer_say(a, "The train stops: friction locks the dominoes.\n");
    else if (b->barrier == 0)
        answer_say(a, "The train goes on: it has nothing to climb, and any motion is enough.\n");
    else
        answer_say(a, "The train %s: it has %s%s of the energy that it needs%s.\n",
                   verdict == DOM_OK ? "goes on" : "stops", verdict == DOM_OK ? "" : "only ",
                   measured_share(b->kinetic / b->barrier, 3).text,
                   domq_law(&query->scene->train)->dissipates ? " against its weight and friction" : "");
}

static void why_say(const struct query *query, struct answer *a, enum dom_status verdict,
                    const struct domq_barrier *b, const struct domq_limit *limit)
{
    const struct domq_train *t = &query->scene->train;
    verdict_train_say(query, a, verdict, b);
    if (verdict == DOM_NO_FUEL)
        answer_say(a,
                   "The dominoes that lean on each other are as high as upright ones, or the larger one in "
                   "front takes up more energy than the smaller ones give: the fuel P = H(0) - H(theta_c) "
                   "is not positive (25; c7).");
    else if (b->barrier > 0)
        answer_say(a,
                   "After the collision the train must come over its %s point, where the head has a tilt of "
                   "%.4g %s. "
                   "Its motion is the energy for that: K %s B (26; c8).",
                   domq_law(t)->dissipates ? "hardest" : "highest",
                   (double)style_angle(&query->state->settings.style, b->theta_m),
                   style_angle_unit(&query->state->settings.style), verdict == DOM_OK ? ">=" : "<");
    if (limit->ends == DOM_END_NONE)
        answer_say(a, "With a gap of %.6g heights not even equal dominoes go on.", (double)t->s);
    else if (limit->ends == DOM_END_REACH)
        answer_say(
            a,
            "With a gap of %.6g heights growth ends by reach: beyond r = %s%.6g the head falls past the next "
            "domino (2; a2).",
            (double)t->s, t->rho == 0 ? "1/s = " : "", (double)limit->r_max);
    else
        answer_say(
            a,
            "With a gap of %.6g heights a domino may be up to %.6g times as large as the one before; a "
            "larger one is too heavy for those before it.",
            (double)t->s, (double)limit->r_max);
}

/* Says whether dominoes stay in contact along the cycle, as the paper assumes. */
static void contact_say(const struct query *query, struct answer *a, const struct domq_least_force *c)
{
    bool holds = c->force > 0 && c->impulse > 0;
    if (!isfinite(c->force) || !isfinite(c->impulse))
        answer_say(a, "At r s = 1 the head is hit at its own hinge: the arm of the contact is 0, the model's "
                      "impulse has no bound, and the assumption of the paper fails (14; b10).");
    else if (holds)
        answer_say(
            a,
            "The dominoes stay in contact, as the paper assumes: the smallest contact force is %s of the "
            "weight of domino %zu, which it pushes, at a tilt of %.4g %s.",
            measured(c->force, "share", 3).text, c->domino,
            (double)style_angle(&query->state->settings.style, c->theta),
            style_angle_unit(&query->state->settings.style));
    else if (c->force > 0)
        answer_say(a,
                   "The dominoes do not stay in contact, as the paper assumes: one of them would have to be "
                   "pulled in the collision. The answer does not hold.");
    else
        answer_say(
            a,
            "The dominoes do not stay in contact, as the paper assumes: domino %zu would have to be "
            "pulled with %s of its weight, at a tilt of %.4g %s. From there on the answer does not hold.",
            c->domino, measured(quad(fabs)(c->force), "share", 3).text,
            (double)style_angle(&query->state->settings.style, c->theta),
            style_angle_unit(&query->state->settings.style));
}

bool run_why(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct domq_compute compute = query_compute(query);
    struct walk_units u = walk_units(query, 1);
    struct domq_launch l;
    struct domq_barrier b;
    struct domq_limit limit;
    enum dom_status verdict = domq_barrier_find(&query->scene->train, &compute, &b), status = verdict;
    if (verdict == DOM_OK || verdict == DOM_STOPS || verdict == DOM_NO_FUEL)
        status = domq_launch_find(&query->scene->train, &compute, &l);
    if (status == DOM_OK || status == DOM_NO_FUEL)
        status = domq_limit_rmax(&query->scene->train, &compute, &limit);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    why_say(query, a, verdict, &b, &limit);
    struct domq_least_force contact;
    if (answer_for_people(a) &&
        domq_cycle_least_force(&query->scene->train, &query->scene->compute, &contact) == DOM_OK)
        contact_say(query, a, &contact);
    if (domq_law(&query->scene->train)->dissipates)
        a->columns = why_rubbing_columns;
    walk_columns_in(query, a);
    if (query->scene->train.rho != 0)
        answer_means(a, "J0", "inertia J(0): the collision takes the share i(0)/J(0) (22; c4)");
    return answer_cells(a,
                        cell_word(verdict == DOM_OK      ? "goes on"
                                  : verdict == DOM_STOPS ? "stops"
                                                         : "no fuel"),
                        CELL_TIMES(l, fuel, u.energy), CELL_OF(l, J0), CELL_TIMES(b, kinetic, u.energy),
                        CELL_TIMES(b, barrier, u.energy), CELL_TIMES(b, margin, u.energy),
                        CELL_OF(limit, r_max));
}
