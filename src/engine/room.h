/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Memory for spaces of Chipmunk, which crashes where an allocation fails. A space is begun only if there is
 * room for all that it and the other spaces may take.
 */
#ifndef ENGINE_ROOM_H
#define ENGINE_ROOM_H

#include <stdbool.h>
#include <stddef.h>

/* Takes room for a space with this many boxes; returns false if there is not enough. Any thread may call. */
bool room_take(size_t boxes);

/* Gives the room back, after the space has been freed. */
void room_give(size_t boxes);

#endif
