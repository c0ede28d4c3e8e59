/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors are values here. A function that fails stores a message in a struct problem, and returns false. The
 * caller decides what happens to the message. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum problem_kind {
    PROBLEM_NONE,
    PROBLEM_WRONG,     /* the line is wrong, whatever the values of the parameters */
    PROBLEM_NO_ANSWER, /* there is no answer for the current values; a sweep continues with its next point */
};

enum { PROBLEM_TEXT = 1024 };

struct problem {
    enum problem_kind kind;
    int column; /* the column of the error in the line, counted from 1; 0 stands for the whole line */
    int place;  /* the column to report if an error occurs now; problem_report copies it to `column` */
    const char *command; /* the name of the command; may be NULL */
    const char *at;      /* the position of an error in an expression, until its column is known, or NULL */
    bool of_function;    /* the message already names the 'let' function that has this error */
    char text[PROBLEM_TEXT];
};

static inline void problem_begin(struct problem *problem, const char *command)
{
    problem->kind = PROBLEM_NONE;
    problem->column = problem->place = 0;
    problem->command = command;
    problem->at = NULL;
    problem->of_function = false;
    /* Clearing the whole array would take longer than running a short command. */
    problem->text[0] = '\0';
}

/* Stores a problem and its message, unless the struct already has a problem. Always returns false. */
bool problem_report(struct problem *problem, enum problem_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
#define problem_error(problem, ...)     problem_report(problem, PROBLEM_WRONG, __VA_ARGS__)
#define problem_no_answer(problem, ...) problem_report(problem, PROBLEM_NO_ANSWER, __VA_ARGS__)
