/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'count H fewest': the gap and the growth together that need the fewest dominoes. */
#include "language/quad.h"
#include "rows/rows.h"
#include "train/train.h"
#include <stdlib.h>
#include <string.h>

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

/* Returns margin / barrier of the moving train, which is positive if it keeps falling. Returns -INFINITY if a
 * domino misses the next one or if falling releases no energy. */
static double train_spare(const struct search *s)
{
    struct domq_barrier barrier;
    const enum dom_status status = any_barrier_find(&s->train, query_compute(s->query), &barrier);
    if (status != DOM_OK && status != DOM_STOPS)
        return (double)-INFINITY;
    const double share = (double)(barrier.margin / barrier.barrier);
    return status == DOM_OK ? fmin(share, HUGE_VAL) : fmin(share, -0.0);
}

/* A row whose sizes are out of range after fewer dominoes decides nothing. */
enum { FEW = 8 };

/*
 * Returns how well the row falls with gaps of `separation`: the smallest margin / barrier of its dominoes,
 * which is positive if all fall. If the row stops, the result is at most 0, and lower if the row stops
 * earlier. Returns -INFINITY if the fall ends in another way.
 */
static double spare_at(double separation, void *context)
{
    struct search *s = context;
    s->train.s = quad_decimal(separation);
    if (dom_raised(query_compute(s->query)->interrupt))
        s->status = DOM_INTERRUPTED;
    struct start start;
    struct problem ignored = {.kind = PROBLEM_NONE};
    const domq_real dominoes = s->count + 1, most = quad_smaller(dominoes, (domq_real)START_DOMINOES);
    double value = (double)-INFINITY;
    if (s->moves) {
        value = train_spare(s);
    } else if (!start_run(s->query, &s->train, dominoes, false, &start, &ignored)) {
        s->status =
            start.status == DOM_NO_MEMORY || start.status == DOM_INTERRUPTED ? start.status : s->status;
    } else if ((domq_real)start.count >= quad_smaller(most, (domq_real)FEW)) {
        if (start.falls)
            value = dominoes > most ? fmin(start.spare, train_spare(s)) : start.spare;
        else if (start.end == DOM_ROW_STOPS) /* by 1 lower for each domino that is left */
            value = fmin(start.spare, 0) - (double)(most - (domq_real)start.stops_at);
    }
    return s->status == DOM_OK && !isnan(value) ? value : (double)-INFINITY;
}

/* The number of gaps that are tried first, and how accurately the best gap near one of them is found,
 * relative to their distance. */
enum { GRID = 40 };
#define GRAIN 1e-4

/* Finds the gap at which a row of `count` dominoes has the most energy to spare. Returns true if it falls
 * there. The growth is the smallest one that reaches the height. */
static bool falls_somewhere(struct search *s, domq_real count)
{
    const domq_real least = parameter_find("s")->value->lowest;
    struct spot spot[GRID + 2], best = {(double)NAN, (double)-INFINITY};
    s->count = count;
    s->train.r = quad(pow)(s->ratio, 1 / count);
    /* a domino that is farther away is not touched */
    const double step = (double)(1 / (s->train.r * (GRID + 1)));
    if ((domq_real)step < least || s->train.r > parameter_find("r")->value->highest)
        return false;
    for (int k = 0; k < GRID + 2; k++) {
        spot[k] = (struct spot){k == 0 ? step / 1024 : k * step, (double)-INFINITY};
        if (k > 0 && k <= GRID)
            spot[k].value = spare_at(spot[k].x, s);
    }
    for (int k = 1; k <= GRID && s->status == DOM_OK; k++) {
        const double below = spot[k - 1].value, here = spot[k].value, above = spot[k + 1].value;
        if (here == (double)-INFINITY || here < below || here < above || (here == below && here == above))
            continue;
        const struct spot top =
            seek_top(spare_at, s, spot[k - 1].x, spot[k], spot[k + 1].x, GRAIN * step, HUGE_VAL);
        best = top.value > best.value ? top : best;
    }
    s->train.s = quad_decimal(best.x);
    return s->status == DOM_OK && best.value > 0;
}

/* Returns true if a row with these numbers falls, and reaches the height with s->count dominoes. */
static bool is_enough(struct search *s, domq_real r, domq_real separation)
{
    struct domq_count count;
    s->train.r = r;
    return any_count_find(1, s->ratio, r, query_compute(s->query), &count) == DOM_OK &&
           count.dominoes <= s->count && spare_at((double)separation, s) > 0;
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

/* Finds the row for one kind of domino, and writes it. Stores its train in *first unless one is there. */
static bool row_answer(const struct query *query, struct answer *a, struct search s, bool has_engine,
                       struct domq_train *first, struct problem *problem)
{
    const domq_real h = query->scene->scale.h;
    const char *word = parameter_word(parameter_find("q"), s.train.q);
    struct cell row[ANSWER_COLUMNS] = {{.kind = CELL_NONE}};
    char name[48];
    snprintf(name, sizeof name, "%s%s", word ? "" : "q = ", word ? word : quad_text(s.train.q, 6));
    row[0] = cell_word(name);
    const domq_real push = scene_push(query->scene, h);
    row[1] = cell_word(s.moves                                            ? "moving"
                       : isnan(push)                                      ? "tips over"
                       : push == 0 && !isnan(scene_release(query->scene)) ? "released"
                                                                          : "pushed");
    if (has_engine && !s.moves)
        return answer_row(a, row,
                          "the rigid-body engine would take too long to search for the fewest dominoes");
    const bool is_found = fewest_find(&s, 1);
    if (!query_status(query, problem, s.status))
        return false;
    if (!is_found)
        return answer_row(a, row,
                          s.moves ? "no such train keeps falling, whatever its gaps and its growth"
                          : isnan(push)
                              ? "no such row starts by itself, whatever its gaps and its growth"
                              : "no such row falls from this start, whatever its gaps and its growth");
    const domq_real r = s.train.r, last = h * quad(pow)(r, s.count - 1);
    const struct cell numbers[] = {cell_count(s.count),
                                   cell_narrow(r, ROUNDED),
                                   cell_narrow(s.train.s, ROUNDED),
                                   cell_without_error(h * r * s.train.s),
                                   cell_without_error(last),
                                   cell_without_error(last * r)};
    memcpy(row + 2, numbers, sizeof numbers);
    *first = isnan(first->q) ? s.train : *first;
    return answer_row(a, row, answer_for_people(a) ? NULL : "");
}

bool run_fewest(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct domq_train *train = &query->scene->train;
    const domq_real height = query->given->number[0], h = query->scene->scale.h;
    domq_real kind[KINDS_MOST];
    struct domq_train first = {.q = DOMQ_NAN};
    struct scene_row made;
    if (height <= h) {
        answer_say(a, "No other domino is needed: the first is already %s tall.", measured(h, "m", 6).text);
        return true;
    }
    /* A row of two shows whether the effects can be combined, and whether the dominoes stand. */
    const struct scene row = start_scene(query, train, 2);
    struct domq_angles angles;
    const enum dom_status status = any_angles_find(train, query_compute(query), &angles);
    if (!query_status(query, problem, status) || !scene_row_make(&row, &made, problem))
        return false;
    free(made.domino);
    const size_t kinds = kinds_find(query, train, kind);
    for (size_t k = 0; k < 2 * kinds && !answer_lost(a); k++) {
        struct search s = {.query = query, .train = *train, .moves = k % 2 == 1, .ratio = height / h};
        s.train.q = kind[k / 2];
        if (!row_answer(query, a, s, scene_engine(&row), &first, problem))
            return false;
    }
    if (isnan(first.q))
        return true;
    char q[48] = "";
    if (first.q != train->q)
        snprintf(q, sizeof q, " q %s", quad_text(first.q, 6));
    answer_say(
        a,
        "These are the fewest dominoes that topple one that is %s tall. From its start, each row "
        "was run with exactly this growth r and gap s, and falls; 'count %s m %s with s %s%s' explains one.",
        measured(height, "m", 6).text, quad_text(height, ROUNDED), quad_text(first.r, ROUNDED),
        quad_text(first.s, ROUNDED), q);
    return true;
}
