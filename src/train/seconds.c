/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "train/seconds.h"
#include "io/terminal.h"
#include <math.h>

double seconds_of(bool (*answer)(void *context), void *context)
{
    const double shortest = 2e-4; /* in s; the clock is too coarse for a shorter batch */
    const double slow = 0.1;      /* in s; a batch that takes longer is the last */
    const int batches = 7;
    double least = HUGE_VAL;
    long repeats = 1;
    for (int batch = 0; batch < batches;) {
        double begun = terminal_clock();
        for (long i = 0; i < repeats; i++)
            if (!answer(context))
                return (double)NAN;
        double seconds = terminal_clock() - begun;
        if (seconds < shortest) {
            repeats *= 2;
            continue;
        }
        least = fmin(least, seconds / (double)repeats);
        batch += seconds > slow ? batches : 1;
    }
    return least;
}
