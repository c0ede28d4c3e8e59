/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The chain of followers at one tilt of the head. A pass visits the dominoes from the head down and computes
 * sums over them, such as the energy H of equation (19; c1). The pass ends after geometry->n dominoes. It
 * ends earlier at a domino whose follower has detached, or if a geometric series shows that the remaining
 * terms are negligible at the tolerance.
 */
#ifndef DOM_CHAIN_H
#define DOM_CHAIN_H

#include "geometry/sums.h"
#include "numerics/numerics.h"

/* Finds J and H1. */
KERNEL enum dom_status chain_sum(const struct geometry *geometry, struct tilt head, struct sums *sums);

/* Finds H1. If `sign` is true, only its sign is reliable, and the pass ends early. */
KERNEL enum dom_status chain_slope(const struct geometry *geometry, struct tilt head, bool sign, real *H1);

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
KERNEL bool contact_pushes(const struct walk *a, const struct walk *b, int halvings);

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

#endif
