/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Films, which are shown at the terminal or written into a .gif file. */
#ifndef SHELL_FILM_H
#define SHELL_FILM_H

#include "pictures/options.h"
#include "pictures/picture/stage.h"

/* The words of 'animate'. */
enum { FILM_SPEED, FILM_RATE, FILM_SLOW, FILM_TRAIN, FILM_TOWER, FILM_CYCLES };

/* 'animate slow' is this many times slower. */
enum { SLOWER = 4 };

struct film {
    const struct query *query;
    struct problem *problem;
    struct answer *out;
    bool is_data; /* the frames are written as data, rather than drawn */
    const struct options *options;
    size_t frames, frame; /* the total number of frames, and the number written so far */
    int delay;            /* time between two frames, in hundredths of a second */

    /* At the terminal: */
    FILE *screen; /* NULL for a file */
    double next;  /* when the next frame is due, in s */
    char *text;   /* the current frame */
    size_t size;
    bool is_stopped, failed;

    /* For a file: */
    struct picture picture; /* its script has a plot command for each frame */
    struct sheet sheet;     /* the size of all frames, and the part of the stage that the next frame shows */
};

/* Makes the film. All frames have the same size, so the caption of `stage` must have as many lines as the
 * captions of the frames. `watch` passes each frame to film_frame, or adds it to film->out. On failure,
 * `watch` sets film->problem. */
bool film_make(struct film *film, const struct stage *stage, bool (*watch)(struct film *film));

/* Moves the view of a film that follows the fall. If `part` is 0, the size of the view suits the domino
 * `from`, which is near its middle. If `part` is 1, the same holds for the domino `to`. */
void film_follow(struct stage *stage, const struct drawn *from, const struct drawn *to, double part);

/* Draws a frame. At the terminal, returns when it is time for the next one. Returns false if the user has
 * ended the film, or if memory ran out. */
bool film_frame(struct film *film, const struct stage *stage);

bool animate_train(const struct film *film);

/* The command 'animate', for the table in draw.c. */
extern const struct option_list film_options;
extern const struct column animate_columns[];
bool run_animate(const struct query *query, struct answer *a, struct problem *problem);

#endif
