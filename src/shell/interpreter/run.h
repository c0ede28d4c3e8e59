/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef SHELL_RUN_H
#define SHELL_RUN_H

#include "interpreter/reader.h"
#include "session/session.h"

/* Parses and runs the command at the reader's position, writes its answer to standard output or a
 * file, and moves the reader to where parsing ended. */
void run_command_at(struct session *session, struct reader *line);

#endif
