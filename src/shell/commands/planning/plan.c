/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/planning/plan.h"
#include <stdlib.h>

domq_real plan_material(const struct plan *p, const struct domq_domino *d)
{
    domq_real width = d->height / 2;
    return p->hollow ? 2 * (d->height * width + d->height * d->thickness + width * d->thickness)
                     : d->height * width * d->thickness;
}

bool plan_make(const struct query *query, struct problem *problem, const struct domq_design *d,
               domq_real height, struct plan *p)
{
    struct domq_train train = query->scene->train;
    train.s = d->s;
    train.r = d->r;
    *p = (struct plan){
        .count = d->steps + 1, .mass = scene_mass(query->scene), .hollow = query->scene->train.q == 3};
    p->domino = malloc(p->count * sizeof *p->domino);
    if (!p->domino)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    domq_row_of_train(&train, &query->scene->scale, p->mass > 0 ? p->mass : 1, p->domino, p->count);
    p->domino[d->steps].height = height;
    return true;
}

static const struct column list_columns[] = {
    {"domino", "", "", 6},    {"height", "m", "", 0}, {"thickness", "m", "", 0}, {"gap", "m", "", 0},
    {"at", "m", "", 0},       {"mass", "kg", "", 0},  {"relative", "", "", 0},   {"surface", "m^2", "", 0},
    {"volume", "m^3", "", 0}, {NULL, NULL, NULL, 0},
};

void plan_list(const struct answer *a, const struct plan *p)
{
    struct answer list = {.out = a->out, .style = a->style, .columns = list_columns, .rows = true};
    const struct domq_domino *last = &p->domino[p->count - 1];
    domq_real at = 0;
    list.style.errors = false;
    answer_leave_out(&list, p->mass > 0 ? "relative" : "mass");
    answer_leave_out(&list, p->hollow ? "volume" : "surface");
    answer_largest(&list, "height", last->height);
    answer_largest(&list, "thickness", last->thickness);
    answer_largest(&list, "gap", last->gap);
    answer_largest(&list, "at", last->height);
    for (int i = 1; list.own[i].key; i++)
        list.own[i].width = 9;
    for (size_t k = 0; k < p->count && !answer_lost(&list); k++) {
        const struct domq_domino *d = &p->domino[k];
        struct cell cells[] = {cell_count((domq_real)k + 1),
                               cell_real(d->height),
                               cell_real(d->thickness),
                               cell_real(d->gap),
                               cell_real(at += d->gap),
                               cell_real(d->mass),
                               cell_real(d->mass / p->domino[0].mass),
                               cell_real(plan_material(p, d)),
                               cell_real(plan_material(p, d))};
        for (int i = 1; i < 9; i++)
            cells[i].digits = 4;
        answer_row(&list, cells, NULL);
        at += d->thickness;
    }
}

void plan_file(struct answer *a, const struct plan *p)
{
    static const struct column columns[] = {
        {"domino", "", "", 6}, {"height", "m", "", 0},  {"thickness", "m", "", 0}, {"gap", "m", "", 0},
        {"mass", "kg", "", 0}, {"relative", "", "", 0}, {NULL, NULL, NULL, 0}};
    a->columns = columns;
    a->rows = a->units = true;
    a->style.errors = false;
    answer_leave_out(a, p->mass > 0 ? "relative" : "mass");
    for (size_t k = 0; k < p->count && !answer_lost(a); k++) {
        const struct domq_domino *d = &p->domino[k];
        answer_cells(a, cell_count((domq_real)k + 1), cell_real(d->height), cell_real(d->thickness),
                     cell_real(d->gap), cell_real(d->mass), cell_real(d->mass / p->domino[0].mass));
    }
}
