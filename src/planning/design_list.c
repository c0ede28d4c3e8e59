/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes the dominoes of a design, and writes its numbers as a row of the answer. */
#include "language/quad.h"
#include "planning/designs.h"
#include "planning/planning.h"
#include "rows/row_edit.h"
#include "train/falling.h"
#include <stdlib.h>

const struct column design_columns[] = {
    {"s", "h", "the gap divided by the height", 0},
    {"r", "", "the growth from domino to domino", 0},
    {"steps", "", "n, with h r^n = H: the row has n + 1 dominoes", 0},
    {"feet", "m", "the length from the back of the first domino to the front of the last one", 0},
    {"length", "m", "the length of the row, including its fallen last domino", 0},
    {"mass", "kg", "the mass of all dominoes, if masses are known", 0},
    {"surface", "m^2", "the surface area of all dominoes, if q is 3 and their walls are not known", 0},
    {"volume", "m^3", "the volume of the wood in all dominoes, if 'surface' has no value", 0},
    {"safety", "", "the energy of the weakest domino, divided by the energy that it needs", 0},
    {"weakest", "", "the number of the weakest domino", 0},
    {"train", "", "the energy of the endless train, divided by the energy that it needs", 0},
    {"seconds", "s", "the time until the last domino lies on the floor, as 'fall' measures it", 0},
    {"probability", "share", "the share of the random rows that fall", 0},
    {"low", "share", "the lower end of the 95 % interval of the probability", 0},
    {"rows", "", "the number of random rows that were set up", 0},
    {NULL, NULL, NULL, 0},
};

void design_columns_choose(struct answer *a, bool is_random)
{
    static const char *const keys[] = {"probability", "low", "rows"};
    for (size_t i = 0; !is_random && i < sizeof keys / sizeof *keys; i++)
        answer_leave_out(a, keys[i]);
}

/* ---- The dominoes of a design ---- */

bool designed_make(const struct query *query, struct problem *problem, const struct dom_wish *wish,
                   const struct dom_limits *limits, const struct dom_design *d, struct designed_row *p)
{
    const domq_real mass = scene_mass(query->scene);
    *p = (struct designed_row){.count = d->steps + 1,
                               .has_masses = mass > 0,
                               .scene = query->scene,
                               .walls_unknown = query->scene->train.q == 3 && scene_walls(query->scene) == 0,
                               .limits = limits};
    p->domino = malloc(p->count * sizeof *p->domino);
    if (!p->domino)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    const struct dom_train train = train_in_double(&query->scene->train);
    struct dom_domino *domino = malloc(p->count * sizeof *domino);
    const enum dom_status status =
        domino ? dom_design_dominoes(&train, wish, limits, d, domino) : DOM_NO_MEMORY;
    for (size_t k = 0; k < p->count && status == DOM_OK; k++) {
        p->domino[k] = domino_from_double(&domino[k]);
        p->domino[k].mass *= p->has_masses ? mass : 1;
    }
    free(domino);
    if (status == DOM_OK)
        return true;
    free(p->domino);
    return problem_status(problem, query->scene, status);
}

/* Returns the volume of wood in a domino or, if the thickness of its walls is not known, its surface area. */
static domq_real plan_material(const struct designed_row *p, const struct domq_domino *d)
{
    return p->walls_unknown ? 2 * (d->height * d->width + d->height * d->thickness + d->width * d->thickness)
                            : d->height * d->width * d->thickness * scene_filled(p->scene, d);
}

domq_real designed_mass(const struct designed_row *p)
{
    domq_real mass = 0;
    for (size_t k = 0; k < p->count; k++)
        mass += p->domino[k].mass;
    return p->has_masses ? mass : mass / p->domino[0].mass;
}

void design_row(struct answer *a, const struct designed_row *p, const struct dom_design *d,
                const struct dom_study *study, const char *reason)
{
    const struct cell none = cell_real(DOMQ_NAN);
    const bool counted = study && study->rows > 0;
    domq_real material = 0;
    for (size_t k = 0; p && k < p->count; k++)
        material += plan_material(p, &p->domino[k]);
    answer_row(a,
               ROW(cell_real(d->s), cell_computed(d->r), p ? cell_count((domq_real)d->steps) : none,
                   cell_narrow(d->feet, 5), cell_narrow(d->length, 5),
                   p && p->has_masses ? cell_narrow(designed_mass(p), 5) : none,
                   p && p->walls_unknown ? cell_narrow(material, 5) : none,
                   p && !p->walls_unknown ? cell_narrow(material, 5) : none, cell_narrow(d->row, 5),
                   d->weakest > 0 ? cell_count((domq_real)d->weakest) : none, cell_narrow(d->train, 5),
                   cell_narrow(d->seconds, 5),
                   counted ? cell_narrow((domq_real)study->fall / (domq_real)study->rows, 6) : none,
                   counted ? cell_narrow((domq_real)study->low, 6) : none,
                   counted ? cell_count((domq_real)study->rows) : none),
               reason);
}

domq_real design_growth(const struct scene *scene, const struct designed_row *plan)
{
    const size_t steps = plan->count - 1;
    return quad(pow)(plan->domino[steps].height / scene->scale.h, 1 / (domq_real)steps);
}

bool design_scene(const struct scene *from, const struct dom_design *d, const struct designed_row *plan,
                  struct scene *scene, struct problem *problem)
{
    *scene = *from;
    scene->listed = (struct listed_row){.domino = NULL};
    scene->effect[DOM_EFFECT_row].on = true;
    scene->effect[DOM_EFFECT_row].value[0] = (domq_real)plan->count;
    scene->train.s = quad_decimal(d->s);
    scene->train.r = design_growth(scene, plan);
    return !plan->limits || scene_row_set(scene, plan->domino, plan->count, true, problem);
}
