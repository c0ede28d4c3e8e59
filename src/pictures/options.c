/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/options.h"
#include <ctype.h>
#include <string.h>

/* ---- Parsing ---- */

static bool option_fits(const struct option *w, unsigned seen)
{
    return (seen & ~w->beside) == 0 && (w->after & ~seen) == 0;
}

/* Returns true if the next word cannot begin a value and so was probably meant as a keyword. */
static bool is_stray(const struct reader *r)
{
    char word[64];
    int n = (int)strspn(r->at, "abcdefghijklmnopqrstuvwxyz");
    snprintf(word, sizeof word, "%.*s", n, r->at);
    return n > 0 && (isspace((unsigned char)r->at[n]) || r->at[n] == '>' || command_ends(r->at + n)) &&
           names_exact(value_names, r->query->state, word) < 0;
}

/* Reads the next keyword. Returns its index, the index of a value without a keyword, or that of the end of
 * the list. */
static int option_next(struct reader *r, const struct options_parsed *p)
{
    int k = 0;
    for (const struct option *w; (w = &p->list->options[k])->name; k++)
        if (option_fits(w, p->seen) && (*w->name ? reader_takes(r, w->name) : !is_stray(r)))
            break;
    return k;
}

/* Reports a word that is not in the list, or that does not fit the words before it. */
static bool wrong_word(struct reader *r, const struct options_parsed *p)
{
    bool is_many = !is_stray(r);
    for (const struct option *w = p->list->options; w->name; w++)
        is_many = is_many || (*w->name && (w->after & ~p->seen) == 0 && word_is_next(r, w->name));
    const char *word = read_word(r, false);
    return problem_error(r->problem, "'%s' %s; %s", names_shown(word ? word : ""),
                         is_many ? "is one argument too many"
                                 : "is neither a value nor a word that fits here",
                         p->list->usage);
}

static bool value_parse(struct reader *r, struct options_parsed *p, int k, int i)
{
    const struct option *w = &p->list->options[k];
    const char *no_unit = r->no_unit;
    reader_place(r, r->at);
    if (reader_ends(r))
        return problem_error(r->problem, "the value of '%s' is missing; %s", w->name, p->list->usage);
    if (!w->argument)
        return (p->text[k] = read_text(r)) != NULL;
    if (w->argument->choices)
        return item_parse_choice(r, w->argument, &p->item[k][i]);
    /* Is this the last argument of the command? */
    r->last = p->list->is_whole;
    for (const struct option *other = p->list->options; other->name; other++)
        r->last = r->last && !option_fits(other, p->seen | BIT(k));
    r->no_unit = p->list->no_unit;
    const bool good = item_parse(r, w->argument, &p->item[k][i]);
    r->no_unit = no_unit;
    return good;
}

bool options_parse(struct reader *r, const struct option_list *list, struct options_parsed *p)
{
    p->list = list;
    while (!reader_ends(r)) {
        r->last = false;
        reader_place(r, r->at);
        const int k = option_next(r, p), column = r->problem->place;
        const struct option *w = &list->options[k];
        if (!w->name)
            return !list->is_whole || wrong_word(r, p);
        for (int i = 0; i < w->values; i++)
            if (!value_parse(r, p, k, i))
                return false;
        p->column[k] = column;
        p->seen |= BIT(k); /* not before its values, which completion may offer beside other words */
    }
    return true;
}

/* ---- Binding ---- */

static bool value_check(const struct option *w, struct quantity quantity, domq_real *number,
                        struct problem *problem)
{
    const char *unit = w->unit ? w->unit : "";
    const bool is_plain = quantity_is_number(quantity);
    if (w->time && !quantity_is_dimensionless(quantity) &&
        !quantity_alike(quantity, (struct quantity){.time = w->time}))
        return problem_error(problem, "%s, not %s",
                             w->time > 0 ? "this needs a time such as 2.5 s"
                                         : "this needs a rate such as 25/s",
                             expression_kind(quantity));
    *number *= strcmp(unit, " cm") == 0 && !is_plain ? 100 : 1;
    return !(w->most > 0) ||
           (*number >= (domq_real)(w->least * (1 - 1e-12)) &&
            *number <= (domq_real)(w->most * (1 + 1e-12))) ||
           problem_error(problem, "%s is %.6g%s; it must be in the range %g .. %g%s", w->name,
                         (double)*number, unit, w->least, w->most, unit);
}

bool options_bind(const struct options_parsed *p, const struct text *text, const struct query *query,
                  struct options *options, struct problem *problem)
{
    for (int k = 0; p->list && p->list->options[k].name; k++) {
        const struct option *w = &p->list->options[k];
        options->has[k] = (p->seen & BIT(k)) != 0;
        options->column[k] = p->column[k];
        options->text[k] = p->text[k];
        for (int i = 0; i < w->values && options->has[k] && w->argument; i++) {
            struct quantity quantity;
            domq_real *value = &options->value[k][i];
            if (w->argument->choices)
                *value = p->item[k][i].number;
            else if (!item_bind(&p->item[k][i], text, query, &quantity, value, problem) ||
                     !value_check(w, quantity, value, problem))
                return false;
        }
    }
    return true;
}

bool options_bind_argument(const struct question *q, const struct query *query, struct arguments *given,
                           struct problem *problem)
{
    struct options *options = arguments_take(given, sizeof *options, query, problem);
    return options && options_bind(q->parsed, q->text, query, options, problem);
}

const struct options *options_of(const struct query *query)
{
    static const struct options none = {.has = {false}};
    return query->given->bound ? query->given->bound : &none;
}
