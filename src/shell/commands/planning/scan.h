/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The values of a parameter at which an answer takes a value: a scan of a range, then roots. */
#ifndef SHELL_SCAN_H
#define SHELL_SCAN_H

#include "commands/planning/inquiry.h"

struct solve {
    const struct parameter *parameter;
    domq_real from, to;
    const struct question *question;
    bool verdict;          /* no value was given: finds where the verdict changes */
    struct quantity value; /* that the answer is to take */
};

enum { ROOTS_MOST = 64 };

struct point {
    domq_real x, f; /* the answer less the value; NaN: no answer */
};

struct root {
    domq_real x, answer;
    const char *branch;
};

/* What is known of an answer along the parameter. */
struct scan {
    struct probe probe;
    const struct solve *solve;
    struct root root[ROOTS_MOST];
    int roots, jumps;
    domq_real jump;           /* where the answer passes the value without taking it */
    struct point most, least; /* of all points with an answer */
    size_t answers;
    char none[PROBLEM_TEXT / 2]; /* the first reason for no answer */
};

/* Looks along the whole range. False: the line is wrong, or there was an interrupt; see scan->probe. */
bool scan_run(struct scan *scan);

#endif
