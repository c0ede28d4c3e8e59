/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a command that has been parsed, and sends its answer where it goes. */
#ifndef SHELL_RUN_H
#define SHELL_RUN_H

#include "interpreter/question.h"
#include "session/session.h"

/*
 * Binds and runs a command. Its answer goes to standard output, to the pager, or to a file if '>' follows
 * where the reader is. Returns false with a problem, which is the reader's.
 */
bool run_question(struct session *session, struct reader *reader, const struct question *question);

#endif
