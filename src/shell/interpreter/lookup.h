/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The names of a session in expressions: its parameters, the last answer, commands with their keys. */
#ifndef SHELL_LOOKUP_H
#define SHELL_LOOKUP_H

#include "language/expression.h"

/* For struct expression; its context is the session. */
bool session_lookup(struct expression *expression, const char *name, const char *key,
                    const struct quantity *arguments, int count, struct quantity *result);

/* A list for names.h: every name that has a value. */
const char *value_names(const void *context, int k);

#endif
