/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums over the dominoes of a chain, compensated for rounding. */
#ifndef DOM_SUMS_H
#define DOM_SUMS_H

#include "geometry/link.h"

struct sums {
    real J;  /* (20; c2) */
    real H1; /* dH/dtheta = sum r^(-q i) theta_i' h_i'(theta_i) */
    /* The second derivative d2H/dtheta2, found by PASS_SECOND_DERIVATIVE. H2 is less accurate
     * than the other sums: its rounding errors are not compensated, and the test for the end of the pass does
     * not look at its tail. */
    real H2;
    /* H(theta) - H(0), or H(theta) minus H at another tilt. Only in passes that compare two tilts. */
    real dH;
    real left; /* part of dH due to a follower that has detached in the cycle */
    size_t n;  /* number of dominoes in the sums */
    /* True if the contacts of all dominoes that the pass visits are proved to stay closed between the two
     * tilts. Valid only with PASS_PUSHES. */
    bool pushes;
};

/* The largest number of dominoes in a pass. A pass of this length takes tens of milliseconds. Few trains
 * would need more dominoes: at r = 1, only those with sqrt(s (s + 2 d)) < 2e-5. */
#define LINKS_MAX ((size_t)2000000)

/* The tail of a sum may be at most this fraction of the tolerance. A result that combines several sums then
 * stays within the tolerance. */
#define TAIL_SHARE ((real)0.125)

/* A compensated sum. */
struct series {
    real sum, size; /* sum of the terms, and sum of their absolute values */
    real lost;      /* sum of the rounding errors, to be added at the end */
};

struct sum_state {
    struct series J, H1, dH;
    real left;
};

/* Adds a term by Fast2Sum, which needs the larger number first. */
KERNEL_LOOP void series_add(struct series *s, real term)
{
    real sum = s->sum + term;
    s->lost += fabs(s->sum) >= fabs(term) ? (s->sum - sum) + term : (term - sum) + s->sum;
    s->sum = sum;
    s->size += fabs(term);
}

/*
 * Returns true when the remaining terms can be left out. `term` is an upper bound on the last term. `ratio`
 * is an upper bound on the ratio of each later term to the term before it. A tail below the unit roundoff of
 * the sum is always left out.
 */
KERNEL_LOOP bool series_done(const struct series *s, real term, real ratio, real tol)
{
    return term * ratio <= (1 - ratio) * fmax(TAIL_SHARE * tol * fabs(s->sum), ROUNDOFF / 2 * s->size);
}

KERNEL void chain_count(const struct geometry *geometry, size_t n)
{
    if (geometry->effort)
        *geometry->effort += n;
    if (!geometry->work)
        return;
    geometry->work->passes++;
    geometry->work->dominoes += n;
    geometry->work->longest = n > geometry->work->longest ? n : geometry->work->longest;
}

/* Stops a pass or a search that takes too long, or that the user interrupts. Checks this only at every 4096th
 * domino. */
KERNEL_LOOP enum dom_status chain_watch(const struct geometry *geometry, size_t i)
{
    if (i % CHECK_EVERY != 0)
        return DOM_OK;
    if (dom_interrupted(geometry->interrupt))
        return DOM_INTERRUPTED;
    if (geometry->effort && *geometry->effort + i > geometry->effort_most)
        return DOM_TOO_LONG;
    if (i < LINKS_MAX)
        return DOM_OK;
    chain_count(geometry, i); /* the pass fails, but its work was done and must be counted */
    return DOM_TOO_LONG;
}

#endif
