/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "proof/model/cover.h"
#include "domino.h"
#include "numerics/interrupt.h"

#include <stdlib.h>

/* Sums end when their remainders are at most this large. */
static const double REST = 1e-17;

enum { DEEPEST = 48, PER_STRIP = 400, PER_WIDE_STRIP = 64 };

bool proof_begin(struct proof *proof, const struct shape *shape)
{
    *proof = (struct proof){.shape = *shape, .boxes_most = 200000};
    proof->links = malloc((size_t)2 * (LINKS_MOST + 2) * sizeof *proof->links);
    if (!proof->links)
        return false;
    proof->box.link = proof->links;
    proof->point.link = proof->links + LINKS_MOST + 2;
    return true;
}

void proof_end(struct proof *proof)
{
    free(proof->links);
    proof->links = NULL;
}

bool proof_interrupted(const struct proof *proof)
{
    return dom_interrupted(proof->interrupt);
}

static struct climb climb_of(struct proof *proof, const struct upright *upright, double low, double high,
                             bool derivatives)
{
    proof->chains += low < high ? 2 : 1;
    return climb_find(upright, low, high, derivatives);
}

/* A level below which D must stay, for all growths in a strip: the kinetic energy K, or a constant. */
struct level {
    struct span box;   /* the level in the whole strip */
    struct span point; /* the level at the upper end of the strip */
    struct span by_r;  /* derivative of the level with respect to r */
    bool refute;       /* true if the outcome is OUTCOME_REFUTED as soon as D exceeds `point` */
};

/* Returns max(M, 0) w, which bound 3 of cover_tilts needs: the most by which K - D can be smaller than its
 * value at the upper end of the strip, for any growth in the strip. */
static double growth_loss(const struct level *level, struct span climb_by_r, double width)
{
    double loss = up(least_0(up(level->by_r.hi - climb_by_r.lo)) * width);
    return PROOF_BOUND(MEAN_VALUE_GROWTH, loss, 0);
}

/*
 * Tries to prove that K - D > 0 for all growths in the strip, and for all tilts from `low` to `high`. Here K
 * is the level of struct level, either the kinetic energy or a constant. Tilts are given as
 * sigma = 2 sin(theta/2). There are three lower bounds on K - D. The proof succeeds if one of them is
 * positive.
 *
 * Bound 1 uses the box of all these tilts and growths as a whole. K and D are computed from the corners of
 * the box.
 *
 * Bound 2 uses the mean value theorem in sigma. D is computed only at one tilt `at`. For the other tilts,
 * D(sigma) <= D(at) + |sigma - at| max |dD/dsigma|. If D is monotonic in the box, `at` is the end of the
 * interval at which D is largest. Otherwise `at` is the middle of the interval.
 *
 * Bound 3 also uses the mean value theorem in the growth r, for the finite sums K_n - D_n <= K - D
 * (energy.c). They are computed only at the upper end of the strip. Let M be an upper bound on
 * d(K_n - D_n)/dr, and let w be the width of the strip. Then K_n - D_n is at least its value at the upper
 * end, minus max(M, 0) w.
 *
 * If all three bounds fail, the interval of tilts is halved. If they fail even for the single tilt `at`, the
 * strip is too wide.
 */
static enum outcome cover_tilts(struct proof *proof, const struct level *level, double low, double high,
                                int depth, size_t *left)
{
    const struct upright *box = &proof->box, *point = &proof->point;
    if (proof_interrupted(proof))
        return OUTCOME_INTERRUPTED;
    if (*left == 0 || depth > DEEPEST)
        return OUTCOME_OPEN;
    --*left;
    if (++proof->boxes > proof->boxes_most)
        return OUTCOME_LIMIT;
    struct climb all = climb_of(proof, box, low, high, true);
    if (down(level->box.lo - all.height.hi) > 0)
        return OUTCOME_PROVED;

    double at = all.by_tilt.lo >= 0 ? high : all.by_tilt.hi <= 0 ? low : 0.5 * (low + high);
    /*
     * A cycle ends when the head has the tilt theta_c, and the bounds on D hold only up to theta_c. So the
     * tilt `at` may not exceed theta_c. The tilt `low` may always be used: if any tilt in the box belongs to
     * the cycle, `low` does.
     */
    at = smaller(at, larger(low, upright_hit_below(box)));
    double farther = up(least_0(all.by_tilt.hi) * up(high - at)),
           nearer = up(least_0(-all.by_tilt.lo) * up(at - low));
    double spread = PROOF_BOUND(MEAN_VALUE_TILT, larger(farther, nearer), 0);
    struct climb thin = climb_of(proof, box, at, at, true);
    double by_monotony = down(level->box.lo - thin.height.hi);
    if (down(by_monotony - spread) > 0)
        return OUTCOME_PROVED;

    double width = up(box->growth.r.hi - box->growth.r.lo), here = -HUGE_VAL;
    if (box->by_r && isfinite(all.by_r.lo)) {
        struct climb end = climb_of(proof, point, at, at, false);
        if (level->refute && at <= upright_hit_below(point) && up(level->point.hi - end.height.lo) < 0)
            return OUTCOME_REFUTED;
        double by_end = down(level->point.lo - end.height.hi);
        if (down(down(by_end - spread) - growth_loss(level, all.by_r, width)) > 0)
            return OUTCOME_PROVED;
        here = by_end - growth_loss(level, thin.by_r, width);
    }
    if (!(by_monotony > 0) && !(here > 0))
        return OUTCOME_OPEN;
    double middle = 0.5 * (low + high);
    enum outcome first = cover_tilts(proof, level, low, middle, depth + 1, left);
    return first == OUTCOME_PROVED ? cover_tilts(proof, level, middle, high, depth + 1, left) : first;
}

/* Tries to prove that D stays below the kinetic energy or, if `most` is not NULL, below *most. */
static enum outcome cover(struct proof *proof, double r_low, double r_high, const double *most)
{
    if (proof_interrupted(proof))
        return OUTCOME_INTERRUPTED;
    proof->chains += 3;
    if (!upright_find(&proof->shape, r_low, r_high, REST, 0, &proof->box) ||
        !upright_find(&proof->shape, r_high, r_high, REST, proof->box.n, &proof->point))
        return most ? OUTCOME_LIMIT : OUTCOME_OPEN;
    if (!most && proof->point.fuel.hi <= 0)
        return OUTCOME_REFUTED;
    const struct dual kinetic = most ? dual_of(span_of(*most)) : proof->box.kinetic;
    const struct level level = {kinetic.value, most ? kinetic.value : proof->point.kinetic.value,
                                kinetic.by_r, !most};
    /* A wide strip is given up early, since halving the strip is cheaper than using many boxes. */
    size_t left = r_high - r_low > 1e-4 * r_high ? PER_WIDE_STRIP : PER_STRIP;
    return cover_tilts(proof, &level, 0, upright_hit_above(&proof->box), 0, &left);
}

enum outcome proof_strip(struct proof *proof, double r_low, double r_high)
{
    return cover(proof, r_low, r_high, NULL);
}

enum outcome proof_below(struct proof *proof, double r_low, double r_high, double most)
{
    return cover(proof, r_low, r_high, &most);
}

enum outcome proof_range(struct proof *proof, double *done, double r_high, double finest, double *stop)
{
    double end = r_high;
    while (*done < r_high) {
        enum outcome outcome = proof_strip(proof, *done, end);
        double width = end - *done;
        if (outcome == OUTCOME_PROVED) {
            *done = end;
            end = smaller(end + 2 * width, r_high);
        } else if (outcome == OUTCOME_OPEN && width > finest) {
            end = *done + 0.5 * width;
        } else {
            *stop = end;
            return outcome;
        }
    }
    return OUTCOME_PROVED;
}

bool proof_stops(struct proof *proof, double r_low, double r_high, double top)
{
    if (proof_interrupted(proof))
        return false;
    proof->boxes++;
    proof->chains += 2;
    if (!upright_find(&proof->shape, r_low, r_high, REST, 0, &proof->box))
        return false;
    if (proof->box.fuel.hi <= 0)
        return true;
    double at = smaller(top, upright_hit_below(&proof->box));
    struct climb climb = climb_of(proof, &proof->box, at, at, false);
    return up(proof->box.kinetic.value.hi - climb.height.lo) < 0;
}

double proof_guess(struct proof *proof, double r, double *top)
{
    enum { SAMPLES = 48, STEPS = 60 };
    *top = 0;
    if (proof_interrupted(proof) || !upright_find(&proof->shape, r, r, REST, 0, &proof->point))
        return NAN;
    double hit = upright_hit_below(&proof->point), best = 0,
           kinetic = span_middle(proof->point.kinetic.value);
    for (int k = 1; k <= SAMPLES && !proof_interrupted(proof); k++) {
        const double at = hit * k / SAMPLES,
                     height = span_middle(climb_of(proof, &proof->point, at, at, false).height);
        *top = height > best ? at : *top;
        best = larger(best, height);
    }
    /* find the maximum between the neighbours of the highest sample, by bisection on the slope of D */
    double low = larger(*top - hit / SAMPLES, 0), high = smaller(*top + hit / SAMPLES, hit), at;
    for (int k = 0; k < STEPS && high - low > 1e-9 * hit && !proof_interrupted(proof); k++) {
        at = 0.5 * (low + high);
        *(span_middle(climb_of(proof, &proof->point, at, at, true).by_tilt) > 0 ? &low : &high) = at;
    }
    at = 0.5 * (low + high);
    const double height = span_middle(climb_of(proof, &proof->point, at, at, false).height);
    *top = height > best ? at : *top;
    best = larger(best, height);
    if (proof_interrupted(proof))
        return NAN;
    return kinetic - best;
}
