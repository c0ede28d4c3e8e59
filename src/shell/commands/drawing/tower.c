/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/drawing/tower.h"
#include "interpreter/symbols.h"
#include "language/quad.h"
#include "language/text.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The width of the tower, as a fraction of its height. */
#define TOWER_WIDTH 0.2
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
/* In a film, the distance from the last domino to the tower, divided by the last domino's height. */
#define BEYOND 1.1

bool tower_query(const struct query *query, struct state *state, struct query *changed, double *height,
                 struct problem *problem)
{
    /* Indices of the first columns in the answer of 'count'. */
    enum { COUNT_HEIGHT, COUNT_GROWTH, COUNT_DOMINOES };
    const struct last_answer *ans = query->ans;
    if (!ans->command || strcmp(ans->command->name, "count") != 0)
        return problem_error(problem,
                             "'tower' works only if the last answer was a count; first enter 'count 112 m'");
    const domq_real dominoes = ans->cells[COUNT_DOMINOES].number,
                    most = domq_effect(DOM_EFFECT_row)->argument[0].highest;
    if (!isfinite(dominoes) || dominoes < 1 || dominoes > most)
        return problem_no_answer(problem, "there is no row to draw: the last 'count' needs %s",
                                 dominoes == 0 ? "no dominoes" : "more dominoes than a row can have");
    const struct assigned assigned[] = {{parameter_find("r"), ans->cells[COUNT_GROWTH].number, NULL},
                                        {parameter_find("row"), dominoes, NULL}};
    *height = (double)ans->cells[COUNT_HEIGHT].number;
    return query_with(query, assigned, 2, state, changed, problem);
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

/* Stores the tower in the element after the last domino and leaves stage->count unchanged. The gap between
 * the last domino and the tower is `distance` times the height of that domino. Also allocates room for
 * `copies` more dominoes. */
static bool tower_put(struct stage *stage, double height, double distance, size_t copies)
{
    const size_t count = stage->count;
    struct drawn *more = realloc(stage->domino, (count + 1 + copies) * sizeof *more);
    if (!more)
        return false;
    stage->domino = more;
    stage->row = NULL; /* there is no room for labels with the sizes */
    struct drawn *tower = &more[count];
    const struct drawn *last = tower - 1;
    *tower = *last;
    tower->number = NUMBER_TOWER;
    tower->part = STANDS;
    tower->height = height;
    tower->thickness = TOWER_WIDTH * height;
    tower->radius = tower->theta = 0;
    tower->foot = last->foot + distance * last->height + tower->thickness;
    drawn_corners(tower);
    stage->top = fmax(stage->top, height);
    stage->right = fmax(stage->right, tower->foot);
    return true;
}

bool tower_film(struct falling_row *row, double height)
{
    return tower_put(&row->stage, height, BEYOND, 0);
}

bool tower_add(struct falling_row *row, double height)
{
    struct stage *stage = &row->stage;
    const size_t count = stage->count;
    const struct drawn *last = &stage->domino[count - 1];
    const double pitch = last->foot - (last - (count > 1))->foot;
    if (!tower_put(stage, height, 1.2 * pitch / last->height, count))
        return false;
    stage->count++;
    text_add(stage->caption, CAPTION, "\nBehind the last domino: a tower of %s.",
             measured((domq_real)height, "m", 4).text);
    zoom_add(stage, count, height);
    return true;
}
