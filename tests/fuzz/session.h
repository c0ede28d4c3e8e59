/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a session on a text, as 'domino -f' does, and checks properties of the output that hold for every
 * text. */
#ifndef FUZZ_SESSION_H
#define FUZZ_SESSION_H

#include <stdbool.h>
#include <stddef.h>

/* Runs the text. Aborts if the output contains a control character or invalid json. */
void fuzz_session(const void *text, size_t size, bool safe);

#endif
