/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a line that is being typed ends in: for completion, and for the hint after it. */
#ifndef SHELL_TYPED_H
#define SHELL_TYPED_H

#include "interpreter/command.h"

enum { TYPED_WORD = 64 };

struct typed {
    const char *line;  /* where the last command of the line begins, after a ';' */
    const char *begin; /* the same, or after the ':' of a sweep, where another command begins */
    const char *last;  /* of the command's last word, which may be empty; after its '"' if it has one */
    const struct command *command;     /* NULL: not known yet */
    const struct parameter *parameter; /* that the command gives values to, or NULL */
    int words;                         /* the command's name and the arguments before the last word */
    const struct command *sweep;       /* unless NULL, the command comes after its ':' */
    bool file;                         /* the last word is the file after '>' */
    bool joins;                        /* the last word goes on with the expression before it */
    bool number;                       /* the word before the last one is a number without a unit */
    bool unit;                         /* the last word is a unit of that number */
    char choice[TYPED_WORD];           /* the first argument, and the word before the last one */
    char before[TYPED_WORD];
};

/* Finds what the line ends in. */
void typed_read(const char *line, struct typed *typed);

/* Returns the argument that the last word belongs to, from 0; -1: it is the name of the command. */
int typed_argument(const struct typed *typed);

#endif
