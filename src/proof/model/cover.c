/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "domino.h"
#include "proof/model/proof.h"

#include <stdlib.h>

/* Sums end when their remainders are at most this large. */
static const double REST = 1e-17;

enum { BOXES_MOST = 200000, DEEPEST = 48, PER_STRIP = 400, PER_WIDE_STRIP = 64 };

bool proof_begin(struct proof *proof, const struct shape *shape)
{
    struct link *links = malloc((size_t)2 * (LINKS_MOST + 2) * sizeof *links);
    *proof = (struct proof){.shape = *shape, .box.link = links};
    if (links)
        proof->point.link = links + LINKS_MOST + 2;
    return links;
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
    if (dom_interrupted(proof->interrupt))
        return OUTCOME_INTERRUPTED;
    if (*left == 0 || depth > DEEPEST)
        return OUTCOME_OPEN;
    --*left;
    if (++proof->boxes > BOXES_MOST)
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
    at = smaller(at, larger(low, box->growth.hit.lo));
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
        if (level->refute && at <= point->growth.hit.lo && up(level->point.hi - end.height.lo) < 0)
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

enum outcome proof_strip(struct proof *proof, double r_low, double r_high, const double *most)
{
    if (dom_interrupted(proof->interrupt))
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
    return cover_tilts(proof, &level, 0, proof->box.growth.hit.hi, 0, &left);
}

/*
 * Tries to prove that the train keeps falling for all growths from *done to r_high. The proof works upwards
 * in strips, which are intervals of growths. After each proved strip, *done is raised to the end of that
 * strip. If the outcome for a strip is OUTCOME_OPEN and the strip is wider than `finest`, the strip is halved
 * and tried again. Any other failure ends the proof and sets *stop to the upper end of the failed strip.
 */
static enum outcome proof_range(struct proof *proof, double *done, double r_high, double finest, double *stop)
{
    double end = r_high;
    while (*done < r_high) {
        enum outcome outcome = proof_strip(proof, *done, end, NULL);
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

/*
 * Tries to prove that the train stops for all growths from r_low to r_high. The train stops if it has no
 * fuel, or if its kinetic energy is too small to reach a tilt theta of the cycle. The caller chooses theta
 * and passes `top` = 2 sin(theta/2). If theta exceeds theta_c, theta_c is used instead. Returns false if the
 * proof fails.
 */
static bool proof_stops(struct proof *proof, double r_low, double r_high, double top)
{
    if (dom_interrupted(proof->interrupt))
        return false;
    proof->boxes++;
    proof->chains += 2;
    if (!upright_find(&proof->shape, r_low, r_high, REST, 0, &proof->box))
        return false;
    if (proof->box.fuel.hi <= 0)
        return true;
    double at = smaller(top, proof->box.growth.hit.lo);
    struct climb climb = climb_of(proof, &proof->box, at, at, false);
    return up(proof->box.kinetic.value.hi - climb.height.lo) < 0;
}

double proof_guess(struct proof *proof, double r, double *top)
{
    enum { SAMPLES = 48, STEPS = 60 };
    *top = 0;
    if (dom_interrupted(proof->interrupt) || !upright_find(&proof->shape, r, r, REST, 0, &proof->point))
        return NAN;
    double hit = proof->point.growth.hit.lo, best = 0, kinetic = span_middle(proof->point.kinetic.value);
    for (int k = 1; k <= SAMPLES && !dom_interrupted(proof->interrupt); k++) {
        const double at = hit * k / SAMPLES,
                     height = span_middle(climb_of(proof, &proof->point, at, at, false).height);
        *top = height > best ? at : *top;
        best = larger(best, height);
    }
    /* find the maximum between the neighbours of the highest sample, by bisection on the slope of D */
    double low = larger(*top - hit / SAMPLES, 0), high = smaller(*top + hit / SAMPLES, hit), at;
    for (int k = 0; k < STEPS && high - low > 1e-9 * hit && !dom_interrupted(proof->interrupt); k++) {
        at = 0.5 * (low + high);
        *(span_middle(climb_of(proof, &proof->point, at, at, true).by_tilt) > 0 ? &low : &high) = at;
    }
    at = 0.5 * (low + high);
    const double height = span_middle(climb_of(proof, &proof->point, at, at, false).height);
    *top = height > best ? at : *top;
    best = larger(best, height);
    if (dom_interrupted(proof->interrupt))
        return NAN;
    return kinetic - best;
}

/* ---- The smallest growth at which the train stops ---- */

/*
 * Encloses the smallest growth at which a train stops: finds two close numbers and proves that this growth
 * lies between them.
 *
 * The search works upwards from r = 1 in strips, which are intervals of growths. For each strip, it tries to
 * prove that the train keeps falling. After a success, the next strip is twice as wide. After a failure, the
 * next strip is half as wide.
 *
 * If the train seems to stop at the upper end of a strip, the search estimates the growth at which the margin
 * is 0 (the root). Two proofs follow. The first shows that the train stops at a decimal number just above the
 * root. The second shows that the train keeps falling for all growths up to a decimal number just below the
 * root. If the estimate of the root is wrong, one of the two proofs fails, but nothing wrong is proved.
 */
static const double FIRST_STRIP = 0.05, LAST_STRIP = 1e-15;

struct search {
    struct proof *proof;
    double tol;
    double done;          /* the train keeps falling for all growths from found->from to this one */
    double stop;          /* after OUTCOME_REFUTED: the train stops at this growth */
    enum outcome outcome; /* of the last proof */
    struct dom_proof *found;
};

/* Estimates the growth at which the margin is 0, between `low`, where the train seems to keep falling, and
 * `high`, where it seems to stop. Sets *top as proof_guess does. */
static double root_between(struct proof *proof, double low, double high, double *top)
{
    double at_low = proof_guess(proof, low, top), at_high = proof_guess(proof, high, top);
    for (int k = 0; k < 80 && high - low > 2e-16 * high && !dom_interrupted(proof->interrupt); k++) {
        double at = low - at_low * (high - low) / (at_high - at_low);
        if (k % 3 == 2 || !(at > low && at < high))
            at = 0.5 * (low + high);
        if (!(at > low && at < high))
            break;
        const double margin = proof_guess(proof, at, top);
        *(margin > 0 ? &low : &high) = at;
        *(margin > 0 ? &at_low : &at_high) = margin;
    }
    proof_guess(proof, low, top);
    return low;
}

/*
 * Finds a decimal number above n / unit at which the train is proved to stop. The double r that is nearest to
 * this number may be a little smaller or larger than the number. So the proof covers the whole interval
 * between the two neighbours of r.
 */
static bool stops_after(struct search *s, double n, double unit, double top)
{
    for (int more = 1; more <= 256; more *= 2) {
        const double r = (n + more) / unit, low = nextafter(r, 0), above = nextafter(r, INFINITY);
        if (low * s->proof->shape.s.hi < 1 && proof_stops(s->proof, low, above, top)) {
            s->found->high = r;
            return true;
        }
    }
    return false;
}

/* Tries to prove that the train keeps falling for all growths up to n / unit. If the outcome is OUTCOME_OPEN,
 * tries (n - 1) / unit, then (n - 2) / unit, then (n - 4) / unit, and so on. */
static bool goes_on_before(struct search *s, double n, double unit)
{
    for (int less = 0; less <= 1024; less = less > 0 ? 2 * less : 1) {
        const double end = nextafter((n - less) / unit, INFINITY);
        s->found->low = (n - less) / unit;
        if (s->found->low < s->found->from)
            break;
        s->outcome = OUTCOME_PROVED;
        if (s->done < end)
            s->outcome =
                proof_range(s->proof, &s->done, end, larger(1e-3 / unit, LAST_STRIP * end), &s->stop);
        if (s->outcome != OUTCOME_OPEN)
            break;
    }
    return s->outcome == OUTCOME_PROVED;
}

/*
 * Estimates the growth between s->done and `high` at which the margin is 0 (the root). Tries to prove that
 * the train keeps falling up to a decimal number slightly below the root, and that it stops at one slightly
 * above. Returns false if a proof fails, with the reason in s->outcome.
 */
static bool bracket_prove(struct search *s, double high)
{
    double top, root = root_between(s->proof, s->done, high, &top), tol = s->tol;
    s->stop = NAN;
    s->outcome = dom_interrupted(s->proof->interrupt) ? OUTCOME_INTERRUPTED : OUTCOME_OPEN;
    /* With few decimal places, the number just above the root may lie beyond the next root, where the train
     * keeps falling again, or beyond 1/s. The number just below the root may lie below the first growth. So
     * try again with more decimal places. */
    for (int finer = 0; finer < 9 && s->outcome == OUTCOME_OPEN; finer++, tol /= 10) {
        double unit = 1;
        int decimals = 0;
        for (; 1 / unit > tol * root * (1 + 1e-9) && root * unit < 0x1p49; unit *= 10)
            decimals++;
        const double n = floor(root * unit);
        s->found->decimals = decimals;
        if (stops_after(s, n, unit, top) && n / unit > s->found->from)
            return goes_on_before(s, n, unit);
    }
    return false;
}

static void limit_from(struct search *s)
{
    double end = up(1 / s->proof->shape.s.lo), width = FIRST_STRIP, top;
    while (s->done < end && width > LAST_STRIP * s->done) {
        double next = smaller(s->done + width, end);
        s->outcome = proof_strip(s->proof, s->done, next, NULL);
        if (s->outcome == OUTCOME_PROVED) {
            s->done = next;
            width *= 2;
            continue;
        }
        bool stops = s->outcome == OUTCOME_REFUTED ||
                     (s->outcome == OUTCOME_OPEN && next < end && proof_guess(s->proof, next, &top) < 0);
        for (; stops; next = s->stop) {
            if (bracket_prove(s, next)) {
                s->found->ends = DOM_PROVED_BARRIER;
                return;
            }
            stops = s->outcome == OUTCOME_REFUTED;
        }
        if (s->outcome == OUTCOME_LIMIT || s->outcome == OUTCOME_INTERRUPTED)
            break;
        width /= 2;
    }
    s->found->low = s->done;
    if (s->done >= end) {
        s->found->ends = DOM_PROVED_REACH;
        s->found->low = down(1 / s->proof->shape.s.hi);
        s->found->high = end;
    }
}

/*
 * A pair that stops at r = 1 may keep falling at larger growths. Finds such a growth, at which the search can
 * begin: estimates the smallest growth at which the margin is 0, and returns a growth above it at which the
 * pair provably keeps falling. Returns NaN if no proof succeeds.
 */
static double band_begin(struct proof *proof)
{
    enum { SAMPLES = 400 };
    double low = 1, reach = 1 / proof->shape.s.hi, top;
    for (int k = 1; k <= SAMPLES; k++) {
        const double r = 1 + (reach - 1) * k / (SAMPLES + 1);
        double high = r;
        if (!(proof_guess(proof, r, &top) > 0)) {
            low = r;
            continue;
        }
        for (int step = 0; step < 24; step++) {
            const double at = 0.5 * (low + high);
            *(proof_guess(proof, at, &top) > 0 ? &high : &low) = at;
        }
        const double from = ceil(high * 1e6) / 1e6;
        if (from < r && proof_strip(proof, from, from, NULL) == OUTCOME_PROVED)
            return from;
        return proof_strip(proof, r, r, NULL) == OUTCOME_PROVED ? r : (double)NAN;
    }
    return NAN;
}

enum outcome limit_prove(struct proof *proof, double tol, struct dom_proof *found)
{
    struct search s = {.proof = proof, .tol = tol, .done = 1, .found = found};
    double top;
    *found = (struct dom_proof){
        .ends = DOM_PROVED_PARTLY, .from = 1, .low = NAN, .high = INFINITY, .decimals = 17};
    s.outcome = proof_strip(proof, 1, 1, NULL);
    if (s.outcome != OUTCOME_PROVED) {
        proof_guess(proof, 1, &top);
        const bool stops = proof_stops(proof, 1, 1, top);
        const double from = stops && proof->shape.pair ? band_begin(proof) : (double)NAN;
        if (from > 1)
            s.done = found->from = from;
        else if (dom_interrupted(proof->interrupt))
            return OUTCOME_INTERRUPTED;
        else {
            found->ends = stops ? DOM_PROVED_NONE : DOM_PROVED_PARTLY;
            found->high = stops ? 1 : INFINITY;
            return s.outcome;
        }
    }
    limit_from(&s);
    return s.outcome;
}
