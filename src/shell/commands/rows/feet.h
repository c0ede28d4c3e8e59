/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the feet of a row need of the floor, while dominoes fall and in the instant of each hit. */
#ifndef SHELL_FEET_H
#define SHELL_FEET_H

#include "session/query.h"

/* The friction that a foot needs, while the domino `head` falls, or in the instant when it is hit. */
struct slip {
    domq_real needs;     /* infinite: the domino is lifted off */
    size_t domino, head; /* from 1; head = 0: none */
};

/* The largest friction that a foot needs, and the first that is above the friction of the floor. */
struct feet {
    domq_real floor; /* the friction of the floor */
    struct slip motion, motion_first, hit, hit_first;
};

/* Begins, with the floor of the session. */
struct feet feet_begin(const struct query *query);

/* Adds a domino that was hit. */
void feet_add(struct feet *feet, const struct domq_fall *f);

/* Prints what the row needs while it falls, and in its collisions, and what follows; count: of its dominoes.
 */
void feet_say(struct answer *a, const struct feet *feet, size_t count);

/* Prints what it means that feet slip: in the instant of a hit alone, or also while dominoes fall. */
void feet_matter(struct answer *a, bool in_motion);

#endif
