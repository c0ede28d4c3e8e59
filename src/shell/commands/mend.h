/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command mend: what would save a row that does not fall. */
#ifndef SHELL_MEND_H
#define SHELL_MEND_H

#include "interpreter/command.h"

extern const struct column mend_columns[];
bool mend_run(struct session *session, const struct call *call);

#endif
