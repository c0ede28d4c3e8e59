/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The command fit, which finds the friction that best explains the measured speeds of rows of equal dominoes.
 * The speeds are read from a csv file (language/csv_table.h):
 *
 *     # a hard floor
 *     gap (mm), speed (m/s), error (m/s)
 *     9.38, 1.295, 0.02
 *
 * The column of errors may be missing, and other columns are ignored.
 */
#include "commands/planning/planning.h"
#include "commands/rows/falling.h"
#include "session/rowfile.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <stdlib.h>

const char *fit_names(const void *context, int k)
{
    (void)context;
    return k == 0 ? "friction" : NULL;
}

const struct column fit_columns[] = {
    {"gap", "m", "the free gap between equal dominoes", 0},
    {"measured", "m/s", "the measured speed", 0},
    {"fitted", "m/s", "the speed with the fitted friction", 0},
    {"residual", "share", "measured / fitted - 1", 0},
    {"mu", "", "the fitted friction, in every row", 0},
    {"uncertainty", "", "the standard deviation of mu, in every row", 0},
    {NULL, NULL, NULL, 0},
};

struct fit {
    const struct query *query;
    struct measured_row {
        domq_real gap, speed, error; /* in m and m/s; the error is 0 if it is not known */
    } * row;
    size_t count;
    bool errors;            /* the errors of all speeds are known */
    enum dom_status status; /* the reason why speed_at last returned NaN */
};

/* ---- The file ---- */

enum { GAP, SPEED, ERROR, KINDS };

#define SPEEDS "m/s", "m/s, cm/s, mm/s, ft/s", "m/s", "write a speed such as 1.3 m/s"

static const struct csv_column csv_columns[KINDS] = {
    {"gap", "spacing,distance,separation", CSV_REQUIRED, CSV_LENGTH, "write a length such as 9 mm",
     CSV_ABOVE_0, 1e9, "more than 0, up to 1e9 m"},
    {"speed", "velocity,v", CSV_REQUIRED, SPEEDS, CSV_ABOVE_0, 3e8, "more than 0, up to 3e8 m/s"},
    {"error", "errors,sigma,uncertainty,speed error", CSV_EMPTY, SPEEDS, CSV_ABOVE_0, 3e8,
     "more than 0, up to 3e8 m/s"},
};

static const struct csv_kind measurements = {
    .column = csv_columns,
    .columns = KINDS,
    .rows_most = 10000,
    .item = "measured row",
    .items = "speeds",
    .names = "gap (mm), speed (m/s), and, if known, error (m/s)",
    .example = "gap (mm), speed (m/s)",
};

static bool row_add(struct fit *f, struct csv_table *csv)
{
    const domq_real *value = csv->value;
    const bool known = value[ERROR] > 0;
    if (f->count > 0 && known != f->errors)
        return csv_wrong(&csv->file, csv_cell(csv, ERROR).at,
                         "some speeds have an error and some have none; give all of them one, or none");
    struct measured_row *more = realloc(f->row, (f->count + 1) * sizeof *more);
    if (!more)
        return csv_wrong(&csv->file, csv->row.at, "out of memory");
    f->errors = known;
    f->row = more;
    f->row[f->count++] = (struct measured_row){value[GAP], value[SPEED], known ? value[ERROR] : 0};
    return true;
}

/* Checks that the friction can be found from the measured rows. If not, sets *problem and returns false. */
static bool rows_check(const struct fit *f, struct problem *problem)
{
    char shown[NAMES_SHOWN];
    const domq_real h = f->query->scene->scale.h;
    bool several = false;
    names_shown(f->query->given->word[1], shown);
    for (size_t k = 0; k < f->count; k++) {
        several = several || f->row[k].gap != f->row[0].gap;
        if (f->row[k].gap > h)
            return problem_no_answer(
                problem, "%s: the gap %s is longer than the domino is tall, h = %s; 'set h' changes that",
                shown, measured(f->row[k].gap, "m", 6).text, measured(h, "m", 6).text);
    }
    return several ||
           problem_no_answer(problem,
                             "%s has one gap, which any friction may fit; add a second gap, or use 'set r "
                             "1; set s GAP/h; solve friction : duration.speed = SPEED'",
                             shown);
}

/* ---- The sum of squares ---- */

/* Returns the front speed of equal dominoes with this gap and friction. If it cannot be computed, sets
 * f->status and returns NaN. */
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

/* Returns the standard error of a speed. If errors are not known, all speeds get the same relative error. */
static domq_real error_of(const struct measured_row *row)
{
    return row->error > 0 ? row->error : row->speed;
}

/* Returns the sum of (residual / error)^2 over all measured rows, for friction mu. */
static double squares_at(double mu, void *context)
{
    struct fit *f = context;
    domq_real sum = 0;
    for (size_t k = 0; k < f->count; k++) {
        const struct measured_row *row = &f->row[k];
        domq_real residual = (speed_at(f, row->gap, (domq_real)mu) - row->speed) / error_of(row);
        sum += residual * residual;
    }
    return (double)sum;
}

/* ---- Its minimum ---- */

/* Finds the friction with the least sum of squares, by a scan from 0 to 3 and then Brent's method. Returns
 * NaN if the dominoes do not keep falling at any friction. */
static double friction_find(struct fit *f)
{
    const double highest = 3, step = 0.02;
    double best = (double)NAN, least = HUGE_VAL;
    for (int k = 0; k * step <= highest; k++) {
        double squares = squares_at(k * step, f);
        if (squares < least) {
            least = squares;
            best = k * step;
        }
    }
    double low = fmax(best - step, 0), high = best + step;
    if (isnan(best) || best == 0) { /* the minimum may be exactly at 0 */
        if (isnan(best) || !(squares_at(step * 1e-6, f) < least))
            return best;
        best = step * 1e-6;
        low = 0;
    }
    gsl_function squares = {.function = squares_at, .params = f};
    gsl_min_fminimizer *m = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
    if (m && gsl_min_fminimizer_set(m, &squares, best, low, high) == GSL_SUCCESS)
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
 * Returns the standard deviation of the fitted friction. It follows from the errors of the speeds and from
 * the derivatives of the speeds with respect to friction. If the residuals are larger than the errors, or if
 * no errors are known, the residuals are used in place of the errors.
 */
static double uncertainty_of(struct fit *f, double mu)
{
    const double low = fmax(mu - 1e-4, 0), high = mu + 1e-4, freedom = (double)f->count - 1;
    double sum = 0;
    for (size_t k = 0; k < f->count; k++) {
        const struct measured_row *row = &f->row[k];
        domq_real slope = (speed_at(f, row->gap, (domq_real)high) - speed_at(f, row->gap, (domq_real)low)) /
                          (domq_real)(high - low) / error_of(row);
        sum += (double)(slope * slope);
    }
    double spread = squares_at(mu, f) / freedom;
    return sqrt((f->errors && spread < 1 ? 1 : spread) / sum);
}

/* ---- The answer ---- */

static void fit_answer(struct answer *a, struct fit *f, double mu, double uncertainty)
{
    double worst = 0;
    if (answer_for_people(a)) {
        answer_leave_out(a, "mu");
        answer_leave_out(a, "uncertainty");
    }
    for (size_t k = 0; k < f->count && !answer_lost(a); k++) {
        const struct measured_row *row = &f->row[k];
        domq_real fitted = speed_at(f, row->gap, (domq_real)mu), residual = row->speed / fitted - 1;
        worst = fmax(worst, fabs((double)residual));
        answer_cells(a, cell_real(row->gap), cell_real(row->speed), cell_narrow(fitted, 4),
                     cell_narrow(residual, 2), cell_narrow((domq_real)mu, 4),
                     cell_narrow((domq_real)uncertainty, 4));
    }
    answer_say(a,
               "\nA friction of %.3g fits best, with a standard deviation of %.2g; %s. 'effect friction "
               "%.3g' sets it.",
               mu, uncertainty,
               f->errors ? "speeds are weighted by their errors" : "all speeds have the same relative weight",
               mu);
    if (mu == 0)
        answer_say(a, "The speeds are as high as without friction, or higher.");
    answer_say(a, "The largest residual is %.2g %%.", 100 * worst);
}

/* Finds the friction from the measured rows of the file, and prints the answer. */
static bool rows_fit(struct fit *f, struct answer *a, struct problem *problem)
{
    if (!rows_check(f, problem))
        return false;
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    double mu = friction_find(f), uncertainty = uncertainty_of(f, mu);
    gsl_set_error_handler(handler);
    if (dom_raised(f->query->scene->compute.interrupt))
        return problem_status(problem, f->query->scene, DOM_INTERRUPTED);
    if (isnan(mu))
        return problem_status(problem, f->query->scene, f->status);
    fit_answer(a, f, mu, uncertainty);
    return true;
}

bool run_fit(const struct query *query, struct answer *a, struct problem *problem)
{
    struct fit f = {.query = query};
    struct csv_table *csv =
        csv_named(query->scene, query->means, query->given->word[1], false, &measurements, problem);
    while (csv && csv_next(csv) && row_add(&f, csv))
        ;
    bool done = csv_end(csv, problem) && rows_fit(&f, a, problem);
    free(f.row);
    return done;
}
