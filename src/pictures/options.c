/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/options.h"
#include "language/text.h"

/* ---- Parsing ---- */

static bool option_fits(const struct option *w, unsigned seen)
{
    return (seen & ~w->beside) == 0 && (w->after & ~seen) == 0;
}

static bool value_parse(struct reader *r, struct options_parsed *p, int k)
{
    const struct option *w = &p->list->options[k];
    reader_place(r, r->at);
    if (reader_ends(r))
        return problem_error(r->problem, "the value of '%s' is missing; %s", w->name, p->list->usage);
    return item_parse(r, w->argument, &p->item[k]);
}

const struct options_parsed *options_parse(struct reader *r, struct question *q,
                                           const struct option_list *list)
{
    struct options_parsed *p = q->parsed = reader_memory(r, sizeof *p);
    if (!p)
        return NULL;
    p->list = list;
    while (!reader_ends(r)) {
        int k = 0;
        const struct option *w;
        reader_place(r, r->at);
        const int column = r->problem->place;
        for (; (w = &list->options[k])->name; k++)
            if (option_fits(w, p->seen) && (!*w->name || reader_takes(r, w->name)))
                break;
        if (!w->name) {
            const char *word = read_word(r, false);
            problem_error(r->problem, "'%s' does not fit here; %s", names_shown(word ? word : ""),
                          list->usage);
            return NULL;
        }
        if (w->argument && !value_parse(r, p, k)) {
            if (!*w->name) /* it may have been meant as a keyword */
                text_add(r->problem->text, sizeof r->problem->text, "; %s", list->usage);
            return NULL;
        }
        p->column[k] = column;
        p->seen |= BIT(k); /* not before its value, which completion may offer beside other words */
    }
    reader_place(r, r->at);
    return p;
}

/* ---- Binding ---- */

static bool value_check(const struct option *w, struct quantity quantity, domq_real number,
                        struct problem *problem)
{
    const char *unit = w->unit ? w->unit : "";
    if (w->time && !quantity_is_dimensionless(quantity) &&
        !quantity_alike(quantity, (struct quantity){.time = w->time}))
        return problem_error(problem, "%s, not %s",
                             w->time > 0 ? "this needs a time such as 2.5 s"
                                         : "this needs a rate such as 25/s",
                             expression_kind(quantity));
    return !(w->most > 0) ||
           (number >= (domq_real)(w->least * (1 - 1e-12)) && number <= (domq_real)(w->most * (1 + 1e-12))) ||
           problem_error(problem, "%s is %.6g%s; it must be in the range %g .. %g%s", w->name, (double)number,
                         unit, w->least, w->most, unit);
}

bool options_bind_argument(const struct question *q, const struct query *query, struct arguments *given,
                           struct problem *problem)
{
    const struct options_parsed *p = q->parsed;
    struct options *options = arguments_take(given, sizeof *options, query, problem);
    for (int k = 0; options && p->list && p->list->options[k].name; k++) {
        const struct option *w = &p->list->options[k];
        struct quantity quantity;
        options->has[k] = (p->seen & BIT(k)) != 0;
        options->column[k] = p->column[k];
        if (options->has[k] && w->argument &&
            (!item_bind(&p->item[k], q->text, query, &quantity, &options->value[k], problem) ||
             !value_check(w, quantity, options->value[k], problem)))
            return false;
    }
    return options;
}

const struct options *options_of(const struct query *query)
{
    static const struct options none = {.has = {false}};
    return query->given->bound ? query->given->bound : &none;
}
