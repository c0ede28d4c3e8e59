/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Films of the train, and the function film_make, which makes the films of the train and of the row. */
#ifndef SHELL_ANIMATE_TRAIN_H
#define SHELL_ANIMATE_TRAIN_H

#include "commands/drawing/draw_words.h"
#include "picture/movie.h"

struct film {
    const struct query *query;
    struct problem *problem;
    struct answer *answer; /* receives the frames as data; NULL if they are drawn instead */
    const struct draw_options *options;
    struct movie movie;
    size_t frames;
    int delay; /* time between two frames, in hundredths of a second */
};

/* Makes the film. `stage` gives the size of the frames, as in movie_begin. `watch` passes each frame to
 * movie_frame, or adds it to film->answer. On failure, `watch` sets film->problem. */
bool film_make(struct film *film, const struct stage *stage, bool (*watch)(struct film *film));

bool animate_train(const struct film *film);

#endif
