/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The public functions of <domino_proof.h>. They check their arguments and then run the proof. */
#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_proof.h"
#pragma GCC visibility pop
#include "proof/model/proof.h"

#include <fenv.h>
#include <stdlib.h>

const char *dom_proof_gap_text(enum dom_proof_gap gap)
{
    static const char *const text[] = {
#define GAP_TEXT(name, text) [DOM_PROOF_##name] = text,
        DOM_PROOF_GAPS(GAP_TEXT)
#undef GAP_TEXT
    };
    return text[gap];
}

/* Checks the parameters of a train, but not its effects. The product r s may be too large. */
static enum dom_status train_check(const struct dom_train *t, double tol)
{
    const struct dom_train plain = {
        .s = t->s, .r = t->r, .d = t->d, .q = t->q, .width = t->width, .fuel = t->fuel};
    struct dom_angles angles;
    const enum dom_status status = dom_angles_find(&plain, NULL, &angles);
    if (status != DOM_OK && status != DOM_OUT_OF_REACH && status != DOM_UNDERFLOW)
        return status;
    return tol > 0 && tol <= 0.1 ? DOM_OK : DOM_BAD_TOL;
}

static enum dom_proof_gap gap_of(enum outcome outcome)
{
    return outcome == OUTCOME_INTERRUPTED ? DOM_PROOF_INTERRUPTED
           : outcome == OUTCOME_LIMIT     ? DOM_PROOF_BOXES
                                          : DOM_PROOF_ROUNDING;
}

static double tolerance_of(const struct dom_compute *compute)
{
    return compute ? compute->tol : dom_compute_default().tol;
}

/* Checks the arguments and prepares a proof. If no proof can be attempted, sets *gap to the reason. The
 * caller frees proof->box.link. */
static enum dom_status begin(struct proof *proof, const struct dom_train *train,
                             const struct dom_compute *compute, bool pair, enum dom_proof_gap *gap)
{
    *proof = (struct proof){.box.link = NULL};
    const enum dom_status status = train_check(train, tolerance_of(compute));
    if (status != DOM_OK)
        return status;
/* Walls are allowed, since they do not affect any result of a proof. */
#define OR_ON(effect, member, status) || (DOM_EFFECT_##effect != DOM_EFFECT_walls && train->member != 0)
    const bool has_effect = false DOM_DYNAMICS(OR_ON);
#undef OR_ON
    /* The interval arithmetic in span.h needs this rounding mode, but a caller may have changed the mode. */
    *gap = has_effect ? DOM_PROOF_EFFECT : fegetround() != FE_TONEAREST ? DOM_PROOF_MODE : DOM_PROOF_NONE;
    if (*gap != DOM_PROOF_NONE)
        return DOM_OK;
    struct shape shape = shape_make(train->s, train->d, train->q);
    shape.paper = train->fuel == DOM_FUEL_PAPER;
    shape.pair = pair;
    if (!proof_begin(proof, &shape))
        return DOM_NO_MEMORY;
    proof->interrupt = compute ? compute->interrupt : NULL;
    return DOM_OK;
}

static enum dom_status prove_limit(const struct dom_train *train, const struct dom_compute *compute,
                                   bool pair, struct dom_proof *result)
{
    struct proof proof;
    enum dom_proof_gap gap;
    const enum dom_status status = begin(&proof, train, compute, pair, &gap);
    if (status != DOM_OK)
        return status;
    *result = (struct dom_proof){
        .ends = DOM_PROVED_PARTLY, .from = 1, .low = DOM_NAN, .high = INFINITY, .gap = gap};
    if (gap == DOM_PROOF_NONE) {
        const enum outcome outcome = limit_prove(&proof, larger(tolerance_of(compute), 1e-15), result);
        if (result->ends == DOM_PROVED_PARTLY)
            result->gap = gap_of(outcome);
        result->work = (struct dom_proof_work){proof.boxes, proof.chains};
    }
    free(proof.box.link);
    return DOM_OK;
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

/* Returns a lower and an upper bound on the barrier. The barrier is the largest D, so the value of D at any
 * single tilt is a lower bound. The upper bound is a level that D provably never exceeds. */
static struct span barrier_prove(struct proof *proof, double low, double high, double tol, double top,
                                 enum outcome *outcome)
{
    struct span barrier = {0, INFINITY};
    if (upright_find(&proof->shape, low, high, 1e-17, 0, &proof->box)) {
        double at = smaller(top, proof->box.growth.hit.lo);
        barrier.lo = least_0(climb_find(&proof->box, at, at, false).height.lo);
    }
    double kinetic = larger(proof->box.kinetic.value.hi, 0);
    *outcome = OUTCOME_OPEN;
    for (double more = larger(tol * (barrier.lo + kinetic), 1e-16); more < 1 && *outcome == OUTCOME_OPEN;
         more *= 4) {
        const double level = barrier.lo + more;
        *outcome = proof_strip(proof, low, high, &level);
        if (*outcome == OUTCOME_PROVED)
            barrier.hi = up(level);
    }
    return barrier;
}

static void cycle_prove(struct proof *proof, double r, double tol, struct dom_proof_cycle *result)
{
    double low = larger(1, nextafter(r, 0)), high = nextafter(r, INFINITY), top;
    enum outcome outcome;
    proof_guess(proof, r, &top);
    if (!upright_find(&proof->shape, low, high, 1e-17, 0, &proof->box)) {
        result->gap = DOM_PROOF_BOXES;
        return;
    }
    if (proof->box.fuel.hi <= 0) {
        result->verdict = DOM_PROVED_NO_FUEL;
        return;
    }
    struct span kinetic = proof->box.kinetic.value,
                barrier = barrier_prove(proof, low, high, tol, top, &outcome),
                margin = span_sub(kinetic, barrier);
    bool fuel = proof->box.fuel.lo > 0;
    result->kinetic = (struct dom_interval){kinetic.lo, kinetic.hi};
    result->barrier = (struct dom_interval){barrier.lo, barrier.hi};
    result->margin = (struct dom_interval){margin.lo, margin.hi};
    if (margin.hi < 0)
        result->verdict = DOM_PROVED_STOPS;
    else if (fuel && (margin.lo >= 0 || proof_strip(proof, low, high, NULL) == OUTCOME_PROVED))
        result->verdict = DOM_PROVED_GOES_ON;
    else
        result->gap = dom_interrupted(proof->interrupt) ? DOM_PROOF_INTERRUPTED
                      : outcome == OUTCOME_PROVED       ? DOM_PROOF_ROUNDING
                                                        : gap_of(outcome);
}

enum dom_status dom_prove_cycle(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_proof_cycle *result)
{
    struct proof proof;
    enum dom_proof_gap gap;
    const struct dom_interval none = {DOM_NAN, DOM_NAN};
    const enum dom_status status = begin(&proof, train, compute, false, &gap);
    if (status != DOM_OK)
        return status;
    *result = (struct dom_proof_cycle){
        .verdict = DOM_PROVED_NOTHING, .kinetic = none, .barrier = none, .margin = none, .gap = gap};
    if (gap == DOM_PROOF_NONE) {
        if (span_scale(span_around(train->r), proof.shape.s).lo > 1)
            result->verdict = DOM_PROVED_OUT_OF_REACH;
        else
            cycle_prove(&proof, train->r, larger(tolerance_of(compute), 1e-15), result);
        result->work = (struct dom_proof_work){proof.boxes, proof.chains};
    }
    free(proof.box.link);
    return DOM_OK;
}

/* Returns a bound on a product, and moves it outwards only if the product has a rounding error. */
static double product_below(double a, double b)
{
    const double least = 0x1p-960; /* below this, the rounding error of a product may underflow to 0 */
    return b == 1 || (a * b > least && fma(a, b, -(a * b)) == 0) ? a * b : down(a * b);
}

static double product_above(double a, double b)
{
    return product_below(a, b) == a * b ? a * b : up(a * b);
}

/*
 * Finds bounds on the smallest n with first * r^n >= height, by multiplying. Without an upper bound, *most is
 * infinite. Returns true if all products are exact.
 */
static bool count_by_products(struct span first, struct span r, struct span height, double *least,
                              double *most)
{
    enum { POWERS_MOST = 100000 };
    struct span tall = first;
    int n = 0;
    *least = 0;
    for (; tall.lo < height.hi && n < POWERS_MOST; n++) {
        *least += tall.hi < height.lo;
        tall = (struct span){product_below(tall.lo, r.lo), product_above(tall.hi, r.hi)};
    }
    *most = tall.lo >= height.hi ? n : HUGE_VAL;
    if (r.hi <= 1 && tall.hi < height.lo)
        *least = HUGE_VAL;
    return tall.lo == tall.hi;
}

enum dom_status dom_prove_count(double first, double height, double r, double *least, double *most)
{
    if (!(first > 0 && height > 0 && isfinite(first) && isfinite(height)))
        return DOM_BAD_HEIGHT;
    if (!(r >= 1 && isfinite(r)))
        return DOM_BAD_R;
    *least = 0;
    *most = INFINITY;
    if (fegetround() != FE_TONEAREST)
        return DOM_OK;
    /*
     * If all products are exact, the number of dominoes is computed exactly, for these very arguments.
     * Otherwise only bounds are found. The bounds hold not only for these arguments, but for all numbers that
     * round to them.
     */
    if (!count_by_products(span_of(first), span_of(r), span_of(height), least, most))
        count_by_products(span_around(first), (struct span){larger(1, down(r)), up(r)}, span_around(height),
                          least, most);
    return DOM_OK;
}
