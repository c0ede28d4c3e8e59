/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'why', which explains why the train keeps falling or stops, and what all commands about a cycle
 * share: its units and its verdict. */
#include "language/quad.h"
#include "train/train.h"
#include <string.h>

const struct column why_columns[] = {
    {"verdict", "", "'goes on', 'stops' or 'no fuel' (no energy is released)", 7},
    {"fuel", "mgh/2", "P, the energy that one cycle releases, minus losses (25; c7)", 0},
    {"J0", "", "J(0), the inertia of the train (50; d8, corrected)", 0},
    {"kinetic", "mgh/2", "K, the kinetic energy after the collision (24; c6)", 0},
    {"barrier", "mgh/2", "B, the energy that the train needs to keep falling (26; c8)", 0},
    {"margin", "mgh/2", "K - B, the energy that is left at the top of the barrier", 0},
    {"r_max", "", "largest growth at this s: either K = B, or r equals the reach", 0},
    {NULL, NULL, NULL, 0},
};

struct walk_units walk_units(const struct query *query, int cycle)
{
    const struct domq_train *t = &query->scene->train;
    domq_real mass = scene_mass(query->scene), grown = quad(pow)(t->r, (domq_real)(cycle - 1)),
              heavier = quad(pow)(grown, t->q);
    struct domq_scale scale = query->scene->scale;
    scale.h *= grown;
    return (struct walk_units){
        .height = scale.h,
        .tau = domq_scale_tau(&scale, t),
        .energy = mass > 0 ? heavier * mass * scale.g * query->scene->scale.h / 2 : heavier,
    };
}

void columns_in_joules(struct answer *a)
{
    for (struct column *c = answer_columns(a, a->columns); c->key; c++)
        if (strcmp(c->unit, "mgh/2") == 0)
            c->unit = "J";
}

void walk_columns_in(const struct query *query, struct answer *a)
{
    if (scene_mass(query->scene) > 0)
        columns_in_joules(a);
}

struct measured angle_text(const struct query *query, domq_real theta, int digits)
{
    const struct answer_style *style = &query->state->settings.style;
    struct measured text;
    snprintf(text.text, sizeof text.text, "%.*g %s", digits, (double)style_angle(style, theta),
             style_angle_unit(style));
    return text;
}

struct cell verdict_cell(enum dom_status verdict)
{
    return cell_word(verdict == DOM_OK      ? "goes on"
                     : verdict == DOM_STOPS ? "stops"
                     : verdict == DOM_LOCKS ? "locks"
                                            : "no fuel");
}

const char *verdict_reason(enum dom_status verdict)
{
    switch (verdict) {
    case DOM_STOPS:
        return "the train has too little energy, and stops before the top of the barrier (26; c8); 'why' "
               "says what to change";
    case DOM_NO_FUEL:
        return "falling releases no energy: the fuel P is not positive (25; c7); 'why' says what to change";
    case DOM_LOCKS:
        return "friction locks the collision, because the force on the struck domino passes its hinge on the "
               "wrong side";
    case DOM_OUT_OF_REACH:
        return "each domino falls past the next one without touching it (r s > 1)";
    case DOM_UNDERFLOW:
        return "r is too large for the precision";
    default:
        return NULL;
    }
}

void verdict_train_say(const struct query *query, struct answer *a, enum dom_status verdict,
                       const struct domq_barrier *b)
{
    const char *losses = losses_of(&query->scene->train);
    if (verdict == DOM_NO_FUEL)
        answer_say(a, "The train does not fall: falling releases no energy.");
    else if (verdict == DOM_LOCKS)
        answer_say(a, "The train stops: friction locks the dominoes.");
    else if (b->barrier == 0)
        answer_say(a, "The train keeps falling: it has nothing to climb, so any motion is enough.");
    else if (verdict == DOM_OK)
        answer_say(a, "The train keeps falling: to push the next domino over%s%s, it %s.",
                   *losses ? " in spite of " : "", losses, energy_words(b->kinetic / b->barrier).text);
    else
        answer_say(a, "The train stops: it %s to push the next domino over%s%s.",
                   energy_words(b->kinetic / b->barrier).text, *losses ? " in spite of " : "", losses);
}

/* Prints advice without symbols: how much the dominoes may grow, or what to change if the train stops. */
static void advice_say(const struct query *query, struct answer *a, bool falls,
                       const struct domq_limit *limit)
{
    const struct domq_train *t = &query->scene->train;
    struct domq_best best;
    if (falls) {
        answer_say(a, "Each domino may be up to %s times as large as the one before; %s.",
                   limit_words(a, limit->r_max, 6).text,
                   limit->ends == DOM_END_REACH ? "with more growth, each domino falls past the next one"
                                                : "a larger domino is too heavy for the dominoes before it");
    } else if (any_limit_best(t, &query->scene->compute, &best) != DOM_OK) {
        answer_say(a, "Make the dominoes thinner: no gap lets dominoes this thick topple larger ones.");
    } else {
        answer_say(a,
                   "With gaps of %s times the height, each domino can be %s times as large as the one "
                   "before%s%s%s.",
                   quad_text(best.s, style_tol_digits(&a->style, 4)), limit_words(a, best.r_max, 4).text,
                   limit->ends == DOM_END_NONE ? "" : "; with the present gaps, ",
                   limit->ends == DOM_END_NONE ? "" : limit_words(a, limit->r_max, 4).text,
                   limit->ends == DOM_END_NONE ? "" : " times");
    }
}

/* Says whether the dominoes stay in contact, as the paper assumes. At r s = 1 the head is hit at its own
 * hinge, and the impulse has no bound. */
static void contact_say(const struct query *query, struct answer *a, const struct domq_least_force *c)
{
    char where[400] = "in the collision, one domino would have to be pulled";
    if (!isfinite(c->force) || !isfinite(c->impulse))
        return;
    if (!(c->force > 0) || c->impulse > 0)
        snprintf(where, sizeof where, "domino %zu %s with %s of its weight, at a head tilt of %s", c->domino,
                 c->force > 0 ? "is pushed" : "would have to be pulled",
                 measured(quad(fabs)(c->force), "share", 3).text, angle_text(query, c->theta, 4).text);
    if (c->force > 0 && c->impulse > 0)
        answer_detail(a, "The dominoes stay in contact, as the paper assumes: at the weakest contact, %s.",
                      where);
    else
        answer_say(a,
                   "The dominoes do not stay in contact, as the paper assumes: %s. Once a contact would have "
                   "to pull, the answer is no longer valid.",
                   where);
}

bool run_why(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct any_compute *compute = query_compute(query);
    const struct domq_train *train = &query->scene->train;
    struct walk_units u = walk_units(query, 1);
    struct domq_launch l;
    struct domq_barrier b;
    struct domq_limit limit;
    struct domq_least_force contact;
    enum dom_status verdict = any_barrier_find(train, compute, &b), status = verdict;
    if (verdict == DOM_OK || verdict == DOM_STOPS || verdict == DOM_NO_FUEL)
        status = any_launch_find(train, compute, &l);
    if (status == DOM_OK || status == DOM_NO_FUEL)
        status = any_limit_rmax(train, compute, &limit);
    if (status != DOM_OK)
        return problem_limit(problem, query->scene, status, &limit);
    bool people = answer_for_people(a);
    if (people) {
        verdict_train_say(query, a, verdict, &b);
        advice_say(query, a, verdict == DOM_OK, &limit);
    }
    walk_columns_in(query, a);
    answer_cells(a, verdict_cell(verdict), cell_computed(l.fuel * u.energy), cell_computed(l.J0),
                 cell_computed(b.kinetic * u.energy), cell_computed(b.barrier * u.energy),
                 cell_computed(b.margin * u.energy), cell_limit(cell_computed(limit.r_max)));
    if (people && any_cycle_least_force(train, &query->scene->compute, &contact) == DOM_OK)
        contact_say(query, a, &contact);
    return true;
}
