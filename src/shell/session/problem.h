/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors as values: a function describes a problem and returns false, and its caller prints the problem,
 * writes it into a row, or ignores it. */
#ifndef SHELL_PROBLEM_H
#define SHELL_PROBLEM_H

#include <stdbool.h>

enum problem_kind {
    PROBLEM_NONE,
    PROBLEM_WRONG,     /* the line is wrong, whatever the values are */
    PROBLEM_NO_ANSWER, /* there is no answer with these values, and a sweep continues */
};

enum { PROBLEM_TEXT = 1024 };

struct problem {
    enum problem_kind kind;
    int column;          /* the place in the line, from 1; 0 for the whole line */
    int place;           /* the column for the next problem */
    const char *command; /* the name of the command; may be NULL */
    char text[PROBLEM_TEXT];
};

/* Begins with no problem. */
static inline void problem_begin(struct problem *problem, const char *command)
{
    problem->kind = PROBLEM_NONE;
    problem->column = problem->place = 0;
    problem->command = command;
    problem->text[0] = '\0'; /* clearing all of the text would take longer than a short command */
}

/* Describes a problem, unless one is described already. Returns false. */
bool problem_report(struct problem *problem, enum problem_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
#define problem_error(problem, ...)     problem_report(problem, PROBLEM_WRONG, __VA_ARGS__)
#define problem_no_answer(problem, ...) problem_report(problem, PROBLEM_NO_ANSWER, __VA_ARGS__)

#endif
