/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses and binds the values in a command's arguments. To bind a value means to evaluate it in a state and
 * check it. A sweep binds a value at every point. */
#ifndef SHELL_ITEM_H
#define SHELL_ITEM_H

#include "interpreter/reader.h"
#include "interpreter/symbols.h"

/* The parsers below move the reader. After an error, they set its problem and return false or NULL. */

/* Parses an expression for an argument. The item keeps a pointer to the argument. */
bool item_parse(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses value number i of a parameter: a word or an expression. Messages call the value `name`. */
bool item_parse_value(struct reader *reader, const struct parameter *parameter, int i, const char *name,
                      struct item *item);

/* Parses one value of a list such as "r 1.5 s 0.3". The value "on" of an effect stands for its usual
 * value. */
bool item_parse_listed(struct reader *reader, const struct parameter *parameter, struct item *item);

/* Parses one of the argument's choices. The item's number is the index of the choice. */
bool item_parse_choice(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses an angle or one of the argument's choices. For choice k, the item's number is -1 - k. */
bool item_parse_place(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses the name of an effect or parameter of the model. Some error messages end with `form`, which shows
 * what the command takes. */
const struct parameter *parameter_parse(struct reader *reader, const char *form);

/* Parses "NAME VALUE NAME VALUE ..." after 'with'. */
const struct assignment *assignments_parse(struct reader *reader);

/* Computes and checks the value of an item. Stores the value in *number and, with its unit, in *quantity,
 * unless `quantity` is NULL. On failure, sets *problem and returns false. The problem has a column if `text`
 * is not NULL. */
bool item_bind(const struct item *item, const struct text *text, const struct query *query,
               struct quantity *quantity, domq_real *number, struct problem *problem);

/* Returns true if the name has a value in this state, or in every state if `state` is NULL. */
bool is_value_name(const struct state *state, const char *name);

/* A names_list of the parameters of the model and, after them, the effects. */
const char *model_names(const void *context, int k);

#endif
