/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shows the frames of an animation in the terminal. */
#ifndef DRAWING_PLAY_H
#define DRAWING_PLAY_H

#include "pictures/picture/stage.h"
#include "session/problem.h"
#include <signal.h>
#include <stdio.h>

/* Returns a player for the terminal of the stream `out`, or sets *problem and returns NULL. `delay` is the
 * time between two frames, in hundredths of a second. */
struct player *player_begin(FILE *out, int delay, const volatile sig_atomic_t *interrupt,
                            struct problem *problem);

/* Shows the next frame, and returns when it is time for the frame after it. Returns false if the user has
 * ended the animation, or if memory ran out. */
bool player_frame(struct player *player, const struct stage *stage);

/* Ends the animation, and leaves the last frame on the screen. */
bool player_end(struct player *player, struct problem *problem);

#endif
