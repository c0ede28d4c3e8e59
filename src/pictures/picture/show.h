/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws a command's picture to the destination of its answer. A terminal shows the picture in characters. In
 * a file, the extension determines the format. */
#ifndef SHELL_SHOW_H
#define SHELL_SHOW_H

#include "answer/extension.h"
#include "pictures/picture/chart.h"
#include "pictures/picture/stage.h"
#include "session/problem.h"
#include <signal.h>

/* Returns true if a picture can be drawn to the destination of the answer. Otherwise sets *problem. */
bool picture_ready(const struct answer *a, struct problem *problem);

/* Returns the words that explain a picture's marks. Text and gnuplot pictures have different marks. */
struct marks picture_marks(const struct answer *a);

/* Draws a chart to the destination of the answer and frees the chart. */
bool chart_show(struct chart *chart, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

/* Draws a stage to the destination of the answer. */
bool stage_show(const struct stage *stage, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

#endif
