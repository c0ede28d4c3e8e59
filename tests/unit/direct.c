/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finite rows of dominoes by constrained dynamics (direct.h). Only the angle and the angular velocity of the
 * head are integrated. The other angles follow from the constraint that each domino leans on the next, so
 * nothing drifts. All accelerations and contact forces come from one linear system, which consists of
 * Newton's law for each domino and of the second derivative of each constraint. A collision has the same
 * matrix, with impulses instead of forces and velocities instead of accelerations.
 */
#include "direct.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdlib.h>

/* the variables of integration: angle and angular velocity of the head, and the work of friction */
enum { THETA, OMEGA, FRICTION_WORK, DIM };
enum { REACH, REST, LEAVE };                    /* events; LEAVE + i means that contact tail + i opens */
enum { LEAST_STEPS = 32, MOST_STEPS = 100000 }; /* limits for the steps of one phase */

static const double eps_rel = 1e-13, eps_abs = 1e-16;

/* The contact of domino j, which leans on domino k = j + 1. The array of contacts is indexed by j. */
struct contact {
    double face;    /* distance of the tip of j from the bottom of k's back face; d(constraint)/d(theta_k) */
    double drop;    /* h_j cos(theta_j - theta_k); d(constraint)/d(theta_j) */
    double arm_on;  /* torque on k that a unit normal force and its friction exert */
    double arm_by;  /* torque against j that this normal force and its friction exert */
    double forced;  /* right-hand side of the second derivative of the constraint */
    double sliding; /* speed of the tip down the face */
};

struct run {
    const struct direct_row *row;
    struct direct_hit *hits;
    struct direct_result *result;
    size_t tail, head; /* first and last moving domino, counted from 0 */
    double began;      /* time at which this phase began */
    double target;     /* angle of the head that ends this phase */
    double *theta, *omega, *alpha, *force;
    struct contact *contact;
    gsl_matrix *band;
    gsl_vector *known, *found;
    gsl_vector_uint *pivot;
    gsl_odeiv2_system system;
    gsl_odeiv2_step *step;
    gsl_odeiv2_evolve *evolve;
    gsl_odeiv2_control *control;
    gsl_root_fsolver *solver;
    const double *from; /* state at the start of the step in which an event is located */
    size_t event;
};

static double width(const struct direct_row *row, size_t i)
{
    return row->width[i] > 0 ? row->width[i] : row->height[i] / 2;
}

/* Returns the sum of y^power dy over the strips of a plate, from the floor to its upper edge, times its width
 * to the power `across`. */
static double strips(const struct direct_row *row, size_t i, int power, int across)
{
    return pow(row->height[i], power + 1) / (power + 1) * pow(width(row, i), across);
}

/* Returns the torque of the air on a domino, which acts against its motion. Each strip is as fast as omega y,
 * and its arm is y. */
static double air_torque(const struct direct_row *row, size_t i, double omega)
{
    return row->air * row->drag / 2 * omega * fabs(omega) * strips(row, i, 3, 1);
}

static double inertia(const struct direct_row *row, size_t i)
{
    double h = row->height[i], d = row->thickness[i], w = width(row, i),
           t = h > row->boxes_above ? row->walls : 0, sum = 0, volume = 0;
    /* Six boards in three pairs: front and back, bottom and top, left and right. A pair leaves out the edges
     * that the pairs before it fill. */
    const double size[][4] = {{t, h, w, d - t}, {d - 2 * t, t, w, h - t}, {d - 2 * t, h - 2 * t, 2 * t, 0}};

    /* The air that moves along: rho pi (w/2)^2 per unit length of a strip. */
    double more = row->air * acos(-1) / 4 * strips(row, i, 2, 2);

    if (t == 0)
        return row->mass[i] * (h * h + d * d) / 3 + more;
    for (int k = 0; k < 3; k++) {
        const double *s = size[k], own = s[0] * s[1] * s[2], about = (s[0] * s[0] + s[1] * s[1]) / 12;
        double away = s[3] / 2; /* distance from the centre of a board to the centre of the box */
        volume += own * (k < 2 ? 2 : 1);
        sum += own * (k < 2 ? 2 : 1) * (about + away * away);
    }
    return row->mass[i] * (sum / volume + (h * h + d * d) / 4) + more;
}

/* Returns the tilt of a domino before it is hit. */
static double lean(const struct direct_row *row, size_t i)
{
    return row->lean ? row->lean[i] : 0;
}

static double torque(const struct run *run, size_t i)
{
    const struct direct_row *row = run->row;
    double h = row->height[i], d = row->thickness[i];

    return row->mass[i] * row->g *
               (h * sin(run->theta[i] + row->slope) - d * cos(run->theta[i] + row->slope)) / 2 -
           air_torque(row, i, run->omega[i]);
}

/* Finds the position and the velocity of domino j from its leader k = j + 1, and the terms of their contact
 * in the system. */
static void geometry(struct run *run, size_t j)
{
    const struct direct_row *row = run->row;
    size_t k = j + 1;
    double h = row->height[j], d = row->thickness[k], pitch = row->gap[k] + d;
    double x = sin(run->theta[k]), y = cos(run->theta[k]), half = sin(run->theta[k] / 2);
    double less = 2 * pitch * half * half;
    /* sine of theta_j - theta_k; 1 - sine is computed without cancellation */
    double sine = (row->gap[k] - less) / h;
    double cosine = sqrt((h - row->gap[k] + less) / h * (1 + sine));
    struct contact *c = &run->contact[j];

    c->drop = h * cosine;
    c->face = h * cosine - pitch * x;
    run->theta[j] = run->theta[k] + atan2(sine, cosine);
    run->omega[j] = c->face * run->omega[k] / c->drop;

    double turn = run->omega[j] - run->omega[k];

    c->arm_on = c->face - row->mu * d;
    c->arm_by = h * (cosine + row->mu * sine);
    c->forced = h * sine * turn * turn - pitch * y * run->omega[k] * run->omega[k];
    c->sliding = h * sine * turn + pitch * y * run->omega[k];
}

static void place(struct run *run, double theta, double omega)
{
    run->theta[run->head] = theta;
    run->omega[run->head] = omega;
    for (size_t j = run->head; j-- > run->tail;)
        geometry(run, j);
}

/* Returns a unit of force that keeps the elements of the matrix near 1 even if the dominoes differ by many
 * orders of magnitude. */
static double unit_of_force(const struct run *run, size_t j)
{
    return inertia(run->row, j) / run->row->height[j];
}

/* Sets an element of the matrix, in the storage of gsl_linalg_LU_band for one diagonal on either side. */
static void put(gsl_matrix *band, size_t line, size_t column, double value)
{
    gsl_matrix_set(band, column, 2 + line - column, value);
}

/*
 * Fills the matrix. The order of the unknowns is: motion of the tail, force between the tail and the next
 * domino, motion of the next domino, ..., motion of the head. Row 2i is Newton's law of a domino divided by
 * its inertia, and row 2i + 1 the constraint of a contact divided by h.
 */
static void fill(struct run *run, gsl_matrix *band)
{
    const struct direct_row *row = run->row;

    gsl_matrix_set_zero(band);
    for (size_t i = run->tail; i <= run->head; i++) {
        size_t at = 2 * (i - run->tail);

        put(band, at, at, 1);
        if (i == run->head)
            return;
        const struct contact *c = &run->contact[i];
        double unit = unit_of_force(run, i), h = row->height[i];

        put(band, at, at + 1, c->arm_by * unit / inertia(row, i));
        put(band, at + 1, at, c->drop / h);
        put(band, at + 1, at + 2, -c->face / h);
        put(band, at + 2, at + 1, -c->arm_on * unit / inertia(row, i + 1));
    }
}

/* Solves for `motion` (accelerations or velocities) and `force` (forces or impulses). run->known must be
 * set. */
static int solve(struct run *run, double *motion)
{
    size_t movers = run->head - run->tail + 1, size = 2 * movers - 1;
    gsl_matrix_view band = gsl_matrix_submatrix(run->band, 0, 0, size, 4);
    gsl_vector_view known = gsl_vector_subvector(run->known, 0, size);
    gsl_vector_view found = gsl_vector_subvector(run->found, 0, size);
    gsl_vector_uint_view pivot = gsl_vector_uint_subvector(run->pivot, 0, size);

    if (movers == 1) { /* a single domino has no contacts */
        motion[run->head] = gsl_vector_get(run->known, 0);
        return GSL_SUCCESS;
    }
    fill(run, &band.matrix);
    int status = gsl_linalg_LU_band_decomp(size, 1, 1, &band.matrix, &pivot.vector);

    if (status == GSL_SUCCESS)
        status = gsl_linalg_LU_band_solve(1, 1, &band.matrix, &pivot.vector, &known.vector, &found.vector);
    for (size_t i = 0; i < movers; i++) {
        motion[run->tail + i] = gsl_vector_get(run->found, 2 * i);
        if (i + 1 < movers)
            run->force[run->tail + i] =
                gsl_vector_get(run->found, 2 * i + 1) * unit_of_force(run, run->tail + i);
    }
    return status;
}

/* Finds accelerations and contact forces for the positions that place() has set. */
static int accelerate(struct run *run)
{
    for (size_t i = run->tail; i <= run->head; i++) {
        size_t at = 2 * (i - run->tail);

        gsl_vector_set(run->known, at, torque(run, i) / inertia(run->row, i));
        if (i < run->head)
            gsl_vector_set(run->known, at + 1, run->contact[i].forced / run->row->height[i]);
    }
    return solve(run, run->alpha);
}

static int derivative(double t, const double y[], double dydt[], void *params)
{
    struct run *run = params;

    (void)t;
    place(run, y[THETA], y[OMEGA]);
    int status = accelerate(run);

    dydt[THETA] = y[OMEGA];
    dydt[OMEGA] = run->alpha[run->head];
    dydt[FRICTION_WORK] = 0;
    for (size_t j = run->tail; j < run->head; j++)
        dydt[FRICTION_WORK] += run->row->mu * run->force[j] * run->contact[j].sliding;
    for (size_t i = run->tail; i <= run->head; i++)
        dydt[FRICTION_WORK] += air_torque(run->row, i, run->omega[i]) * run->omega[i];
    if (status == GSL_SUCCESS && !isfinite(dydt[OMEGA] + dydt[FRICTION_WORK]))
        return GSL_ERANGE; /* a trial step reached an impossible position */
    return status;
}

static double kinetic(const struct run *run)
{
    double sum = 0;

    for (size_t i = run->tail; i <= run->head; i++)
        sum += inertia(run->row, i) * run->omega[i] * run->omega[i] / 2;
    return sum;
}

static double potential(const struct run *run)
{
    const struct direct_row *row = run->row;
    double sum = 0;

    for (size_t i = run->tail; i < row->n; i++) {
        double theta = (i <= run->head ? run->theta[i] : lean(row, i)) + row->slope;

        sum += row->mass[i] * row->g * (row->height[i] * cos(theta) + row->thickness[i] * sin(theta)) / 2;
    }
    return sum;
}

/* Computes everything at the state y and updates the smallest contact force. */
static int look(struct run *run, const double y[])
{
    struct direct_result *result = run->result;
    double dydt[DIM];
    int status = derivative(0, y, dydt, run);

    for (size_t j = run->tail; j < run->head; j++) {
        if (run->force[j] >= result->least_force)
            continue;
        result->least_force = run->force[j];
        result->least_at = j + 1;
        result->least_head = run->head + 1;
    }
    return status;
}

/* Returns a value that rises through 0 when the event happens. */
static double event_value(struct run *run, size_t event, const double y[])
{
    if (event == REACH)
        return y[THETA] - run->target;
    if (event == REST)
        return -y[OMEGA];
    place(run, y[THETA], y[OMEGA]);
    return -run->contact[run->tail + (event - LEAVE)].face;
}

/* Makes one step of the length `span` from run->from. The step needs no error control, since it is shorter
 * than a step that has been accepted. */
static int step_to(struct run *run, double span, double y[])
{
    double error[DIM];

    for (size_t i = 0; i < DIM; i++)
        y[i] = run->from[i];
    if (span <= 0)
        return GSL_SUCCESS;
    gsl_odeiv2_step_reset(run->step);
    return gsl_odeiv2_step_apply(run->step, 0, span, y, error, NULL, NULL, &run->system);
}

static double value_after(double span, void *params)
{
    struct run *run = params;
    double y[DIM];

    if (step_to(run, span, y) != GSL_SUCCESS)
        return nan("");
    return event_value(run, run->event, y);
}

/* Returns when the event happens, measured from the start of a step of the length `span`. Returns a negative
 * number if the event cannot be found. */
static double locate(struct run *run, size_t event, double span)
{
    gsl_function function = {value_after, run};
    double low = 0, high = span;

    run->event = event;
    if (value_after(0, run) >= 0)
        return 0;
    if (gsl_root_fsolver_set(run->solver, &function, low, high) != GSL_SUCCESS)
        return -1;
    for (int i = 0; i < 200; i++) {
        if (gsl_root_fsolver_iterate(run->solver) != GSL_SUCCESS)
            return -1;
        low = gsl_root_fsolver_x_lower(run->solver);
        high = gsl_root_fsolver_x_upper(run->solver);
        if (gsl_root_test_interval(low, high, 0, 4 * GSL_DBL_EPSILON) == GSL_SUCCESS)
            break;
    }
    return gsl_root_fsolver_root(run->solver);
}

/* Finds the first event in the step from run->from to y and cuts y and *span there. Returns false if there
 * is none. */
static bool first_event(struct run *run, double y[], double *span, size_t *event, const char **wrong)
{
    size_t events = LEAVE + (run->head - run->tail);
    double whole = *span;
    bool any = false;

    for (size_t i = 0; i < events; i++) {
        if (!(event_value(run, i, y) >= 0))
            continue;
        double at = locate(run, i, whole);

        if (at < 0) {
            *wrong = "An event could not be located.";
            return false;
        }
        if (!any || at < *span) {
            *span = at;
            *event = i;
        }
        any = true;
    }
    if (any && step_to(run, *span, y) != GSL_SUCCESS)
        *wrong = "The step to an event failed.";
    return any;
}

/* Sets new error scales, since sizes and energies may grow by orders of magnitude along the row. */
static const char *set_control(struct run *run)
{
    const struct direct_row *row = run->row;
    double h = row->height[run->head];
    double scale[DIM] = {1, sqrt(row->g / h), row->mass[run->head] * row->g * h};

    gsl_odeiv2_control_free(run->control);
    run->control = gsl_odeiv2_control_scaled_new(eps_abs, eps_rel, 1, 0, scale, DIM);
    gsl_odeiv2_evolve_reset(run->evolve);
    gsl_odeiv2_step_reset(run->step);
    return run->control ? 0 : "Out of memory.";
}

/* Returns the largest allowed step, which is small at first, and always small enough for frequent checks of
 * the forces. */
static double longest_step(const struct run *run, const double y[])
{
    double swing = sqrt(run->row->height[run->head] / run->row->g);

    double whole = y[OMEGA] > 0 ? (run->target - lean(run->row, run->head)) / y[OMEGA] : swing;

    return fmin(whole, swing) / LEAST_STEPS;
}

/* Makes one step of the integrator. A step that fails is halved and tried again. */
static int advance(struct run *run, double *t, double *h, double y[])
{
    int status = GSL_FAILURE;

    *h = fmin(*h, longest_step(run, y));
    for (int i = 0; i < 40 && status != GSL_SUCCESS; i++) {
        status =
            gsl_odeiv2_evolve_apply(run->evolve, run->control, run->step, &run->system, t, HUGE_VAL, h, y);
        if (status != GSL_SUCCESS) {
            *h /= 2;
            gsl_odeiv2_evolve_reset(run->evolve);
            gsl_odeiv2_step_reset(run->step);
        }
    }
    return status;
}

/* Integrates until an event happens. */
static const char *move(struct run *run, double y[], size_t *event)
{
    double t = 0, h = HUGE_VAL;
    const char *wrong = set_control(run);

    for (int i = 0; i < MOST_STEPS && !wrong; i++) {
        double from[DIM] = {y[THETA], y[OMEGA], y[FRICTION_WORK]}, now = t;

        if (advance(run, &t, &h, y) != GSL_SUCCESS)
            return "The integration failed.";
        double span = t - now;

        run->from = from;
        if (first_event(run, y, &span, event, &wrong)) {
            run->began += now + span;
            return wrong;
        }
        if (!wrong && look(run, y) != GSL_SUCCESS)
            wrong = "The equations of motion are singular.";
    }
    return wrong ? wrong : "The head neither reaches the next domino nor comes to rest.";
}

/* Makes the head strike the next domino, which is at rest. Finds the impulses of all contacts, on the
 * assumption that no contact opens. */
static const char *collide(struct run *run, double y[])
{
    const struct direct_row *row = run->row;
    size_t j = run->head, k = j + 1;

    place(run, y[THETA], y[OMEGA]);
    struct direct_hit *hit = &run->hits[k];

    *hit =
        (struct direct_hit){.time = run->began, .omega_before = y[OMEGA], .friction_work = y[FRICTION_WORK]};
    hit->kinetic_before = kinetic(run);
    gsl_vector_set_zero(run->known);
    for (size_t i = run->tail; i <= j; i++)
        gsl_vector_set(run->known, 2 * (i - run->tail), run->omega[i]);
    run->head = k;
    place(run, lean(row, k), 0);
    if (run->contact[j].face > row->height[k])
        return "The tip passes above the top of the next domino.";
    if (run->contact[j].arm_on <= 0) /* friction prevents the tip from sliding, and the row jams */
        gsl_vector_set_zero(run->known);
    if (solve(run, run->omega) != GSL_SUCCESS)
        return "The collision is singular.";
    hit->omega = run->omega[k];
    hit->kinetic = kinetic(run);
    hit->potential = potential(run);
    run->result->hit = k + 1;
    y[THETA] = lean(row, k);
    y[OMEGA] = hit->omega;
    return 0;
}

/* Returns the angle at which domino j reaches the next one. The bottom of the next domino's back face is
 * lower by `down` and farther away by `off` than if that domino were upright. */
static double reach_angle(const struct direct_row *row, size_t j)
{
    double h = row->height[j], phi = lean(row, j + 1), d = row->thickness[j + 1], off = d * (1 - cos(phi)),
           gap = row->gap[j + 1];

    if (phi == 0)
        return atan2(gap, sqrt((h - gap) * (h + gap)));
    /* The back face is the line x cos(phi) - z sin(phi) = c through its bottom. */
    double c = (gap + off) * cos(phi) - d * sin(phi) * sin(phi);

    return phi + asin(c / h);
}

/* Sets the angle at which the phase ends: at the next domino if that is in reach, and otherwise flat on the
 * floor. */
static void set_target(struct run *run)
{
    const struct direct_row *row = run->row;
    size_t k = run->head + 1;

    run->target = M_PI_2;
    if (k < row->n && row->gap[k] < row->height[run->head])
        run->target = reach_angle(row, run->head);
}

static const char *finish(struct run *run, const double y[], bool flat)
{
    run->result->all_fall = flat && run->head + 1 == run->row->n;
    run->result->end_time = run->began;
    run->result->stop_theta = y[THETA];
    return 0;
}

/* Returns true if the row is at rest at time 0 and begins to move by itself. */
static bool starts(const struct run *run)
{
    return run->began == 0 && run->row->omega == 0 && run->alpha[run->head] > 0;
}

static const char *run_through(struct run *run)
{
    double y[DIM] = {lean(run->row, 0), run->row->omega, 0};

    set_target(run);
    for (;;) {
        size_t event = REACH;

        if (look(run, y) != GSL_SUCCESS)
            return "The equations of motion are singular.";
        if (!(y[OMEGA] > 0) && !starts(run))
            break;
        const char *wrong = move(run, y, &event);

        if (wrong)
            return wrong;
        if (look(run, y) != GSL_SUCCESS)
            return "The equations of motion are singular.";
        if (event >= LEAVE) {
            run->tail += event - LEAVE + 1;
            continue;
        }
        if (event == REST)
            break;
        y[THETA] = run->target;
        if (run->target >= M_PI_2)
            return finish(run, y, true);
        wrong = collide(run, y);
        if (wrong)
            return wrong;
        set_target(run);
    }
    return finish(run, y, false);
}

static bool prepare(struct run *run)
{
    size_t n = run->row->n;

    run->theta = calloc(n, sizeof *run->theta);
    run->omega = calloc(n, sizeof *run->omega);
    run->alpha = calloc(n, sizeof *run->alpha);
    run->force = calloc(n, sizeof *run->force);
    run->contact = calloc(n, sizeof *run->contact);
    run->band = gsl_matrix_calloc(2 * n, 4);
    run->known = gsl_vector_calloc(2 * n);
    run->found = gsl_vector_calloc(2 * n);
    run->pivot = gsl_vector_uint_calloc(2 * n);
    run->system = (gsl_odeiv2_system){derivative, NULL, DIM, run};
    run->step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, DIM);
    run->evolve = gsl_odeiv2_evolve_alloc(DIM);
    run->solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    return run->theta && run->omega && run->alpha && run->force && run->contact && run->band && run->known &&
           run->found && run->pivot && run->step && run->evolve && run->solver;
}

static void release(struct run *run)
{
    free(run->theta);
    free(run->omega);
    free(run->alpha);
    free(run->force);
    free(run->contact);
    gsl_matrix_free(run->band);
    gsl_vector_free(run->known);
    gsl_vector_free(run->found);
    gsl_vector_uint_free(run->pivot);
    gsl_odeiv2_step_free(run->step);
    gsl_odeiv2_evolve_free(run->evolve);
    gsl_odeiv2_control_free(run->control);
    gsl_root_fsolver_free(run->solver);
}

static bool positive(double x)
{
    return isfinite(x) && x > 0;
}

static bool sensible(const struct direct_row *row)
{
    if (row->n == 0 || !(row->mu >= 0 && isfinite(row->mu)) || !positive(row->g) || !isfinite(row->omega))
        return false;
    for (size_t i = 0; i < row->n; i++)
        if (!positive(row->height[i]) || !positive(row->thickness[i]) || !positive(row->mass[i]) ||
            (i > 0 && !positive(row->gap[i])))
            return false;
    return true;
}

const char *direct_run(const struct direct_row *row, struct direct_hit *hits, struct direct_result *result)
{
    struct run run = {.row = row, .hits = hits, .result = result};

    *result = (struct direct_result){.hit = 1, .least_force = HUGE_VAL};
    if (!sensible(row))
        return "A number of the row is not allowed.";
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    const char *wrong = "Out of memory.";

    if (prepare(&run)) {
        run.omega[0] = row->omega;
        hits[0] = (struct direct_hit){.omega = row->omega, .kinetic = kinetic(&run)};
        hits[0].kinetic_before = hits[0].kinetic;
        run.theta[0] = lean(row, 0);
        hits[0].potential = potential(&run);
        wrong = run_through(&run);
    }
    release(&run);
    gsl_set_error_handler(handler);
    return wrong;
}
