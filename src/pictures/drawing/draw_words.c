/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/drawing/draw_words.h"
#include "pictures/picture/show.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- Parsing ---- */

struct draw_parsed {
    struct draw_options options;
    struct item item[DRAW_VALUES];
};

static const struct argument arguments[DRAW_VALUES] = {
    [DRAW_TIME] = {.name = "the time", .kind = ARGUMENT_ANY},
    [DRAW_DOMINO] = {.name = "the domino", .kind = ARGUMENT_ANY},
    [DRAW_TILT] = {.name = "T", .kind = ARGUMENT_TILT},
    [DRAW_CYCLES] = {.name = "N", .kind = ARGUMENT_ANY},
    [DRAW_SPEED] = {.name = "the speed", .kind = ARGUMENT_NUMBER},
    [DRAW_RATE] = {.name = "the rate", .kind = ARGUMENT_ANY},
};

static const char draw_usage[] =
    "usage: draw, draw at 2.5 s, draw at domino 8, draw at end, draw train, draw 0.3 forces, draw tower";
static const char film_usage[] = "usage: animate, animate slow, animate speed 0.5 rate 20, animate train 4, "
                                 "animate tower; '> row.gif' writes a file";

/* Returns true if the next word cannot begin a value and so was probably meant as a keyword. */
static bool is_stray(const struct reader *r)
{
    char word[64];
    int n = (int)strspn(r->at, "abcdefghijklmnopqrstuvwxyz");
    snprintf(word, sizeof word, "%.*s", n, r->at);
    return n > 0 && (isspace((unsigned char)r->at[n]) || r->at[n] == '>' || command_ends(r->at + n)) &&
           names_exact(value_names, r->query->state, word) < 0;
}

/* Reports the next word as unknown or, if `many` is true, as one argument too many. Returns false. */
static bool wrong_word(struct reader *r, bool many, const char *usage)
{
    const char *word = read_word(r, false);
    return problem_error(r->problem, "'%s' %s; %s", names_shown(word ? word : ""),
                         many ? "is one argument too many" : "is neither a value nor a word that fits here",
                         usage);
}

static bool end_parse(struct reader *r, const char *usage)
{
    reader_place(r, r->at);
    return reader_ends(r) || wrong_word(r, true, usage);
}

static bool value_parse(struct reader *r, struct draw_parsed *p, enum draw_value value)
{
    reader_place(r, r->at);
    return reader_ends(r) ? problem_error(r->problem, "%s is missing", arguments[value].name)
                          : item_parse(r, &arguments[value], &p->item[value]);
}

/* Parses the words that follow 'at'. */
static bool moment_parse(struct reader *r, struct draw_parsed *p)
{
    reader_place(r, r->at);
    p->options.column = r->problem->place;
    if (reader_ends(r))
        return problem_error(r->problem, "'at' needs a time, 'domino N' or 'end'; %s", draw_usage);
    bool domino = reader_takes(r, "domino");
    p->options.end = !domino && reader_takes(r, "end");
    r->last = !domino;
    reader_place(r, r->at);
    if (domino && reader_ends(r))
        return problem_error(r->problem,
                             "the number of the domino is missing; write, for example, 'draw at domino 8'");
    if (!domino && !p->options.end && is_stray(r))
        return wrong_word(r, false, draw_usage);
    return (p->options.end || value_parse(r, p, domino ? DRAW_DOMINO : DRAW_TIME)) &&
           end_parse(r, draw_usage);
}

bool draw_parse(struct reader *r, struct question *q)
{
    struct draw_parsed *p = q->parsed = reader_memory(r, sizeof *p);
    if (!p || reader_takes(r, "at"))
        return p && moment_parse(r, p);
    p->options.tower = reader_takes(r, "tower");
    if (p->options.tower)
        return end_parse(r, draw_usage);
    p->options.train = reader_takes(r, "train");
    while (!reader_ends(r)) {
        bool full = p->options.forces || p->item[DRAW_TILT].argument;
        reader_place(r, r->at);
        r->last = false;
        if (!p->options.forces && reader_takes(r, "forces"))
            p->options.forces = true;
        else if (full || is_stray(r))
            return wrong_word(r, full, draw_usage);
        else if (!value_parse(r, p, DRAW_TILT))
            return false;
    }
    return true;
}

/* Returns true if the next word is the name of a file, such as "row.gif". */
static bool is_file(const struct reader *r)
{
    char word[256];
    snprintf(word, sizeof word, "%.*s", (int)strcspn(r->at, " \t>;"), r->at);
    const enum extension_kind kind = extension_of(word)->kind;
    return *word == '"' || kind == EXTENSION_FILM ||
           (kind == EXTENSION_OTHER && isalpha((unsigned char)*word));
}

bool film_parse(struct reader *r, struct question *q)
{
    struct draw_parsed *p = q->parsed = reader_memory(r, sizeof *p);
    bool good = p != NULL;
    if (good && is_file(r)) {
        good = (q->file = read_file(r)) != NULL;
        r->at = skip_blanks(r->at);
    }
    while (good && !reader_ends(r)) {
        bool counted = p->item[DRAW_CYCLES].argument || p->options.tower;
        reader_place(r, r->at);
        r->last = false;
        if (reader_takes(r, "speed"))
            good = value_parse(r, p, DRAW_SPEED);
        else if (reader_takes(r, "rate"))
            good = value_parse(r, p, DRAW_RATE);
        else if (!p->options.slow && reader_takes(r, "slow"))
            p->options.slow = true;
        else if (!p->options.train && !p->options.tower && reader_takes(r, "train"))
            p->options.train = true;
        else if (!p->options.train && !counted && reader_takes(r, "tower"))
            p->options.tower = true;
        else if (counted || is_stray(r))
            return wrong_word(r, counted, film_usage);
        else {
            p->options.column = r->problem->place;
            good = value_parse(r, p, DRAW_CYCLES);
        }
    }
    return good;
}

/* ---- Binding ---- */

/* Checks the unit and the range of a value. A rate may be typed as 20 or as 20/s. */
static bool value_check(enum draw_value value, struct quantity quantity, struct problem *problem)
{
    domq_real number = quantity.value;
    bool plain = quantity_is_number(quantity);
    if (value == DRAW_TIME)
        return quantity_is_dimensionless(quantity) ||
               quantity_alike(quantity, (struct quantity){.time = 1}) ||
               problem_error(problem, "'at' needs a time, not %s; write, for example, 'draw at 2.5 s'",
                             expression_kind(quantity));
    if (value == DRAW_SPEED && !(plain && number >= (domq_real)0.001 && number <= 1000))
        return problem_error(
            problem,
            plain ? "the speed must be in the range 0.001 .. 1000; 1 is real time, and 0.5 is half as fast"
                  : "the speed must be a number without a unit");
    plain = plain || quantity_alike(quantity, (struct quantity){.time = -1});
    return value != DRAW_RATE || (plain && number >= 1 && number <= 50) ||
           problem_error(problem, plain ? "the rate must be from 1 to 50 frames per second"
                                        : "the rate must be a number, such as 25 or 25/s");
}

static const struct draw_options usual = {.value = {[DRAW_SPEED] = 1, [DRAW_RATE] = 25}};

const struct draw_options *draw_options_of(const struct query *query)
{
    return query->given->bound ? query->given->bound : &usual;
}

bool draw_bind(const struct question *q, const struct query *query, struct arguments *given,
               struct problem *problem)
{
    const struct draw_parsed *p = q->parsed;
    struct draw_options *options = arguments_take(given, sizeof *options, query, problem);
    if (!options)
        return false;
    *options = p->options;
    memcpy(options->value, usual.value, sizeof options->value);
    for (int k = 0; k < DRAW_VALUES; k++) {
        struct quantity quantity;
        options->has[k] = p->item[k].argument;
        if (options->has[k] &&
            (!item_bind(&p->item[k], q->text, query, &quantity, &options->value[k], problem) ||
             !value_check((enum draw_value)k, quantity, problem)))
            return false;
    }
    return true;
}
