/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run.h"
#include "support.h"

static bool fall_seen(const struct domq_fall *fall, void *context)
{
    struct run *run = context;
    assert_true(run->falls < ROW_MOST && fall->domino == run->falls + 1);
    run->fall[run->falls++] = *fall;
    return true;
}

enum dom_status run_whole(struct run *run)
{
    run->row.domino = run->domino;
    run->falls = 0;
    return ask_row_run(&run->row, true, fall_seen, run, &run->verdict);
}

enum dom_row_end row_end(struct run *run)
{
    run->row.domino = run->domino;
    assert_status(ask_row_run(&run->row, false, NULL, NULL, &run->verdict), DOM_OK);
    return run->verdict.end;
}

double push_over(const struct domq_domino *domino)
{
    double h = domino->height, d = domino->thickness;
    return sqrt(3 * 9.81 * (hypot(h, d) - h) / (h * h + d * d));
}

void make_row(struct run *run, size_t count, double s, double r, double mu)
{
    struct setup train = setup_default();
    struct domq_scale scale = domq_scale_default();
    train.s = s;
    train.r = r;
    ask_row_of_train(&train, &scale, 0.01, run->domino, count);
    run->row = row_setup_default(run->domino, count, 3 * push_over(run->domino));
    run->row.mu = mu;
}

void alike(struct run *run, size_t count)
{
    make_row(run, count, 13.0 / 48, 1, 0);
    run->row.push = 5;
}

double tips_at(const struct domq_domino *domino)
{
    return atan((double)(domino->thickness / domino->height));
}

/* Makes a random row of equal, growing, shrinking or uneven dominoes. The push is between slightly less and
 * much more than a single domino needs to turn over. */
void row_of_kind(struct run *run, uint64_t *seed, int kind)
{
    static const double mus[] = {0, 0.1, 0.4}, pushes[] = {0.98, 1.02, 1.5, 4, 15};
    size_t count = 1 + (size_t)(25 * random_unit(seed));
    double s = 0.05 + 0.6 * random_unit(seed), r = 1;
    if (kind == 1)
        r = 1 + (fmin(0.98 / s, 1.9) - 1) * random_unit(seed);
    if (kind == 2)
        r = 1 - (1 - 1 / sqrt(1 + s * s)) * random_unit(seed);
    make_row(run, count, s, r, mus[(int)(3 * random_unit(seed))]);
    for (size_t k = 0; k < count; k++) {
        struct domq_domino *d = &run->domino[k];
        double few = kind == 3 ? 0.03 : 0;
        d->height *= 1 + few * (2 * random_unit(seed) - 1);
        if (kind == 3) {
            d->thickness *= 0.5 + random_unit(seed);
            d->gap *= 0.7 + 0.6 * random_unit(seed);
            d->mass *= 0.5 + random_unit(seed);
        }
    }
    run->row.push = pushes[(int)(5 * random_unit(seed))] * push_over(run->domino);
}

bool run_is_clear(const struct run *run)
{
    for (size_t k = 0; k < run->falls; k++)
        if (fabs((double)run->fall[k].margin) < 1e-6 * (double)run->fall[k].kinetic)
            return false;
    return true;
}

static void near_newton(const char *what, const struct run *run, size_t k, domq_real got, double expected,
                        double size, double bound)
{
    double off = (double)got == expected ? 0 : fabs((double)got - expected) / size;
    if (!(off <= bound))
        fail_msg(
            "%s of domino %zu of %zu: %.17g, by Newton %.17g, off by %g (mu %g, lean %g, alpha %g, walls %g)",
            what, k + 1, run->row.count, (double)got, expected, off, (double)run->row.mu,
            (double)run->domino[k].lean, (double)run->row.alpha, (double)run->row.walls);
}

/* The tolerance is 1e-13 for each step of the integrator, and 1e-12 for the row. A small margin is a
 * difference of large energies with large absolute errors, so the bound increases as the margin decreases. */
static void compare_hits(const struct run *run, const struct newton *n)
{
    double friction_work = 0, spare = INFINITY;
    for (size_t k = 0; k < run->falls; k++) {
        const struct domq_fall *f = &run->fall[k];
        const struct newton_hit *h = &n->hit[k];
        double bound = 1e-10 * (1 + 1 / spare);
        if (h->time > 0)
            near_newton("time", run, k, f->time, h->time, h->time, bound);
        near_newton("omega", run, k, f->omega, h->omega, h->omega, bound);
        near_newton("kinetic", run, k, f->kinetic, h->kinetic, h->kinetic, bound);
        near_newton("lost", run, k, f->lost, h->kinetic_before - h->kinetic, h->kinetic_before, bound);
        near_newton("friction_work", run, k, friction_work, h->friction_work,
                    h->kinetic_before + friction_work, bound);
        friction_work += (double)f->friction_work;
        if (f->kinetic > 0)
            spare = fmin(spare, fabs((double)(f->margin / f->kinetic)));
    }
    const size_t last = run->falls - 1;
    const double bound = 1e-10 / fmin(1, spare);
    if (run->verdict.end == DOM_ROW_FALLS)
        near_newton("the end", run, last, run->verdict.seconds, n->end_time, n->end_time, bound);
    if (run->verdict.end == DOM_ROW_STOPS)
        near_newton("rest", run, last, run->fall[last].theta, n->stop_theta, 1, bound);
}

void newton_compare(const struct run *run, const struct newton *n)
{
    const enum dom_row_end end = run->verdict.end;
    if (end == DOM_ROW_FALLS || end == DOM_ROW_STOPS || end == DOM_ROW_MISSES) {
        if (n->wrong)
            fail_msg("Newton: %s (end %d)", n->wrong, end);
        assert_int_equal(n->hits, run->falls);
        assert_int_equal(n->all_fall, end == DOM_ROW_FALLS);
        /* The model checks forces at a few tilts only, so that contacts may open a little. */
        if (n->least_at > 0)
            assert_true(n->least_force >= -0.02 * (double)(run->domino[n->least_at - 1].mass * run->row.g));
    }
    if (end == DOM_ROW_PASSES)
        assert_non_null(n->wrong);
    if (end == DOM_ROW_PARTS) /* from this domino on, contacts pull in Newton's equations */
        assert_true(n->least_force < 0);
    compare_hits(run, n);
}
