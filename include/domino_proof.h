/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Other ways to compute, for comparison with <domino.h>: proofs, and the paper's own recipe.
 *
 * A proved result is a pair of bounds that certainly enclose the true value.
 *
 * The functions of <domino.h> compute results to a tolerance. dom_prove_... prove bounds by interval
 * arithmetic, in double with outward rounding. They share no formula with <domino.h>.
 * domino-model(7) explains the proof.
 *
 * A double can only approximate a fraction such as 7/48, and most decimals. So a proof holds for all trains
 * whose s, d and q round to the given doubles. The train that the caller meant, with d = 7/48 for instance,
 * is one of them. If q is a whole number, it is taken as exact.
 *
 * There is no proof for trains with effects that change their motion. Nothing is proved unless the
 * rounding mode is round-to-nearest.
 */
#ifndef DOMINO_PROOF_H
#define DOMINO_PROOF_H

#include "domino.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Why a proof is incomplete: X(name, meaning). */
#define DOM_PROOF_GAPS(X)                                                                                    \
    X(NONE, "nothing is missing")                                                                            \
    X(EFFECT, "there is no proof for trains with effects that change their motion")                          \
    X(ROUNDING, "the energy and the barrier differ by less than the rounding error of double precision")     \
    X(BOXES, "the proof would have to examine more rectangles or dominoes than the limit allows")            \
    X(INTERRUPTED, "interrupted")                                                                            \
    X(MODE, "the rounding mode is not round-to-nearest: call fesetround(FE_TONEAREST) first")

enum dom_proof_gap {
#define DOM_PROOF_GAP_ENUM(name, text) DOM_PROOF_##name,
    DOM_PROOF_GAPS(DOM_PROOF_GAP_ENUM)
#undef DOM_PROOF_GAP_ENUM
};

/* Returns the meaning of a gap: one line without a full stop. */
const char *dom_proof_gap_text(enum dom_proof_gap gap);

/* What is proved about the largest growth. */
enum dom_proof_end {
    DOM_PROVED_BARRIER, /* the train keeps falling at growths from `from` to `low` and stops at `high` */
    DOM_PROVED_REACH,   /* the train keeps falling at growths from `from` to 1/s; low <= 1/s <= high */
    /* The train stops even at r = 1, or no growth above 1 was found at which the pair provably falls. */
    DOM_PROVED_NONE,
    /* The train keeps falling at every growth from `from` to `low`. If `low` is NaN, nothing is proved.
     * `gap` says why the proof is incomplete. */
    DOM_PROVED_PARTLY
};

struct dom_proof {
    enum dom_proof_end ends;
    double from;  /* the lowest proved growth: 1, except for a pair that succeeds only at larger growths */
    double low;   /* r_max >= low; NaN with DOM_PROVED_NONE */
    double high;  /* r_max <= high; infinite if no bound is proved */
    int decimals; /* with DOM_PROVED_BARRIER, the number of decimal places of `low` and `high` */
    enum dom_proof_gap gap;
};

/*
 * Prove bounds on the largest growth of a train or of a pair, as dom_limit_rmax and dom_limit_pair define it.
 * The bounds are decimal numbers. Their relative distance is compute->tol, or 1e-15 if compute->tol is
 * smaller. Rounding errors may prevent this and leave a larger distance. Even then the bounds are true.
 *
 * Only compute->tol and compute->interrupt are used. After an interrupt the status is DOM_OK, and the gap is
 * DOM_PROOF_INTERRUPTED. Other statuses are DOM_BAD_... and DOM_NO_MEMORY.
 */
enum dom_status dom_prove_rmax(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_proof *proof);
enum dom_status dom_prove_pair(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_proof *proof);

/* What is proved about one growth. */
enum dom_proof_verdict {
    DOM_PROVED_GOES_ON,
    DOM_PROVED_STOPS,        /* the kinetic energy is below the barrier */
    DOM_PROVED_NO_FUEL,      /* P <= 0 */
    DOM_PROVED_OUT_OF_REACH, /* r s > 1 */
    DOM_PROVED_NOTHING       /* `gap` says why */
};

struct dom_interval {
    double low, high;
};

struct dom_proof_cycle {
    enum dom_proof_verdict verdict;
    struct dom_interval kinetic, barrier, margin; /* as in struct dom_barrier; NaN if nothing is proved */
    enum dom_proof_gap gap;
};

/* Proves whether a train keeps falling at the growth train->r. The proof also holds for all other growths
 * that round to this double. Also proves bounds on the kinetic energy, the barrier and the margin of
 * dom_barrier_find. The statuses are those of dom_prove_rmax. */
enum dom_status dom_prove_cycle(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_proof_cycle *proof);

/*
 * Proves bounds on the number n of dominoes: the smallest n with first * r^n >= height, as in dom_count_find.
 * The bounds satisfy *least <= n <= *most. If *least is infinite, no n is large enough. If only *most is
 * infinite, no upper bound is proved. If nothing is proved, the bounds are 0 and infinity.
 *
 * If the products first * r^k, k <= n, are exact in double, as for r = 2, the arguments count as exact.
 * Otherwise the bounds hold for all numbers that round to the arguments. If n depends on that rounding,
 * *least is less than *most.
 * The status is DOM_BAD_HEIGHT or DOM_BAD_R for an argument outside its range.
 */
enum dom_status dom_prove_count(double first, double height, double r, double *least, double *most);

/*
 * The recipe at the end of the paper's section 'A general domino train' raises theta and r in steps of
 * sqrt(tol) / 2, which gives errors of about tol. Each function answers as the function of <domino.h> does
 * whose last word is the same. The status is DOM_NO_METHOD for trains with effects that change their motion,
 * DOM_NOT_CONVERGED if the method fails, and DOM_TOO_LONG for r = 1, where the sums do not converge.
 */
enum dom_status dom_paper_launch(const struct dom_train *train, const struct dom_compute *compute,
                                 struct dom_launch *launch);
enum dom_status dom_paper_barrier(const struct dom_train *train, const struct dom_compute *compute,
                                  struct dom_barrier *barrier);
enum dom_status dom_paper_rmax(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_limit *limit);

#ifdef __cplusplus
}
#endif

#endif
