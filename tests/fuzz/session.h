/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One session on a text, as 'domino -f' would run it, and what must hold whatever the text is. */
#ifndef FUZZ_SESSION_H
#define FUZZ_SESSION_H

#include <stdbool.h>
#include <stddef.h>

/* Runs the text.  Aborts where an answer has a control character, or in json what is no number. */
void fuzz_session(const void *text, size_t size, bool safe);

#endif
