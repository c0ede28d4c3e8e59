/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/rows/listing.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

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

void cells_leave_out(const struct answer *a, const struct column *all, struct cell *cells)
{
    int n = 0;
    for (int i = 0; all[i].key && a->columns[n].key; i++)
        if (strcmp(a->columns[n].key, all[i].key) == 0)
            cells[n++] = cells[i];
}

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
    domq_real height = 0, thickness = 0, gap = 0, mass = 0, radius = 0, lean = 0;
    for (size_t k = 0; k < scene->row.count; k++) {
        height = quad_larger(height, scene->domino[k].height);
        thickness = quad_larger(thickness, scene->domino[k].thickness);
        gap = quad_larger(gap, scene->domino[k].gap);
        mass = quad_larger(mass, scene->domino[k].mass);
        radius = quad_larger(radius, scene->domino[k].radius);
        lean = quad_larger(lean, quad(fabs)(row_lean(&scene->domino[k])));
    }
    answer_largest(a, "height", height);
    answer_largest(a, "thickness", thickness);
    answer_largest(a, "gap", gap);
    answer_largest(a, "mass", mass);
    answer_largest(a, "radius", radius);
    answer_largest(a, "lean", lean);
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
        cells_leave_out(a, row_columns, cells);
        answer_row(a, cells, NULL);
    }
    free(scene.domino);
    if (query->next && a->path)
        query->next->scene.listed.saved = true;
    return true;
}
