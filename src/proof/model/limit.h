/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_PROOF_LIMIT_H
#define DOM_PROOF_LIMIT_H

#include "proof/model/cover.h"

enum limit_kind {
    LIMIT_BRACKET, /* the train keeps falling for all growths in [from, low], and stops at `high` */
    LIMIT_REACH,   /* the train keeps falling for all growths in [from, 1/s] */
    /* the train stops at r = 1; if it is a pair, no larger growth was found at which it keeps falling */
    LIMIT_NONE,
    /* if `low` is not NaN, the train keeps falling for all growths in [from, low]; if `high` is finite, the
     * train stops at `high` */
    LIMIT_PARTLY
};

/* What has been proved about the growths at which the train keeps falling or stops. */
struct limit_proof {
    enum limit_kind kind;
    double from, low, high;
    int decimals;         /* with LIMIT_BRACKET, the number of decimal places of `low` and `high` */
    enum outcome outcome; /* with LIMIT_PARTLY, the reason why nothing more is proved */
};

/* Tries to prove that the smallest growth above `from` at which the train stops lies between `low` and
 * `high`. If the proof succeeds (LIMIT_BRACKET), the relative difference between `low` and `high` is about
 * `tol`. */
struct limit_proof limit_prove(struct proof *proof, double tol);

#endif
