/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/problem.h"
#include <stdarg.h>
#include <stdio.h>

bool problem_report(struct problem *problem, enum problem_kind kind, const char *format, ...)
{
    if (problem->kind != PROBLEM_NONE)
        return false;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(problem->text, sizeof problem->text, format, arguments);
    va_end(arguments);
    problem->kind = kind;
    problem->column = problem->place;
    return false;
}
