/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The chain of followers at one tilt of the head. A pass visits the dominoes from the head down and computes
 * sums over them, such as the energy H of equation (19; c1). The pass ends after geometry->n dominoes. It
 * ends earlier at a domino whose follower has detached, or if a geometric series shows that the remaining
 * terms are negligible at the tolerance.
 */
#pragma once

#include "geometry/link.h"
#include "numerics/numerics.h"

/* ---- The sums of a pass, compensated for rounding ---- */

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

/* ---- The passes ---- */

/* Builds the series geometry->far of an endless train with sharp edges, if they save time in `passes` passes.
 */
KERNEL void far_make(struct geometry *geometry, int passes);

/* The far tail: a domino with its tilts in two chains, the tangent of half the angle between them and the
 * members of its struct link in chain a, and all dominoes behind it. dH, H1, J and H2 are their terms in the
 * sums. */
struct far_tail {
    struct tilt a, b;
    real t, weight, inertia, slope, second_derivative;
    real dH, H1, J, H2;
};

/* Finds the terms, which are to be added to `sum`. Returns 0. If the series are not accurate enough at these
 * tilts, returns the value of 1 - cos theta from which on they probably are. */
KERNEL real far_find(const struct geometry *geometry, struct far_tail *tail, struct sum_state sum);

/* Finds J and H1. If `sign` is true, only the sign of H1 is reliable, and the pass ends early. */
KERNEL enum dom_status chain_sum(const struct geometry *geometry, struct tilt head, bool sign,
                                 struct sums *sums);

/* The passes that compare two chains: one whose head is at the tilt `head`, and one with its head at `from`.
 * Each pass computes J and dH = H(head) - H(from). */
enum pass {
    PASS_PLAIN,             /* also H1 */
    PASS_SECOND_DERIVATIVE, /* also H1 and H2 */
    PASS_PUSHES,            /* also H1; tries to prove that all contacts push */
    /* For a train with its head at theta_c, compared with the upright one. During the cycle, each domino
     * turns to the initial tilt of its follower. So one chain is enough: the chain at theta_c, shifted by one
     * domino, is the chain at 0. */
    PASS_FUEL
};

/* Does the pass. If the tilt `from` is not upright, no domino may detach between the two tilts. */
KERNEL_SHARED enum dom_status chain_change(const struct geometry *geometry, struct tilt from,
                                           struct tilt head, enum pass pass, struct sums *sums);

/* Does the same as chain_change. t is the tangent of half the angle between the tilts `from` and `head`. If
 * they are close, computing t from the two tilts would be inaccurate. */
KERNEL enum dom_status chain_change_by(const struct geometry *geometry, struct tilt from, struct tilt head,
                                       real t, enum pass pass, struct sums *sums);

/* Finds J, H1 and H(theta) - H(0) at theta in [0, theta_c]. */
KERNEL enum dom_status chain_energy_at(const struct geometry *geometry, real theta, struct sums *sums);

/* The equation of motion at one tilt of the head: (A/2) dw/dtheta + B w = C. Without friction, A is J, B is
 * half of dJ/dtheta, and C is -H1/2. */
struct equation_of_motion {
    real A, B, C;
    /* Sums of the absolute values of all terms, from which rounding errors are estimated. If digits cancel
     * inside a term, these sums are increased. */
    real A_size, B_size, C_size;
    /* True if no acceleration satisfies the equation (Painleve): A <= 0, or some arm b <= 0. */
    bool locks;
    size_t n;
};
KERNEL enum dom_status chain_equation(const struct geometry *geometry, struct tilt head,
                                      struct equation_of_motion *equation);

/* Finds tau^2 times the angular acceleration of the head: half of dw/dtheta, from the equation of motion,
 * with or without losses. `w` is tau^2 omega^2 at the tilt `head`. Unless n is NULL, sets *n to the number of
 * dominoes that contribute. */
KERNEL enum dom_status chain_acceleration(const struct geometry *geometry, struct tilt head, real w,
                                          real *acceleration, size_t *n);

/*
 * Part of a proof that no contact of a chain opens while the head moves. Tests one contact while its leader
 * moves from b to a. If every contact of the chain passes its test, all of them stay closed during the
 * motion. If only some contacts pass, nothing is proved about any of them. If there is no proof for the whole
 * motion, both halves of the motion are tried, because the bounds are tighter there. A motion is halved at
 * most `halvings` times in succession.
 */
enum { PUSHES_HALVINGS = 4 };
KERNEL_SHARED bool contact_pushes(const struct link *a, const struct link *b, int halvings);

/*
 * Finds the tilt of the head at which a domino detaches. At most one domino detaches while the head moves
 * from 0 to theta_c, since the train at theta_c is the train at 0 shifted by one domino. If no domino
 * detaches, or only one that contributes less than the rounding errors, *leaves is false. Unless `domino` is
 * NULL, *domino receives the number of the domino that detaches.
 */
KERNEL enum dom_status chain_leave(const struct geometry *geometry, bool *leaves, struct tilt *head,
                                   size_t *domino);

/*
 * Divides the motion up to the tilt `end` into pieces in which the sums are smooth functions of the tilt. The
 * array `edge` receives the tilts of the head at which the pieces begin and end:
 * - edge[0] is 0. If the head only just reaches the next domino, edge[0] is slightly above 0.
 * - If a domino detaches before `end`, the tilt at that moment is the next edge. From this edge on, the
 *   detached domino no longer moves.
 * - The last edge is `end`.
 *
 * *edges receives the number of edges. Unless `moving` is NULL, *moving receives the number of dominoes that
 * move in the first piece. If no domino detaches, this number is CHAIN_ENDLESS.
 */
enum { CHAIN_EDGES = 3 };
KERNEL enum dom_status chain_edges(const struct geometry *geometry, real end, real edge[CHAIN_EDGES],
                                   int *edges, size_t *moving);

/* Combines the status of a solver with the status of the function that it evaluated. An error of the function
 * takes precedence, because it tells why the solver failed. */
static inline enum dom_status model_status(enum dom_status function, enum num_status solver)
{
    static const enum dom_status of[] = {
        [NUM_OK] = DOM_OK,
        [NUM_NOT_BRACKETED] = DOM_NOT_CONVERGED,
        [NUM_NOT_FINITE] = DOM_NOT_FINITE,
        [NUM_NOT_CONVERGED] = DOM_NOT_CONVERGED,
        [NUM_NO_MEMORY] = DOM_NO_MEMORY,
    };
    return function != DOM_OK ? function : of[solver];
}
