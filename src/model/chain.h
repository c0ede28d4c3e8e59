/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The train behind the head at one tilt: its dominoes in order, and the sums over them.
 * A finite train has n dominoes (c1); the endless one, CHAIN_ENDLESS, is followed until its tail,
 * bounded by a geometric series, no longer matters at the tolerance.
 */
#ifndef DOM_CHAIN_H
#define DOM_CHAIN_H

#include "lean.h"

#define CHAIN_ENDLESS SIZE_MAX

struct link {
    size_t i;
    struct tilt tilt;
    struct turn turn; /* to the follower, where it leads one */
    real step;        /* slope of the lean to the follower, theta_{i+1}' / theta_i' */
    real slope;       /* theta_i' (A9) */
    real weight;      /* r^-(q i) */
    real inertia;     /* r^-((q+1) i) */
    bool leads;       /* a follower leans on it */
};

KERNEL struct link link_head(const struct lean *lean, struct tilt head);
KERNEL void link_next(const struct lean *lean, struct link *link);

struct sums {
    real J;    /* (c2) */
    real H1;   /* dH/dtheta = sum r^(-q i) theta_i' (d cos theta_i - sin theta_i) */
    real dH;   /* H(theta) - H(0); only from chain_rise */
    real left; /* the part of it in a follower that has left during the cycle */
    size_t n;  /* dominoes followed */
};

/* The sign of H1 alone, right to rounding, from as few dominoes as show it. */
KERNEL enum dom_status chain_sign(const struct lean *lean, struct tilt head, size_t n, real *H1);

/* J and H1 of at most n dominoes. */
KERNEL enum dom_status chain_sum(const struct lean *lean, struct tilt head, size_t n, struct sums *sums);

/* J, H1 and dH; and, where error is not NULL, bounds of their errors (bound.h). */
KERNEL enum dom_status chain_rise(const struct lean *lean, struct tilt head, size_t n, struct sums *sums,
                                  struct sums *error);

/*
 * The tilt of the head at which one of the first n dominoes falls off; false where none does within
 * the cycle.  domino, unless NULL, gets its number.  One at most does: the train at theta_c is the train at
 * 0, shifted by one.
 */
KERNEL enum dom_status chain_leave(const struct lean *lean, size_t n, bool *leaves, struct tilt *head,
                                   size_t *domino);

#endif
