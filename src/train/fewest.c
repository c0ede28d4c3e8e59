/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'count H fewest': the gap and the growth together that need the fewest dominoes. */
#include "language/quad.h"
#include "train/row_start.h"
#include "train/train.h"
#include <stdlib.h>

const struct column fewest_columns[] = {
    {"kind", "", "the kind of domino: a word for q", 7},
    {"start", "",
     "whether the train is moving already, or the first domino tips over, is pushed or is released", 9},
    {"dominoes", "", "the smallest number of dominoes", 0},
    {"r", "", "growth: the size of each domino relative to the one before", 0},
    {"s", "h", "the gap before each domino, divided by its height", 0},
    {"gap", "m", "the first gap, before the second domino: h r s", 0},
    {"last", "m", "the height of the last domino before the one to topple", 0},
    {"reach", "m", "the height of the tallest domino that this row can topple", 0},
    {NULL, NULL, NULL, 0},
};

/* ---- Rows and trains that fall ---- */

/* The search for one kind of domino. */
struct search {
    const struct query *query;
    struct domq_train train;
    bool moves;      /* the train is moving already; otherwise a row begins at rest or with the push */
    domq_real ratio; /* height to reach / height of the first domino */
    domq_real count; /* the number of dominoes, without the one to topple */
    enum dom_status status;
};

/*
 * Returns how well the row of s->train falls: the smallest margin / barrier of its dominoes, which is
 * positive if all fall. If the row stops, the result is at most 0, and lower if the row stops earlier.
 * Returns -INFINITY if the fall ends in another way.
 */
static double spare(struct search *s)
{
    if (dom_raised(query_compute(s->query)->interrupt))
        s->status = DOM_INTERRUPTED;
    const double value = s->moves ? start_train_spare(s->query, &s->train)
                                  : start_row_spare(s->query, &s->train, s->count + 1, &s->status);
    return s->status == DOM_OK && !isnan(value) ? value : (double)-INFINITY;
}

static double spare_at(struct search *s, domq_real separation)
{
    s->train.s = separation;
    return spare(s);
}

/* The gaps that are tried first, and the number of further steps near the best of them. */
enum { GRID = 40, STEPS = 20 };

/* Climbs to a maximum of spare_at between two gaps by golden sections, from the gap `middle` between them.
 * Leaves the best gap in s->train.s and returns its spare. */
static double climb(struct search *s, domq_real low, domq_real middle, double at_middle, domq_real high)
{
    const domq_real golden = (domq_real)0.381966011250105;
    for (int k = 0; k < STEPS && s->status == DOM_OK; k++) {
        const bool is_above = high - middle > middle - low;
        const domq_real x = middle + golden * (is_above ? high - middle : low - middle);
        const double at_x = spare_at(s, x);
        if (at_x > at_middle) {
            *(is_above ? &low : &high) = middle;
            middle = x;
            at_middle = at_x;
        } else
            *(is_above ? &high : &low) = x;
    }
    s->train.s = middle;
    return at_middle;
}

/* Finds the gap at which a row of `count` dominoes has the most energy to spare. Returns true if it falls
 * there. The growth is the smallest one that reaches the height. */
static bool falls_somewhere(struct search *s, domq_real count)
{
    const domq_real least = parameter_find("s")->value->lowest;
    double value[GRID + 2], best = (double)-INFINITY;
    domq_real best_s = DOMQ_NAN;
    s->count = count;
    s->train.r = quad(pow)(s->ratio, 1 / count);
    const domq_real step = 1 / (s->train.r * (GRID + 1)); /* a domino that is farther away is not touched */
    if (step < least || s->train.r > parameter_find("r")->value->highest)
        return false;
    value[0] = value[GRID + 1] = (double)-INFINITY;
    for (int k = 1; k <= GRID && s->status == DOM_OK; k++)
        value[k] = spare_at(s, k * step);
    for (int k = 1; k <= GRID && s->status == DOM_OK; k++) {
        const bool is_top = value[k] >= value[k - 1] && value[k] >= value[k + 1],
                   is_flat = value[k] == value[k - 1] && value[k] == value[k + 1];
        if (!is_top || is_flat || value[k] == (double)-INFINITY)
            continue;
        const double top = climb(s, (k - 1) * step + step / 1024, k * step, value[k], (k + 1) * step);
        if (top > best) {
            best = top;
            best_s = s->train.s;
        }
    }
    s->train.s = best_s;
    return s->status == DOM_OK && best > 0;
}

/* Returns true if a row with these numbers falls, and reaches the height with s->count dominoes. */
static bool is_enough(struct search *s, domq_real r, domq_real separation)
{
    struct domq_count count;
    s->train.r = r;
    s->train.s = separation;
    return any_count_find(1, s->ratio, r, query_compute(s->query), &count) == DOM_OK &&
           count.dominoes <= s->count && spare(s) > 0;
}

/* Rounds growth and gap to as few digits as possible such that the row, run with the rounded numbers, still
 * falls and reaches the height. */
enum { ROUNDED = 12 };
static bool rounds(struct search *s)
{
    const domq_real r = s->train.r, separation = s->train.s;
    for (int digits = 3; digits <= ROUNDED; digits++)
        for (int of_s = 2; of_s <= digits && s->status == DOM_OK; of_s++)
            if (is_enough(s, round_digits(r, digits, true), round_digits(separation, of_s, false)))
                return true;
    return false;
}

static bool count_falls(struct search *s, domq_real count)
{
    return falls_somewhere(s, count) && rounds(s);
}

/* Below this number of dominoes, every number is tried. Beyond it, a row that falls with n dominoes is taken
 * to fall with more of them, because its growth is then smaller. */
enum { COUNT_TRIED = 32 };

/* Finds the smallest number of dominoes with which a row falls, from `count` on, and its numbers. Returns
 * false if there is none. */
static bool fewest_find(struct search *s, domq_real count)
{
    domq_real good = count;
    while (good <= COUNT_TRIED && s->status == DOM_OK && !count_falls(s, good))
        good++;
    domq_real bad = good - 1;
    if (good > COUNT_TRIED && !count_falls(s, COUNT_MAX))
        return false;
    while (good > COUNT_TRIED && s->status == DOM_OK && !count_falls(s, good)) {
        bad = good;
        good = quad_smaller(2 * good, COUNT_MAX);
    }
    while (good - bad > 1 && s->status == DOM_OK) {
        const domq_real middle = quad(floor)((good + bad) / 2);
        *(count_falls(s, middle) ? &good : &bad) = middle;
    }
    return s->status == DOM_OK && (s->count == good || count_falls(s, good));
}

/* ---- The answer ---- */

/* One row of the answer. */
struct found {
    struct domq_train train;
    bool moves;
    const char *why;   /* why there is no such row, or NULL */
    domq_real count;   /* the number of dominoes */
    struct words name; /* the kind of domino */
};

static bool row_find(const struct query *query, domq_real q, bool moves, bool has_engine, struct found *f,
                     struct problem *problem)
{
    const domq_real h = query->scene->scale.h;
    const char *word = parameter_word(parameter_find("q"), q);
    struct search s = {.query = query, .train = query->scene->train, .moves = moves};
    s.ratio = query->given->number[0] / h;
    s.train.q = q;
    *f = (struct found){.moves = moves};
    snprintf(f->name.text, sizeof f->name.text, "%s%s", word ? "" : "q = ", word ? word : quad_text(q, 6));
    if (has_engine && !moves)
        f->why = "the rigid-body engine would take too long to search for the fewest dominoes";
    else if (!fewest_find(&s, 1))
        f->why = moves ? "no such train keeps falling, whatever its gaps and its growth"
                 : isnan(scene_push(query->scene, h))
                     ? "no such row starts by itself, whatever its gaps and its growth"
                     : "no such row falls from this start, whatever its gaps and its growth";
    f->train = s.train;
    f->count = s.count;
    return query_status(query, problem, s.status);
}

enum { KINDS_MOST = 8, FOUND_MOST = 2 * KINDS_MOST };

/* Finds the rows for the session's kind of domino and for every kind that has a name. Returns their number,
 * or 0 after a problem. */
static size_t rows_find(const struct query *query, bool has_engine, struct found found[FOUND_MOST],
                        struct problem *problem)
{
    const domq_real own = query->scene->train.q;
    const struct word *w = parameter_find("q")->words;
    size_t count = 0;
    for (domq_real q = own; count + 2 <= FOUND_MOST; q = w++->value) {
        struct domq_train train = query->scene->train;
        train.q = q;
        if (any_train_check(&train, query_compute(query)) != DOM_NO_AIR) /* it is self-similar */
            for (int moves = 0; moves < 2; moves++)
                if (!row_find(query, q, moves != 0, has_engine, &found[count++], problem))
                    return 0;
        /* Several words can have the same value. */
        while (w->name && (w->value == own || (w[1].name && w[1].value == w->value)))
            w++;
        if (!w->name)
            break;
    }
    return count;
}

/* Returns the word for how a row starts. */
static const char *start_word(const struct query *query, bool moves)
{
    const domq_real push = scene_push(query->scene, query->scene->scale.h);
    return moves                                              ? "moving"
           : isnan(push)                                      ? "tips over"
           : push == 0 && !isnan(scene_release(query->scene)) ? "released"
                                                              : "pushed";
}

static void found_row(const struct query *query, struct answer *a, const struct found *f)
{
    const domq_real h = query->scene->scale.h, r = f->train.r, s = f->train.s;
    const domq_real last = h * quad(pow)(r, f->count - 1);
    const struct cell none = {.kind = CELL_NONE}, kind = cell_word(f->name.text),
                      start = cell_word(start_word(query, f->moves));
    if (f->why)
        answer_row(a, ROW(kind, start, none, none, none, none, none, none), f->why);
    else
        answer_row(a,
                   ROW(kind, start, cell_count(f->count), cell_narrow(r, ROUNDED), cell_narrow(s, ROUNDED),
                       cell_without_error(h * r * s), cell_without_error(last), cell_without_error(last * r)),
                   answer_for_people(a) ? NULL : "");
}

/* Explains the rows of the answer. */
static void rows_say(const struct query *query, struct answer *a, const struct found *found, size_t count)
{
    const struct found *first = found;
    while (first < found + count && first->why)
        first++;
    if (first == found + count)
        return;
    char q[48] = "";
    if (first->train.q != query->scene->train.q)
        snprintf(q, sizeof q, " q %s", quad_text(first->train.q, 6));
    answer_say(a,
               "These are the fewest dominoes that topple one that is %s tall. Each row was run with exactly "
               "this growth r and gap s, and falls; 'count %s m %s with s %s%s' explains one.",
               measured(query->given->number[0], "m", 6).text, quad_text(query->given->number[0], ROUNDED),
               quad_text(first->train.r, ROUNDED), quad_text(first->train.s, ROUNDED), q);
}

bool run_fewest(const struct query *query, struct answer *a, struct problem *problem)
{
    struct found found[FOUND_MOST];
    struct scene_row made;
    if (query->given->number[0] <= query->scene->scale.h) {
        answer_say(a, "No other domino is needed: the first is already %s tall.",
                   measured(query->scene->scale.h, "m", 6).text);
        return true;
    }
    /* A row of two shows whether the effects can be combined, and whether the dominoes stand. */
    const struct scene row = start_scene(query, &query->scene->train, 2);
    const enum dom_status status = any_train_check(&query->scene->train, query_compute(query));
    if (status != DOM_OK)
        return query_status(query, problem, status);
    if (!scene_row_make(&row, &made, problem))
        return false;
    free(made.domino);
    const size_t count = rows_find(query, scene_has_engine(&row), found, problem);
    for (size_t k = 0; k < count; k++)
        found_row(query, a, &found[k]);
    rows_say(query, a, found, count);
    return count > 0;
}
