/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The command interpreter.  A row of a command table drives dispatch, arity errors, help and completion.
 */
#ifndef SHELL_COMMAND_H
#define SHELL_COMMAND_H

#include "session.h"

/* What completion may offer for an argument. */
enum argument { ARGUMENT_ANY, ARGUMENT_COMMAND, ARGUMENT_PARAMETER };

/* A command's arguments: word[0] is the command itself. */
struct call {
    int count; /* of arguments, without the command */
    char **word;
    struct answer *answer;
};

struct command {
    const char *name;
    const char *usage;            /* the arguments, "[S]" for one that may be missing */
    const char *summary;          /* one line */
    const char *help;             /* more, or NULL */
    int fewest, most;             /* arguments */
    enum argument first;          /* what the first argument is */
    const struct column *columns; /* of the answer, or NULL */
    bool rows;
    bool (*run)(struct session *session, const struct call *call); /* false: an error was reported */
};

struct command_group {
    const char *title;
    const struct command *commands; /* ends with a NULL name */
};

extern const struct command_group command_groups[]; /* ends with a NULL title */
extern const struct command cycle_commands[], limit_commands[], session_commands[];

const struct command *command_find(const char *name);

/* Runs every command of a text: lines, and ';' between commands; '#' begins a comment. */
void command_run_text(struct session *session, const char *text);

#endif
