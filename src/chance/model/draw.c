/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Draws the random errors of a row. The random numbers for each kind of error depend only on the seed, the
 * kind and the number of the row. So if one kind of error is left out, the errors of all other kinds stay the
 * same.
 */
#include "chance/model/draw.h"
#include "numerics/real.h"
#include <gsl/gsl_randist.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* A random error never reduces a size or a mass below this fraction of its original value. */
#define LEAST_SHARE 0.01

/* A factor that makes the limits of slopes, leans, radii and thicknesses slightly tighter. A value that is
 * within the tightened limits is within the true limits in spite of rounding errors. */
#define INSIDE (1 - 1e-6)

/* Derives seed number i from `seed`. Successive integers as seeds would give similar random numbers, so the
 * bits are mixed, as in splitmix64 (Steele et al., 2014). */
static unsigned long long seed_of(unsigned long long seed, size_t i)
{
    unsigned long long z = seed * 0x9e3779b97f4a7c15ULL + i * 0xbf58476d1ce4e5b9ULL + 0x94d049bb133111ebULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

/* Returns the next random error. It is made from the numbers of two generators, because the seeds of GSL have
 * only 32 bits. With a single generator, about a hundred pairs among a million rows would have the same seed
 * and therefore the same errors. */
static double error_next(const struct draw *draw, const struct dom_random_error *error)
{
    const gsl_rng *random = draw->random;
    if (error->uniform) {
        double u = gsl_rng_uniform(&random[0]) + gsl_rng_uniform(&random[1]);
        return error->size * (2 * (u < 1 ? u : u - 1) - 1);
    }
    double normal = gsl_ran_gaussian_ziggurat(&random[0], 1) + gsl_ran_gaussian_ziggurat(&random[1], 1);
    return error->size * (normal * M_SQRT1_2);
}

static double radius_of(const struct dom_row *row, const struct dom_domino *d)
{
    return row->rho == 0 ? 0 : d->radius > 0 ? d->radius : row->rho * d->height;
}

double row_steepest(const struct dom_row *row)
{
    double steepest = M_PI_2;
    for (size_t k = 0; k < row->count; k++) {
        double limit[2];
        dom_lean_limits(&row->domino[k], 0, row->rho, limit);
        steepest = fmin(steepest, limit[1] - fabs(row->domino[k].lean));
    }
    return steepest;
}

/*
 * Applies a random error to domino k, or to the whole row. A domino that would fall over by itself gets the
 * largest lean at which it stands. The thickness and the radius are limited, so that walls and rounded edges
 * still fit.
 */
static void error_apply(struct draw *draw, enum dom_error_of kind, size_t k, double by)
{
    struct dom_row *const row = &draw->row;
    struct dom_domino *const d = &draw->domino[k];
    const struct dom_domino before = *d;
    const double factor = fmax(1 + by, LEAST_SHARE);
    double limit[2], middle, bound;
    switch (kind) {
    case DOM_ERROR_gap:
        d->gap = k > 0 ? fmax(d->gap + by, 0) : d->gap;
        break;
    case DOM_ERROR_height:
        d->width = width_of(d);
        d->height = height_of_kind(row, d->height, d->height * factor);
        d->mass *= wood_factor(row, &before, d, factor);
        break;
    case DOM_ERROR_thickness:
        bound = 2 * fmax(walls_of(row, d->height), radius_of(row, d)) / INSIDE;
        d->thickness = fmax(d->thickness * factor, fmin(bound, d->thickness));
        d->mass *= wood_factor(row, &before, d, d->thickness / before.thickness);
        break;
    case DOM_ERROR_mass:
        d->mass *= factor;
        break;
    case DOM_ERROR_radius:
        if (row->rho != 0)
            d->radius = fmin(radius_of(row, d) * factor, fmin(d->thickness, d->height) / 2 * INSIDE);
        break;
    case DOM_ERROR_lean:
        dom_lean_limits(d, row->alpha, row->rho, limit);
        middle = (limit[0] + limit[1]) / 2;
        bound = (limit[1] - limit[0]) / 2 * INSIDE;
        d->lean = fmin(fmax(d->lean + by, middle - bound), middle + bound);
        break;
    case DOM_ERROR_friction:
        row->mu = fmin(fmax(row->mu + by, 0), DOM_MU_HIGHEST);
        break;
    case DOM_ERROR_slope:
        bound = fmax(row_steepest(row) * INSIDE, fabs(row->alpha));
        row->alpha = fmin(fmax(row->alpha + by, -bound), bound);
        break;
    case DOM_ERROR_floor:
        row->feet += by;
        break;
    default: /* DOM_ERROR_push */
        row->push = isnan(row->push) ? row->push : fmax(row->push + by, 0);
    }
}

/* Moves each domino after the first by a random error of its own. If a domino would overlap the previous
 * domino, it is placed so that it touches the previous domino. */
static void places_draw(const struct draw *draw, const struct dom_random_error *error)
{
    double before = 0; /* distance by which the previous domino has moved */
    for (size_t k = 1; k < draw->row.count; k++) {
        const double by = error_next(draw, error), gap = draw->domino[k].gap + by - before;
        draw->domino[k].gap = fmax(gap, 0);
        before = gap < 0 ? by - gap : by;
    }
}

void draw_row(struct draw *draw, const struct dom_row *row, const struct dom_placement *p, size_t i)
{
    /* Random leans come last, since their limits depend on the sizes and on the slope. */
    static const enum dom_error_of order[] = {DOM_ERROR_gap,       DOM_ERROR_place, DOM_ERROR_height,
                                              DOM_ERROR_thickness, DOM_ERROR_mass,  DOM_ERROR_radius,
                                              DOM_ERROR_friction,  DOM_ERROR_slope, DOM_ERROR_floor,
                                              DOM_ERROR_push,      DOM_ERROR_lean};
    _Static_assert(sizeof order / sizeof *order == DOM_ERROR_COUNT,
                   "`order` must list each kind of error once");
    const unsigned long long row_seed = seed_of(p->seed, i);
    memcpy(draw->domino, row->domino, row->count * sizeof *draw->domino);
    draw->row = *row;
    draw->row.domino = draw->domino;
    for (int k = 0; k < DOM_ERROR_COUNT; k++) {
        const struct dom_random_error *error = &p->error[order[k]];
        if (!(error->size > 0))
            continue;
        const unsigned long long seed =
            order[k] == DOM_ERROR_gap ? row_seed : seed_of(row_seed, (size_t)order[k]);
        gsl_rng_set(&draw->random[0], (unsigned long)(seed & 0xffffffffU));
        gsl_rng_set(&draw->random[1], (unsigned long)(seed >> 32));
        if (order[k] == DOM_ERROR_place)
            places_draw(draw, error);
        else
            for (size_t j = 0; j < (order[k] < DOM_ERROR_friction ? row->count : 1); j++)
                error_apply(draw, order[k], j, error_next(draw, error));
    }
    /* A first domino that would be inside the second one is released where it touches it. */
    struct dom_row *const drawn = &draw->row;
    double touch;
    if (drawn->release > 0 && isfinite(drawn->release) && !isnan(drawn->push) &&
        dom_row_touch(drawn, NULL, &touch) == DOM_OK && drawn->release > touch)
        drawn->release = HUGE_VAL;
}

/* The number of random rows in a batch, large enough to make the time for memory allocation negligible. */
enum { BATCH = 16 };

/* The data that all batches share. */
struct batches {
    const struct dom_row *row;
    size_t rows;
    draw_visit *visit;
    void *context;
    atomic_int status; /* DOM_OK, or the status of the first batch that failed */
};

/* A dom_task that visits the rows of batch number `index`, unless another batch has failed. */
static void batch_run(size_t index, void *context)
{
    struct batches *b = context;
    if (atomic_load(&b->status) != DOM_OK)
        return;
    /* gsl_rng_alloc would end the program if memory runs out, unless GSL's error handler, which belongs to
     * the whole process, is switched off. */
    struct draw draw = {
        .random = {{gsl_rng_taus2, malloc(gsl_rng_taus2->size)}, {gsl_rng_mrg, malloc(gsl_rng_mrg->size)}},
        .domino = malloc(b->row->count * sizeof *draw.domino)};
    const bool ready = draw.random[0].state && draw.random[1].state && draw.domino;
    enum dom_status status = ready ? DOM_OK : DOM_NO_MEMORY;
    for (size_t i = index * BATCH; i < b->rows && i < (index + 1) * BATCH && status == DOM_OK; i++)
        status = b->visit(&draw, i, b->context);
    int none = DOM_OK;
    if (status != DOM_OK)
        atomic_compare_exchange_strong(&b->status, &none, (int)status);
    free(draw.random[0].state);
    free(draw.random[1].state);
    free(draw.domino);
}

enum dom_status draw_run(const struct dom_row *row, const struct dom_placement *p, draw_visit *visit,
                         void *context)
{
    struct batches b = {row, p->rows, visit, context, DOM_OK};
    const size_t batches = p->rows / BATCH + (p->rows % BATCH > 0);
    enum dom_status status = DOM_OK;
    if (p->parallel)
        status = p->parallel(batches, batch_run, &b, p->pool);
    for (size_t i = 0; i < batches && !p->parallel; i++)
        batch_run(i, &b);
    return b.status != DOM_OK ? (enum dom_status)b.status : status;
}
