/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/row_start.h"
#include "language/quad.h"
#include <stdlib.h>

/* A very long row need not be run to its end. If the endless train keeps falling, and a row of this many
 * dominoes falls, then any longer row also falls, because a row forgets its start: in the model, the energy
 * of a cycle is a linear function of the energy of the cycle before it, with a slope below 1. */
enum { START_DOMINOES = 64 };

/* The search for the largest growth runs rows of this many dominoes. */
enum { START_SEARCHED = 24 };

/* The smallest relative tolerance of the search for a growth. The result of the search is rounded down to
 * START_DIGITS digits. */
#define START_TOL ((domq_real)1e-9)
enum { START_DIGITS = 9 };

/* Two growths count as equal if their relative difference is below this number, or below 4 times the
 * tolerance of the search if that is larger. At exactly the largest growth the margin is 0, and rounding
 * errors would otherwise decide whether the row falls. */
#define START_SAME ((domq_real)1e-8)

/* Returns a copy of the scene with a row of `count` dominoes. The copy shares the memory of the original. */
static struct scene start_scene(const struct query *query, const struct domq_train *train, size_t count)
{
    struct scene scene = *query->scene;
    scene.train = *train;
    effect_put(&scene, DOM_EFFECT_row, (domq_real)count, NULL);
    return scene;
}

/* Halves the row if a size or a mass is out of range. The dropped dominoes are too far away to affect the
 * start. */
static bool row_shorten(struct domq_row *row, enum dom_status status)
{
    const bool shorter = status >= DOM_BAD_COUNT && status <= DOM_BAD_MASS && row->count > 2;
    row->count /= shorter ? 2 : 1;
    return shorter;
}

bool start_find(const struct query *query, const struct domq_train *train, domq_real dominoes,
                struct start *start, struct problem *problem)
{
    struct scene_row made;
    struct domq_verdict verdict;
    enum dom_status status;
    struct scene scene =
        start_scene(query, train, dominoes < START_DOMINOES ? (size_t)dominoes : START_DOMINOES);
    if (!scene_row_make(&scene, &made, problem))
        return false;
    made.row.floor = false;
    do
        status = domq_row_run(&made.row, &made.compute, false, NULL, NULL, &verdict);
    while (row_shorten(&made.row, status));
    *start = (struct start){.count = made.row.count,
                            .push = DOMQ_NAN,
                            .engine = made.row.engine ? scene_engine_why(&scene) : NULL};
    start->falls = status == DOM_OK && verdict.end == DOM_ROW_FALLS;
    if (status == DOM_OK && !start->falls) {
        start->end = verdict.end;
        start->stops_at = verdict.domino;
        /* The centre of a falling domino moves on a circle. If omega^2 h/2 > g, its weight is too small to
         * keep it on the circle, and the domino lifts off the floor. */
        const domq_real lifting = quad(sqrt)(2 * made.row.g / made.domino[0].height);
        if (!start->engine)
            status = domq_row_weakest_push(&made.row, &made.compute, lifting, &start->push);
    }
    free(made.domino);
    return row_status(query, problem, status);
}

bool start_growths_find(const struct query *query, const struct domq_train *train, domq_real highest,
                        struct start_growths *growths, struct problem *problem)
{
    struct scene scene = start_scene(query, train, START_SEARCHED);
    struct scene_row made;
    struct domq_row_growth found;
    *growths = (struct start_growths){DOMQ_NAN, scene_has_engine(&scene)};
    scene.train.r = 1;
    if (growths->is_too_slow)
        return true;
    if (!scene_row_make(&scene, &made, problem))
        return false;
    made.row.floor = false;
    made.compute.tol = quad_larger(made.compute.tol, START_TOL);
    enum dom_status status;
    do
        status = domq_row_rmax(&made.row, &made.compute, highest, row_grow, &scene, &found);
    while (row_shorten(&made.row, status));
    free(made.domino);
    if (!row_status(query, problem, status))
        return false;
    growths->r_max = found.r_max >= highest * (1 - quad_larger(START_SAME, 4 * made.compute.tol))
                         ? highest
                         : round_digits(found.r_max, START_DIGITS, false);
    return true;
}

struct words start_words(const struct query *query)
{
    const struct effect_state *push = &query->scene->effect[DOM_EFFECT_push];
    struct words words = {"if its first domino just tips over"};
    if (push->on)
        snprintf(words.text, sizeof words.text, "with a push of %.4g rad/s", (double)push->value[0]);
    return words;
}

const char *start_problem(const struct query *query, const struct start *start, char text[START_TEXT])
{
    char push[80] = "";
    if (isfinite(start->push))
        snprintf(push, sizeof push, "; a push of %.4g rad/s is enough", (double)start->push);
    else if (!start->engine && start->end != DOM_ROW_MISSES)
        snprintf(push, sizeof push, "; no push that leaves the first domino on the floor is enough");
    snprintf(text, START_TEXT, "%s, the fall ends at domino %zu: %s%s", start_words(query).text,
             start->stops_at,
             start->end == DOM_ROW_LEANS ? "the first domino touches the second before it tips over"
                                         : dom_row_end_text(start->end),
             push);
    return text;
}
