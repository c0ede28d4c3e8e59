/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The part that is common to films of the row and films of the train. */
#ifndef SHELL_FILM_H
#define SHELL_FILM_H

#include "commands/drawing/draw_words.h"
#include "picture/movie.h"
#include "picture/stage.h"

struct film {
    const struct query *query;
    struct problem *problem;
    struct answer *answer; /* receives the frames as data; NULL if they are drawn instead */
    const struct draw_what *what;
    struct movie movie;
    struct sheet sheet;
    size_t frames, frame; /* number of all frames, and of the frames drawn so far */
    int delay;            /* time between two frames, in hundredths of a second */
};

/* Makes the film. All frames have the size of the picture of `stage`, whose caption must have as many lines
 * as the captions of the frames. `watch` passes each frame to film_frame or adds it to film->answer. If
 * `watch` fails, it sets film->problem and returns false. */
bool film_make(struct film *film, const struct stage *stage, bool (*watch)(struct film *film));

/* Draws a frame. */
void film_frame(struct film *film, const struct stage *stage);

/* Makes a film of several cycles of the train; defined in animate_train.c. */
bool animate_train(const struct film *film);

#endif
