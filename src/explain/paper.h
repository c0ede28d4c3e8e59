/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'recipe' and 'paper', which compare the paper with this program. */
#ifndef SHELL_PAPER_H
#define SHELL_PAPER_H

#include "interpreter/command.h"

extern const struct column recipe_columns[], paper_columns[];
bool run_recipe(const struct query *query, struct answer *a, struct problem *problem);
bool run_paper(const struct query *query, struct answer *a, struct problem *problem);

#endif
