/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses the wishes of 'design' and 'improve', such as 'safety 2 hall 20 m', in any order. */
#include "planning/planning.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* 'design' has the wishes before 'sizes', and 'improve' those from 'hall' on. */
enum wish { FALLS, SAFETY, HALL, GRID, BOARDS, SIZES, WISHES };

static const char *const names[WISHES + 1] = {"falls", "safety", "hall", "grid", "boards", "sizes"};

/* The largest probability that 'falls' accepts. Designs are then tried with 200000 random rows. */
#define FALLS_MOST ((domq_real)9999 / 10000)

static const struct wishes usual_wishes = {.safety = 2, .hall = (domq_real)HUGE_VAL};

struct domq_domino domino_from_double(const struct dom_domino *domino)
{
#define VALUE(member) .member = quad_decimal(domino->member),
#define NONE(...)
    return (struct domq_domino){DOM_MEMBERS_domino(VALUE, NONE, NONE, NONE)};
#undef VALUE
#undef NONE
}

const struct wishes *wishes_of(const struct query *query)
{
    return query->given->bound ? query->given->bound : &usual_wishes;
}

const char *design_wishes(const void *context, int k)
{
    (void)context;
    return k < SIZES ? names[k] : NULL;
}

const char *improve_wishes(const void *context, int k)
{
    (void)context;
    return names[k + HALL];
}

/* The wishes as they were parsed. An item that the user did not type is zero. */
struct wishes_parsed {
    struct item value[BOARDS], board[BOARDS_MOST];
    size_t boards;
    /* The unit at the end of the list of boards, in m: 0.01 for '1, 2, 3 cm'. If the list does not end with a
     * unit of length, 0.001, which stands for mm. */
    domq_real board_unit;
    bool sizes;
};

/* Returns the length unit at the end of the text from `from` to `end` in m, or 1 mm if there is none. */
static domq_real unit_at_end(const char *from, const char *end)
{
    char name[8];
    const char *at = end;
    while (at > from && isalpha((unsigned char)at[-1]))
        at--;
    struct quantity unit = {.value = 0};
    if (name_copy(at, (size_t)(end - at), name, sizeof name))
        unit = expression_unit(name);
    return quantity_alike(unit, (struct quantity){.length = 1}) ? unit.value : (domq_real)1 / 1000;
}

/* Parses a list of thicknesses, as in '9, 12, 15 mm'. */
static bool boards_parse(struct reader *r, struct wishes_parsed *w)
{
    static const struct argument board = {.name = "boards", .kind = ARGUMENT_ANY};
    bool more;
    w->boards = 0;
    do {
        if (w->boards == BOARDS_MOST)
            return problem_error(r->problem, "there are more than %d boards; leave some out", BOARDS_MOST);
        r->at = skip_blanks(r->at);
        reader_place(r, r->at);
        r->stops = ",";
        const char *from = r->at;
        const bool good = item_parse(r, &board, &w->board[w->boards++]);
        r->stops = NULL;
        if (!good)
            return false;
        w->board_unit = unit_at_end(from, r->at);
        r->at = skip_blanks(r->at);
        more = *r->at == ',';
        r->at += more;
    } while (more);
    return true;
}

bool wishes_parse(struct reader *r, struct question *q)
{
    const struct argument *own = q->command->argument;
    while (own->parse != wishes_parse)
        own++;
    names_list *const list = own->choices;
    static const struct argument values[BOARDS] = {{.name = "falls", .kind = ARGUMENT_ANY},
                                                   {.name = "safety", .kind = ARGUMENT_ANY},
                                                   {.name = "hall", .kind = ARGUMENT_HEIGHT},
                                                   {.name = "grid", .kind = ARGUMENT_HEIGHT}};
    const struct argument wish = {.name = "WISHES", .noun = "wish", .choices = list};
    struct wishes_parsed *w = q->parsed = reader_memory(r, sizeof *w);
    if (!w)
        return false;
    while (!reader_ends(r)) {
        struct item name;
        reader_place(r, r->at);
        if (!item_parse_choice(r, &wish, &name))
            return false;
        const int k = (int)name.number + (list == improve_wishes ? HALL : 0);
        const bool ends = k != SIZES && reader_ends(r);
        reader_place(r, r->at);
        if (ends)
            return problem_error(r->problem, "the value of '%s' is missing; write, for example, '%s'",
                                 names[k],
                                 k == FALLS    ? "falls 99 %"
                                 : k == SAFETY ? "safety 2"
                                 : k == HALL   ? "hall 20 m"
                                 : k == BOARDS ? "boards 9, 12, 15 mm"
                                               : "grid 1 mm");
        if (k == SIZES)
            w->sizes = true;
        else if (k == BOARDS ? !boards_parse(r, w) : !item_parse(r, &values[k], &w->value[k]))
            return false;
    }
    return true;
}

bool grid_check(domq_real grid, domq_real first, struct problem *problem)
{
    return grid < first || problem_no_answer(problem,
                                             "a grid of %s is too coarse: domino 1 is %s tall and cannot "
                                             "reach across a gap of this length; enter a finer grid",
                                             measured(grid, "m", 6).text, measured(first, "m", 6).text);
}

/* ---- Binding ---- */

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* Computes and sorts the thicknesses of the boards. The unit at the end of the list also applies to
 * numbers without a unit, such as the 1 and the 2 in '1, 2, 3 cm'. If the list does not end with a unit,
 * these numbers are in mm, the usual unit for boards. */
static bool boards_bind(const struct question *q, const struct query *query, struct wishes *w,
                        struct problem *problem)
{
    const struct wishes_parsed *parsed = q->parsed;
    struct quantity board[BOARDS_MOST] = {{.value = 0}};
    w->boards = parsed->boards;
    for (size_t i = 0; i < w->boards; i++) {
        domq_real thickness;
        if (!item_bind(&parsed->board[i], q->text, query, &board[i], &thickness, problem))
            return false;
        const bool bare = quantity_is_number(board[i]),
                   length = quantity_alike(board[i], (struct quantity){.length = 1});
        if (!(thickness > 0) || (!bare && !length))
            return problem_error(
                problem, "the thickness of a board must be a length above 0, as in 'boards 9, 12, 15 mm'");
        w->board[i] = (double)(bare ? thickness * parsed->board_unit : thickness);
    }
    qsort(w->board, w->boards, sizeof *w->board, compare);
    return true;
}

bool wishes_bind(const struct question *q, const struct query *query, struct arguments *given,
                 struct problem *problem)
{
    const struct wishes_parsed *parsed = q->parsed;
    struct quantity unit[BOARDS] = {{.value = 0}};
    struct wishes *w = arguments_take(given, sizeof *w, query, problem);
    if (!w)
        return false;
    *w = usual_wishes;
    w->sizes = parsed->sizes;
    domq_real *const value[BOARDS] = {&w->falls, &w->safety, &w->hall, &w->grid};
    for (int k = 0; k < BOARDS; k++)
        if (parsed->value[k].argument &&
            !item_bind(&parsed->value[k], q->text, query, &unit[k], value[k], problem))
            return false;
    if (parsed->value[FALLS].argument &&
        !(quantity_is_number(unit[FALLS]) && w->falls > 0 && w->falls <= FALLS_MOST))
        return problem_error(problem, "'falls' is a probability of at most 99.99 %%, as in 'falls 99 %%'");
    if (!quantity_is_number(unit[SAFETY]))
        return problem_error(
            problem, "the safety is a number without a unit; 2 means twice the energy that a domino needs");
    return boards_bind(q, query, w, problem);
}
