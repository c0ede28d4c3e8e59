/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Answers with a proof: each is a pair of bounds between which the true answer surely is.
 *
 * The functions of <domino.h> compute answers to a tolerance. The functions of this header prove bounds, by
 * interval arithmetic in double with outward rounding, and share no formula with the others. domino-model(7)
 * has the proof.
 *
 * A proof holds for all trains whose s, d and q (unless q is a whole number) round to the doubles given:
 * decimals and fractions such as 7/48 are among them. A train with friction or a slope has no proof. In
 * another rounding mode than to nearest, nothing is proved.
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
    X(EFFECT, "trains with friction, a slope or rounded edges have no proof")                                \
    X(ROUNDING, "the two sides differ by less than the rounding of double precision")                        \
    X(BOXES, "the proof takes more boxes or dominoes than are allowed")                                      \
    X(INTERRUPTED, "interrupted")                                                                            \
    X(MODE, "the rounding mode is not to nearest: call fesetround(FE_TONEAREST) first")

enum dom_proof_gap {
#define DOM_PROOF_GAP_ENUM(name, text) DOM_PROOF_##name,
    DOM_PROOF_GAPS(DOM_PROOF_GAP_ENUM)
#undef DOM_PROOF_GAP_ENUM
};

/* Returns the meaning of a gap: one line without a full stop. */
const char *dom_proof_gap_text(enum dom_proof_gap gap);

/* The work that a proof took. */
struct dom_proof_work {
    size_t boxes;  /* parts of the plane of tilts and growths */
    size_t chains; /* passes down the train */
};

/* What is proved about the largest growth. */
enum dom_proof_end {
    DOM_PROVED_BARRIER, /* every growth from `from` to `low` goes on; at `high` the train stops */
    DOM_PROVED_REACH,   /* every growth from `from` up to 1/s goes on; low <= 1/s <= high */
    DOM_PROVED_NONE,  /* the train stops at r = 1; for a pair, no larger growth was found that goes on either
                       */
    DOM_PROVED_PARTLY /* every growth from `from` to `low` goes on, or none is proved if `low` is NaN; see
                         `gap` */
};

struct dom_proof {
    enum dom_proof_end ends;
    /* 1, or a growth in the band that goes on, for a pair in which equal dominoes fail but larger ones
     * succeed. */
    double from;
    double low;   /* r_max >= low; NaN with DOM_PROVED_NONE */
    double high;  /* r_max <= high; infinite if no bound is proved */
    int decimals; /* with DOM_PROVED_BARRIER, the number of decimal places of low and high */
    enum dom_proof_gap gap;
    struct dom_proof_work work;
};

/*
 * Prove bounds of the largest growth of a train, or of a pair, as dom_limit_rmax and dom_limit_pair find it.
 * The bounds are decimals with a relative distance of compute->tol, but at least 1e-15. Rounding may leave
 * them farther apart, and they are true then as well. Of compute only tol and interrupt are used. After an
 * interrupt the status is DOM_OK, and the gap is DOM_PROOF_INTERRUPTED. Other statuses are DOM_BAD_... and
 * DOM_NO_MEMORY.
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
    struct dom_proof_work work;
};

/* Proves whether a train goes on at train->r and at all growths that round to this double, and bounds of its
 * barrier, as dom_barrier_find finds it. The statuses are those of dom_prove_rmax. */
enum dom_status dom_prove_cycle(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_proof_cycle *proof);

/*
 * Proves bounds of the smallest n with first r^n >= height, as dom_count_find finds it: `least` <= n <=
 * `most`. The bounds differ if the last digit of a height or of r decides. For powers that are exact in
 * double, such as those of r = 2, the doubles themselves decide. Infinity means that no n is enough. If
 * nothing is proved, the bounds are 0 and infinity. The status is DOM_BAD_HEIGHT or DOM_BAD_R for a number
 * outside its range.
 */
enum dom_status dom_prove_count(double first, double height, double r, double *least, double *most);

#ifdef __cplusplus
}
#endif

#endif
