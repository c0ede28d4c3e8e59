/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Copies the dimensions of dominoes to the row of the scene, in the same way as 'change'. */
#include "language/quad.h"
#include "planning/planning.h"
#include "rows/row_edit.h"
#include <stdlib.h>

/* Changes one measurement of domino k, such as its height; k counts from 0. If `times` is true, multiplies
 * the measurement by `value`. If not, sets the measurement to `value`. */
static bool measurement_change(struct scene *scene, size_t k, enum row_measure measure, bool times,
                               domq_real value, struct problem *problem)
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
            (is_near(a->gap, b->gap) || measurement_change(scene, k, MEASURE_GAP, false, b->gap, problem)) &&
            (is_near(a->height, b->height) ||
             measurement_change(scene, k, MEASURE_HEIGHT, false, b->height, problem)) &&
            (!sizes || is_near(a->width, b->width) ||
             measurement_change(scene, k, MEASURE_WIDTH, false, b->width, problem)) &&
            (is_near(a->thickness, b->thickness) ||
             measurement_change(scene, k, MEASURE_THICKNESS, false, b->thickness, problem)) &&
            (is_near(a->radius, b->radius) ||
             measurement_change(scene, k, MEASURE_RADIUS, false, b->radius, problem));
    }
    free(now.domino);
    /* The changes of size have also changed the masses, because they keep the density of each domino. Now
     * change the masses so that their ratios to the mass of the first domino are as in `from`. */
    if (!good || !sizes || !scene_row_list(scene, &now, problem))
        return good && !sizes;
    for (size_t k = 0; k < count && good; k++) {
        const domq_real times = from[k].mass / now.domino[k].mass * (now.domino[0].mass / from[0].mass);
        good = is_near(times, 1) || measurement_change(scene, k, MEASURE_MASS, true, times, problem);
    }
    free(now.domino);
    return good;
}
