/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes animations into files: .gif with gnuplot alone, and .webm and .mp4 with gnuplot and ffmpeg. */
#ifndef SHELL_MOVIE_H
#define SHELL_MOVIE_H

#include "answer/answer.h"
#include "language/names.h"
#include "pictures/picture/picture.h"
#include "pictures/picture/stage.h"

struct movie {
    struct picture picture; /* the picture whose script contains a plot command for each frame */
    struct sheet sheet;     /* the size of all frames, and the part of the stage that the next frame shows */
    const struct answer *answer; /* receives the film */
    const struct movie_kind *kind;
    FILE *drawn;          /* the drawn frames for ffmpeg, or NULL for a gif */
    int delay;            /* the time between two frames, in hundredths of a second */
    size_t frames, frame; /* the total number of frames, and the number written so far */
};

/* Returns true if ffmpeg is installed or not needed for this file. Otherwise reports a problem. */
bool movie_ready(const char *path, struct problem *problem);

/* Begins an animation, which is written to the file of the answer. `delay` is the time between two frames, in
 * hundredths of a second. All frames have the same size, so the caption of `stage` must have as many lines as
 * the captions of the frames. On failure, sets *problem and returns false. */
bool movie_begin(struct movie *movie, const struct answer *answer, const struct stage *stage, size_t frames,
                 int delay, const volatile sig_atomic_t *interrupt, struct problem *problem);

void movie_frame(struct movie *movie, const struct stage *stage);

/* Ends the animation. Writes the film if the script is complete (`whole`). Otherwise discards the film and
 * returns false. */
bool movie_end(struct movie *movie, bool whole, struct problem *problem);

#endif
