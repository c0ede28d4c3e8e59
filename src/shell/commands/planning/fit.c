/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fit: the friction that explains the speeds of measured rows best. */
#include "answer/measure.h"
#include "commands/planning/measured.h"
#include "commands/planning/planning.h"
#include "language/quad.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <stdlib.h>

const char *fit_names(const void *context, int k)
{
    (void)context;
    return k == 0 ? "friction" : NULL;
}

const struct column fit_columns[] = {
    {"gap", "m", "free, between equal dominoes", 0},
    {"measured", "m/s", "speed", 0},
    {"fitted", "m/s", "speed with the fitted friction", 0},
    {"residual", "share", "measured over fitted, less 1", 0},
    {"mu", "", "the fitted friction, in every row", 0},
    {"uncertainty", "", "its standard deviation, in every row", 0},
    {NULL, NULL, NULL, 0},
};

/* ---- The sum of squares ---- */

struct fit {
    const struct query *query;
    const struct measured_rows *rows;
    enum dom_status status; /* of the last speed that has none */
};

/* Returns the front speed of equal dominoes with this gap and friction; NaN if there is none. */
static domq_real speed_at(struct fit *f, domq_real gap, domq_real mu)
{
    struct domq_train train = f->query->scene->train;
    struct domq_value duration;
    train.r = 1;
    train.s = gap / f->query->scene->scale.h;
    train.mu = mu;
    enum dom_status status = domq_cycle_duration(&train, &f->query->scene->compute, &duration);
    if (status == DOM_OK)
        return domq_scale_speed(&f->query->scene->scale, &train, duration.value);
    f->status = status;
    return DOMQ_NAN;
}

/* Returns the standard error of a speed: as measured, or else the same share of each. */
static domq_real error_of(const struct measured_row *row)
{
    return row->error > 0 ? row->error : row->speed;
}

/* Returns the sum of the squared residuals, each over its error. */
static double squares_at(double mu, void *context)
{
    struct fit *f = context;
    domq_real sum = 0;
    for (size_t k = 0; k < f->rows->count; k++) {
        const struct measured_row *row = &f->rows->row[k];
        domq_real residual = (speed_at(f, row->gap, (domq_real)mu) - row->speed) / error_of(row);
        sum += residual * residual;
    }
    return (double)sum;
}

/* ---- Its minimum ---- */

static const double widest = 3, step = 0.02; /* of friction: nothing slides worse */

/* Finds the friction with the least squares: a scan, then Brent's method of GSL. NaN: no speeds anywhere. */
static double friction_find(struct fit *f)
{
    double best = (double)NAN, least = HUGE_VAL;
    for (int k = 0; k * step <= widest; k++) {
        double squares = squares_at(k * step, f);
        if (squares < least) {
            least = squares;
            best = k * step;
        }
    }
    double lo = fmax(best - step, 0), hi = best + step;
    if (isnan(best) || best == 0) { /* the minimum may be at 0 itself */
        if (isnan(best) || !(squares_at(step * 1e-6, f) < least))
            return best;
        best = step * 1e-6;
        lo = 0;
    }
    gsl_function squares = {.function = squares_at, .params = f};
    gsl_min_fminimizer *m = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
    if (m && gsl_min_fminimizer_set(m, &squares, best, lo, hi) == GSL_SUCCESS)
        for (int i = 0; i < 100; i++) {
            if (gsl_min_fminimizer_iterate(m) != GSL_SUCCESS)
                break;
            best = gsl_min_fminimizer_x_minimum(m);
            if (gsl_min_test_interval(gsl_min_fminimizer_x_lower(m), gsl_min_fminimizer_x_upper(m), 1e-10,
                                      1e-8) == GSL_SUCCESS)
                break;
        }
    gsl_min_fminimizer_free(m);
    return best;
}

/*
 * Returns the standard deviation of the friction: the errors of the speeds over what friction does to them.
 * Where the residuals are larger than these errors, or no errors are known, the residuals count instead.
 */
static double uncertainty_of(struct fit *f, double mu)
{
    double at = mu, h = 1e-4, sum = 0, freedom = (double)f->rows->count - 1;
    for (size_t k = 0; k < f->rows->count; k++) {
        const struct measured_row *row = &f->rows->row[k];
        double lo = fmax(at - h, 0), hi = at + h;
        domq_real slope = (speed_at(f, row->gap, (domq_real)hi) - speed_at(f, row->gap, (domq_real)lo)) /
                          (domq_real)(hi - lo) / error_of(row);
        sum += (double)(slope * slope);
    }
    double spread = squares_at(mu, f) / freedom;
    return sqrt((f->rows->errors && spread < 1 ? 1 : spread) / sum);
}

/* ---- The answer ---- */

static bool rows_check(const struct query *query, struct problem *problem, const struct measured_rows *rows,
                       const char *path)
{
    char shown[NAMES_SHOWN];
    size_t gaps = 0;
    for (size_t k = 0; k < rows->count; k++) {
        bool again = false;
        for (size_t j = 0; j < k; j++)
            again = again || rows->row[j].gap == rows->row[k].gap;
        gaps += !again;
        if (rows->row[k].gap > query->scene->scale.h)
            return problem_no_answer(problem,
                                     "%s: the gap %s is longer than the domino is tall, h = %s; 'set h'",
                                     names_shown(path, shown), measured(rows->row[k].gap, "m", 6).text,
                                     measured(query->scene->scale.h, "m", 6).text);
    }
    return gaps >= 2 ||
           problem_no_answer(problem,
                             "%s has one gap, which any friction may fit; add a second gap, or "
                             "use 'set r 1; set s GAP/h; solve friction : duration.speed = SPEED'",
                             names_shown(path, shown));
}

static void fit_say(struct answer *a, const struct measured_rows *rows, double mu, double uncertainty,
                    double worst)
{
    answer_say(
        a,
        "\nA friction of %.3g fits best, with a standard deviation of %.2g; %s. 'effect friction %.3g' "
        "takes it.",
        mu, uncertainty,
        rows->errors ? "each speed counts by its error" : "each speed counts by the same relative error", mu);
    if (mu == 0)
        answer_say(a, "The speeds are as high as without friction, or higher.");
    answer_say(a, "The largest residual is %.2g %%.", 100 * worst);
}

bool run_fit(const struct query *query, struct answer *a, struct problem *problem)
{
    struct measured_rows rows;
    struct fit f = {.query = query, .rows = &rows, .status = DOM_OK};
    double worst = 0;
    if (!measured_read(query, problem, query->given->word[1], &rows))
        return false;
    bool done = rows_check(query, problem, &rows, query->given->word[1]);
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    double mu = done ? friction_find(&f) : 0, uncertainty = done ? uncertainty_of(&f, mu) : 0;
    gsl_set_error_handler(handler);
    if (done && dom_raised(query->scene->compute.interrupt))
        done = problem_status(problem, query->scene, DOM_INTERRUPTED);
    if (done && isnan(mu))
        done = problem_status(problem, query->scene, f.status);
    if (done && answer_for_people(a)) {
        answer_leave_out(a, "mu");
        answer_leave_out(a, "uncertainty");
    }
    if (done)
        answer_largest(a, "residual", 1);
    for (size_t k = 0; done && k < rows.count && !answer_lost(a); k++) {
        const struct measured_row *row = &rows.row[k];
        domq_real fitted = speed_at(&f, row->gap, (domq_real)mu);
        struct cell cells[] = {cell_real(row->gap),
                               cell_real(row->speed),
                               cell_bound(fitted, DOMQ_NAN),
                               cell_bound(row->speed / fitted - 1, DOMQ_NAN),
                               cell_bound((domq_real)mu, DOMQ_NAN),
                               cell_bound((domq_real)uncertainty, DOMQ_NAN)};
        cells[2].digits = 4;
        cells[3].digits = 2;
        cells[4].digits = cells[5].digits = 4;
        worst = fmax(worst, fabs((double)(row->speed / fitted) - 1));
        answer_row(a, cells, NULL);
    }
    if (done)
        fit_say(a, &rows, mu, uncertainty, worst);
    free(rows.row);
    return done;
}
