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

bool chain_fill(struct derivation *d, struct chain *chain, domq_real theta, size_t least)
{
    struct chain_room room = {.chain = chain};
    struct domq_angles angles;
    chain->count = 0;
    const struct domq_train *train = &d->state->scene.train;
    enum dom_status status = domq_angles_find(train, &d->state->scene.compute, &angles);
    if (status == DOM_OK)
        status = domq_chain_walk(train, &d->state->scene.compute, theta, chain_link, &room);
    const struct domq_link rest = {.theta = angles.theta_f, .slope = 0};
    const size_t walked = chain->count;
    while (status == DOM_OK && !room.full && chain->count < (walked > least ? walked : least) + 2)
        (void)chain_link(&rest, &room);
    if (status == DOM_OK && room.full)
        status = DOM_NO_MEMORY;
    return status == DOM_OK || problem_status(d->problem, &d->state->scene, status);
}

void chain_free(struct chain *chain)
{
    free(chain->link);
    *chain = (struct chain){.link = NULL};
}
