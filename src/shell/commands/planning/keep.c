/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Copies the dimensions of dominoes to the row of the scene, in the same way as 'change'. */
#include "commands/planning/planning.h"
#include "language/quad.h"
#include <stdlib.h>

/* Multiplies a measurement of domino k, counted from 0, by `value`, or sets it to `value`. */
static bool change_to(struct scene *scene, size_t k, enum row_measure measure, bool times, domq_real value,
                      struct problem *problem)
{
    const struct row_change change = {
        .measure = measure, .how = times ? CHANGE_TIMES : CHANGE_TO, .value = value};
    return scene_row_change(scene, &change, &(struct row_range){k + 1, k + 1}, 1, problem);
}

static bool is_near(domq_real a, domq_real b)
{
    return quad(fabs)(a - b) <= (domq_real)1e-12 * quad(fabs)(b);
}

bool dominoes_keep(struct scene *scene, const struct domq_domino *from, size_t count, bool sizes,
                   struct problem *problem)
{
    struct scene_row now;
    if (!scene_row_list(scene, &now, problem))
        return false;
    bool good = true;
    for (size_t k = 0; k < count && good; k++) {
        const struct domq_domino *a = &now.domino[k], *b = &from[k];
        good =
            (is_near(a->gap, b->gap) || change_to(scene, k, MEASURE_GAP, false, b->gap, problem)) &&
            (is_near(a->height, b->height) ||
             change_to(scene, k, MEASURE_HEIGHT, false, b->height, problem)) &&
            (!sizes || is_near(a->width, b->width) ||
             change_to(scene, k, MEASURE_WIDTH, false, b->width, problem)) &&
            (is_near(a->thickness, b->thickness) ||
             change_to(scene, k, MEASURE_THICKNESS, false, b->thickness, problem)) &&
            (is_near(a->radius, b->radius) || change_to(scene, k, MEASURE_RADIUS, false, b->radius, problem));
    }
    free(now.domino);
    /* These changes keep the density of each domino, so the masses change with the sizes. If the mass ratios
     * now differ from those in `from`, they must be changed, too. */
    if (!good || !sizes || !scene_row_list(scene, &now, problem))
        return good && !sizes;
    for (size_t k = 0; k < count && good; k++) {
        const domq_real times = from[k].mass / now.domino[k].mass * (now.domino[0].mass / from[0].mass);
        good = is_near(times, 1) || change_to(scene, k, MEASURE_MASS, true, times, problem);
    }
    free(now.domino);
    return good;
}
