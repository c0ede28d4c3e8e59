/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Looks up names in lists. An unambiguous prefix stands for a name. If a name has a typo, messages suggest
 * the right name. */
#ifndef SHELL_NAMES_H
#define SHELL_NAMES_H

#include "io/escape.h"
#include <stdbool.h>
#include <stddef.h>

/* Returns the name with index k of a list, or NULL after the last name. */
typedef const char *names_list(const void *context, int k);

/* Returns the index of the name that equals the text, or -1. */
int names_exact(names_list *list, const void *context, const char *text);

/* Returns the index of a name in a text such as "gap separation spacing", or -1. `separator` is the character
 * between names. The text may be NULL. */
int names_index(const char *list, char separator, const char *name);

enum { NAMES_MESSAGE = 256 };

/* The results of names_find if there is no match. All of them are negative. */
enum {
    NAMES_UNKNOWN = -1, /* no name is similar */
    NAMES_CLOSE = -2,   /* the message suggests a name that is spelled similarly */
    NAMES_SEVERAL = -3, /* the text is a prefix of several names, which the message lists */
};

/*
 * Returns the index of the name that equals the text, or of the only one that begins with the text. Otherwise
 * returns one of the negative results above, and writes a message. `what` is the noun in the message, such as
 * "command".
 */
int names_find(names_list *list, const void *context, const char *what, const char *text,
               char message[NAMES_MESSAGE]);

/* Returns the name whose spelling is closest to the text, or NULL if no name is similar. */
const char *names_closest(names_list *list, const void *context, const char *text);

enum { NAMES_SHOWN = 64 };

/* Returns a copy of a text for messages, shortened and escaped. The copy lives until the end of the block
 * that contains the call. */
#define names_shown(text) escape_text(text, (char[NAMES_SHOWN]){""}, NAMES_SHOWN)

#endif
