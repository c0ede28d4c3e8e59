/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heights that people want to topple. Their names have values in expressions: 'count big_ben', or 'eiffel/h'.
 * A name that 'let' defines hides a landmark of the same name. */
#ifndef SHELL_LANDMARKS_H
#define SHELL_LANDMARKS_H

struct landmark {
    const char *name;   /* in lower case, with '_' between words */
    const char *also;   /* another name, or NULL */
    const char *height; /* a decimal number, in metres */
    const char *what;   /* what the landmark is, and for which year or state the height holds */
    const char *source;
};

/* The last name is NULL. */
enum { LANDMARKS = 20 };
extern const struct landmark landmarks[LANDMARKS + 1];

/* Returns the landmark with whose name the text begins, and stores the end of the name in *end. The longest
 * name counts. Case does not matter, and blanks may stand for '_', as in "Big Ben". Returns NULL if the text
 * begins with no such name. */
const struct landmark *landmark_scan(const char *text, const char **end);

/* Returns the landmark with this name, or NULL. */
const struct landmark *landmark_find(const char *name);

/* A names_list (see names.h). */
const char *landmark_names(const void *context, int k);

#endif
