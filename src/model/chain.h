/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The train behind the head at one tilt: its dominoes in order, and the sums over them.
 * A finite train has n dominoes (c1); the endless one, CHAIN_ENDLESS, is followed until its tail,
 * bounded by a geometric series, no longer matters at the tolerance.
 */
#ifndef DOM_CHAIN_H
#define DOM_CHAIN_H

#include "lean.h"
#include <stdint.h>

#define CHAIN_ENDLESS SIZE_MAX

struct link {
    size_t i;
    struct tilt tilt;
    struct turn turn; /* to the follower, where it leads one */
    double step;      /* slope of the lean to the follower, theta_{i+1}' / theta_i' */
    double slope;     /* theta_i' (A9) */
    double weight;    /* r^-(q i) */
    double inertia;   /* r^-((q+1) i) */
    bool leads;       /* a follower leans on it */
};

struct link link_head(const struct lean *lean, struct tilt head);
void link_next(const struct lean *lean, struct link *link);

struct sums {
    double J;  /* (c2) */
    double H1; /* dH/dtheta = sum r^(-q i) theta_i' (d cos theta_i - sin theta_i) */
    double dH; /* H(theta) - H(0); only from chain_rise */
    size_t n;  /* dominoes followed */
};

/* J and H1 of at most n dominoes. */
enum dom_status chain_sum(const struct lean *lean, struct tilt head, size_t n, struct sums *sums);

/* J, H1 and dH. */
enum dom_status chain_rise(const struct lean *lean, struct tilt head, size_t n, struct sums *sums);

/*
 * The tilt of the head at which one of the first n dominoes falls off; false where none does within
 * the cycle.  One at most does: the train at theta_c is the train at 0, shifted by one.
 */
enum dom_status chain_leave(const struct lean *lean, size_t n, bool *leaves, struct tilt *head);

#endif
