/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Chipmunk crashes if an allocation fails. So a Chipmunk space is created only if there is enough memory for
 * this space and for all existing spaces.
 */
#ifndef ENGINE_ROOM_H
#define ENGINE_ROOM_H

#include <stdbool.h>
#include <stddef.h>

/* Reserves memory for a space with this many boxes. Returns false if there is not enough memory.
 * Thread-safe. */
bool room_take(size_t boxes);

/* Ends the reservation for a space with this many boxes, after the space has been freed. */
void room_give(size_t boxes);

#endif
