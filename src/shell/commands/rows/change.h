/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of the commands change and place. */
#ifndef SHELL_CHANGE_H
#define SHELL_CHANGE_H

#include "interpreter/question.h"

/* change_parse_dominoes parses which dominoes change, as in "4,6-8" or "all". change_parse_value parses the
 * value, such as "16 mm", "+1 cm" or "-10 %". change_bind is the binding function of the value; it evaluates
 * both arguments. */
bool change_parse_dominoes(struct reader *reader, struct question *question);
bool change_parse_value(struct reader *reader, struct question *question);
bool change_bind(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);

/* Changes a measure of dominoes. Without an argument that names the measure, changes gaps. */
bool run_change(const struct query *query, struct answer *a, struct problem *problem);

#endif
