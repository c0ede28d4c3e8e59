/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help for programs: a row for each command, parameter and effect. */
#include "commands/help_rows.h"
#include "answer/answer.h"
#include "session/effects.h"
#include <string.h>

static const struct column help_columns[] = {
    {"name", "", "what is explained", 0},
    {"kind", "", "command, parameter, effect, variable or function", 0},
    {"usage", "", "how it is typed", 0},
    {"summary", "", "what it does, in one line", 0},
    {"equation", "", "of the paper", 0},
    {"text", "", "more about it", 0},
    {"keys", "", "of the answer, with blanks between", 0},
    {"example", "", "commands that show it", 0},
    {"see", "", "others, with blanks between", 0},
    {NULL, NULL, NULL, 0},
};

void help_rows_begin(struct answer *answer)
{
    answer_columns(answer, help_columns);
}

void help_row_command(struct answer *answer, const struct command *c)
{
    char usage[USAGE_SIZE], keys[ANSWER_HEAD] = "";
    for (const struct column *k = c->columns; k && k->key; k++) {
        size_t used = strlen(keys);
        snprintf(keys + used, sizeof keys - used, "%s%s", used ? " " : "", k->key);
    }
    answer_cells(answer, cell_word(c->name), cell_word("command"), cell_word(command_usage(c, usage)),
                 cell_word(c->summary), cell_word(c->equation), cell_word(c->help),
                 cell_word(*keys ? keys : NULL), cell_word(c->example), cell_word(c->see));
}

void help_row_parameter(struct answer *answer, const struct parameter *p)
{
    char usage[EFFECT_USAGE + 8], rest[EFFECT_USAGE] = "VALUE", example[EFFECT_EXAMPLE];
    if (p->effect)
        snprintf(usage, sizeof usage, "effect %s", effect_usage(p->which, rest));
    else
        snprintf(usage, sizeof usage, "set %s VALUE", p->name);
    answer_cells(answer, cell_word(p->name), cell_word(p->effect ? "effect" : "parameter"), cell_word(usage),
                 cell_word(parameter_meaning(p)), cell_word(p->effect ? p->effect->source : NULL),
                 cell_word(parameter_help(p)), cell_word(NULL),
                 cell_word(p->effect ? effect_example(p->which, example) : NULL), cell_word(NULL));
}

void help_row_variable(struct answer *answer, const struct variable *v)
{
    char head[VARIABLE_HEAD], value[VARIABLE_VALUE], usage[VARIABLE_HEAD + 16];
    snprintf(usage, sizeof usage, "let %s = VALUE", variable_head(v, head));
    answer_cells(answer, cell_word(v->name), cell_word(v->body ? "function" : "variable"), cell_word(usage),
                 cell_word(v->body ? v->body : variable_value(v, value)), cell_word(NULL), cell_word(NULL),
                 cell_word(NULL), cell_word(NULL), cell_word("let"));
}
