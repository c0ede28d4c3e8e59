/* SPDX-License-Identifier: GPL-3.0-or-later */
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
#include "proof/model/limit.h"

static const double FIRST_STRIP = 0.05, LAST_STRIP = 1e-15;

/* Estimates the growth at which the margin is 0. The train must seem to keep falling at `low` and to stop at
 * `high`. */
static double root_between(struct proof *proof, double low, double high, double *top)
{
    double at_low = proof_guess(proof, low, top), at_high = proof_guess(proof, high, top);
    for (int k = 0; k < 80 && high - low > 2e-16 * high && !proof_interrupted(proof); k++) {
        double at = low - at_low * (high - low) / (at_high - at_low);
        if (k % 3 == 2 || !(at > low && at < high))
            at = 0.5 * (low + high);
        if (!(at > low && at < high))
            break;
        double margin = proof_guess(proof, at, top);
        if (margin > 0) {
            low = at;
            at_low = margin;
        } else {
            high = at;
            at_high = margin;
        }
    }
    return low;
}

/* A grid of decimal numbers n / unit, where n is an integer and unit = 10^decimals. The two ends of an
 * enclosure are such numbers, so they can be printed exactly. */
struct grid {
    double unit;
    int decimals;
};

static struct grid grid_for(double r, double tol)
{
    struct grid grid = {1, 0};
    while (1 / grid.unit > tol * r * (1 + 1e-9) && r * grid.unit < 0x1p49) {
        grid.unit *= 10;
        grid.decimals++;
    }
    return grid;
}

/*
 * Finds a decimal number above n / unit at which the train is proved to stop. The double r that is nearest to
 * this number may be a little smaller or larger than the number. So the proof covers the whole interval
 * between the two neighbours of r.
 */
static bool stops_after(struct proof *proof, const struct grid *grid, double n, double top, double *high)
{
    for (int more = 1; more <= 256; more *= 2) {
        double r = (n + more) / grid->unit, low = nextafter(r, 0), above = nextafter(r, INFINITY);
        if (low * proof->shape.s.hi < 1 && proof_stops(proof, low, above, top)) {
            *high = r;
            return true;
        }
    }
    return false;
}

/* Tries to prove that the train keeps falling for all growths from *done to n / unit. If the outcome is
 * OUTCOME_OPEN, tries (n - 1) / unit, then (n - 2) / unit, then (n - 4) / unit, and so on. */
static bool goes_on_before(struct proof *proof, const struct grid *grid, double n, double *done, double *stop,
                           struct limit_proof *limit)
{
    for (int less = 0; less <= 1024; less = less > 0 ? 2 * less : 1) {
        double end = nextafter((n - less) / grid->unit, INFINITY);
        limit->low = (n - less) / grid->unit;
        if (limit->low < limit->from)
            break;
        limit->outcome = OUTCOME_PROVED;
        if (*done < end)
            limit->outcome = proof_range(proof, done, end, larger(1e-3 / grid->unit, LAST_STRIP * end), stop);
        if (limit->outcome != OUTCOME_OPEN)
            break;
    }
    return limit->outcome == OUTCOME_PROVED;
}

/*
 * Estimates the growth between *done and `high` at which the margin is 0 (the root). Tries to prove that the
 * train keeps falling for all growths up to limit->low, slightly below the root. Also tries to prove that the
 * train stops at limit->high, slightly above the root.
 *
 * Returns false if a proof fails, with the reason in limit->outcome. If the reason is OUTCOME_REFUTED, the
 * train already stops at a smaller growth, and *stop is that growth.
 */
static bool bracket_prove(struct proof *proof, double tol, double *done, double high, double *stop,
                          struct limit_proof *limit)
{
    double top, root = root_between(proof, *done, high, &top);
    *stop = NAN;
    limit->outcome = OUTCOME_OPEN;
    proof_guess(proof, root, &top);
    if (proof_interrupted(proof)) {
        limit->outcome = OUTCOME_INTERRUPTED;
        return false;
    }
    /* With few decimal places, the number just above the root may lie beyond the next root, where the train
     * keeps falling again, or beyond 1/s. The number just below the root may lie below limit->from. So try
     * again with more decimal places. */
    for (int finer = 0; finer < 9; finer++, tol /= 10) {
        struct grid grid = grid_for(root, tol);
        double n = floor(root * grid.unit);
        limit->decimals = grid.decimals;
        if (!stops_after(proof, &grid, n, top, &limit->high))
            continue;
        if (n / grid.unit <= limit->from)
            continue;
        if (goes_on_before(proof, &grid, n, done, stop, limit)) {
            limit->kind = LIMIT_BRACKET;
            return true;
        }
        break;
    }
    return false;
}

static struct limit_proof limit_from(struct proof *proof, double from, double tol)
{
    struct limit_proof limit = {
        .kind = LIMIT_PARTLY, .from = from, .low = from, .high = INFINITY, .decimals = 17};
    double end = up(1 / proof->shape.s.lo), width = FIRST_STRIP, done = from;
    while (done < end && width > LAST_STRIP * done) {
        double next = smaller(done + width, end), top;
        limit.outcome = proof_strip(proof, done, next);
        if (limit.outcome == OUTCOME_PROVED) {
            done = next;
            width *= 2;
            continue;
        }
        if (limit.outcome == OUTCOME_LIMIT || limit.outcome == OUTCOME_INTERRUPTED)
            break;
        bool stops = limit.outcome == OUTCOME_REFUTED || (next < end && proof_guess(proof, next, &top) < 0);
        while (stops) {
            double stop;
            if (bracket_prove(proof, tol, &done, next, &stop, &limit))
                return limit;
            stops = limit.outcome == OUTCOME_REFUTED;
            next = stop;
        }
        if (limit.outcome == OUTCOME_LIMIT || limit.outcome == OUTCOME_INTERRUPTED)
            break;
        width /= 2;
    }
    if (done >= end)
        limit.kind = LIMIT_REACH;
    limit.low = done;
    return limit;
}

/*
 * A pair that stops at r = 1 may keep falling at larger growths. Finds such a growth, at which the search can
 * begin: estimates the smallest growth at which the margin is 0, and returns a growth above it at which the
 * pair provably keeps falling. Returns NaN if no proof succeeds.
 */
static double band_begin(struct proof *proof)
{
    enum { SAMPLES = 400 };
    double last = 1, reach = 1 / proof->shape.s.hi, top;
    for (int k = 1; k <= SAMPLES; k++) {
        double r = 1 + (reach - 1) * k / (SAMPLES + 1);
        if (proof_guess(proof, r, &top) > 0) {
            double low = last, high = r;
            for (int step = 0; step < 24; step++) {
                double at = 0.5 * (low + high);
                if (proof_guess(proof, at, &top) > 0)
                    high = at;
                else
                    low = at;
            }
            double from = ceil(high * 1e6) / 1e6;
            if (from < r && proof_strip(proof, from, from) == OUTCOME_PROVED)
                return from;
            if (proof_strip(proof, r, r) == OUTCOME_PROVED)
                return r;
            return NAN;
        }
        last = r;
    }
    return NAN;
}

struct limit_proof limit_prove(struct proof *proof, double tol)
{
    double top, from = 1;
    enum outcome first = proof_strip(proof, 1, 1);
    if (first == OUTCOME_PROVED)
        return limit_from(proof, 1, tol);
    proof_guess(proof, 1, &top);
    bool none = proof_stops(proof, 1, 1, top);
    if (none && proof->shape.pair) {
        from = band_begin(proof);
        if (from > 1)
            return limit_from(proof, from, tol);
        none = !proof_interrupted(proof);
    }
    return (struct limit_proof){.kind = none ? LIMIT_NONE : LIMIT_PARTLY,
                                .from = 1,
                                .low = NAN,
                                .high = none ? 1 : INFINITY,
                                .outcome = proof_interrupted(proof) ? OUTCOME_INTERRUPTED : first};
}
