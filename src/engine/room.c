/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "room.h"
#include <pthread.h>
#include <stdlib.h>

/* Bytes to reserve. Chipmunk 7.0.3 needs at most 0.4 MB for a space and 4 kB for each box. */
enum { SPACE = 1 << 20, BOX = 1 << 14 };

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static size_t taken; /* bytes reserved for all existing Chipmunk spaces */

bool room_take(size_t boxes)
{
    const size_t more = SPACE + BOX * boxes;
    pthread_mutex_lock(&lock);
    /* volatile, because gcc could otherwise remove a malloc whose result is only freed */
    void *volatile room = malloc(taken + more);
    const bool found = room;
    free(room);
    if (found)
        taken += more;
    pthread_mutex_unlock(&lock);
    return found;
}

void room_give(size_t boxes)
{
    pthread_mutex_lock(&lock);
    taken -= SPACE + BOX * boxes;
    pthread_mutex_unlock(&lock);
}
