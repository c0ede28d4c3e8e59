/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures how long a computation takes. */
#ifndef SHELL_SECONDS_H
#define SHELL_SECONDS_H

#include <stdbool.h>

/* Returns how many seconds a call to `answer` takes, in the fastest of up to seven batches of calls. A slow
 * call is timed only once. Returns NaN if a call returns false. */
double seconds_of(bool (*answer)(void *context), void *context);

#endif
