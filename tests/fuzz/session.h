/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs one session on a text, as 'domino -f' does, and checks what must be true for every text. */
#ifndef FUZZ_SESSION_H
#define FUZZ_SESSION_H

#include <stdbool.h>
#include <stddef.h>

/* Runs the text. Aborts if an answer has a control character, or json a value that is not a number. */
void fuzz_session(const void *text, size_t size, bool safe);

#endif
