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
#include "proof/model/cover.h"

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
    for (int k = 0; k < 80 && high - low > 2e-16 * high && !proof_interrupted(proof); k++) {
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
    s->outcome = proof_interrupted(s->proof) ? OUTCOME_INTERRUPTED : OUTCOME_OPEN;
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
        s->outcome = proof_strip(s->proof, s->done, next);
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
        if (from < r && proof_strip(proof, from, from) == OUTCOME_PROVED)
            return from;
        return proof_strip(proof, r, r) == OUTCOME_PROVED ? r : (double)NAN;
    }
    return NAN;
}

enum outcome limit_prove(struct proof *proof, double tol, struct dom_proof *found)
{
    struct search s = {.proof = proof, .tol = tol, .done = 1, .found = found};
    double top;
    *found = (struct dom_proof){
        .ends = DOM_PROVED_PARTLY, .from = 1, .low = NAN, .high = INFINITY, .decimals = 17};
    s.outcome = proof_strip(proof, 1, 1);
    if (s.outcome != OUTCOME_PROVED) {
        proof_guess(proof, 1, &top);
        const bool stops = proof_stops(proof, 1, 1, top);
        const double from = stops && proof->shape.pair ? band_begin(proof) : (double)NAN;
        if (from > 1)
            s.done = found->from = from;
        else if (proof_interrupted(proof))
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
