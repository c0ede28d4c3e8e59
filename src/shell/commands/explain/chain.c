/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tilts of the dominoes of a train, for the terms of sums. */
#include "commands/explain/derivation.h"
#include <stdlib.h>

struct chain_room {
    struct chain *chain;
    size_t room;
    bool full; /* memory ran out */
};

static bool chain_link(const struct domq_link *link, void *context)
{
    struct chain_room *r = context;
    struct chain *c = r->chain;
    if (c->count + 2 > r->room) {
        r->room = 2 * r->room + 64;
        struct domq_link *grown = realloc(c->link, r->room * sizeof *grown);
        if (!grown) {
            r->full = true;
            return false;
        }
        c->link = grown;
    }
    c->link[c->count++] = *link;
    return true;
}

/* Reports the problem if the chain could not be made. */
static bool chain_made(struct derivation *d, const struct chain_room *room, enum dom_status status)
{
    if (status == DOM_OK && room->full)
        status = DOM_NO_MEMORY;
    return status == DOM_OK || problem_status(d->problem, &d->state->scene, status);
}

bool chain_fill(struct derivation *d, struct chain *chain, domq_real theta)
{
    struct chain_room room = {.chain = chain};
    chain->count = 0;
    enum dom_status status =
        domq_chain_walk(&d->state->scene.train, &d->state->scene.compute, theta, chain_link, &room);
    return chain_made(d, &room, status);
}

bool chain_extend(struct derivation *d, struct chain *chain, size_t count)
{
    struct chain_room room = {.chain = chain, .room = chain->count};
    struct domq_angles angles;
    enum dom_status status = domq_angles_find(&d->state->scene.train, &d->state->scene.compute, &angles);
    const struct domq_link rest = {.theta = angles.theta_f, .slope = 0};
    while (status == DOM_OK && !room.full && chain->count < count)
        (void)chain_link(&rest, &room);
    return chain_made(d, &room, status);
}

void chain_free(struct chain *chain)
{
    free(chain->link);
    *chain = (struct chain){.link = NULL};
}
