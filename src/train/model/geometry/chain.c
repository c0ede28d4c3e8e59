/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/chain.h"

KERNEL enum dom_status chain_edges(const struct geometry *geometry, real edge[CHAIN_EDGES], int *edges,
                                   real *leave, size_t *domino)
{
    /* With sharp edges and r s = 1, the follower detaches as soon as the head moves, so H' jumps at the tilt
     * 0. Start just after the jump. */
    edge[0] = geometry->short_of == 0 ? REAL_MIN : 0;
    edge[1] = tilt_angle(geometry->c);
    *edges = 2;
    *leave = REAL_NAN;
    *domino = 0;
    if (!geometry->detaches)
        return DOM_OK;
    struct link b = link_head(geometry, standing, geometry->rolls);
    /* The part of the torque on domino b.i that reaches the head. Without friction, this is theta_i'. */
    real passed = 1;
    while (b.leads) {
        enum dom_status status = chain_watch(geometry, b.i);
        if (status != DOM_OK)
            return status;
        /* A domino that contributes less than the rounding errors does not matter, even if it detaches. */
        if (b.i + 1 >= geometry->n || b.weight * fmax(b.slope, passed) < REAL_EPSILON * REAL_EPSILON)
            return DOM_OK;
        const struct arms arms = link_arms(&b, geometry->rolls);
        passed *= fabs(arms.a / arms.b);
        link_on(&b);
    }
    /* When the head is upright, the follower of domino b.i is already detached. The next domino to detach is
     * b.i itself. This happens when the leader of b.i reaches theta_leave. */
    struct tilt head = geometry->leave;
    for (size_t i = b.i; i > 1; i--)
        head = geometry_leader(geometry, head);
    *domino = b.i;
    *leave = tilt_angle(head);
    if (*leave > edge[0] && *leave < edge[1]) {
        edge[2] = edge[1];
        edge[1] = *leave;
        *edges = 3;
    }
    return DOM_OK;
}
