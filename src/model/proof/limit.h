/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_PROOF_LIMIT_H
#define DOM_PROOF_LIMIT_H

#include "proof/cover.h"

enum limit_kind {
    LIMIT_BRACKET, /* every growth from `from` to `low` goes on, and at `high` the train stops */
    LIMIT_REACH,   /* every growth from `from` up to 1/s goes on */
    LIMIT_NONE,    /* r = 1 stops, and no larger growth was found that goes on */
    LIMIT_PARTLY   /* every growth from `from` to `low` goes on; nothing is proved of those after it */
};

/* What is proved of the largest growth. */
struct limit_proof {
    enum limit_kind kind;
    double from, low, high;
    int decimals;         /* number of decimal places of the numbers, each of which is the nearest double */
    enum outcome outcome; /* with LIMIT_PARTLY, the reason why no more is proved */
};

/* Proves where the first growth is, raised from 1, at which the train stops, within a relative tolerance. */
struct limit_proof limit_prove(struct proof *proof, double tol);

#endif
