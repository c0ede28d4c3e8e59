/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Looks up names in lists. A name can be shortened if no other name in the list begins with the typed
 * letters. If no name begins with them, the message suggests a name with a similar spelling. */
#pragma once

#include "io/escape.h"
#include <stdbool.h>
#include <stddef.h>

/* Returns the name with index k of a list, or NULL after the last name. */
typedef const char *names_list(const void *context, int k);

/* Returns the index of the name that equals the text, or -1. */
int names_exact(names_list *list, const void *context, const char *text);

/* Finds a name in a list that is written as one text, such as "gap separation spacing". `separator` is the
 * character between the names. Returns the index of the name, or -1 if the list does not contain it. The list
 * may be NULL. */
int names_index(const char *list, char separator, const char *name);

/* Writes the names of a list, separated by commas, with the text `before` in front of each. Names for which
 * there is no room become "...". Returns `text`. */
enum { NAMES_ALL = 384 };
const char *names_join(names_list *list, const void *context, const char *before, char text[NAMES_ALL]);

enum { NAMES_MESSAGE = 256 };

/* The results of names_find if there is no match. All of them are negative. */
enum {
    NAMES_UNKNOWN = -1, /* no name is similar */
    NAMES_CLOSE = -2,   /* the message suggests a name that is spelled similarly */
    NAMES_SEVERAL = -3, /* the text is a prefix of several names, which the message lists */
    NAMES_ABSENT = -4,  /* a feature that this build lacks has the name, as the message says */
};

/* The names of features that this build lacks, and these features. The last name is NULL (features.c). */
extern const struct absent_name {
    const char *name, *feature;
} absent_names[];

/* Returns true if a feature that this build lacks has the name. Writes a message that says so. */
bool name_absent(const char *name, char message[NAMES_MESSAGE]);

/*
 * Finds the name that a user means. Returns the index of the name that equals the text. If there is none, but
 * exactly one name begins with the text, returns the index of that name. Otherwise writes a message, and
 * returns one of the negative results above. `what` is the noun in the message, such as "command".
 */
int names_find(names_list *list, const void *context, const char *what, const char *text,
               char message[NAMES_MESSAGE]);

/* Returns the name whose spelling is closest to the text, or NULL if no name is similar. */
const char *names_closest(names_list *list, const void *context, const char *text);

enum { NAMES_SHOWN = 64 };

/* Returns a copy of a string for messages, shortened and escaped. The copy lives until the end of the block
 * that contains the call. */
#define names_shown(text) escape_text(text, (char[NAMES_SHOWN]){""}, NAMES_SHOWN)
