/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/drawing/tower.h"
#include "interpreter/question.h"
#include "language/quad.h"
#include "language/text.h"
#include "session/row_change.h"
#include "train/train.h"
#include <math.h>
#include <stdlib.h>

/* Dominoes smaller than this fraction of the tower's height are drawn a second time, enlarged. */
#define TOO_SMALL 0.012
/* The largest width of the enlarged copy, as a fraction of the width of the picture. */
#define ZOOM_WIDE 0.36
/* The largest height of the enlarged copy, as a fraction of the tower's height. */
#define ZOOM_HIGH 0.4
/* The enlarged copy is drawn above the row. This is its distance from the floor, as a fraction of the tower's
 * height. */
#define ZOOM_ABOVE 0.52
/* A copy that would be enlarged by less than this factor is not drawn. */
#define ZOOM_LEAST 2
/* Turns the last domino of the row into the tower: a domino of this height, with the proportions of the
 * others. The gap before it is s times its height, as for every domino. */
static bool tower_stand(struct tower *tower, size_t dominoes)
{
    struct scene *scene = &tower->state.scene;
    const struct domq_train *train = &scene->train;
    const domq_real height = tower->height;
    struct listed_row listed = {.domino = NULL};
    if (!row_changes_open(&listed, dominoes + 1))
        return false;
    scene->listed = listed;
    tower->change = listed.change;
    struct domq_domino *change = &tower->change[dominoes].to;
    change->height = height;
    change->thickness = train->d * height;
    change->width = train->width * height;
    change->gap = train->s * height;
    /* A change of the three sizes gives the mass of a solid domino, for which q = 4. */
    if (!(scene_walls(scene) > 0))
        change->mass =
            quad(pow)(height / scene->scale.h / quad(pow)(train->r, (domq_real)dominoes), train->q - 4);
    return true;
}

bool tower_make(const struct query *query, struct tower *tower, struct problem *problem)
{
    /* Indices of the first columns in the answer of 'count'. */
    enum { COUNT_HEIGHT, COUNT_GROWTH, COUNT_DOMINOES };
    const struct last_answer *ans = query->ans;
    *tower = (struct tower){.change = NULL};
    if (!ans->command || ans->command->run != run_count)
        return problem_error(problem,
                             "'tower' works only if the last answer was a count; first enter 'count 112 m'");
    if (ans->with)
        return problem_error(problem, "the last count was made 'with' settings that the session does not "
                                      "have; first set them, and count again");
    const domq_real dominoes = ans->cells[COUNT_DOMINOES].number,
                    most = domq_effect(DOM_EFFECT_row)->argument[0].highest;
    if (!isfinite(dominoes) || dominoes < 1 || dominoes >= most)
        return problem_no_answer(problem, "there is no row to draw: the last 'count' %s",
                                 dominoes == 0         ? "needs no dominoes"
                                 : !isfinite(dominoes) ? "does not reach its height"
                                                       : "needs more dominoes than a row can have");
    const struct assigned assigned[] = {
        {.parameter = parameter_find("r"), .value = ans->cells[COUNT_GROWTH].number},
        {.parameter = parameter_find("row"), .value = dominoes + 1}};
    tower->height = ans->cells[COUNT_HEIGHT].number;
    return query_with(query, assigned, 2, &tower->state, &tower->query, problem) &&
           (tower_stand(tower, (size_t)dominoes) || problem_status(problem, query->scene, DOM_NO_MEMORY));
}

void tower_free(struct tower *tower)
{
    free(tower->change);
}

/* Adds an enlarged copy of the dominoes that are too small to see, and mentions it in the caption. */
static void zoom_add(struct stage *stage, size_t count, double height)
{
    const double left = stage->domino[0].foot - stage->domino[0].thickness;
    size_t small = 0;
    while (small < count && stage->domino[small].height < TOO_SMALL * height)
        small++;
    if (small == 0)
        return;
    const struct drawn *last = &stage->domino[small - 1];
    double room = ZOOM_WIDE * (stage->right - stage->left);
    /* The copy stands above the row, and must not touch the tall dominoes to its right. */
    for (size_t k = count; k-- > 0;)
        if (stage->domino[k].height > (ZOOM_ABOVE - 0.02) * height)
            room = fmin(room, stage->domino[k].foot - 1.5 * stage->domino[k].thickness - left);
    double wide = room / (last->foot - left), high = ZOOM_HIGH * height / last->height,
           scale = fmin(wide, high);
    if (scale < ZOOM_LEAST)
        return;
    for (size_t k = 0; k < small; k++) {
        struct drawn *d = &stage->domino[stage->count++];
        *d = stage->domino[k];
        d->number = NUMBER_NONE;
        d->height *= scale;
        d->thickness *= scale;
        d->radius *= scale;
        d->foot = left + scale * (d->foot - left);
        drawn_corners(d);
        for (int i = 0; i < CORNERS; i++)
            d->corner[i].y += ZOOM_ABOVE * height;
    }
    text_add(stage->caption, CAPTION, "\nAbove the row, enlarged %.3g times: domino%s 1%s%.0d.", scale,
             small > 1 ? "es" : "", small > 1 ? " to " : "", small > 1 ? (int)small : 0);
}

bool tower_zoom(struct falling_row *row)
{
    struct stage *stage = &row->stage;
    const size_t count = stage->count - 1;
    struct drawn *more = realloc(stage->domino, (stage->count + count) * sizeof *more);
    if (!more)
        return false;
    stage->domino = more;
    zoom_add(stage, count, more[count].height);
    return true;
}
