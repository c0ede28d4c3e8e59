/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/rows/listing.h"
#include "language/quad.h"
#include <stdlib.h>

const struct column row_columns[] = {
    {"domino", "", "its number, from 1", 6},
    {"height", "m", "its height", 0},
    {"thickness", "m", "its thickness", 0},
    {"gap", "m", "free distance to the domino before it", 0},
    {"mass", "kg", "its mass, if masses are known", 0},
    {"relative", "", "its mass over that of the first, if they are not known", 0},
    {"radius", "m", "of its edges, if the file of the row has radii; with 'effect edges'", 0},
    {"lean", "m", "what its top is off plumb, if the file has leans; negative: backwards", 0},
    {NULL, NULL, NULL, 0},
};

/* Returns what the top of a domino is off plumb. */
static domq_real row_lean(const struct domq_domino *d)
{
    return d->height * quad(sin)(d->lean);
}

/* Returns true if dominoes have a radius of their own, which a file of the row has to keep. */
static bool row_has_radii(const struct scene_row *scene)
{
    for (size_t k = 0; k < scene->row.count; k++)
        if (scene->domino[k].radius > 0)
            return true;
    return false;
}

/* Returns true if a domino leans when it is set up. */
static bool row_has_leans(const struct scene_row *scene)
{
    for (size_t k = 0; k < scene->row.count; k++)
        if (scene->domino[k].lean != 0)
            return true;
    return false;
}

void row_largest(struct answer *a, const struct scene_row *scene)
{
    for (size_t k = 0; k < scene->row.count; k++) {
        const struct domq_domino *d = &scene->domino[k];
        answer_largest(a, "height", d->height);
        answer_largest(a, "thickness", d->thickness);
        answer_largest(a, "gap", d->gap);
        answer_largest(a, "mass", d->mass);
        answer_largest(a, "radius", d->radius);
        answer_largest(a, "lean", row_lean(d));
    }
}

bool run_row(const struct query *query, struct answer *a, struct problem *problem)
{
    struct scene_row scene;
    if (!scene_row_list(query->scene, &scene, problem))
        return false;
    bool weighed = scene_weighed(query->scene);
    bool rounds = row_has_radii(&scene), leans = row_has_leans(&scene);
    answer_leave_out(a, weighed ? "relative" : "mass");
    if (!rounds)
        answer_leave_out(a, "radius");
    if (!leans)
        answer_leave_out(a, "lean");
    a->units = true;
    a->style.errors = false; /* its columns are those that 'effect row FILE' reads */
    a->others = a->path ? query->scene->listed.others : NULL;
    row_largest(a, &scene);
    for (size_t k = 0; k < scene.row.count && !answer_lost(a); k++) {
        const struct domq_domino *d = &scene.domino[k];
        struct cell cells[] = {cell_count((domq_real)k + 1), cell_real(d->height),
                               cell_real(d->thickness),      cell_real(d->gap),
                               cell_real(d->mass),           cell_real(d->mass / scene.domino[0].mass),
                               cell_real(d->radius),         cell_real(row_lean(d))};
        answer_row(a, cells, NULL);
    }
    free(scene.domino);
    if (query->next && a->path)
        query->next->scene.listed.saved = true;
    return true;
}
