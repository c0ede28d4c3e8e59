/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proofs for all tilts of a cycle and all growths in an interval, and the public functions of
 * <domino_proof.h>. */
#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_proof.h"
#pragma GCC visibility pop
#include "numerics/interrupt.h"
#include "numerics/numerics.h"
#include "proof/model/proof.h"

#include <fenv.h>
#include <stdlib.h>

/* The header of numerics declares functions that only the kernel's own sources define. */
#pragma GCC diagnostic ignored "-Wunused-function"

/* A proof in progress. */
struct proof {
    struct shape shape;
    double tol;
    const volatile sig_atomic_t *interrupt;
    /* Why the last attempt has failed, if it has. A narrower interval of growths may help against
     * DOM_PROOF_ROUNDING; all other gaps end the proof. */
    enum dom_proof_gap gap;
    int boxes; /* how many boxes have been tried */
    /* the train for the whole interval of growths, and for the upper end of the interval */
    struct upright box, point;
    double top;  /* 2 sin(theta/2) at the top of the barrier, as margin_guess has estimated it */
    double done; /* the train keeps falling for all growths from the first one to this one */
};

/* Sums end when their remainders are at most this large. */
static const double REST = 1e-17;

static bool given_up(struct proof *proof)
{
    if (proof->gap == DOM_PROOF_ROUNDING && dom_interrupted(proof->interrupt))
        proof->gap = DOM_PROOF_INTERRUPTED;
    return proof->gap != DOM_PROOF_ROUNDING;
}

/* ---- An interval of growths ---- */

/* Returns the most by which K_n - D_n can be smaller than its value at the upper end of the strip, for any
 * growth in the strip: an upper bound on its derivative with respect to r, times the width of the strip. */
static double growth_loss(const struct upright *box, struct climb climb)
{
    const double width = up(box->r.hi - box->r.lo),
                 loss = up(least_0(up(box->kinetic.by_r.hi - climb.height.by_r.lo)) * width);
    return PROOF_BOUND(MEAN_VALUE_GROWTH, loss, 0);
}

/*
 * Tries to prove that the train keeps falling for all growths in a strip, from r_low to r_high, by showing
 * that K - D > 0 at every tilt of the cycle. If `level` is not NULL, it takes the place of K. Tilts are given
 * as sigma = 2 sin(theta/2). A box of tilts, from `low` to `high`, is proved if one of the two lower bounds
 * of Lemma 3 in domino-model(7) is positive:
 *
 * 1. K - D of the box of all these tilts and growths, from its corners.
 * 2. K_n - D_n at one tilt `at` and at the upper end of the strip, minus `spread`, by which D may be larger
 * at other tilts, and minus growth_loss.
 *
 * Boxes are tried from 0 upwards. After a success the next box is twice as wide; after a failure the box is
 * halved. If the bounds fail even for the single tilt `at`, the strip is too wide.
 */
static bool strip_prove(struct proof *proof, double r_low, double r_high, const double *level)
{
    enum { BOXES_MOST = 200000, PER_STRIP = 400, PER_WIDE_STRIP = 64 };
    struct upright *const box = &proof->box, *const point = &proof->point;
    if (given_up(proof) || !upright_find(&proof->shape, r_low, r_high, REST, 0, box) ||
        !upright_find(&proof->shape, r_high, r_high, REST, box->n, point))
        return false;
    if (level)
        box->kinetic = point->kinetic = dual_of(span_of(*level));
    else if (point->fuel.hi <= 0)
        return false;
    /* A wide strip is given up early, since halving the strip is cheaper than using many boxes. */
    int left = r_high - r_low > 1e-4 * r_high ? PER_WIDE_STRIP : PER_STRIP;
    const double end = box->hit.hi;
    /* The box begins at the part `from` of the tilts and is the part `share` of them; both are exact. */
    double from = 0, share = 1;
    while (from < 1) {
        const double low = end * from, high = end * (from + share);
        if (++proof->boxes > BOXES_MOST)
            proof->gap = DOM_PROOF_BOXES;
        if (left-- == 0 || given_up(proof))
            return false;
        const struct climb all = climb_find(box, low, high, true);
        bool proved = down(box->kinetic.value.lo - all.height.value.hi) > 0;
        /*
         * If D is monotonic in the box, `at` is the end of the interval at which D is largest. A cycle ends
         * when the head has the tilt theta_c, and the bounds on D hold only up to theta_c. So the tilt `at`
         * may not exceed theta_c. The tilt `low` may always be used: if any tilt in the box belongs to the
         * cycle, `low` does.
         */
        if (!proved) {
            double at = all.by_tilt.lo >= 0 ? high : all.by_tilt.hi <= 0 ? low : 0.5 * (low + high);
            at = smaller(at, larger(low, box->hit.lo));
            const double farther = up(least_0(all.by_tilt.hi) * up(high - at)),
                         nearer = up(least_0(-all.by_tilt.lo) * up(at - low)),
                         spread = PROOF_BOUND(MEAN_VALUE_TILT, larger(farther, nearer), 0),
                         by_end =
                             down(point->kinetic.value.lo - climb_find(point, at, at, false).height.value.hi);
            proved = down(down(by_end - spread) - growth_loss(box, all)) > 0;
            if (!proved && !(by_end - growth_loss(box, climb_find(box, at, at, true)) > 0))
                return false;
        }
        share /= proved ? 1 : 2;
        if (proved)
            for (from += share; from < 1 && fmod(from, 2 * share) == 0;)
                share *= 2;
    }
    return true;
}

/* Returns an estimate of the margin K - B at the growth r, where B is the height of the barrier, and sets
 * proof->top. These estimates prove nothing; they only tell which proof to try. Returns NaN if the train
 * cannot be computed, or after an interrupt. */
static double margin_guess(double r, void *context)
{
    enum { SAMPLES = 48, HALVINGS = 25 }; /* these show tilts to 1e-9 of theta_c */
    struct proof *const proof = context;
    struct upright *const u = &proof->point;
    double barrier = 0, low = 0, high = 0;
    proof->top = 0;
    if (given_up(proof) || !upright_find(&proof->shape, r, r, REST, 0, u))
        return NAN;
    const double step = u->hit.lo / SAMPLES;
    for (int k = 1; k <= SAMPLES + HALVINGS && !given_up(proof); k++) {
        /* After the samples, find the maximum between the neighbours of the highest one, by bisection on the
         * slope of D. */
        const double at = k <= SAMPLES ? step * k : 0.5 * (low + high);
        const struct climb climb = climb_find(u, at, at, k > SAMPLES);
        if (span_middle(climb.height.value) > barrier) {
            barrier = span_middle(climb.height.value);
            proof->top = at;
        }
        if (k > SAMPLES)
            *(span_middle(climb.by_tilt) > 0 ? &low : &high) = at;
        else if (k == SAMPLES) {
            low = larger(proof->top - step, 0);
            high = smaller(proof->top + step, u->hit.lo);
        }
    }
    return given_up(proof) ? (double)NAN : larger(span_middle(u->kinetic.value), -1) - barrier;
}

/* Tries to prove that the train stops for all growths from r_low to r_high, because it has no fuel, or
 * because its kinetic energy is too small to reach the top of the barrier or, if the estimate of the top
 * exceeds theta_c, theta_c. Returns false if the proof fails. */
static bool stops_prove(struct proof *proof, double r_low, double r_high)
{
    struct upright *const box = &proof->box;
    margin_guess(r_high, proof);
    if (given_up(proof) || !upright_find(&proof->shape, r_low, r_high, REST, 0, box))
        return false;
    const double at = smaller(proof->top, box->hit.lo);
    return box->fuel.hi <= 0 ||
           up(box->kinetic.value.hi - climb_find(box, at, at, false).height.value.lo) < 0;
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

static bool bracket_prove(struct proof *proof, double stop, struct dom_proof *found);

/*
 * Tries to prove that the train keeps falling for all growths from proof->done to `end`, in strips of which
 * the first is `width` wide. After a success, proof->done is the end of the strip, and the next strip is
 * twice as wide. After a failure, the strip is halved, unless it is as narrow as `finest`. If `found` is not
 * NULL, and the train seems to stop at the upper end of a strip, the search ends with the growth at which it
 * stops. Returns false if the range is given up.
 */
static bool range_prove(struct proof *proof, double end, double width, double finest, struct dom_proof *found)
{
    while (proof->done < end) {
        const double stop = smaller(proof->done + width, end);
        width = stop - proof->done;
        if (strip_prove(proof, proof->done, stop, NULL)) {
            proof->done = stop;
            width *= 2;
            continue;
        }
        if (found && stop < end && margin_guess(stop, proof) < 0 && bracket_prove(proof, stop, found))
            return true;
        if (width <= finest || given_up(proof))
            return false;
        width /= 2;
    }
    return true;
}

/* Estimates the growth between proof->done and `stop` at which the margin is 0 (the root). Tries to prove
 * that the train stops at a decimal number slightly above it, and keeps falling up to one slightly below. */
static bool bracket_prove(struct proof *proof, double stop, struct dom_proof *found)
{
    enum { ABOVE_MOST = 256, BELOW_MOST = 1024 };
    double root = proof->done, unit = 1;
    int decimals = 0;
    if (num_root(margin_guess, proof, proof->done, stop, 2e-16, &root) == NUM_NOT_FINITE)
        return false;
    for (; 1 / unit > proof->tol * root * (1 + 1e-9) && root * unit < 0x1p49; unit *= 10)
        decimals++;
    /* With few decimal places, the number just above the root may lie beyond the next root, where the train
     * keeps falling again, or beyond 1/s. The number just below the root may lie below the first growth. So
     * try again with more decimal places. */
    for (; root * unit < 0x1p53; unit *= 10, decimals++) {
        const double n = floor(root * unit);
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
        range_prove(proof, nextafter(n / unit, INFINITY), INFINITY, larger(1e-3 / unit, LAST_STRIP * root),
                    NULL);
        double below = floor(proof->done * unit);
        below -= nextafter(below / unit, INFINITY) > proof->done;
        if (given_up(proof) || n - below >= BELOW_MOST || below / unit < found->from)
            return false;
        found->low = below / unit;
        found->decimals = decimals;
        found->ends = DOM_PROVED_BARRIER;
        return true;
    }
    return false;
}

/* A pair that stops at r = 1 may keep falling at larger growths. Returns a growth just above the smallest one
 * at which the margin seems to be 0, if the pair provably keeps falling there. Returns 1 otherwise. */
static double band_begin(struct proof *proof)
{
    enum { SAMPLES = 400 };
    const double reach = 1 / proof->shape.s.hi;
    double low = 1, r = 1, from = INFINITY;
    for (int k = 1; k <= SAMPLES && !(margin_guess(r, proof) > 0) && !given_up(proof); k++) {
        low = r;
        r = 1 + (reach - 1) * k / (SAMPLES + 1);
    }
    if (num_root(margin_guess, proof, low, r, 1e-7, &from) == NUM_OK)
        from = ceil(from * 1e6) / 1e6;
    return from < r && strip_prove(proof, from, from, NULL) ? from : strip_prove(proof, r, r, NULL) ? r : 1;
}

/* Tries to enclose the smallest growth at which the train stops, as dom_prove_rmax says. */
static void limit_prove(struct proof *proof, struct dom_proof *found)
{
    const double end = up(1 / proof->shape.s.lo);
    proof->done = 1;
    if (!strip_prove(proof, 1, 1, NULL)) {
        const bool stops = stops_prove(proof, 1, 1);
        if (stops && proof->shape.pair)
            proof->done = band_begin(proof);
        if (given_up(proof))
            return;
        if (proof->done == 1) {
            found->ends = stops ? DOM_PROVED_NONE : DOM_PROVED_PARTLY;
            found->high = stops ? 1 : INFINITY;
            return;
        }
    }
    found->from = proof->done;
    range_prove(proof, end, FIRST_STRIP, LAST_STRIP * proof->done, found);
    if (found->ends == DOM_PROVED_BARRIER)
        return;
    found->low = proof->done;
    if (proof->done >= end) {
        found->ends = DOM_PROVED_REACH;
        found->low = down(1 / proof->shape.s.hi);
        found->high = end;
    }
}

/* ---- One growth ---- */

static void cycle_prove(struct proof *proof, double r, struct dom_proof_cycle *result)
{
    const double low = larger(1, nextafter(r, 0)), high = nextafter(r, INFINITY);
    if (given_up(proof))
        return;
    if (span_mul(span_around(r), proof->shape.s).lo > 1) {
        result->verdict = DOM_PROVED_OUT_OF_REACH;
        return;
    }
    margin_guess(r, proof);
    if (!upright_find(&proof->shape, low, high, REST, 0, &proof->box)) {
        proof->gap = DOM_PROOF_BOXES;
        return;
    }
    const struct span fuel = proof->box.fuel, kinetic = proof->box.kinetic.value;
    if (fuel.hi <= 0) {
        result->verdict = DOM_PROVED_NO_FUEL;
        return;
    }
    /* The barrier is the largest D, so the value of D at any single tilt is a lower bound. The upper bound is
     * a level that D provably never exceeds. */
    const double at = smaller(proof->top, proof->box.hit.lo);
    struct span barrier = {least_0(climb_find(&proof->box, at, at, false).height.value.lo), INFINITY};
    for (double more = larger(proof->tol * (barrier.lo + least_0(kinetic.hi)), 1e-16);
         more < 1 && isinf(barrier.hi) && !given_up(proof); more *= 4) {
        const double level = barrier.lo + more;
        if (strip_prove(proof, low, high, &level))
            barrier.hi = up(level);
    }
    const struct span margin = span_sub(kinetic, barrier);
    result->kinetic = (struct dom_interval){kinetic.lo, kinetic.hi};
    result->barrier = (struct dom_interval){barrier.lo, barrier.hi};
    result->margin = (struct dom_interval){margin.lo, margin.hi};
    if (margin.hi < 0)
        result->verdict = DOM_PROVED_STOPS;
    else if (fuel.lo > 0 && (margin.lo >= 0 || strip_prove(proof, low, high, NULL)))
        result->verdict = DOM_PROVED_GOES_ON;
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

/* Checks the arguments and prepares a proof. The caller frees proof->box.link, in which `point` has links,
 * too. */
static enum dom_status begin(struct proof *proof, const struct dom_train *train,
                             const struct dom_compute *compute, bool pair)
{
    const struct dom_compute how = compute ? *compute : dom_compute_default();
    struct dom_train plain = *train;
    struct dom_angles angles;
    bool has_effect = false;
    *proof = (struct proof){.tol = larger(how.tol, 1e-15), .interrupt = how.interrupt};
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
    proof->gap = has_effect                     ? DOM_PROOF_EFFECT
                 : fegetround() != FE_TONEAREST ? DOM_PROOF_MODE
                                                : DOM_PROOF_ROUNDING;
    proof->shape = shape_make(train->s, train->d, train->q);
    proof->shape.paper = train->fuel == DOM_FUEL_PAPER;
    proof->shape.pair = pair;
    struct link *const links = proof->box.link = malloc((size_t)2 * (LINKS_MOST + 2) * sizeof *links);
    proof->point.link = links ? links + LINKS_MOST + 2 : NULL;
    return links ? DOM_OK : DOM_NO_MEMORY;
}

static enum dom_status prove_limit(const struct dom_train *train, const struct dom_compute *compute,
                                   bool pair, struct dom_proof *result)
{
    struct proof proof;
    *result = (struct dom_proof){.ends = DOM_PROVED_PARTLY, .from = 1, .low = DOM_NAN, .high = INFINITY};
    const enum dom_status status = begin(&proof, train, compute, pair);
    if (status == DOM_OK)
        limit_prove(&proof, result);
    result->gap = result->ends == DOM_PROVED_PARTLY ? proof.gap : DOM_PROOF_NONE;
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
    const enum dom_status status = begin(&proof, train, compute, false);
    if (status == DOM_OK)
        cycle_prove(&proof, train->r, result);
    result->gap = result->verdict == DOM_PROVED_NOTHING ? proof.gap : DOM_PROOF_NONE;
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
