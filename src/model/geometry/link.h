/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The dominoes of a train one after the other, from the head down; and the contact of each with its follower.
 */
#ifndef DOM_LINK_H
#define DOM_LINK_H

#include "geometry/lean.h"

struct link {
    const struct lean *lean; /* of this domino and its follower */
    size_t i;
    struct tilt tilt;
    struct turn turn; /* to the follower, where it leads one */
    real step;        /* slope of the lean to the follower, theta_{i+1}' / theta_i' */
    real slope;       /* theta_i' (A9) */
    real weight;      /* r^-(q i) */
    real inertia;     /* r^-((q+1) i) */
    bool leads;       /* a follower leans on it */
};

KERNEL_LOOP void link_lean(struct link *k)
{
    const struct lean *g = k->lean;
    /* Upright is leaned on in any case: it has just been hit, even in the limit theta_leave = 0. */
    k->leads = !g->falls_off || k->tilt.v < g->leave.v || k->tilt.x == 0;
    if (k->leads) {
        k->turn = lean_turn(g, k->tilt);
        k->step = k->turn.step;
    }
}

KERNEL_LOOP struct link link_head(const struct lean *g, struct tilt head)
{
    struct link k = {.lean = g, .i = 0, .tilt = head, .slope = 1, .weight = 1, .inertia = 1};
    link_lean(&k);
    return k;
}

KERNEL_LOOP void link_next(struct link *k)
{
    const struct lean *g = k->lean;
    k->i++;
    k->tilt = tilt_turn(k->tilt, k->turn);
    k->slope *= k->step;
    k->weight *= g->weight;
    k->inertia *= g->inertia;
    if (g->behind)
        k->lean = g->behind;
    link_lean(k);
}

/* theta'' of a follower from that of its leader: d/dtheta of (b10) along the chain. */
KERNEL_LOOP real link_bend(const struct link *leader, real bend, const struct link *follower)
{
    real X = leader->turn.X, Y = leader->turn.Y;
    if (leader->tilt.x == 0 && Y == 0)
        return 0;
    real turned = (follower->tilt.y + leader->step * leader->tilt.x * X) / (Y * Y);
    return leader->step * bend - leader->lean->r * leader->lean->L * turned * leader->slope * leader->slope;
}

/* The arms of the contact of a domino with its follower (table 1), with friction, times r of that domino. */
KERNEL real contact_arm_a(const struct link *k)
{
    return k->turn.arm - k->lean->mu * k->lean->r * k->lean->d;
}

KERNEL real contact_arm_b(const struct link *k)
{
    return k->turn.Y + k->lean->mu * k->turn.X;
}

/* a / b: the share of a torque that the contact passes on to the leader; without friction the slope (b10). */
KERNEL real torque_ratio(const struct link *k)
{
    return contact_arm_a(k) / contact_arm_b(k);
}

#endif
