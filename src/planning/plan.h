/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'plan', which writes a guide for building the row. */
#ifndef SHELL_PLAN_H
#define SHELL_PLAN_H

#include "interpreter/question.h"

extern const struct column plan_columns[];
bool plan_parse(struct reader *reader, struct question *question);
bool run_plan(const struct query *query, struct answer *a, struct problem *problem);

#endif
