/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Chipmunk crashes if an allocation fails, so that a space is made only if there is enough memory for all
 * that this space and the other spaces may allocate.
 */
#ifndef ENGINE_ROOM_H
#define ENGINE_ROOM_H

#include <stdbool.h>
#include <stddef.h>

/* Reserves memory for a space with this many boxes. Returns false if there is not enough. Any thread may
 * call. */
bool room_take(size_t boxes);

/* Ends the reservation after the space has been freed. */
void room_give(size_t boxes);

#endif
