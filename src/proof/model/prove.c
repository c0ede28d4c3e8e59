/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proofs for all tilts of a cycle and all growths in an interval, and the public functions of
 * <domino_proof.h>. */
#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_proof.h"
#pragma GCC visibility pop
#include "numerics/interrupt.h"
#include "proof/model/proof.h"

#include <fenv.h>
#include <stdlib.h>

enum outcome {
    OUTCOME_PROVED,  /* the train keeps falling for all growths in the interval */
    OUTCOME_REFUTED, /* the train stops, or seems to stop, at the upper end of the interval */
    OUTCOME_OPEN,    /* the proof failed; it may succeed for a narrower interval of growths */
    OUTCOME_LIMIT,   /* the proof would need too many dominoes or boxes */
    OUTCOME_INTERRUPTED
};

/* A proof in progress. */
struct proof {
    struct shape shape;
    double tol;
    const volatile sig_atomic_t *interrupt;
    size_t boxes; /* how many boxes have been tried */
    /* the train for the whole interval of growths, and for the upper end of the interval */
    struct upright box, point;
    double top;  /* 2 sin(theta/2) at the top of the barrier, as margin_guess has estimated it */
    double done; /* the train keeps falling for all growths from the first one to this one */
    double stop; /* upper end of the last interval of growths that was tried */
};

/* Sums end when their remainders are at most this large. */
static const double REST = 1e-17;

enum { BOXES_MOST = 200000, DEEPEST = 48, PER_STRIP = 400, PER_WIDE_STRIP = 64, BRACKETS_MOST = 200 };

/* ---- An interval of growths ---- */

/* Returns the most by which K_n - D_n can be smaller than its value at the upper end of the strip, for any
 * growth in the strip: an upper bound on its derivative with respect to r, times the width of the strip. */
static double growth_loss(const struct upright *box, struct span climb_by_r)
{
    const double width = up(box->growth.r.hi - box->growth.r.lo),
                 loss = up(least_0(up(box->kinetic.by_r.hi - climb_by_r.lo)) * width);
    return PROOF_BOUND(MEAN_VALUE_GROWTH, loss, 0);
}

/*
 * Tries to prove that K - D > 0 for all growths in the strip, and for all tilts from `low` to `high`, given
 * as sigma = 2 sin(theta/2). It is proved if one of the two lower bounds of Lemma 3 in domino-model(7) is
 * positive:
 *
 * 1. K - D of the box of all these tilts and growths, from its corners.
 * 2. K_n - D_n at one tilt `at` and at the upper end of the strip, minus `spread`, by which D may be larger
 * at other tilts, and minus growth_loss.
 *
 * If both bounds fail, the interval of tilts is halved. If they fail even for the single tilt `at`, the strip
 * is too wide.
 */
static enum outcome cover_tilts(struct proof *proof, double low, double high, int depth, size_t *left)
{
    const struct upright *box = &proof->box, *point = &proof->point;
    if (dom_interrupted(proof->interrupt))
        return OUTCOME_INTERRUPTED;
    if (*left == 0 || depth > DEEPEST)
        return OUTCOME_OPEN;
    --*left;
    if (++proof->boxes > BOXES_MOST)
        return OUTCOME_LIMIT;
    const struct climb all = climb_find(box, low, high, true);
    if (down(box->kinetic.value.lo - all.height.hi) > 0)
        return OUTCOME_PROVED;
    if (!isfinite(all.by_r.lo))
        return OUTCOME_OPEN;
    /*
     * If D is monotonic in the box, `at` is the end of the interval at which D is largest. A cycle ends when
     * the head has the tilt theta_c, and the bounds on D hold only up to theta_c. So the tilt `at` may not
     * exceed theta_c. The tilt `low` may always be used: if any tilt in the box belongs to the cycle, `low`
     * does.
     */
    double at = all.by_tilt.lo >= 0 ? high : all.by_tilt.hi <= 0 ? low : 0.5 * (low + high);
    at = smaller(at, larger(low, box->growth.hit.lo));
    const double farther = up(least_0(all.by_tilt.hi) * up(high - at)),
                 nearer = up(least_0(-all.by_tilt.lo) * up(at - low)),
                 spread = PROOF_BOUND(MEAN_VALUE_TILT, larger(farther, nearer), 0);
    const struct climb end = climb_find(point, at, at, false);
    if (at <= point->growth.hit.lo && up(point->kinetic.value.hi - end.height.lo) < 0)
        return OUTCOME_REFUTED;
    const double by_end = down(point->kinetic.value.lo - end.height.hi);
    if (down(down(by_end - spread) - growth_loss(box, all.by_r)) > 0)
        return OUTCOME_PROVED;
    if (!(by_end - growth_loss(box, climb_find(box, at, at, true).by_r) > 0))
        return OUTCOME_OPEN;
    const double middle = 0.5 * (low + high);
    const enum outcome first = cover_tilts(proof, low, middle, depth + 1, left);
    return first == OUTCOME_PROVED ? cover_tilts(proof, middle, high, depth + 1, left) : first;
}

/* Tries to prove that the train keeps falling for all growths from r_low to r_high, by showing that K > D at
 * every tilt of the cycle. If `level` is not NULL, it takes the place of K. */
static enum outcome strip_prove(struct proof *proof, double r_low, double r_high, const double *level)
{
    if (dom_interrupted(proof->interrupt))
        return OUTCOME_INTERRUPTED;
    if (!upright_find(&proof->shape, r_low, r_high, REST, 0, &proof->box) ||
        !upright_find(&proof->shape, r_high, r_high, REST, proof->box.n, &proof->point))
        return level ? OUTCOME_LIMIT : OUTCOME_OPEN;
    if (level)
        proof->box.kinetic = proof->point.kinetic = dual_of(span_of(*level));
    else if (proof->point.fuel.hi <= 0)
        return OUTCOME_REFUTED;
    /* A wide strip is given up early, since halving the strip is cheaper than using many boxes. */
    size_t left = r_high - r_low > 1e-4 * r_high ? PER_WIDE_STRIP : PER_STRIP;
    return cover_tilts(proof, 0, proof->box.growth.hit.hi, 0, &left);
}

/* Tries to prove that the train stops for all growths from r_low to r_high, because it has no fuel, or
 * because its kinetic energy is too small to reach the tilt proof->top or, if that exceeds theta_c, theta_c.
 * Returns false if the proof fails. */
static bool stops_prove(struct proof *proof, double r_low, double r_high)
{
    if (dom_interrupted(proof->interrupt) ||
        !upright_find(&proof->shape, r_low, r_high, REST, 0, &proof->box))
        return false;
    const double at = smaller(proof->top, proof->box.growth.hit.lo);
    return proof->box.fuel.hi <= 0 ||
           up(proof->box.kinetic.value.hi - climb_find(&proof->box, at, at, false).height.lo) < 0;
}

/* Returns an estimate of the margin K - B at the growth r, where B is the height of the barrier, and sets
 * proof->top. These estimates prove nothing; they only tell which proof to try. Returns NaN if the train
 * cannot be computed, or after an interrupt. */
static double margin_guess(struct proof *proof, double r)
{
    enum { SAMPLES = 48, HALVINGS = 25 }; /* these show tilts to 1e-9 of theta_c */
    proof->top = 0;
    if (dom_interrupted(proof->interrupt) || !upright_find(&proof->shape, r, r, REST, 0, &proof->point))
        return NAN;
    const struct upright *u = &proof->point;
    const double kinetic = span_middle(u->kinetic.value), hit = u->growth.hit.lo;
    double barrier = 0, low = 0, high = hit;
    for (int k = 1; k <= SAMPLES + HALVINGS && !dom_interrupted(proof->interrupt); k++) {
        /* After the samples, find the maximum between the neighbours of the highest one, by bisection on the
         * slope of D. */
        const bool sample = k <= SAMPLES;
        const double at = sample ? hit * k / SAMPLES : 0.5 * (low + high);
        const struct climb climb = climb_find(u, at, at, !sample);
        if (span_middle(climb.height) > barrier) {
            barrier = span_middle(climb.height);
            proof->top = at;
        }
        if (!sample)
            *(span_middle(climb.by_tilt) > 0 ? &low : &high) = at;
        else if (k == SAMPLES) {
            low = larger(proof->top - hit / SAMPLES, 0);
            high = smaller(proof->top + hit / SAMPLES, hit);
        }
    }
    return dom_interrupted(proof->interrupt) ? (double)NAN : (kinetic < -1 ? -1 : kinetic) - barrier;
}

/* Estimates the growth between `low` and `high` at which the margin is 0, to the relative tolerance `tol`, by
 * the method of false position, and leaves proof->top there. The value at an end that stays twice is halved
 * (Illinois). */
static double root_guess(struct proof *proof, double low, double high, double tol)
{
    double at_low = margin_guess(proof, low), at_high = margin_guess(proof, high), root = high, before = low;
    bool was_low = false;
    for (int k = 0; k < 80 && fabs(root - before) > tol * high; k++) {
        before = root;
        root = low - at_low * (high - low) / (at_high - at_low);
        if (!(root > low && root < high))
            root = 0.5 * (low + high);
        const double margin = margin_guess(proof, root);
        const bool is_low = margin > 0;
        if (isnan(margin) || fabs(margin) < REST)
            break;
        *(is_low ? &low : &high) = root;
        *(is_low ? &at_low : &at_high) = margin;
        if (k > 0 && is_low == was_low)
            *(is_low ? &at_high : &at_low) /= 2;
        was_low = is_low;
    }
    return root;
}

/* ---- The smallest growth at which the train stops ---- */

/*
 * The search for the smallest growth at which a train stops works upwards from r = 1 in strips, which are
 * intervals of growths.
 *
 * If the train seems to stop at the upper end of a strip, the search estimates the growth at which the margin
 * is 0 (the root). Two proofs follow. The first shows that the train stops at a decimal number just above the
 * root. The second shows that the train keeps falling for all growths up to a decimal number just below the
 * root. If the estimate of the root is wrong, one of the two proofs fails, but nothing wrong is proved.
 */
static const double FIRST_STRIP = 0.05, LAST_STRIP = 1e-15;

/*
 * Tries to prove that the train keeps falling for all growths from proof->done to `end`, in strips of which
 * the first is `width` wide. After a success, proof->done is the end of the strip, and the next strip is
 * twice as wide. After a failure, the strip is halved, unless it is as narrow as `finest`, or `guess` is true
 * and the train seems to stop at the upper end of the strip. The range is then given up.
 */
static enum outcome range_prove(struct proof *proof, double end, double width, double finest, bool guess)
{
    while (proof->done < end) {
        proof->stop = smaller(proof->done + width, end);
        const enum outcome outcome = strip_prove(proof, proof->done, proof->stop, NULL);
        width = proof->stop - proof->done;
        if (outcome == OUTCOME_PROVED) {
            proof->done = proof->stop;
            width *= 2;
            continue;
        }
        if (outcome != OUTCOME_OPEN || width <= finest)
            return outcome;
        if (guess && proof->stop < end && margin_guess(proof, proof->stop) < 0)
            return OUTCOME_REFUTED;
        width /= 2;
    }
    return OUTCOME_PROVED;
}

/* Estimates the growth between proof->done and proof->stop at which the margin is 0 (the root). Tries to
 * prove that the train stops at a decimal number slightly above it, and keeps falling up to one slightly
 * below. */
static enum outcome bracket_prove(struct proof *proof, struct dom_proof *found)
{
    enum { ABOVE_MOST = 256, BELOW_MOST = 1024 };
    const double root = root_guess(proof, proof->done, proof->stop, 2e-16);
    double tol = proof->tol;
    /* With few decimal places, the number just above the root may lie beyond the next root, where the train
     * keeps falling again, or beyond 1/s. The number just below the root may lie below the first growth. So
     * try again with more decimal places. */
    for (int finer = 0; finer < 9 && !dom_interrupted(proof->interrupt); finer++, tol /= 10) {
        double unit = 1;
        int decimals = 0;
        for (; 1 / unit > tol * root * (1 + 1e-9) && root * unit < 0x1p49; unit *= 10)
            decimals++;
        double n = floor(root * unit);
        const double least = n - BELOW_MOST;
        bool stops = false;
        /* The double r that is nearest to a decimal number may be a little smaller or larger than this
         * number. So the proof covers the whole interval between the two neighbours of r. */
        for (int more = 1; more <= ABOVE_MOST && !stops && n / unit > found->from; more *= 2) {
            const double r = (n + more) / unit, low = nextafter(r, 0);
            stops = low * proof->shape.s.hi < 1 && stops_prove(proof, low, nextafter(r, INFINITY));
            found->high = stops ? r : found->high;
        }
        if (!stops)
            continue;
        const enum outcome outcome = range_prove(proof, nextafter(n / unit, INFINITY), INFINITY,
                                                 larger(1e-3 / unit, LAST_STRIP * root), false);
        while (n > least && nextafter(n / unit, INFINITY) > proof->done)
            n--;
        found->low = n / unit;
        found->decimals = decimals;
        if ((outcome != OUTCOME_PROVED && outcome != OUTCOME_OPEN) || n == least || found->low < found->from)
            return outcome;
        found->ends = DOM_PROVED_BARRIER;
        return OUTCOME_PROVED;
    }
    return dom_interrupted(proof->interrupt) ? OUTCOME_INTERRUPTED : OUTCOME_OPEN;
}

/* A pair that stops at r = 1 may keep falling at larger growths. Returns a growth just above the smallest one
 * at which the margin seems to be 0, if the pair provably keeps falling there. Returns NaN otherwise. */
static double band_begin(struct proof *proof)
{
    enum { SAMPLES = 400 };
    const double reach = 1 / proof->shape.s.hi;
    double low = 1, r = 1;
    int k = 0;
    do {
        low = r;
        r = 1 + (reach - 1) * ++k / (SAMPLES + 1);
    } while (k < SAMPLES && !(margin_guess(proof, r) > 0) && !dom_interrupted(proof->interrupt));
    const double from = ceil(root_guess(proof, low, r, 1e-7) * 1e6) / 1e6;
    return from < r && strip_prove(proof, from, from, NULL) == OUTCOME_PROVED ? from
           : strip_prove(proof, r, r, NULL) == OUTCOME_PROVED                 ? r
                                                                              : (double)NAN;
}

/* Tries to enclose the smallest growth at which the train stops, as dom_prove_rmax says. If the proof remains
 * incomplete (DOM_PROVED_PARTLY), the result is the reason. */
static enum outcome limit_prove(struct proof *proof, struct dom_proof *found)
{
    const double end = up(1 / proof->shape.s.lo);
    enum outcome outcome = strip_prove(proof, 1, 1, NULL);
    proof->done = 1;
    if (outcome != OUTCOME_PROVED) {
        margin_guess(proof, 1);
        const bool stops = stops_prove(proof, 1, 1);
        proof->done = stops && proof->shape.pair ? band_begin(proof) : 1;
        if (dom_interrupted(proof->interrupt))
            return OUTCOME_INTERRUPTED;
        if (!(proof->done > 1)) {
            found->ends = stops ? DOM_PROVED_NONE : DOM_PROVED_PARTLY;
            found->high = stops ? 1 : INFINITY;
            return outcome;
        }
    }
    found->from = proof->done;
    outcome = range_prove(proof, end, FIRST_STRIP, LAST_STRIP * proof->done, true);
    for (int tries = 0; tries < BRACKETS_MOST && outcome == OUTCOME_REFUTED; tries++) {
        const double width = proof->stop - proof->done;
        outcome = bracket_prove(proof, found);
        if (found->ends == DOM_PROVED_BARRIER)
            return outcome;
        if (outcome == OUTCOME_OPEN) /* the estimate was wrong */
            outcome = range_prove(proof, end, width / 2, LAST_STRIP * proof->done, true);
    }
    found->low = proof->done;
    if (proof->done >= end) {
        found->ends = DOM_PROVED_REACH;
        found->low = down(1 / proof->shape.s.hi);
        found->high = end;
    }
    return outcome;
}

/* ---- One growth ---- */

static enum dom_proof_gap gap_of(enum outcome outcome)
{
    return outcome == OUTCOME_INTERRUPTED ? DOM_PROOF_INTERRUPTED
           : outcome == OUTCOME_LIMIT     ? DOM_PROOF_BOXES
                                          : DOM_PROOF_ROUNDING;
}

static void cycle_prove(struct proof *proof, double r, struct dom_proof_cycle *result)
{
    const double low = larger(1, nextafter(r, 0)), high = nextafter(r, INFINITY);
    if (span_mul(span_around(r), proof->shape.s).lo > 1) {
        result->verdict = DOM_PROVED_OUT_OF_REACH;
        return;
    }
    margin_guess(proof, r);
    if (!upright_find(&proof->shape, low, high, REST, 0, &proof->box)) {
        result->gap = DOM_PROOF_BOXES;
        return;
    }
    const struct span fuel = proof->box.fuel, kinetic = proof->box.kinetic.value;
    if (fuel.hi <= 0) {
        result->verdict = DOM_PROVED_NO_FUEL;
        return;
    }
    /* The barrier is the largest D, so the value of D at any single tilt is a lower bound. The upper bound is
     * a level that D provably never exceeds. */
    const double at = smaller(proof->top, proof->box.growth.hit.lo);
    struct span barrier = {least_0(climb_find(&proof->box, at, at, false).height.lo), INFINITY};
    enum outcome outcome = OUTCOME_OPEN;
    for (double more = larger(proof->tol * (barrier.lo + least_0(kinetic.hi)), 1e-16);
         more < 1 && (outcome == OUTCOME_OPEN || outcome == OUTCOME_REFUTED); more *= 4) {
        const double level = barrier.lo + more;
        outcome = strip_prove(proof, low, high, &level);
        if (outcome == OUTCOME_PROVED)
            barrier.hi = up(level);
    }
    const struct span margin = span_sub(kinetic, barrier);
    result->kinetic = (struct dom_interval){kinetic.lo, kinetic.hi};
    result->barrier = (struct dom_interval){barrier.lo, barrier.hi};
    result->margin = (struct dom_interval){margin.lo, margin.hi};
    if (margin.hi < 0)
        result->verdict = DOM_PROVED_STOPS;
    else if (fuel.lo > 0 && (margin.lo >= 0 || strip_prove(proof, low, high, NULL) == OUTCOME_PROVED))
        result->verdict = DOM_PROVED_GOES_ON;
    else
        result->gap = dom_interrupted(proof->interrupt) ? DOM_PROOF_INTERRUPTED : gap_of(outcome);
}

/* ---- Public functions ---- */

const char *dom_proof_gap_text(enum dom_proof_gap gap)
{
    static const char *const text[] = {
#define GAP_TEXT(name, text) [DOM_PROOF_##name] = text,
        DOM_PROOF_GAPS(GAP_TEXT)
#undef GAP_TEXT
    };
    return text[gap];
}

/* Checks the arguments and prepares a proof. If no proof can be attempted, sets *gap to the reason. The
 * caller frees proof->box.link, in which `point` has links, too. */
static enum dom_status begin(struct proof *proof, const struct dom_train *train,
                             const struct dom_compute *compute, bool pair, enum dom_proof_gap *gap)
{
    const struct dom_compute how = compute ? *compute : dom_compute_default();
    struct dom_train plain = *train;
    struct dom_angles angles;
    bool has_effect = false;
    *proof = (struct proof){.box.link = NULL};
/* Walls are allowed, since they do not affect any result of a proof. */
#define SWITCH_OFF(effect, member, status)                                                                   \
    has_effect = has_effect || (DOM_EFFECT_##effect != DOM_EFFECT_walls && plain.member != 0);               \
    plain.member = 0;
    DOM_DYNAMICS(SWITCH_OFF)
#undef SWITCH_OFF
    /* The product r s may be too large. */
    const enum dom_status status = dom_angles_find(&plain, NULL, &angles);
    if (status != DOM_OK && status != DOM_OUT_OF_REACH && status != DOM_UNDERFLOW)
        return status;
    if (!(how.tol > 0 && how.tol <= 0.1))
        return DOM_BAD_TOL;
    /* The interval arithmetic in span.h needs this rounding mode, but a caller may have changed the mode. */
    *gap = has_effect ? DOM_PROOF_EFFECT : fegetround() != FE_TONEAREST ? DOM_PROOF_MODE : DOM_PROOF_NONE;
    if (*gap != DOM_PROOF_NONE)
        return DOM_OK;
    proof->shape = shape_make(train->s, train->d, train->q);
    proof->shape.paper = train->fuel == DOM_FUEL_PAPER;
    proof->shape.pair = pair;
    proof->tol = larger(how.tol, 1e-15);
    proof->interrupt = how.interrupt;
    struct link *const links = proof->box.link = malloc((size_t)2 * (LINKS_MOST + 2) * sizeof *links);
    proof->point.link = links ? links + LINKS_MOST + 2 : NULL;
    return links ? DOM_OK : DOM_NO_MEMORY;
}

static enum dom_status prove_limit(const struct dom_train *train, const struct dom_compute *compute,
                                   bool pair, struct dom_proof *result)
{
    struct proof proof;
    *result = (struct dom_proof){.ends = DOM_PROVED_PARTLY, .from = 1, .low = DOM_NAN, .high = INFINITY};
    const enum dom_status status = begin(&proof, train, compute, pair, &result->gap);
    if (status == DOM_OK && result->gap == DOM_PROOF_NONE) {
        const enum outcome outcome = limit_prove(&proof, result);
        result->gap = result->ends == DOM_PROVED_PARTLY ? gap_of(outcome) : DOM_PROOF_NONE;
    }
    free(proof.box.link);
    return status;
}

enum dom_status dom_prove_rmax(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_proof *proof)
{
    return prove_limit(train, compute, false, proof);
}

enum dom_status dom_prove_pair(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_proof *proof)
{
    return prove_limit(train, compute, true, proof);
}

enum dom_status dom_prove_cycle(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_proof_cycle *result)
{
    const struct dom_interval none = {DOM_NAN, DOM_NAN};
    struct proof proof;
    *result = (struct dom_proof_cycle){
        .verdict = DOM_PROVED_NOTHING, .kinetic = none, .barrier = none, .margin = none};
    const enum dom_status status = begin(&proof, train, compute, false, &result->gap);
    if (status == DOM_OK && result->gap == DOM_PROOF_NONE)
        cycle_prove(&proof, train->r, result);
    free(proof.box.link);
    return status;
}

enum dom_status dom_prove_count(double first, double height, double r, double *least, double *most)
{
    enum { POWERS_MOST = 100000 };
    const double exact_least = 0x1p-960; /* below this, the rounding error of a product may underflow to 0 */
    if (!(first > 0 && height > 0 && isfinite(first) && isfinite(height)))
        return DOM_BAD_HEIGHT;
    if (!(r >= 1 && isfinite(r)))
        return DOM_BAD_R;
    *least = 0;
    *most = INFINITY;
    if (fegetround() != FE_TONEAREST)
        return DOM_OK;
    /* If all products are exact, the number of dominoes is computed exactly, for these very arguments. */
    double n = 0, tall = first;
    while (tall < height && r > 1 && tall > exact_least && fma(tall, r, -(tall * r)) == 0) {
        tall *= r;
        n++;
    }
    if (tall >= height || r == 1) {
        *least = *most = tall >= height ? n : HUGE_VAL;
        return DOM_OK;
    }
    /* Otherwise only bounds are found. The bounds hold not only for these arguments, but for all numbers that
     * round to them. */
    struct span powers = span_around(first);
    const struct span target = span_around(height), growth = span_around(r);
    for (n = 0; powers.lo < target.hi && n < POWERS_MOST; n++) {
        *least += powers.hi < target.lo;
        powers = span_mul(growth, powers);
    }
    if (powers.lo >= target.hi)
        *most = n;
    return DOM_OK;
}
