/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_PROOF_LIMIT_H
#define DOM_PROOF_LIMIT_H

#include "proof/cover.h"

enum limit_kind {
    LIMIT_BRACKET, /* the train keeps falling at every growth from `from` to `low`, and stops at `high` */
    LIMIT_REACH,   /* the train keeps falling at every growth from `from` up to 1/s */
    LIMIT_NONE,    /* the train stops at r = 1, and no larger growth was found at which it keeps falling */
    /* the train keeps falling at every growth from `from` to `low`; nothing is proved for larger growths */
    LIMIT_PARTLY
};

/* What has been proved about the largest growth. */
struct limit_proof {
    enum limit_kind kind;
    double from, low, high;
    /* number of decimal places; `low` and `high` are the doubles nearest to decimals with so many places */
    int decimals;
    enum outcome outcome; /* with LIMIT_PARTLY, the reason why nothing more is proved */
};

/* Encloses the first growth at which the train stops, as r is raised from 1, with the relative tolerance
 * `tol`. */
struct limit_proof limit_prove(struct proof *proof, double tol);

#endif
