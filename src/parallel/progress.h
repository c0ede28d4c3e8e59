/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The progress of a long command. While a command runs, a line on standard error such as "3 s; ^C stops it"
 * shows the elapsed time. It is updated every second. */
#pragma once

#include <stdbool.h>

/* Shows which fraction of the work is done. The line then reads "12 %, 3 s left". In a worker, which computes
 * only a part of the work, the function does nothing. */
void progress_show(double fraction);

/* Begins to show the progress, or clears the line (see progress_hook). */
void progress_line(bool begins);
