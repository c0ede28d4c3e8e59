/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/drawing/draw_words.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- Lists for completion ---- */

/* The words that may follow a word, up to a NULL. */
struct follow {
    const char *before; /* "": the first; NULL: any other */
    const char *word[5];
};

static const char *follower(const struct follow *list, const char *before, int k)
{
    while (list->before && strcmp(list->before, before) != 0)
        list++;
    return k < 5 ? list->word[k] : NULL;
}

const char *draw_names(const void *before, int k)
{
    static const struct follow list[] = {
        {"draw", {"at", "forces", "train"}},
        {"train", {"forces"}},
        {"at", {"domino", "end"}},
        {"domino", {NULL}},
        {"forces", {NULL}},
        {"end", {NULL}},
        {NULL, {"forces"}},
    };
    return follower(list, before ? before : "draw", k);
}

const char *film_names(const void *before, int k)
{
    static const struct follow list[] = {
        {"train", {NULL}},
        {"speed", {NULL}},
        {"rate", {NULL}},
        {NULL, {"rate", "speed", "train"}},
    };
    return follower(list, before ? before : "", k);
}

/* ---- Reading ---- */

static bool more(struct reader *r)
{
    r->at = skip_blanks(r->at);
    return !command_ends(r->at) && *r->at != '>';
}

/* Takes this very word, if it is the next one. */
static bool word_is(struct reader *r, const char *word)
{
    size_t n = strlen(word);
    bool is = strncmp(r->at, word, n) == 0 && !isalnum((unsigned char)r->at[n]) &&
              !strchr("_.(", r->at[n] ? r->at[n] : ' ');
    if (is)
        r->at += n;
    return is;
}

/* Returns true where a name begins that is neither a value nor one of the words: it was meant as one of them.
 */
static bool stray_word(struct reader *r)
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
    char *word = read_word(r, false);
    problem_error(r->problem, "'%s' %s; %s", names_shown(word ? word : "", shown), what, usage);
    free(word);
    return false;
}

static const char unknown[] = "is neither a value nor one of the words",
                  too_many[] = "is one argument too many";

/* Reads a value; its kind is checked. */
static bool value(struct reader *r, const char *name, enum argument_kind kind, struct quantity *q,
                  domq_real *number)
{
    r->problem->place = reader_column(r, r->at);
    return more(r) ? read_quantity(r, &(struct argument){.name = name, .kind = kind}, q, number)
                   : problem_error(r->problem, "%s is missing", name);
}

static bool nothing_more(struct reader *r, const char *usage)
{
    r->problem->place = reader_column(r, r->at);
    return !more(r) || wrong_word(r, too_many, usage);
}

static const char draw_usage[] =
    "usage: draw, draw at 2.5 s, draw at domino 8, draw at end, draw train, draw 0.3 forces";

/* Reads the moment that follows 'at'. */
static bool read_at(struct reader *r, struct draw_what *what)
{
    struct quantity q = {.value = 0};
    what->column = r->problem->place = reader_column(r, skip_blanks(r->at));
    if (!more(r))
        return problem_error(r->problem, "the moment is missing; %s", draw_usage);
    what->at = ROW_AT_TIME;
    if (word_is(r, "end")) {
        what->at = ROW_AT_END;
        return nothing_more(r, draw_usage);
    }
    if (word_is(r, "domino")) {
        what->at = ROW_AT_DOMINO;
        r->problem->place = reader_column(r, skip_blanks(r->at));
        return more(r)
                   ? value(r, "the domino", ARGUMENT_ANY, &q, &what->domino) && nothing_more(r, draw_usage)
                   : problem_error(r->problem,
                                   "the number of the domino is missing, as in 'draw at domino 8'");
    }
    if (stray_word(r))
        return wrong_word(r, unknown, draw_usage);
    r->last = true;
    if (!value(r, "the moment", ARGUMENT_ANY, &q, &what->time))
        return false;
    if (!quantity_plain(q) && !quantity_alike(q, (struct quantity){.time = 1})) {
        char kind[64];
        return problem_error(r->problem, "the moment is a time in s, not %s; an example is 'draw at 2.5 s'",
                             expression_kind(q, kind, sizeof kind));
    }
    return nothing_more(r, draw_usage);
}

bool draw_read(struct reader *r, struct arguments *given)
{
    struct draw_what *what = calloc(1, sizeof *what);
    struct quantity q = {.value = 0};
    given->own = what;
    given->own_free = free;
    if (!what)
        return problem_status(r->problem, r->query->scene, DOM_NO_MEMORY);
    if (word_is(r, "at"))
        return read_at(r, what);
    what->train = word_is(r, "train");
    while (more(r)) {
        r->problem->place = reader_column(r, r->at);
        r->last = false;
        if (what->forces && word_is(r, "forces"))
            return problem_error(r->problem, "'forces' is said twice; T is an angle, 'draw 0.1 forces'");
        if (what->forces)
            return wrong_word(r, too_many, draw_usage);
        if (word_is(r, "forces"))
            what->forces = true;
        else if (what->tilted || stray_word(r))
            return wrong_word(r, what->tilted ? too_many : unknown, draw_usage);
        else if (!value(r, "T", ARGUMENT_PLACE, &q, &what->theta))
            return false;
        else
            what->tilted = true;
    }
    return true;
}

static const char film_usage[] =
    "usage: animate row.gif, animate row.gif speed 0.5 rate 20, animate train.gif train 4";

bool film_read(struct reader *r, struct arguments *given)
{
    struct film_what *what = calloc(1, sizeof *what);
    struct quantity q = {.value = 0};
    given->own = what;
    given->own_free = free;
    if (!what)
        return problem_status(r->problem, r->query->scene, DOM_NO_MEMORY);
    *what = (struct film_what){.speed = 1, .rate = 25};
    while (more(r)) {
        r->problem->place = reader_column(r, r->at);
        r->last = false;
        bool speed = word_is(r, "speed"), rate = !speed && word_is(r, "rate");
        if (speed || rate) {
            what->timed = true;
            if (!value(r, speed ? "speed" : "rate", ARGUMENT_ANY, &q, speed ? &what->speed : &what->rate))
                return false;
            domq_real got = speed ? what->speed : what->rate;
            /* A rate may be said as 20/s. */
            if (!quantity_bare(q) && !(rate && quantity_alike(q, (struct quantity){.time = -1})))
                return problem_error(r->problem, "%s is a plain number", speed ? "the speed" : "the rate");
            if (!(speed ? got >= (domq_real)0.001 && got <= 1000 : got >= 1 && got <= 50))
                return problem_error(
                    r->problem,
                    speed ? "the speed is a number in 0.001 .. 1000; 1 is real time, 0.5 half as fast"
                          : "the rate is a number of frames in a second in 1 .. 50");
        } else if (!what->train && word_is(r, "train")) {
            what->train = true;
        } else if (what->counted || stray_word(r)) {
            return wrong_word(r, what->counted ? too_many : unknown, film_usage);
        } else {
            what->counted = true;
            what->column = r->problem->place;
            if (!value(r, "N", ARGUMENT_ANY, &q, &what->cycles))
                return false;
        }
    }
    return true;
}
