/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/drawing/draw_words.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- Parsing ---- */

static const struct argument moment_argument = {.name = "the moment", .kind = ARGUMENT_ANY},
                             domino_argument = {.name = "the domino", .kind = ARGUMENT_ANY},
                             tilt_argument = {.name = "T", .kind = ARGUMENT_TILT},
                             speed_argument = {.name = "the speed", .kind = ARGUMENT_NUMBER},
                             rate_argument = {.name = "rate", .kind = ARGUMENT_ANY},
                             cycles_argument = {.name = "N", .kind = ARGUMENT_ANY};

/* Returns true where a name begins that is neither a value nor one of the words: it was meant as one of them.
 */
static bool is_stray(const struct reader *r)
{
    char word[64];
    size_t n = strspn(r->at, "abcdefghijklmnopqrstuvwxyz");
    snprintf(word, sizeof word, "%.*s", (int)(n < 63 ? n : 63), r->at);
    return n > 0 && (isspace((unsigned char)r->at[n]) || r->at[n] == '>' || command_ends(r->at + n)) &&
           names_exact(value_names, r->query->state, word) < 0;
}

static bool wrong_word(struct reader *r, const char *what, const char *usage)
{
    char shown[NAMES_SHOWN];
    const char *word = read_word(r, false);
    return problem_error(r->problem, "'%s' %s; %s", names_shown(word ? word : "", shown), what, usage);
}

static const char unknown[] = "is neither a value nor one of the words",
                  too_many[] = "is one argument too many";

static bool value_parse(struct reader *r, const struct argument *a, struct item *item)
{
    reader_place(r, r->at);
    return reader_ends(r) ? problem_error(r->problem, "%s is missing", a->name) : item_parse(r, a, item);
}

static bool nothing_more(struct reader *r, const char *usage)
{
    reader_place(r, r->at);
    return reader_ends(r) || wrong_word(r, too_many, usage);
}

static const char draw_usage[] =
    "usage: draw, draw at 2.5 s, draw at domino 8, draw at end, draw train, draw 0.3 forces";

/* Words and values as they were parsed. */
struct draw_parsed {
    struct draw_what what;
    struct item value; /* the moment, the domino or the tilt */
};
struct film_parsed {
    struct film_what what;
    struct item speed, rate, cycles;
};

/* Parses the moment that follows 'at'. */
static bool moment_parse(struct reader *r, struct draw_parsed *p)
{
    struct draw_what *what = &p->what;
    reader_place(r, r->at);
    what->column = r->problem->place;
    if (reader_ends(r))
        return problem_error(r->problem, "the moment is missing; %s", draw_usage);
    what->at = ROW_AT_TIME;
    if (reader_takes(r, "end")) {
        what->at = ROW_AT_END;
        return nothing_more(r, draw_usage);
    }
    if (reader_takes(r, "domino")) {
        what->at = ROW_AT_DOMINO;
        reader_place(r, r->at);
        if (reader_ends(r))
            return problem_error(r->problem, "the number of the domino is missing, as in 'draw at domino 8'");
        return value_parse(r, &domino_argument, &p->value) && nothing_more(r, draw_usage);
    }
    if (is_stray(r))
        return wrong_word(r, unknown, draw_usage);
    r->last = true;
    return value_parse(r, &moment_argument, &p->value) && nothing_more(r, draw_usage);
}

bool draw_parse(struct reader *r, struct question *q)
{
    struct draw_parsed *p = q->own = arena_take(r->arena, sizeof *p);
    if (!p)
        return problem_error(r->problem, "out of memory");
    struct draw_what *what = &p->what;
    if (reader_takes(r, "at"))
        return moment_parse(r, p);
    what->train = reader_takes(r, "train");
    while (!reader_ends(r)) {
        reader_place(r, r->at);
        r->last = false;
        if (what->forces && word_is_next(r, "forces"))
            return problem_error(r->problem, "'forces' is said twice; T is an angle, 'draw 0.1 forces'");
        if (what->forces)
            return wrong_word(r, too_many, draw_usage);
        if (reader_takes(r, "forces"))
            what->forces = true;
        else if (what->tilted || is_stray(r))
            return wrong_word(r, what->tilted ? too_many : unknown, draw_usage);
        else if (!value_parse(r, &tilt_argument, &p->value))
            return false;
        else
            what->tilted = true;
    }
    return true;
}

bool draw_bind(const struct question *q, const struct query *query, struct arguments *given,
               struct problem *problem)
{
    const struct draw_parsed *p = q->own;
    struct quantity quantity;
    char kind[64];
    struct draw_what *what = malloc(sizeof *what);
    if (!what)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    given->own = what;
    given->own_free = free;
    *what = p->what;
    domq_real *number = what->at == ROW_AT_DOMINO ? &what->domino
                        : what->at == ROW_AT_TIME ? &what->time
                                                  : &what->theta;
    if (!p->value.value)
        return true;
    if (!item_bind(&p->value, q->text, query, &quantity, number, problem))
        return false;
    return what->at != ROW_AT_TIME || quantity_plain(quantity) ||
           quantity_alike(quantity, (struct quantity){.time = 1}) ||
           problem_error(problem, "the moment is a time in s, not %s; an example is 'draw at 2.5 s'",
                         expression_kind(quantity, kind, sizeof kind));
}

static const char film_usage[] =
    "usage: animate row.gif, animate row.gif speed 0.5 rate 20, animate train.gif train 4";

bool film_parse(struct reader *r, struct question *q)
{
    struct film_parsed *p = q->own = arena_take(r->arena, sizeof *p);
    if (!p)
        return problem_error(r->problem, "out of memory");
    struct film_what *what = &p->what;
    *what = (struct film_what){.speed = 1, .rate = 25};
    while (!reader_ends(r)) {
        reader_place(r, r->at);
        r->last = false;
        bool speed = reader_takes(r, "speed"), rate = !speed && reader_takes(r, "rate");
        if (speed || rate) {
            what->timed = true;
            if (!value_parse(r, speed ? &speed_argument : &rate_argument, speed ? &p->speed : &p->rate))
                return false;
        } else if (!what->train && reader_takes(r, "train")) {
            what->train = true;
        } else if (what->counted || is_stray(r)) {
            return wrong_word(r, what->counted ? too_many : unknown, film_usage);
        } else {
            what->counted = true;
            what->column = r->problem->place;
            if (!value_parse(r, &cycles_argument, &p->cycles))
                return false;
        }
    }
    return true;
}

/* Binds a speed or a rate, a plain number in a range; a rate may be said as 20/s. */
static bool pace_bind(const struct item *item, const struct question *q, const struct query *query, bool rate,
                      domq_real *number, struct problem *problem)
{
    struct quantity quantity;
    if (!item->value)
        return true;
    if (!item_bind(item, q->text, query, &quantity, number, problem))
        return false;
    if (!quantity_bare(quantity) && !(rate && quantity_alike(quantity, (struct quantity){.time = -1})))
        return problem_error(problem, "%s is a plain number", rate ? "the rate" : "the speed");
    if (rate ? *number >= 1 && *number <= 50 : *number >= (domq_real)0.001 && *number <= 1000)
        return true;
    return problem_error(problem,
                         rate ? "the rate is a number of frames in a second in 1 .. 50"
                              : "the speed is a number in 0.001 .. 1000; 1 is real time, 0.5 half as fast");
}

bool film_bind(const struct question *q, const struct query *query, struct arguments *given,
               struct problem *problem)
{
    const struct film_parsed *p = q->own;
    struct film_what *what = malloc(sizeof *what);
    if (!what)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    given->own = what;
    given->own_free = free;
    *what = p->what;
    return pace_bind(&p->speed, q, query, false, &what->speed, problem) &&
           pace_bind(&p->rate, q, query, true, &what->rate, problem) &&
           (!p->cycles.value || item_bind(&p->cycles, q->text, query, NULL, &what->cycles, problem));
}
