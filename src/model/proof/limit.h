/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_PROOF_LIMIT_H
#define DOM_PROOF_LIMIT_H

#include "proof/cover.h"

enum limit_kind {
    LIMIT_BRACKET, /* the train keeps falling for all growths in [from, low], and stops at `high` */
    LIMIT_REACH,   /* the train keeps falling for all growths in [from, 1/s] */
    /* the train stops at r = 1; no larger growth was found at which the train keeps falling */
    LIMIT_NONE,
    /* the train keeps falling for all growths in [from, low]; nothing is proved about larger growths */
    LIMIT_PARTLY
};

/* What has been proved about the growths at which the train keeps falling or stops. */
struct limit_proof {
    enum limit_kind kind;
    double from, low, high;
    /* `low` and `high` are the doubles nearest to numbers with this many decimal places */
    int decimals;
    enum outcome outcome; /* if kind is LIMIT_PARTLY, the reason why nothing more is proved */
};

/* Finds two close numbers and proves that the smallest growth at which the train stops lies between them. The
 * relative difference of the two numbers is about `tol`. */
struct limit_proof limit_prove(struct proof *proof, double tol);

#endif
