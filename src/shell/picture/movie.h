/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Animations in files: .gif by gnuplot alone, .webm and .mp4 by gnuplot and ffmpeg. */
#ifndef SHELL_MOVIE_H
#define SHELL_MOVIE_H

#include "io/output.h"
#include "language/names.h"
#include "picture/picture.h"

struct movie {
    struct picture picture; /* its script takes a plot command for each frame */
    struct output *file;
    const struct movie_kind *kind;
    FILE *frames; /* the frames for ffmpeg; NULL for a gif */
    int delay;
    char shown[NAMES_SHOWN]; /* the name of the file in messages */
};

/* Describes a problem and returns false if the ending of the file is unknown, or needs ffmpeg, which is not
 * installed. */
bool movie_named(const char *path, struct problem *problem);

/* Begins an animation of width x height dots, with frames `delay` hundredths of a second apart. */
bool movie_begin(struct movie *movie, const char *path, int width, int height, int delay,
                 const volatile sig_atomic_t *interrupt, struct problem *problem);

/* Ends the animation. Draws it into the file if the script is whole; else returns false. */
bool movie_end(struct movie *movie, bool whole, struct problem *problem);

#endif
