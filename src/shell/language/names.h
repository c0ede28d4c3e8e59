/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Looks up names in lists. A name may be typed in full or as an unambiguous prefix; for a name with a typo,
 * messages suggest the correct spelling. */
#ifndef SHELL_NAMES_H
#define SHELL_NAMES_H

#include "io/escape.h"
#include <stdbool.h>
#include <stddef.h>

/* A list of names is a function that returns the name with index k, or NULL after the last name. */
typedef const char *names_list(const void *context, int k);

/* Returns the index of the name that equals the text, or -1. */
int names_exact(names_list *list, const void *context, const char *text);

/* Returns the index of a name in a text such as "gap separation spacing", or -1 if the text does not contain
 * the name. `separator` is the character between the names of the text. The text may be NULL. */
int names_index(const char *list, char separator, const char *name);

enum { NAMES_MESSAGE = 256 };

/* The results of names_find if there is no match. All of them are negative. */
enum {
    NAMES_UNKNOWN = -1, /* no name is similar */
    NAMES_CLOSE = -2,   /* the message suggests a name that is spelled similarly */
    NAMES_SEVERAL = -3, /* the text is a prefix of several names, which the message lists */
};

/*
 * Returns the index of the name that equals the text, or of the only name that begins with the text.
 * Otherwise returns NAMES_UNKNOWN, NAMES_CLOSE or NAMES_SEVERAL, and writes a message such as "unknown
 * command 'barier'; did you mean 'barrier'?". `what` is the noun for the names in the message, here
 * "command".
 */
int names_find(names_list *list, const void *context, const char *what, const char *text,
               char message[NAMES_MESSAGE]);

/* Returns the name whose spelling is closest to the text, or NULL if no name is similar. */
const char *names_closest(names_list *list, const void *context, const char *text);

enum { NAMES_SHOWN = 64 };

/* Returns a copy of a text that can be shown in a message: the copy is shortened if necessary, and control
 * characters are escaped. The copy lives until the end of the block that contains the call. */
#define names_shown(text) escape_text(text, (char[NAMES_SHOWN]){""}, NAMES_SHOWN)

#endif
