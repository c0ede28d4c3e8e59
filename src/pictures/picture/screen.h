/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A second screen of the terminal, without a cursor, on which keys are read one by one. ^Z stops the program
 * at once, with the terminal as it was before. When the program continues, the screen is shown again. */
#ifndef SHELL_SCREEN_H
#define SHELL_SCREEN_H

#include <signal.h>
#include <stdio.h>

/* Keys beyond characters. KEY_BACK: the program has continued after ^Z, and the screen is empty. KEY_END: the
 * user has typed 'q', ^D or ^C, or the terminal is gone. */
enum { KEY_NONE = 0, KEY_UP = 256, KEY_DOWN, KEY_RIGHT, KEY_LEFT, KEY_BACK, KEY_END };

/* Shows the screen. Returns a stream to write on it, or NULL if `out` is not shown on a terminal, or if this
 * program is not in the terminal's foreground. */
FILE *screen_begin(FILE *out);
void screen_end(void);

/* Waits for a key, for at most this many seconds, and not longer than 0.2 s. Returns KEY_NONE if there is
 * none. */
int screen_key(double seconds, const volatile sig_atomic_t *interrupt);

#endif
