/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: chance */
/* Verdicts on random rows. In a study, bounds decide for most heads whether they keep falling. Here an engine
 * also runs each random row in full with this library, and must find the same verdicts. */
#include "ask.h"
#include "chance/model/draw.c"
#include "rows/model/boxes.h"
#include "support.h"
#include <string.h>

enum { MOST = 16 };

/* An engine that runs the row in full with the library. */
static enum dom_status in_full(const struct dom_row *row, const struct dom_compute *compute, bool times,
                               dom_fall_visit *visit, void *context, struct dom_verdict *verdict)
{
    struct dom_row own = *row;
    own.engine = NULL;
    return dom_row_run(&own, compute, times, visit, context, verdict);
}

struct kind {
    const char *name;
    double r, s, q, push, sigma, heights, mu, alpha, walls, rho, air;
    size_t rows;
    struct dom_random_error error[DOM_ERROR_COUNT]; /* more errors */
};

/* Initializers for the size of a normal error, and for the limit of a uniform error. */
#define SIZE(kind, size_)  [DOM_ERROR_##kind] = {.size = size_}
#define WITHIN(kind, most) [DOM_ERROR_##kind] = {.size = most, .uniform = true}
#define NO_MORE                                                                                              \
    {                                                                                                        \
        [DOM_ERROR_gap] = {.size = 0 }                                                                       \
    }

static const struct kind KIND[] = {
    /* r, s, q, push, sigma, heights, mu, alpha, walls, rho, air, rows */
    {"few stop", 1.3, 0.4, 0, 0, 0.004, 0, 0, 0, 0, 0, 0, 0, NO_MORE},
    {"many stop", 1.7, 0.5, 0, 0, 0.005, 0, 0, 0, 0, 0, 0, 0, NO_MORE},
    {"pushed", 1.45, 0.2, 0, 4, 0.004, 0, 0, 0, 0, 0, 0, 0, NO_MORE},
    {"heights", 1.5, 0.6, 0, 0, 0.001, 0.1, 0, 0, 0, 0, 0, 0, NO_MORE},
    {"equal", 1, 0.1, 0, 6, 0.002, 0, 0, 0, 0, 0, 0, 0, NO_MORE},
    {"touching", 1.05, 0.03, 0, 6, 0.003, 0, 0, 0, 0, 0, 0, 0, NO_MORE},
    {"detach", 1.1, 0.85, 0, 6, 0.003, 0, 0, 0, 0, 0, 0, 0, NO_MORE},
    {"solid", 1.4, 0.3, 4, 0, 0.003, 0, 0, 0, 0, 0, 0, 0, NO_MORE},
    {"downhill", 1.6, 0.3, 0, 0, 0.004, 0, 0, 0.03, 0, 0, 0, 0, NO_MORE},
    {"uphill", 1.4, 0.3, 0, 0, 0.004, 0, 0, -0.03, 0, 0, 0, 0, NO_MORE},
    {"walls", 1.3, 0.4, 0, 0, 0.003, 0.02, 0, 0, 0.0005, 0, 0, 0, NO_MORE},
    {"rounded", 1.5, 0.4, 0, 0, 0.004, 0, 0, 0, 0, 0.01, 0, 20, NO_MORE},
    {"air", 1.45, 0.4, 0, 0, 0.005, 0, 0, 0, 0, 0, 2, 0, NO_MORE},
    {"air, rounded", 1.45, 0.4, 0, 0, 0.005, 0, 0, 0, 0, 0.01, 20, 20, NO_MORE},
    {"air, masses", 1, 0.3, 0, 15, 0.002, 0, 0, 0, 0, 0, 20, 0, {SIZE(mass, 0.9), SIZE(thickness, 0.4)}},
    {"air, friction", 1.3, 0.4, 0, 0, 0.004, 0, 0.2, 0, 0, 0, 20, 30, NO_MORE},
    {"friction", 1.3, 0.4, 0, 0, 0.004, 0, 0.2, 0, 0, 0, 0, 30, NO_MORE},
    {"friction, many stop", 1.6, 0.5, 0, 0, 0.004, 0, 0.2, 0, 0, 0, 0, 30, NO_MORE},
    {"friction, pushed", 1.45, 0.2, 0, 4, 0.004, 0, 0.2, 0, 0, 0, 0, 30, NO_MORE},
    {"friction, heights", 1.3, 0.5, 0, 0, 0, 0.1, 0.3, 0, 0, 0, 0, 30, NO_MORE},
    {"friction, locks", 1.2, 0.75, 0, 6, 0.003, 0, 0.6, 0, 0, 0, 0, 30, NO_MORE},
    {"friction, touching", 1.05, 0.03, 0, 6, 0.003, 0, 0.2, 0, 0, 0, 0, 30, NO_MORE},
    {"friction, downhill", 1.5, 0.3, 0, 0, 0.004, 0, 0.2, 0.03, 0, 0, 0, 30, NO_MORE},
    {"friction, rounded", 1.75, 0.4, 0, 0, 0.004, 0, 0.2, 0, 0, 0.01, 0, 30, NO_MORE},
    {"friction, rounded, detach", 1.1, 0.8, 0, 6, 0.003, 0, 0.1, 0, 0, 0.02, 0, 20, NO_MORE},
    {"friction, rounded, locks", 1.2, 0.75, 0, 6, 0.003, 0, 0.6, 0, 0, 0.01, 0, 20, NO_MORE},
    {"friction, rounded, downhill", 1.7, 0.4, 0, 0, 0.004, 0, 0.2, 0.02, 0, 0.01, 0, 20, NO_MORE},
    {"friction, radii", 1.8, 0.4, 0, 0, 0, 0, 0.2, 0, 0, 0.02, 0, 20, {WITHIN(radius, 0.9)}},
    {"places", 1.6, 0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {SIZE(place, 0.004)}},
    {"thickness", 1.8, 0.4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {SIZE(thickness, 0.2)}},
    {"thickness, walls", 1.9, 0.4, 0, 0, 0, 0, 0, 0, 0.003, 0, 0, 0, {SIZE(thickness, 0.3)}},
    {"masses", 1.95, 0.4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {SIZE(mass, 0.2)}},
    {"radii", 2.05, 0.4, 0, 0, 0, 0, 0, 0, 0, 0.01, 0, 20, {WITHIN(radius, 0.9)}},
    {"radii, thickness", 2, 0.4, 0, 0, 0, 0, 0, 0, 0, 0.06, 0, 20, {SIZE(thickness, 0.3)}},
    {"unknown friction", 1.75, 0.4, 0, 0, 0, 0, 0.2, 0, 0, 0, 0, 40, {SIZE(friction, 0.1)}},
    {"some friction", 1.95, 0.4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 40, {WITHIN(friction, 0.1)}},
    {"unknown slope", 1.9, 0.4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {SIZE(slope, 0.03)}},
    {"any slope", 1.5, 0.4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {SIZE(slope, 0.3)}},
    {"unknown push", 1.4, 0.2, 0, 2.6, 0, 0, 0, 0, 0, 0, 0, 0, {WITHIN(push, 1)}},
    {"all but leans",
     1.6,
     0.4,
     0,
     4,
     0.002,
     0.02,
     0.2,
     0.01,
     0,
     0,
     0,
     40,
     {WITHIN(place, 0.002), SIZE(thickness, 0.05), WITHIN(mass, 0.1), SIZE(friction, 0.05),
      WITHIN(slope, 0.01), SIZE(push, 0.5)}},
};

static struct dom_row row_of(const struct kind *k, struct dom_domino *domino)
{
    struct dom_train train = dom_train_default();
    struct dom_scale scale = dom_scale_default();
    const size_t count = k->r == 1 ? MOST : MOST / 2;
    train.r = k->r;
    train.s = k->s;
    train.q = k->q != 0 ? k->q : 3;
    dom_row_of_train(&train, &scale, 0.01, domino, count);
    return (struct dom_row){.domino = domino,
                            .count = count,
                            .g = scale.g,
                            .push = k->push != 0 ? k->push : DOM_NAN,
                            .mu = k->mu,
                            .alpha = k->alpha,
                            .walls = k->walls,
                            .rho = k->rho,
                            .air = k->air};
}

/* Checks that the same number of rows end at each domino as when each row is run in full. */
TEST(as_in_full)
{
    const struct dom_engine full = {.run = in_full};
    size_t fall = 0, stop = 0;
    for (size_t i = 0; i < sizeof KIND / sizeof *KIND; i++) {
        const struct kind *k = &KIND[i];
        struct dom_domino domino[MOST];
        struct dom_row row = row_of(k, domino);
        struct dom_compute compute = dom_compute_default();
        struct dom_placement p = {
            .error = {[DOM_ERROR_gap].size = k->sigma, [DOM_ERROR_height].size = k->heights},
            .seed = 7,
            .rows = k->rows ? k->rows : 100};
        for (int of = 0; of < DOM_ERROR_COUNT; of++)
            if (k->error[of].size > 0)
                p.error[of] = k->error[of];
        struct dom_study study, other;
        size_t stops[MOST] = {0}, others[MOST] = {0};
        compute.tol = 1e-9;
        assert_status(dom_placement_study(&row, &compute, &p, &study, stops), DOM_OK);
        row.engine = &full;
        assert_status(dom_placement_study(&row, &compute, &p, &other, others), DOM_OK);
        if (study.fall != other.fall || study.unknown != other.unknown ||
            memcmp(stops, others, sizeof stops) != 0)
            fail_msg("%s: %zu fall, %zu are unknown; in full %zu and %zu", k->name, study.fall, study.unknown,
                     other.fall, other.unknown);
        fall += study.fall;
        stop += study.rows - study.fall;
    }
    assert_true(fall > 200 && stop > 200); /* both verdicts must occur */
}

/* A dom_parallel that runs three batches and then reports an interrupt. */
static enum dom_status three_batches(size_t count, dom_task *task, void *context, void *pool)
{
    (void)pool;
    for (size_t i = 0; i < count && i < 3; i++)
        task(i, context);
    return DOM_INTERRUPTED;
}

/* Checks that an interrupted study counts the rows that were run, and that it writes nothing if no row was
 * run. */
TEST(interrupted_in_the_middle)
{
    struct dom_domino domino[MOST];
    struct dom_row row = row_of(&KIND[0], domino);
    struct dom_compute compute = dom_compute_default();
    struct dom_placement p = {
        .error[DOM_ERROR_gap].size = KIND[0].sigma, .seed = 7, .rows = 100000, .parallel = three_batches};
    struct dom_study part, whole;
    size_t stops[MOST] = {0}, others[MOST] = {0};
    assert_status(dom_placement_study(&row, &compute, &p, &part, stops), DOM_INTERRUPTED);
    assert_true(part.rows > 3 && part.rows < 1000);
    p.rows = part.rows;
    p.parallel = NULL;
    assert_status(dom_placement_study(&row, &compute, &p, &whole, others), DOM_OK);
    assert_memory_equal(&part, &whole, sizeof part);
    assert_memory_equal(stops, others, sizeof stops);
    volatile sig_atomic_t raised = 1;
    compute.interrupt = &raised;
    assert_status(dom_placement_study(&row, &compute, &p, &part, stops), DOM_INTERRUPTED);
    assert_memory_equal(&part, &whole, sizeof part);
}

/* ---- The random errors ---- */

enum { DRAWS = 3000, DRAWN = 4 };

/* Returns the volume of wood in a domino, whose width is that of the planned one. */
static double wood(const struct dom_domino *d, const struct dom_domino *planned, double walls)
{
    const double width = planned->width != 0 ? planned->width : planned->height / 2;
    struct dom_box box = {.filled = 1};
    if (walls != 0)
        assert_status(dom_box_find(d->height, d->thickness, width, walls, &box), DOM_OK);
    return d->height * d->thickness * width * box.filled;
}

/* Finds the change of each property of domino k. */
static void changes(const struct draw *draw, const struct dom_row *row, size_t k, double by[DOM_ERROR_COUNT])
{
    const struct dom_domino *a = &draw->domino[k], *b = &row->domino[k];
    by[DOM_ERROR_gap] = by[DOM_ERROR_place] = a->gap - b->gap;
    by[DOM_ERROR_height] = a->height / b->height - 1;
    by[DOM_ERROR_thickness] = a->thickness / b->thickness - 1;
    by[DOM_ERROR_mass] = a->mass / b->mass * wood(b, b, row->walls) / wood(a, b, row->walls) - 1;
    by[DOM_ERROR_radius] = a->radius / b->radius - 1;
    by[DOM_ERROR_lean] = a->lean - b->lean;
    by[DOM_ERROR_friction] = draw->row.mu - row->mu;
    by[DOM_ERROR_slope] = draw->row.alpha - row->alpha;
    by[DOM_ERROR_floor] = draw->row.feet - row->feet;
    by[DOM_ERROR_push] = draw->row.push - row->push;
}

/* Checks that each kind of error changes its property of every domino by the right amount, and changes
 * nothing else. The gap before the first domino is ignored. In boxes the walls and the widths stay the same.
 */
static void every_measure_is_drawn(double walls)
{
    struct dom_domino domino[DRAWN];
    for (size_t k = 0; k < DRAWN; k++)
        domino[k] = (struct dom_domino){.height = 0.05,
                                        .thickness = 0.008,
                                        .gap = 0.02,
                                        .mass = 0.01,
                                        .radius = 0.001,
                                        .lean = 0.01,
                                        .width = k % 2 ? 0.03 : 0};
    struct dom_row row = dom_row_default();
    row.domino = domino;
    row.count = DRAWN;
    row.mu = 0.3;
    row.rho = 0.01;
    row.feet = 0.5;
    row.push = 3;
    row.walls = walls;
    gsl_rng *const random[] = {gsl_rng_alloc(gsl_rng_taus2), gsl_rng_alloc(gsl_rng_mrg)};
    struct dom_domino drawn[DRAWN];
    struct draw draw = {.random = {*random[0], *random[1]}, .domino = drawn};
    for (int kind = 0; kind < DOM_ERROR_COUNT; kind++)
        for (size_t k = kind == DOM_ERROR_gap || kind == DOM_ERROR_place; k < DRAWN; k++) {
            struct dom_placement p = {.seed = 5};
            p.error[kind].size = 1e-3;
            double sum = 0, squares = 0, moved = kind == DOM_ERROR_place && k > 1 ? sqrt(2) : 1;
            for (size_t i = 0; i < DRAWS; i++) {
                draw_row(&draw, &row, &p, i);
                double by[DOM_ERROR_COUNT];
                changes(&draw, &row, k, by);
                const double share = by[kind] / (double)p.error[kind].size;
                sum += share;
                squares += share * share;
                by[kind] = 0;
                by[kind == DOM_ERROR_gap     ? DOM_ERROR_place
                   : kind == DOM_ERROR_place ? DOM_ERROR_gap
                                             : kind] = 0;
                for (int other = 0; other < DOM_ERROR_COUNT; other++)
                    assert_true(fabs(by[other]) < 1e-15);
            }
            assert_true(fabs(sum) < 4 * moved * sqrt(DRAWS));
            assert_near("standard deviation", sqrt(squares / DRAWS), moved, 0.06);
        }
    gsl_rng_free(random[0]);
    gsl_rng_free(random[1]);
    /* The domino that stands on the gentlest slope decides. */
    for (size_t k = 0; k < DRAWN; k++) {
        domino[k].thickness = 0.004;
        domino[k].lean = -0.02;
        assert_near("steepest", row_steepest(&row), atan(0.002 / 0.05) - 0.02, 1e-14);
        domino[k].thickness = 0.008;
        domino[k].lean = 0.01;
    }
}

TEST(solid_dominoes_and_boxes)
{
    every_measure_is_drawn(0);
    every_measure_is_drawn(0.001);
}
