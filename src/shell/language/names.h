/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names as people type them: exact, or an unambiguous beginning; else what they may have meant. */
#ifndef SHELL_NAMES_H
#define SHELL_NAMES_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

/* Returns name k of a list; NULL after the last one. */
typedef const char *names_list(const void *context, int k);

enum { NAMES_MESSAGE = 256 };

/* What names_find returns if there is no name; all are negative. */
enum {
    NAMES_UNKNOWN = -1, /* no name is similar */
    NAMES_CLOSE = -2,   /* the message says what was meant */
    NAMES_SEVERAL = -3, /* the message says which names begin so */
};

/*
 * Returns the index of the name that text is, or is the only beginning of; else one of the above, with a
 * message: "unknown command 'barier'; did you mean 'barrier'?".  `what` is the kind of name: "command".
 */
int names_find(names_list *list, const void *context, const char *what, const char *text,
               char message[NAMES_MESSAGE]);

/* Returns the index of the exact name, or -1. */
int names_exact(names_list *list, const void *context, const char *text);

/*
 * An index of a list that does not change and needs no context, at most half as long as the index: begins
 * with the list alone, and is made at the first look-up, which may be that of any thread.
 */
enum { NAMES_INDEXED = 256 };

struct names_index {
    names_list *list;
    atomic_bool made;
    unsigned char slot[NAMES_INDEXED]; /* 1 + the number of a name; 0: none */
};

/* Returns what names_exact does, without a walk through the list. */
int names_indexed(struct names_index *index, const char *text);

/* Returns the name in the list that is closest to text, if it is close; else NULL. */
const char *names_closest(names_list *list, const void *context, const char *text);

enum { NAMES_SHOWN = 64 };

/* Writes text as a message can quote it: nothing unprintable, nothing long. */
const char *names_shown(const char *text, char shown[NAMES_SHOWN]);

#endif
