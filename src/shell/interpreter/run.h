/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a parsed command and sends its output to the terminal, the pager or a file. */
#ifndef SHELL_RUN_H
#define SHELL_RUN_H

#include "interpreter/question.h"
#include "session/session.h"

/* Binds and runs a command. If the reader is at a '>', the answer goes to the file named after the '>'.
 * Returns false, with the problem in reader->problem. */
bool run_question(struct session *session, struct reader *reader, const struct question *question);

#endif
