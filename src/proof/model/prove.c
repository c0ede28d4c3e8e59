/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The public functions of <domino_proof.h>. They check their arguments and then run the proof. */
#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_proof.h"
#pragma GCC visibility pop
#include "proof/model/cover.h"

#include <fenv.h>

const char *dom_proof_gap_text(enum dom_proof_gap gap)
{
    static const char *const text[] = {
#define GAP_TEXT(name, text) [DOM_PROOF_##name] = text,
        DOM_PROOF_GAPS(GAP_TEXT)
#undef GAP_TEXT
    };
    return text[gap];
}

static enum dom_status train_check(const struct dom_train *t, double tol)
{
    const struct {
        double value, lowest, highest;
        enum dom_status status;
    } range[] = {
#define BAD_s                                                 DOM_BAD_S
#define BAD_r                                                 DOM_BAD_R
#define BAD_d                                                 DOM_BAD_D
#define BAD_q                                                 DOM_BAD_Q
#define BAD_width                                             DOM_BAD_WIDTH
#define RANGE(name, default_, lowest, highest, unit, meaning) {t->name, lowest, highest, BAD_##name},
        DOM_TRAIN_PARAMETERS(RANGE)
#undef RANGE
    };
    for (size_t k = 0; k < sizeof range / sizeof *range; k++)
        if (!(range[k].value >= range[k].lowest && range[k].value <= range[k].highest))
            return range[k].status;
    if (t->fuel != DOM_FUEL_EXACT && t->fuel != DOM_FUEL_PAPER)
        return DOM_BAD_FUEL;
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
/* dom_compute_default is not called, because a program that uses only <domino_quad.h> does not link it. */
#define DEFAULT(name, default_, lowest, highest, unit, meaning) default_
    return compute ? compute->tol : DOM_COMPUTE_PARAMETERS(DEFAULT);
#undef DEFAULT
}

/* Checks the arguments and prepares a proof. If no proof can be attempted, sets *gap to the reason. Call
 * proof_end afterwards. */
static enum dom_status begin(struct proof *proof, const struct dom_train *train,
                             const struct dom_compute *compute, bool pair, enum dom_proof_gap *gap)
{
    *proof = (struct proof){.links = NULL};
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
    proof_end(&proof);
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
        double at = smaller(top, upright_hit_below(&proof->box));
        barrier.lo = least_0(climb_find(&proof->box, at, at, false).height.lo);
    }
    double kinetic = larger(proof->box.kinetic.value.hi, 0);
    *outcome = OUTCOME_OPEN;
    for (double more = larger(tol * (barrier.lo + kinetic), 1e-16); more < 1 && *outcome == OUTCOME_OPEN;
         more *= 4) {
        *outcome = proof_below(proof, low, high, barrier.lo + more);
        if (*outcome == OUTCOME_PROVED)
            barrier.hi = up(barrier.lo + more);
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
    else if (fuel && (margin.lo >= 0 || proof_strip(proof, low, high) == OUTCOME_PROVED))
        result->verdict = DOM_PROVED_GOES_ON;
    else
        result->gap = proof_interrupted(proof)    ? DOM_PROOF_INTERRUPTED
                      : outcome == OUTCOME_PROVED ? DOM_PROOF_ROUNDING
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
    proof_end(&proof);
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

enum { POWERS_MOST = 100000 };

/*
 * Finds bounds on the smallest n with first * r^n >= height, by multiplying. The bounds are infinite if no n
 * is large enough, and NaN if n may exceed POWERS_MOST. Returns true if all products are exact.
 */
static bool count_by_products(struct span first, struct span r, struct span height, double *least,
                              double *most)
{
    struct span tall = first, before = {0, 0};
    *least = *most = DOM_NAN;
    for (int n = 0; n < POWERS_MOST && isnan(*most); n++) {
        const bool grows = tall.lo > before.lo, may_grow = tall.hi > before.hi;
        if (isnan(*least) && (tall.hi >= height.lo || !may_grow))
            *least = may_grow ? n : HUGE_VAL;
        if (!isnan(*least) && (tall.lo >= height.hi || !grows))
            *most = grows ? n : HUGE_VAL;
        before = tall;
        tall = (struct span){product_below(tall.lo, r.lo), product_above(tall.hi, r.hi)};
    }
    return before.lo == before.hi && !isnan(*most);
}

/* Finds bounds on the smallest n with first * r^n >= `height`, for an n that is too large for
 * count_by_products. This n is ln(height/first)/ln r, rounded up. `height` must be larger than `first`. */
static void count_by_logarithms(double first, double height, double r, double *least, double *most)
{
    struct span growth = {larger(1, down(r)), up(r)},
                ratio = span_over(span_around(height), span_around(first));
    if (!span_finite(ratio)) {
        *least = POWERS_MOST;
        *most = INFINITY;
        return;
    }
    ratio.lo = larger(ratio.lo, 1);
    struct span n = span_over(span_log(ratio), span_log(growth));
    *least = ceil(larger(0, n.lo));
    *most = isfinite(n.hi) ? ceil(n.hi) : HUGE_VAL;
}

enum dom_status dom_prove_count(double first, double height, double r, double *least, double *most)
{
    if (!(first > 0 && height > 0 && isfinite(first) && isfinite(height)))
        return DOM_BAD_HEIGHT;
    if (!(r >= 1 && isfinite(r)))
        return DOM_BAD_R;
    if (fegetround() != FE_TONEAREST) {
        *least = 0;
        *most = INFINITY;
        return DOM_OK;
    }
    /*
     * If all products are exact, the number of dominoes is computed exactly, for these very arguments.
     * Otherwise only bounds are found. The bounds hold not only for these arguments, but for all numbers that
     * round to them.
     */
    if (count_by_products(span_of(first), span_of(r), span_of(height), least, most))
        return DOM_OK;
    count_by_products(span_around(first), (struct span){larger(1, down(r)), up(r)}, span_around(height),
                      least, most);
    if (isnan(*least))
        count_by_logarithms(first, height, r, least, most);
    *most = isnan(*most) ? HUGE_VAL : *most;
    return DOM_OK;
}
