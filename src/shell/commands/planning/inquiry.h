/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A question that is asked again and again with other values of one parameter. */
#ifndef SHELL_INQUIRY_H
#define SHELL_INQUIRY_H

#include "interpreter/question.h"

/* A parameter that is varied in copies of the state of a query. */
struct probe {
    const struct query *query;
    const char *command; /* the name of the command that asks */
    const struct question *question;
    const struct parameter *parameter; /* NULL: nothing is changed */
    bool verdict;                      /* asks whether what the command decides is true: 1 or -1 */
    struct problem problem;            /* of the last question that had no answer */
    bool wrong;                        /* the line is wrong: no value of the parameter helps */
    struct quantity unit;              /* of the last answer */
};

/* Returns the answer where the parameter has this value; NaN if there is none, with probe->problem. */
domq_real probe_at(struct probe *probe, domq_real value);

/* Gives the problem of the last question. Returns false. */
bool probe_report(const struct probe *probe, struct problem *problem);

#endif
