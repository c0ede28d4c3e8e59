/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The chain of followers at one tilt of the head. First the contact of a domino with its follower, and the
 * step to the follower; with rounded edges both are in rounded.c. A pass visits the dominoes from the head
 * down and computes sums over them, such as the energy H of equation (19; c1). The pass ends after
 * geometry->n dominoes. It ends earlier at a domino whose follower has detached, or if a geometric series
 * shows that the remaining terms are negligible at the tolerance.
 */
#pragma once

#include "geometry/geometry.h"
#include "numerics/numerics.h"

/* ---- One contact ---- */

/* The contact of a leader, at the tilt theta, with its follower, at theta_1. */
struct contact {
    real X, Y;  /* sine and cosine of theta_1 - theta, with errors of a few units of roundoff (absolute) */
    real arm;   /* r times the lever arm of the force on the leader (table 1); Y - r L x with sharp edges */
    real slope; /* d theta_1 / d theta (34; A10); 1 for an upright leader, even at Y = 0 */
};

/* The follower's upper edge touches the leader's back face: X = sin(theta_1 - theta) = r (L cos theta - d)
 * (12; b8), and Y = cos(theta_1 - theta) = sqrt((1 - X) (1 + X)). With cos theta = 1 - v, no digits of 1 - X
 * and of Y cancel. */
KERNEL_LOOP struct contact geometry_contact(const struct geometry *geometry, struct tilt leader)
{
    const real rLv = geometry->rL * leader.v, rLx = geometry->rL * leader.x;
    const real X = geometry->rs - rLv;                                          /* (12; b8) */
    const real Y = sqrt((geometry->short_of + rLv) * (1 + geometry->rs - rLv)); /* (30; A5) */
    /* theta_1' = 1 - r L x / Y (14; b10). A chain multiplies many slopes, so a slope near 1 must not have
     * more than one rounding error. */
    if (2 * rLx <= Y)
        return (struct contact){X, Y, Y - rLx, leader.x == 0 ? 1 : 1 - rLx / Y};
    /* Computing the arm as Y - r L x would lose digits by cancellation. So it is computed from
     * Y^2 - (r L x)^2, which equals (1 - r^2 s^2) - 2 r^2 L d v. */
    const real arm = (geometry->leave_at - geometry->leave_by * leader.v) / (Y + rLx);
    return (struct contact){X, Y, arm, arm / Y};
}

/*
 * Returns the follower's tilt, by equation (31; A6) in its corrected form: y' = Y y - X x. In a train,
 * X >= 0, so the formula for v' = 1 - y' only adds terms of one sign, and no digits cancel. x' and y' are
 * computed from v', so they stay the sine and cosine of one angle, even far down a long train. In a row, a
 * leader may lean backwards, and its follower, too: the formula x' = Y x + X y keeps the sign of the tilt.
 */
KERNEL_LOOP struct tilt tilt_follower(struct tilt t, struct contact contact)
{
    if (t.x < 0)
        return tilt_make(contact.Y * t.x + contact.X * t.y, contact.Y * t.y - contact.X * t.x);
    real v = contact.X * contact.X / (1 + contact.Y) + (contact.Y * t.v + contact.X * t.x);
    return (struct tilt){.x = sqrt(v * (2 - v)), .y = 1 - v, .v = v};
}

/* A domino of a chain. */
struct link {
    const struct geometry *geometry; /* geometry of this domino and its follower */
    size_t i;
    struct tilt tilt;
    struct contact contact; /* contact with the follower; valid only if `leads` is true */
    real slope;             /* theta_i' (33; A9), (35; A11) */
    real weight;            /* r^-(q i) */
    real inertia;           /* r^-((q+1) i) */
    bool leads;             /* true if a follower leans on this domino */
    real second_derivative; /* theta_i'' */
    real curve;             /* d2 theta_1 / d theta2 of the contact */
    /* Only with rounded edges: the tilt of the domino as an angle, and the turn from the domino to its
     * follower, theta_1 - theta, as an angle and as a tilt. */
    real theta;
    struct turn {
        real angle;
        struct tilt tilt;
    } turn;
};

/* Returns false if the follower of this domino has detached. A domino that is still upright has only just
 * been hit. So its follower leans on it, even if theta_leave is 0. */
KERNEL_LOOP bool link_leads(const struct link *k)
{
    return !k->geometry->detaches || k->tilt.v < k->geometry->leave.v || k->tilt.x == 0;
}

/* Returns the slope d theta_1 / d theta when the leader is hit. A leaning leader must have sharp edges. */
KERNEL real geometry_hit_slope(const struct geometry *geometry)
{
    return geometry->lean == 0 ? 1 : geometry_contact(geometry, geometry_rest(geometry)).slope;
}

/* The lever arms of a contact (table 1), multiplied by r of the leader. */
struct arms {
    real a, b;    /* arms of the force on the leader and on the follower */
    real b_plain; /* b without friction */
    real ratio;   /* a / b: the part of a torque that the follower passes on to its leader */
};

/* ---- A walk down a chain, domino by domino ---- */

/*
 * The steps with rounded edges. rounded_step moves on to the follower, and finds the turn to the next one. If
 * only tilts are needed, this function is enough. rounded_levers finds the lever arms and the derivatives of
 * the new contact. If two chains are walked down side by side, call each function for both chains before you
 * call the next one. The processor can then work on both turns at once. rounded_touch finds the contact, even
 * if the follower counts as detached.
 */
KERNEL_SHARED struct link rounded_head(const struct geometry *geometry, struct tilt head);
KERNEL_SHARED void rounded_step(struct link *k);
KERNEL_SHARED void rounded_levers(struct link *k);
KERNEL_SHARED void rounded_touch(struct link *k);
KERNEL_SHARED struct arms rounded_arms(const struct link *k);

/* Returns the head of a chain. In the loops of passes, `rolls` (of the geometry) is a constant, so the
 * compiler makes a loop for sharp edges that knows nothing of rounded ones. */
KERNEL_LOOP struct link link_head(const struct geometry *geometry, struct tilt head, const bool rolls)
{
    if (rolls)
        return rounded_head(geometry, head);
    struct link k; /* not initialized as a whole: the members of rounded edges would keep it in memory */
    k.geometry = geometry;
    k.i = 0;
    k.tilt = head;
    k.slope = k.weight = k.inertia = 1;
    k.second_derivative = k.curve = 0;
    k.leads = link_leads(&k);
    k.contact = k.leads ? geometry_contact(geometry, head) : (struct contact){0};
    return k;
}

/* Finds theta_1'' of the contact with the follower: the derivative of equation (14; b10). The formula avoids
 * the follower's cosine Y y - X x, since this subtraction loses digits near pi/2. With rounded edges,
 * rounded_levers has found theta_1''. */
KERNEL_LOOP void link_bend(struct link *k, const bool rolls)
{
    const real X = k->contact.X, Y = k->contact.Y;
    if (!rolls)
        k->curve =
            k->tilt.x == 0 && Y == 0
                ? 0
                : -k->geometry->rL * (Y * k->tilt.y - (1 - k->contact.slope) * k->tilt.x * X) / (Y * Y);
}

/* Moves on to the follower. With sharp edges, theta_i'' is found only if `bends` is true, after link_bend. */
KERNEL_LOOP void link_next(struct link *k, const bool rolls, const bool bends)
{
    const struct geometry *geometry = k->geometry;
    if (rolls || bends) /* the derivative of (35; A11) */
        k->second_derivative = k->contact.slope * k->second_derivative + k->curve * k->slope * k->slope;
    k->slope *= k->contact.slope; /* (35; A11) */
    k->weight *= geometry->weight;
    k->inertia *= geometry->inertia;
    if (rolls) {
        rounded_step(k);
        if (k->leads)
            rounded_levers(k);
        return;
    }
    k->i++;
    k->tilt = tilt_follower(k->tilt, k->contact); /* (31; A6) */
    if (geometry->follower)
        k->geometry = geometry->follower;
    k->leads = link_leads(k);
    if (k->leads)
        k->contact = geometry_contact(k->geometry, k->tilt);
}

/* Moves on to the follower, with all derivatives. */
KERNEL void link_on(struct link *k)
{
    const bool rolls = k->geometry->rolls;
    link_bend(k, rolls);
    link_next(k, rolls, true);
}

/* Finds the contact with the follower, even if the follower counts as detached. */
KERNEL void link_touch(struct link *k)
{
    if (k->geometry->rolls)
        rounded_touch(k);
    else
        k->contact = geometry_contact(k->geometry, k->tilt);
}

KERNEL_LOOP struct arms link_arms(const struct link *k, const bool rolls)
{
    if (rolls)
        return rounded_arms(k);
    const struct contact *contact = &k->contact;
    const real mu = k->geometry->mu, a = contact->arm - mu * k->geometry->r * k->geometry->d,
               b = contact->Y + mu * contact->X;
    /* without friction the ratio is the slope (14; b10) */
    return (struct arms){.a = a, .b = b, .b_plain = contact->Y, .ratio = mu != 0 ? a / b : contact->slope};
}

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
    real H2, left;
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

/* Finds the terms of the far tail in `sum`: those of a domino of chain a and all dominoes behind it. In chain
 * b the domino has the tilt b, and t is the tangent of half the angle between its two tilts. Returns 0. If
 * the series are not accurate enough here, returns the value of 1 - cos theta from which on they probably
 * are. */
KERNEL real far_find(struct link a, struct tilt b, real t, struct sum_state sum, struct sums *tail);

enum pass {
    PASS_SIGN, /* only the sign of H1; ends early */
    PASS_SUMS, /* J and H1 */
    /* The others compare two chains: one whose head is at the tilt `head`, and one with its head at `from`.
     * Each computes J and dH = H(head) - H(from). */
    PASS_PLAIN,             /* also H1 */
    PASS_SECOND_DERIVATIVE, /* also H1 and H2 */
    PASS_PUSHES,            /* also H1; tries to prove that all contacts push */
    /* For a train with its head at theta_c, compared with the upright one. During the cycle, each domino
     * turns to the initial tilt of its follower (32; A7). So one chain is enough: the chain at theta_c,
     * shifted by one domino, is the chain at 0. */
    PASS_FUEL
};

/* Does the pass. If the tilt `from` is not upright, no domino may detach between the two tilts. */
KERNEL_SHARED enum dom_status chain_change(const struct geometry *geometry, struct tilt from,
                                           struct tilt head, enum pass pass, struct sums *sums);

/* Does the same as chain_change. t is the tangent of half the angle between the tilts `from` and `head`. If
 * they are close, computing t from the two tilts would be inaccurate. */
KERNEL enum dom_status chain_change_by(const struct geometry *geometry, struct tilt from, struct tilt head,
                                       real t, enum pass pass, struct sums *sums);

/* Does PASS_SIGN or PASS_SUMS. */
KERNEL enum dom_status chain_sum(const struct geometry *geometry, struct tilt head, bool sign,
                                 struct sums *sums);

/* The equation of motion at one tilt of the head: (A/2) dw/dtheta + B w = C. Without friction, A is J
 * and C is -H1/2; without drag, too, B is half of dJ/dtheta. */
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
 * Divides a cycle into pieces in which the sums are smooth functions of the tilt. The array `edge` receives
 * the tilts of the head at which the pieces begin and end, and *edges their number. edge[0] is 0, or slightly
 * above 0 if the head only just reaches the next domino. The last edge is theta_c.
 *
 * At most one domino detaches in a cycle, since the train at theta_c is the train at 0 shifted by one domino.
 * *leave receives the tilt of the head at that moment, and *domino the number of the domino. If the tilt is
 * between the other two, it is an edge. *leave is NaN if no domino detaches, or only one that contributes
 * less than the rounding errors.
 */
enum { CHAIN_EDGES = 3 };
KERNEL enum dom_status chain_edges(const struct geometry *geometry, real edge[CHAIN_EDGES], int *edges,
                                   real *leave, size_t *domino);

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
