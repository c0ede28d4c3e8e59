/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses and binds the values in a command's arguments. To bind a value means to compute it in a state and to
 * check whether it is allowed. A sweep parses a value once and binds it at every point. */
#ifndef SHELL_ITEM_H
#define SHELL_ITEM_H

#include "interpreter/reader.h"
#include "interpreter/symbols.h"

/* The functions below parse text at the position of the reader and move the reader to the end of this text.
 * After an error, they set the reader's problem and return false or NULL. */

/* Parses an expression for an argument. The item keeps a pointer to the argument. */
bool item_parse(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses value number i of a parameter: a word or an expression. Messages call the value `name`. */
bool item_parse_value(struct reader *reader, const struct parameter *parameter, int i, const char *name,
                      struct item *item);

/* Parses one value of a list such as "r 1.5 s 0.3". If the value of an effect is the word "on", the effect
 * gets its usual value. */
bool item_parse_listed(struct reader *reader, const struct parameter *parameter, struct item *item);

/* Parses one of the argument's choices. The item's number is the index of the choice. */
bool item_parse_choice(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses an angle or one of the argument's choices. For an angle, the item holds an expression. For choice k,
 * it holds the number -1 - k, which cannot be mistaken for an angle. */
bool item_parse_place(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses the name of a parameter of the model or of an effect. If the next word is not a name at all, the
 * error message ends with the text `form`, which shows what the command expects. */
const struct parameter *parameter_parse(struct reader *reader, const char *form);

/* Parses "NAME VALUE NAME VALUE ..." after 'with'. */
const struct assignment *assignments_parse(struct reader *reader);

/* Computes and checks the value of an item. Stores the value in *number. If `quantity` is not NULL, also
 * stores the value with its unit in *quantity. On failure, sets *problem and returns false. If `text` is not
 * NULL, the problem says at which column of the line the value is. */
bool item_bind(const struct item *item, const struct text *text, const struct query *query,
               struct quantity *quantity, domq_real *number, struct problem *problem);

/* Returns true if the name is known in expressions (see value_names). */
bool is_value_name(const struct state *state, const char *name);

/* A names_list of the parameters of the model and, after them, the effects. */
const char *model_names(const void *context, int k);

#endif
