/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes animations into files: .gif with gnuplot alone, and .webm and .mp4 with gnuplot and ffmpeg. */
#ifndef SHELL_MOVIE_H
#define SHELL_MOVIE_H

#include "io/output.h"
#include "language/names.h"
#include "picture/picture.h"

struct movie {
    struct picture picture; /* the picture whose script contains a plot command for each frame */
    struct output *file;
    const struct movie_kind *kind;
    FILE *frames; /* the frames for ffmpeg, or NULL for a gif */
    int delay;
    char shown[NAMES_SHOWN]; /* the name of the file in messages */
};

/* Checks the extension of the file. If it is unknown, or if it needs ffmpeg and ffmpeg is not installed,
 * reports a problem and returns false. */
bool movie_named(const char *path, struct problem *problem);

/* Begins an animation of width x height pixels, with frames `delay` hundredths of a second apart. Returns
 * false with a problem on failure. */
bool movie_begin(struct movie *movie, const char *path, int width, int height, int delay,
                 const volatile sig_atomic_t *interrupt, struct problem *problem);

/* Ends the animation. If `whole` is true, the script is complete, and the film is written to the file.
 * Otherwise discards the film and returns false. */
bool movie_end(struct movie *movie, bool whole, struct problem *problem);

#endif
