/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where the picture of a command goes, which is where its answer goes: as characters or as a real picture
 * into the terminal, or into the file after '>', whose ending decides the format.
 */
#ifndef SHELL_SHOW_H
#define SHELL_SHOW_H

#include "answer/answer.h"
#include "picture/chart.h"
#include "picture/stage.h"
#include "session/problem.h"
#include <signal.h>

/* Returns true if a picture is drawn in characters: for the terminal, and for a file whose ending names no
 * kind of picture. */
bool picture_is_text(const struct answer *a);

/* Reports an error if the terminal is too small for the picture of a command; files have room. */
bool picture_fits(const struct answer *a, const char *command, struct problem *problem);

/* Reports an error, before any work is done, if the picture cannot be drawn where the answer goes. */
bool picture_ready(const struct answer *a, struct problem *problem);

/* Returns how the dominoes of a stage are marked where the answer goes. */
struct marks picture_marks(const struct answer *a);

/* Draw a chart, and give it back; and a stage. False: an error was reported. */
bool chart_show(struct chart *chart, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);
bool stage_show(const struct stage *stage, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem);

#endif
