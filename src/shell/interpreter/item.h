/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The values of a command: each is parsed once, and bound in every state that a sweep visits. */
#ifndef SHELL_ITEM_H
#define SHELL_ITEM_H

#include "interpreter/reader.h"
#include "interpreter/symbols.h"

/* The parsers below return false or NULL after an error, with a problem. */

/* Parses an expression for an argument, which the item refers to from then on. */
bool item_parse(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses value number i of a parameter: one of its words, or an expression, which messages call `name`. */
bool item_parse_value(struct reader *reader, const struct parameter *parameter, int i, const char *name,
                      struct item *item);

/* Parses the value of a parameter in a list of names and values, where the next name may follow at once. An
 * effect that is "on" gets its usual value. */
bool item_parse_listed(struct reader *reader, const struct parameter *parameter, struct item *item);

/* Parses one of the argument's names; the number of the item is its index. */
bool item_parse_choice(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses one of the argument's names, whose number is -1 - index, or an angle. */
bool item_parse_place(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses the name of a parameter of the model or of an effect. `form` shows what the command takes. */
const struct parameter *parameter_parse(struct reader *reader, const char *form);

/* Parses "NAME VALUE NAME VALUE ..." after 'with'. */
const struct assignment *assignments_parse(struct reader *reader);

/* Computes the value of an item and checks it. `quantity` may be NULL. */
bool item_bind(const struct item *item, const struct text *text, const struct query *query,
               struct quantity *quantity, domq_real *number, struct problem *problem);

/* Returns true if the name has a value in this state, or, if the state is NULL, in every state. */
bool is_value_name(const struct state *state, const char *name);

/* Lists for names.h the parameters of the model, then the effects. */
const char *model_names(const void *context, int k);

#endif
