/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses the wishes of 'design', such as 'safety 2 hall 20 m minimise length', which may be in any order. */
#include "commands/planning/planning.h"

enum wish { SAFETY, HALL, MINIMISE };

const struct wishes usual_wishes = {.safety = 2, .hall = (domq_real)HUGE_VAL, .least = DOM_LEAST_DOMINOES};

const char *wish_names(const void *context, int k)
{
    static const char *const names[] = {[SAFETY] = "safety", [HALL] = "hall", [MINIMISE] = "minimise", NULL};
    (void)context;
    return names[k];
}

static const char *least_names(const void *context, int k)
{
    static const char *const names[] = {
        [DOM_LEAST_DOMINOES] = "dominoes", [DOM_LEAST_LENGTH] = "length", [DOM_LEAST_MASS] = "mass", NULL};
    (void)context;
    return names[k];
}

/* The wishes as they were parsed. An item that the user did not type is zero. */
struct wishes_parsed {
    struct item value[MINIMISE];
    enum dom_least least;
};

static bool wish_parse(struct reader *r, struct wishes_parsed *w)
{
    static const struct argument wish = {.name = "WISHES", .of = "wish", .choices = wish_names},
                                 least = {.name = "minimise",
                                          .of = "thing to minimise",
                                          .choices = least_names},
                                 values[] = {[SAFETY] = {.name = "safety", .kind = ARGUMENT_ANY},
                                             [HALL] = {.name = "hall", .kind = ARGUMENT_HEIGHT}};
    struct item name, thing;
    if (!item_parse_choice(r, &wish, &name))
        return false;
    const int k = (int)name.number;
    bool ends = reader_ends(r);
    reader_place(r, r->at);
    if (ends)
        return problem_error(r->problem,
                             "the value of '%s' is missing; wishes are 'safety 2', 'hall 20 m' and 'minimise "
                             "dominoes'",
                             wish_names(NULL, k));
    if (k != MINIMISE)
        return item_parse(r, &values[k], &w->value[k]);
    if (!item_parse_choice(r, &least, &thing))
        return false;
    w->least = (enum dom_least)thing.number;
    return true;
}

bool wishes_parse(struct reader *r, struct question *q)
{
    struct wishes_parsed *w = q->parsed = arena_take(r->arena, sizeof *w);
    if (!w)
        return problem_error(r->problem, "out of memory");
    w->least = usual_wishes.least;
    r->last = false;
    while (!reader_ends(r)) {
        reader_place(r, r->at);
        if (!wish_parse(r, w))
            return false;
    }
    return true;
}

bool wishes_bind(const struct question *q, const struct query *query, struct arguments *given,
                 struct problem *problem)
{
    const struct wishes_parsed *parsed = q->parsed;
    const struct item *safety = &parsed->value[SAFETY], *hall = &parsed->value[HALL];
    struct quantity unit = {.value = 0};
    struct wishes *w = arguments_take(given, sizeof *w, query, problem);
    if (!w)
        return false;
    *w = usual_wishes;
    w->least = parsed->least;
    if ((safety->argument && !item_bind(safety, q->text, query, &unit, &w->safety, problem)) ||
        (hall->argument && !item_bind(hall, q->text, query, NULL, &w->hall, problem)))
        return false;
    return quantity_bare(unit) || problem_error(problem, "the safety is a number without a unit, such as 2: "
                                                         "times the energy that a domino needs");
}
