/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The dominoes of a chain, from the head down, and the contact of each with its follower. */
#ifndef DOM_LINK_H
#define DOM_LINK_H

#include "geometry/geometry.h"

struct link {
    const struct geometry *geometry; /* geometry of this domino and its follower */
    size_t i;
    struct tilt tilt;
    struct contact contact; /* contact with the follower; valid only if `leads` is true */
    real contact_slope;     /* theta_(i+1)' / theta_i' */
    real slope;             /* theta_i' (33; A9), (35; A11) */
    real weight;            /* r^-(q i) */
    real inertia;           /* r^-((q+1) i) */
    bool leads;             /* true if a follower leans on this domino */
};

KERNEL_LOOP void link_geometry(struct link *k)
{
    const struct geometry *geometry = k->geometry;
    /* A domino that is still upright has only just been hit. So its follower leans on it, even if theta_leave
     * is 0. */
    k->leads = !geometry->detaches || k->tilt.v < geometry->leave.v || k->tilt.x == 0;
    if (k->leads) {
        k->contact = geometry_contact(geometry, k->tilt);
        k->contact_slope = k->contact.slope;
    }
}

KERNEL_LOOP struct link link_head(const struct geometry *geometry, struct tilt head)
{
    struct link k = {.geometry = geometry, .i = 0, .tilt = head, .slope = 1, .weight = 1, .inertia = 1};
    link_geometry(&k);
    return k;
}

KERNEL_LOOP void link_next(struct link *k)
{
    const struct geometry *geometry = k->geometry;
    const struct tilt leader = k->tilt;
    k->i++;
    k->tilt = tilt_follower(leader, k->contact); /* (31; A6) */
    k->slope *= k->contact_slope;                /* (35; A11) */
    k->weight *= geometry->weight;
    k->inertia *= geometry->inertia;
    if (geometry->follower) {
        if (leader.x < 0)
            k->tilt = tilt_follower_back(leader, k->contact);
        k->geometry = geometry->follower;
    }
    link_geometry(k);
}

/* Returns d2 theta_1 / d theta2, the derivative of equation (14; b10). The formula avoids the follower's
 * cosine Y y - X x, since this subtraction loses digits near pi/2. */
KERNEL_LOOP real link_curve(const struct link *leader)
{
    real X = leader->contact.X, Y = leader->contact.Y;
    if (leader->tilt.x == 0 && Y == 0)
        return 0;
    return -leader->geometry->rL * (Y * leader->tilt.y - (1 - leader->contact_slope) * leader->tilt.x * X) /
           (Y * Y);
}

/* Returns the follower's theta'' (35; A11), from `curve` of the contact and theta'' of the leader. */
KERNEL_LOOP real link_second_derivative(const struct link *leader, real curve, real second_derivative)
{
    return leader->contact_slope * second_derivative + curve * leader->slope * leader->slope;
}

/*
 * Compares two chains that are walked down side by side. A domino has the tilt theta_a in the chain of a, and
 * theta_b in the chain of b. Let t = tan((theta_a - theta_b) / 2). Returns the follower's t divided by this
 * domino's t. The ratio is (1 - G) / (1 + t^2 G), with the quantity G defined at energy_change_between. If G
 * is close to 1, the subtraction 1 - G would lose digits. So 1 - G is computed from the lever arms of the two
 * contacts.
 */
KERNEL_LOOP real pair_shrink(const struct link *a, const struct link *b, real t)
{
    real arms = a->contact.arm + b->contact.arm, Y = a->contact.Y + b->contact.Y;
    return t == 0 ? 1 : arms / (Y + t * t * a->geometry->rL * (a->tilt.x + b->tilt.x));
}

#endif
