/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One link of a chain: the contact of a domino with its follower, and the step to the follower. All passes
 * along a chain consist of these steps. geometry_contact and link_next are the contact and the step with
 * sharp edges; rounded.c has those with rounded edges.
 */
#pragma once

#include "geometry/geometry.h"

/* The contact of a leader, at the tilt theta, with its follower, at theta_1. */
struct contact {
    real X, Y;  /* sine and cosine of theta_1 - theta, accurate for all angles */
    real arm;   /* r times the lever arm of the force on the leader (table 1); Y - r L x with sharp edges */
    real slope; /* d theta_1 / d theta (34; A10); 1 for an upright leader, even at Y = 0 */
};

/* The follower's upper edge touches the leader's back face: X = sin(theta_1 - theta) = r (L cos theta - d)
 * (12; b8), and Y = cos(theta_1 - theta) = sqrt((1 - X) (1 + X)). With cos theta = 1 - v, no digits cancel.
 */
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
 * computed from v', so they stay the sine and cosine of one angle, even far down a long train.
 */
KERNEL_LOOP struct tilt tilt_follower(struct tilt t, struct contact contact)
{
    real v = contact.X * contact.X / (1 + contact.Y) + (contact.Y * t.v + contact.X * t.x);
    return (struct tilt){.x = sqrt(v * (2 - v)), .y = 1 - v, .v = v};
}

/* Like tilt_follower, but for a leader that may lean backwards. The follower may then lean backwards, too.
 * The square root in tilt_follower would lose the sign of the follower's tilt, but the formula x' = Y x + X y
 * keeps it. */
KERNEL struct tilt tilt_follower_back(struct tilt t, struct contact contact)
{
    return tilt_make(contact.Y * t.x + contact.X * t.y, contact.Y * t.y - contact.X * t.x);
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
    /* Only with rounded edges: the tilt of the domino as an angle, the lever arm of the contact force on the
     * follower, and the turn from the domino to its follower, theta_1 - theta, as an angle and as a tilt. */
    real theta, b;
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

/*
 * Compares two chains that are walked down side by side. A domino has the tilt theta_a in the chain of a, and
 * theta_b in the chain of b. Let t = tan((theta_a - theta_b) / 2). Returns the follower's t divided by this
 * domino's t. The ratio is (1 - G) / (1 + t^2 G), with the quantity G defined at chain_difference. If G
 * is close to 1, the subtraction 1 - G would lose digits. So 1 - G is computed from the lever arms of the two
 * contacts.
 */
KERNEL_LOOP real pair_shrink(const struct link *a, const struct link *b, real t)
{
    real arms = a->contact.arm + b->contact.arm, Y = a->contact.Y + b->contact.Y;
    return t == 0 ? 1 : arms / (Y + t * t * a->geometry->rL * (a->tilt.x + b->tilt.x));
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
    struct link k = {.geometry = geometry, .tilt = head, .slope = 1, .weight = 1, .inertia = 1};
    k.leads = link_leads(&k);
    if (k.leads)
        k.contact = geometry_contact(geometry, head);
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
    const struct tilt leader = k->tilt;
    if (rolls || bends) /* (35; A11) */
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
    k->tilt = tilt_follower(leader, k->contact); /* (31; A6) */
    if (geometry->follower) {
        if (leader.x < 0)
            k->tilt = tilt_follower_back(leader, k->contact);
        k->geometry = geometry->follower;
    }
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
