/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What went wrong, as a value. Functions describe a problem and return false; whoever ran them prints it,
 * writes it into a row, or drops it.
 */
#ifndef SHELL_PROBLEM_H
#define SHELL_PROBLEM_H

#include <stdbool.h>

enum problem_kind {
    PROBLEM_NONE,
    PROBLEM_WRONG,     /* the line is wrong, with whatever values */
    PROBLEM_NO_ANSWER, /* the line is right, but has no answer with these values: a sweep goes on */
};

enum { PROBLEM_TEXT = 1024 };

struct problem {
    enum problem_kind kind;
    int column;          /* where in the line it is, from 1; 0: nowhere in particular */
    int place;           /* the column that the next report is about */
    const char *command; /* name of the command that runs, or NULL */
    char text[PROBLEM_TEXT];
};

/* Begins without a problem, in a command. */
static inline void problem_begin(struct problem *problem, const char *command)
{
    problem->kind = PROBLEM_NONE;
    problem->column = problem->place = 0;
    problem->command = command;
    problem->text[0] = '\0'; /* the rest needs no initial value */
}

/* Describes a problem; the first description stays. Returns false. */
bool problem_report(struct problem *problem, enum problem_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
#define problem_error(problem, ...)     problem_report(problem, PROBLEM_WRONG, __VA_ARGS__)
#define problem_no_answer(problem, ...) problem_report(problem, PROBLEM_NO_ANSWER, __VA_ARGS__)

#endif
