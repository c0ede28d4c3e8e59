/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The verdict on a random row. Thousands of verdicts are wanted, and most heads pass their barrier by far, so
 * the search for the barrier can be left out. Without this shortcut, studies of placement take three to four
 * times as long.
 */
#include "chance/model/draw.h"
#include "dynamics/dynamics.h"
#include "effects/effects.h"
#include "row/row.h"

/* True if a motion with losses is computed roughly. If the errors may change the verdict, the run sets
 * `doubt`, and the row is run again, precisely. */
struct quick {
    bool rough, doubt;
};

/* The relative tolerance of sums along the chain in a rough run. */
#define ROUGH_TOL 1e-6

/* Errors of a rough run may change omegasq by at most this fraction. */
#define ROUGH_CLEAR ((real)1 / 32)

/* In a rough run, a contact force must exceed this fraction of the weight of the pushed domino, so that its
 * sign is certain. */
#define LEAST_CLEAR ((real)1 / 64)

/* ---- Heads that certainly keep falling ---- */

/* The largest number of tilts at which a motion without losses is examined. */
enum { CLEAR_TILTS = 6 };

/*
 * Returns an upper bound on the further rise of H while a head moves from one tilt to another, at most to
 * theta_u. Its followers must lose height all the time. As the head turns, they become steeper, and their
 * slopes theta_i' decrease. So they lose at least the energy `steepest` times `falls` per radian, where
 * `falls` is found from the tilts of the beginning and the slopes of the end. Let phi be the angle from a
 * tilt of the head to theta_u. Up to a constant, the energy of the head is steepest cos phi. So H rises to at
 * most the maximum of steepest (cos phi + falls phi), where sin phi = falls. The code takes the change of sin
 * phi in the place of that of phi, which is larger: the bound holds all the more.
 */
static real most_rise(const struct geometry *head, struct tilt from, struct tilt to)
{
    const real cosine = geometry_height(head, from) / head->steepest,
               sine = geometry_lift(head, from) / head->steepest;
    const struct geometry *leader = head;
    real falls = 0, weight = 1, slope = 1;
    for (size_t i = 1; i < head->n; i++, leader = leader->follower) {
        const struct contact begins = geometry_contact(leader, from), ends = geometry_contact(leader, to);
        from = tilt_follower(from, begins);
        to = tilt_follower(to, ends);
        weight *= leader->weight;
        slope *= ends.slope;
        falls -= weight * slope * geometry_lift(leader->follower, from) / head->steepest;
    }
    falls = fmin(falls, sine);
    return head->steepest * (sqrt(1 - falls * falls) - cosine - falls * (sine - falls));
}

/*
 * Returns true if it is certain that a head without losses clears its barrier. All of its followers must
 * only lose height. What they have lost at one tilt, they never regain, so it surely takes the head as far as
 * it would get alone with this energy and its own. There the followers have lost more, and so on, until the
 * energy takes the head to theta_u, or to the next domino, or over the top of H. Each time, more followers
 * are counted.
 */
static bool head_clears(const struct geometry *head, real kinetic)
{
    const real stands = geometry_height(head, standing), half_u = head->h.x / (head->h.y + head->steepest);
    const struct tilt end = half_u < half_of_tilt(head->c) ? tilt_half(half_u) : head->c;
    struct geometry few = *head; /* the head with few followers */
    real energy = kinetic;
    for (size_t i = 0, n = 2; i < CLEAR_TILTS && stands + energy < head->steepest; i++, n *= 2) {
        struct sums sums;
        const real cosine = (stands + energy) / head->steepest; /* of the angle from there to theta_u */
        const real apart = sqrt((1 - cosine) / (1 + cosine)), half = (half_u - apart) / (1 + half_u * apart);
        const struct tilt t = tilt_half(half);
        if (half >= half_of_tilt(head->c))
            return true;
        few.n = n < head->n ? n : head->n;
        if (chain_change(&few, standing, t, PASS_PLAIN, &sums) != DOM_OK)
            return false;
        energy = kinetic + geometry_height(head, t) - stands - sums.dH;
        if (stands + energy < head->steepest && most_rise(&few, t, end) <= kinetic - sums.dH)
            return true;
    }
    return stands + energy >= head->steepest;
}

/* A motion with losses is solved roughly, from a few tilts. The errors of a rough solution are estimated
 * from the last terms of its series. omegasq at the end of the motion may have this relative error, and the
 * head must clear the barrier by several times the error. */
#define ROUGH_ERROR ((real)1 / 256)
#define ROUGH_TIMES 4

/* Number of tilts at which the required energy is sampled to find its maximum. */
enum { ROUGH_PLACES = 12 };

/* Returns the largest u up to the tilt hi (dynamics.h), from samples and parabolas through them. The samples
 * are equally spaced in the square root of the tilt, since thin dominoes have their barrier at a small tilt.
 */
static real rough_need(const struct geometry *head, real hi)
{
    real most = 0, last = 0, self = 0, next;
    for (int i = 1; i <= ROUGH_PLACES; i++) {
        flow_at(head, hi * (real)(i * i) / (ROUGH_PLACES * ROUGH_PLACES), NULL, &next);
        const real bend = 2 * self - last - next;
        most = fmax(most, next);
        if (i > 1 && self >= last && self >= next && bend > 0)
            most = fmax(most, self + (next - last) * (next - last) / (8 * bend));
        last = self;
        self = next;
    }
    return most;
}

/* With drag there is no proof that contacts push, so the forces at a few tilts decide, as in a precise run.
 */
static bool rough_pushes(const struct geometry *head, real w, real hi)
{
    const struct segment st = {.geometry = *head, .hi = hi, .start = {.from = standing, .omegasq = w}};
    real least = (real)INFINITY;
    return segment_contact(&st, hi, &least) == DOM_OK && least > LEAST_CLEAR;
}

static bool head_passes(struct run *run, size_t k, struct start *at)
{
    const struct quick *quick = run->options->context;
    struct geometry *head = &run->row->geometry[k];
    const bool saves = head->conservative || (run->moving == 1 && head->drag == 0), proves = head->drag == 0;
    const real w = run->omegasq, kinetic = (1 + run->inertia_ratio) * w;
    struct sums sums;
    /* only a first domino that is released can lean here */
    if (!(w > 0) || head->lean != 0 || (saves ? head->rolls : !quick->rough))
        return false;
    head->n = run->moving;
    bool rises = false;
    for (size_t j = k; !rises && j-- > k + 1 - run->moving;)
        rises = geometry_lift(&run->row->geometry[j], run->row->geometry[j].c) > 0;
    if ((saves && rises) || chain_change(head, standing, head->c, PASS_PUSHES, &sums) != DOM_OK ||
        (proves && !sums.pushes) || sums.left != 0)
        return false;
    *at = (struct start){.from = head->c, .J = sums.J, .omegasq = (kinetic - sums.dH) / sums.J};
    if (saves)
        return head_clears(head, kinetic);
    /* The last head of a row whose followers only lose height must reach theta_u to fall. Any other head must
     * reach the next domino. */
    const bool last = k + 1 == run->row->given.count;
    const real reach = tilt_angle(head->c), hi = last && !rises ? fmin(reach, geometry_theta_u(head)) : reach;
    const struct num_linear *solution = &head->flow->solution;
    real ln_G, u;
    if (!flow_rough(head, hi))
        return false;
    flow_at(head, hi, &ln_G, &u);
    at->omegasq = exp(ln_G) * (w - u);
    const real off = solution->v_error + solution->ln_G_error * (w - u);
    return off <= ROUGH_ERROR * (w - u) &&
           w - rough_need(head, hi) > ROUGH_CLEAR * w + ROUGH_TIMES * solution->v_error &&
           (proves || rough_pushes(head, w, hi));
}

/* ---- The run ---- */

/* Called after a head whose barrier was found. Returns true if a rough run ends in doubt. */
static bool is_in_doubt(struct run *run, size_t k, const struct run *before, const struct descent *d,
                        const struct dom_fall *fall)
{
    struct quick *quick = run->options->context;
    const bool tips = k == 0 && before->omegasq == 0, pushes = fabs(d->least_force) > LEAST_CLEAR,
               sure = fabs((real)fall->margin) > ROUGH_CLEAR * (real)fall->kinetic;
    quick->doubt = quick->rough && !tips && !(pushes && sure && !d->locks);
    return quick->doubt;
}

enum dom_status draw_verdict(const struct dom_row *row, const struct dom_compute *compute,
                             struct dom_verdict *verdict)
{
    const struct dom_train first = dynamics_of_domino(row, 0);
    struct quick quick = {.rough = dom_dissipates(&first)};
    struct run_options options = {.passes = head_passes, .ends = is_in_doubt, .context = &quick};
    for (size_t k = 0; k < row->count; k++)
        if (row->domino[k].lean != 0) {
            options.passes = NULL;
            quick.rough = false;
        }
    if (quick.rough) {
        struct dom_compute rough = *compute;
        rough.tol = fmax(rough.tol, ROUGH_TOL);
        const enum dom_status status = row_run(row, &rough, &options, NULL, NULL, verdict);
        if (status != DOM_OK || !quick.doubt)
            return status;
        quick.rough = false;
    }
    return row_run(row, compute, &options, NULL, NULL, verdict);
}
