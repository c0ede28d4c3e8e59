/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef SHELL_VALUE_H
#define SHELL_VALUE_H

/*
 * The whole of text as a finite number: decimal, or a quotient of two decimals such as 7/48.
 * NULL, or what is wrong with it ("is no number").
 */
const char *value_parse(const char *text, double *value);

enum { VALUE_SHOWN = 64 };

/* Text as a message may quote it: nothing unprintable, nothing long. */
const char *value_shown(const char *text, char shown[VALUE_SHOWN]);

#endif
