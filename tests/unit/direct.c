/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finite rows by another method: constrained dynamics, without any formula of the model. Only the angle and
 * the angular velocity of the head are integrated. The other angles follow from the constraint that each
 * domino leans on the next, so nothing drifts. All accelerations and contact forces come from one linear
 * system, which consists of Newton's law for each domino and of the second derivative of each constraint. A
 * collision has the same matrix, with impulses instead of forces and velocities instead of accelerations. All
 * numbers are in SI units.
 */
#include "run.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>
#include <math.h>

/* the variables of integration: angle and angular velocity of the head, and the work of friction */
enum { THETA, OMEGA, FRICTION_WORK, DIM };
enum { REACH, REST, LEAVE };                    /* events; LEAVE + i means that contact tail + i opens */
enum { LEAST_STEPS = 32, MOST_STEPS = 100000 }; /* limits for the steps of one phase */

/* Domino j, and its contact with domino k = j + 1, on which it leans. */
struct body {
    double h, d, gap, lean, inertia, weight;
    double drag; /* torque of the air divided by omega^2 */
    double theta, omega;
    double face;    /* distance of the tip of j from the bottom of k's back face; d(constraint)/d(theta_k) */
    double drop;    /* h_j cos(theta_j - theta_k); d(constraint)/d(theta_j) */
    double arm_on;  /* torque on k that a unit normal force and its friction exert */
    double arm_by;  /* torque against j that this normal force and its friction exert */
    double sliding; /* speed of the tip down the face */
    /* The system: torque on the domino and right-hand side of the constraint, or angular momentum before a
     * collision and 0; then the acceleration and the contact force, or the velocity and the impulse. */
    double torque, forced, motion, force;
};

struct fall {
    size_t n, tail, head; /* number of dominoes; first and last moving domino, counted from 0 */
    double mu, slope, g;
    double began;  /* time at which this phase began */
    double target; /* angle of the head that ends this phase */
    struct body body[ROW_MOST];
    struct newton *result;
    gsl_odeiv2_system system;
    gsl_odeiv2_step *step;
    gsl_odeiv2_evolve *evolve;
    gsl_odeiv2_control *control;
    gsl_root_fsolver *solver;
    const double *from; /* state at the start of the step in which an event is located */
    size_t event;
};

/* Fills the constants of a domino. */
static void make(const struct run *run, size_t i, struct body *b)
{
    const struct domq_domino *domino = &run->domino[i];
    const double h = (double)domino->height, d = (double)domino->thickness, air = (double)run->row.air,
                 drag = run->row.drag != 0 ? (double)run->row.drag : 1.2,
                 w = domino->width > 0 ? (double)domino->width : h / 2,
                 t = h > (double)run->row.boxes_above ? (double)run->row.walls : 0;
    double own = (double)domino->mass * (h * h + d * d) / 3, sum = 0, volume = 0;
    /* Six boards in three pairs: front and back, bottom and top, left and right. A pair leaves out the edges
     * that the pairs before it fill. */
    const double size[][4] = {{t, h, w, d - t}, {d - 2 * t, t, w, h - t}, {d - 2 * t, h - 2 * t, 2 * t, 0}};
    for (int k = 0; k < 3 && t != 0; k++) {
        const double *s = size[k], board = s[0] * s[1] * s[2] * (k < 2 ? 2 : 1), away = s[3] / 2;
        volume += board;
        sum += board * ((s[0] * s[0] + s[1] * s[1]) / 12 + away * away); /* about the centre of the box */
    }
    if (t != 0)
        own = (double)domino->mass * (sum / volume + (h * h + d * d) / 4);
    *b = (struct body){.h = h, .d = d, .gap = (double)domino->gap, .lean = (double)domino->lean};
    b->weight = (double)domino->mass * (double)run->row.g;
    /* Strips of a plate, which are as fast as omega y: drag C rho w (omega y)^2 / 2 with the arm y, and the
     * mass rho pi (w/2)^2 of the air that moves along, per unit length. */
    b->drag = air * drag / 2 * w * pow(h, 4) / 4;
    b->inertia = own + air * acos(-1) / 4 * w * w * pow(h, 3) / 3;
}

/* Finds the positions and the velocities of all moving dominoes, and the terms of their contacts. */
static void place(struct fall *f, double theta, double omega)
{
    f->body[f->head].theta = theta;
    f->body[f->head].omega = omega;
    for (size_t j = f->head; j-- > f->tail;) {
        struct body *b = &f->body[j];
        const struct body *k = b + 1;
        const double pitch = k->gap + k->d, x = sin(k->theta), y = cos(k->theta), half = sin(k->theta / 2),
                     less = 2 * pitch * half * half, sine = (k->gap - less) / b->h, /* of theta_j - theta_k */
            cosine = sqrt((b->h - k->gap + less) / b->h * (1 + sine));
        b->drop = b->h * cosine;
        b->face = b->h * cosine - pitch * x;
        b->theta = k->theta + atan2(sine, cosine);
        b->omega = b->face * k->omega / b->drop;
        const double turn = b->omega - k->omega;
        b->arm_on = b->face - f->mu * k->d;
        b->arm_by = b->h * (cosine + f->mu * sine);
        b->forced = b->h * sine * turn * turn - pitch * y * k->omega * k->omega;
        b->sliding = b->h * sine * turn + pitch * y * k->omega;
    }
}

/*
 * Solves the system for `motion` and `force`:
 *
 *     inertia_j motion_j + arm_by_j force_j - arm_on_i force_i = torque_j   (i = j - 1),
 *     drop_j motion_j - face_j motion_k = forced_j.
 *
 * From the tail on, motion_j = p_j - q_j force_j, and force_j = u_j - v_j motion_k. Returns false if the
 * system is singular.
 */
static bool solve(struct fall *f)
{
    double p[ROW_MOST] = {0}, q[ROW_MOST], u = 0, v = 0, U[ROW_MOST], V[ROW_MOST];
    for (size_t j = f->tail; j <= f->head; j++) {
        const struct body *b = &f->body[j];
        const double on = j > f->tail ? b[-1].arm_on : 0, inertia = b->inertia + on * v;
        p[j] = (b->torque + on * u) / inertia;
        q[j] = b->arm_by / inertia;
        U[j] = u = (b->drop * p[j] - b->forced) / (b->drop * q[j]);
        V[j] = v = b->face / (b->drop * q[j]);
    }
    f->body[f->head].motion = p[f->head];
    for (size_t j = f->head; j-- > f->tail;) {
        struct body *b = &f->body[j];
        b->force = U[j] - V[j] * b[1].motion;
        b->motion = p[j] - q[j] * b->force;
    }
    return isfinite(f->body[f->head].motion + f->body[f->tail].motion);
}

static int derivative(double t, const double y[], double dydt[], void *params)
{
    struct fall *f = params;
    (void)t;
    place(f, y[THETA], y[OMEGA]);
    for (size_t i = f->tail; i <= f->head; i++) {
        struct body *b = &f->body[i];
        b->torque = b->weight * (b->h * sin(b->theta + f->slope) - b->d * cos(b->theta + f->slope)) / 2 -
                    b->drag * b->omega * fabs(b->omega);
    }
    if (!solve(f)) /* a trial step reached an impossible position */
        return GSL_ERANGE;
    dydt[THETA] = y[OMEGA];
    dydt[OMEGA] = f->body[f->head].motion;
    dydt[FRICTION_WORK] = 0;
    for (size_t i = f->tail; i <= f->head; i++) {
        const struct body *b = &f->body[i];
        dydt[FRICTION_WORK] += (i < f->head ? f->mu * b->force * b->sliding : 0) +
                               b->drag * fabs(b->omega) * b->omega * b->omega;
    }
    return GSL_SUCCESS;
}

static double kinetic(const struct fall *f)
{
    double sum = 0;
    for (size_t i = f->tail; i <= f->head; i++)
        sum += f->body[i].inertia * f->body[i].omega * f->body[i].omega / 2;
    return sum;
}

/* Computes everything at the state y and updates the smallest contact force. Returns an error or NULL. */
static const char *look(struct fall *f, const double y[])
{
    double dydt[DIM];
    const int status = derivative(0, y, dydt, f);
    for (size_t j = f->tail; j < f->head; j++) {
        if (f->body[j].force >= f->result->least_force)
            continue;
        f->result->least_force = f->body[j].force;
        f->result->least_at = j + 1;
        f->result->least_head = f->head + 1;
    }
    return status == GSL_SUCCESS ? NULL : "The equations of motion are singular.";
}

/* Returns a value that rises through 0 when the event happens. */
static double event_value(struct fall *f, size_t event, const double y[])
{
    if (event == REACH)
        return y[THETA] - f->target;
    if (event == REST)
        return -y[OMEGA];
    place(f, y[THETA], y[OMEGA]);
    return -f->body[f->tail + (event - LEAVE)].face;
}

/* Makes one step of the length `span` from f->from. The step needs no error control, since it is shorter than
 * a step that has been accepted. */
static int step_to(struct fall *f, double span, double y[])
{
    double error[DIM];
    for (size_t i = 0; i < DIM; i++)
        y[i] = f->from[i];
    if (span <= 0)
        return GSL_SUCCESS;
    gsl_odeiv2_step_reset(f->step);
    return gsl_odeiv2_step_apply(f->step, 0, span, y, error, NULL, NULL, &f->system);
}

static double value_after(double span, void *params)
{
    struct fall *f = params;
    double y[DIM];
    return step_to(f, span, y) == GSL_SUCCESS ? event_value(f, f->event, y) : (double)NAN;
}

/* Returns when the event happens, measured from the start of a step of the length `span`. Returns a negative
 * number if the event cannot be found. */
static double locate(struct fall *f, size_t event, double span)
{
    gsl_function function = {value_after, f};
    double low = 0, high = span;
    f->event = event;
    if (value_after(0, f) >= 0)
        return 0;
    if (gsl_root_fsolver_set(f->solver, &function, low, high) != GSL_SUCCESS)
        return -1;
    for (int i = 0; i < 200 && gsl_root_test_interval(low, high, 0, 4 * GSL_DBL_EPSILON) != GSL_SUCCESS;
         i++) {
        if (gsl_root_fsolver_iterate(f->solver) != GSL_SUCCESS)
            return -1;
        low = gsl_root_fsolver_x_lower(f->solver);
        high = gsl_root_fsolver_x_upper(f->solver);
    }
    return gsl_root_fsolver_root(f->solver);
}

/* Finds the first event in the step from f->from to y and cuts y and *span there. Returns false if there is
 * none. */
static bool first_event(struct fall *f, double y[], double *span, size_t *event, const char **wrong)
{
    const double whole = *span;
    bool any = false;
    for (size_t i = 0; i < LEAVE + (f->head - f->tail); i++) {
        if (!(event_value(f, i, y) >= 0))
            continue;
        const double at = locate(f, i, whole);
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
    if (any && step_to(f, *span, y) != GSL_SUCCESS)
        *wrong = "The step to an event failed.";
    return any;
}

/* Makes one step of the integrator. It is small at first, and always small enough for frequent checks of the
 * forces. A step that fails is halved and tried again. */
static bool advance(struct fall *f, double *t, double *h, double y[])
{
    const double swing = sqrt(f->body[f->head].h / f->g),
                 whole = y[OMEGA] > 0 ? (f->target - f->body[f->head].lean) / y[OMEGA] : swing;
    *h = fmin(*h, fmin(whole, swing) / LEAST_STEPS);
    for (int i = 0; i < 40; i++, *h /= 2) {
        if (gsl_odeiv2_evolve_apply(f->evolve, f->control, f->step, &f->system, t, HUGE_VAL, h, y) ==
            GSL_SUCCESS)
            return true;
        gsl_odeiv2_evolve_reset(f->evolve);
        gsl_odeiv2_step_reset(f->step);
    }
    return false;
}

/* Integrates until an event happens. */
static const char *move(struct fall *f, double y[], size_t *event)
{
    const struct body *head = &f->body[f->head];
    /* the scales of errors, since sizes and energies may grow by orders of magnitude along the row */
    const double scale[DIM] = {1, sqrt(f->g / head->h), head->weight * head->h};
    double t = 0, h = HUGE_VAL;
    const char *wrong = NULL;
    gsl_odeiv2_control_free(f->control);
    f->control = gsl_odeiv2_control_scaled_new(1e-16, 1e-13, 1, 0, scale, DIM);
    gsl_odeiv2_evolve_reset(f->evolve);
    gsl_odeiv2_step_reset(f->step);
    for (int i = 0; i < MOST_STEPS && !wrong; i++) {
        const double from[DIM] = {y[THETA], y[OMEGA], y[FRICTION_WORK]}, now = t;
        if (!advance(f, &t, &h, y))
            return "The integration failed.";
        double span = t - now;
        f->from = from;
        if (first_event(f, y, &span, event, &wrong)) {
            f->began += now + span;
            return wrong;
        }
        wrong = wrong ? wrong : look(f, y);
    }
    return wrong ? wrong : "The head neither reaches the next domino nor comes to rest.";
}

/* Makes the head strike the next domino, which is at rest. Finds the impulses of all contacts, on the
 * assumption that no contact opens. If friction prevents the tip from sliding, the row jams. */
static const char *collide(struct fall *f, double y[])
{
    struct newton_hit *hit = &f->result->hit[f->head + 1];
    place(f, y[THETA], y[OMEGA]);
    *hit = (struct newton_hit){
        .time = f->began, .friction_work = y[FRICTION_WORK], .kinetic_before = kinetic(f)};
    struct body *old = &f->body[f->head++], *head = old + 1;
    for (size_t i = f->tail; i < f->head; i++)
        f->body[i].torque = f->body[i].inertia * f->body[i].omega;
    head->torque = 0;
    place(f, head->lean, 0);
    if (old->face > head->h)
        return "The tip passes above the top of the next domino.";
    for (size_t i = f->tail; i <= f->head; i++) {
        f->body[i].torque *= old->arm_on > 0;
        f->body[i].forced = 0;
    }
    if (!solve(f))
        return "The collision is singular.";
    for (size_t i = f->tail; i <= f->head; i++)
        f->body[i].omega = f->body[i].motion;
    hit->omega = head->omega;
    hit->kinetic = kinetic(f);
    f->result->hits = f->head + 1;
    y[THETA] = head->lean;
    y[OMEGA] = hit->omega;
    return NULL;
}

/* Returns the angle at which the head reaches the next domino, or pi/2, flat on the floor, if none is in
 * reach. The bottom of the next domino's back face is lower by `down` and farther away by `off` than if that
 * domino were upright. */
static double reach_angle(const struct fall *f)
{
    const struct body *b = &f->body[f->head], *next = b + 1;
    if (f->head + 1 == f->n || !(next->gap < b->h))
        return M_PI_2;
    const double phi = next->lean, off = next->d * (1 - cos(phi)), gap = next->gap;
    if (phi == 0)
        return atan2(gap, sqrt((b->h - gap) * (b->h + gap)));
    /* The back face is the line x cos(phi) - z sin(phi) = c through its bottom. */
    return phi + asin(((gap + off) * cos(phi) - next->d * sin(phi) * sin(phi)) / b->h);
}

static const char *run_through(struct fall *f, double omega)
{
    double y[DIM] = {f->body[0].lean, omega, 0};
    const char *wrong = NULL;
    size_t event = REACH;
    f->target = reach_angle(f);
    while (!wrong) {
        wrong = look(f, y);
        /* a row that is at rest at time 0 may begin to move by itself */
        const bool starts = f->began == 0 && omega == 0 && f->body[f->head].motion > 0;
        if (wrong || event == REST || !(y[OMEGA] > 0 || starts))
            break;
        event = REACH;
        wrong = move(f, y, &event);
        if (!wrong)
            wrong = look(f, y);
        if (wrong || event == REST)
            break;
        if (event >= LEAVE) {
            f->tail += event - LEAVE + 1;
            continue;
        }
        y[THETA] = f->target;
        if (f->target >= M_PI_2) {
            f->result->all_fall = f->head + 1 == f->n;
            break;
        }
        wrong = collide(f, y);
        f->target = reach_angle(f);
    }
    f->result->end_time = f->began;
    f->result->stop_theta = y[THETA];
    return wrong;
}

void newton_run(const struct run *run, struct newton *n)
{
    static struct fall f;
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    f = (struct fall){.n = run->row.count,
                      .mu = (double)run->row.mu,
                      .slope = (double)run->row.alpha,
                      .g = (double)run->row.g,
                      .result = n,
                      .system = {derivative, NULL, DIM, &f},
                      .step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, DIM),
                      .evolve = gsl_odeiv2_evolve_alloc(DIM),
                      .solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent)};
    for (size_t i = 0; i < f.n; i++)
        make(run, i, &f.body[i]);
    const double gap = f.n > 1 ? f.body[1].gap : 0, height = f.body[0].h, omega = (double)run->row.push;
    if (run->row.release > 0) /* the row then has two dominoes */
        f.body[0].lean = fmin((double)run->row.release, atan2(gap, sqrt((height - gap) * (height + gap))));
    *n = (struct newton){.hits = 1, .least_force = HUGE_VAL};
    f.body[0].omega = omega;
    n->hit[0] = (struct newton_hit){.omega = omega, .kinetic = kinetic(&f), .kinetic_before = kinetic(&f)};
    f.body[0].theta = f.body[0].lean;
    n->wrong = run_through(&f, omega);
    gsl_odeiv2_step_free(f.step);
    gsl_odeiv2_evolve_free(f.evolve);
    gsl_odeiv2_control_free(f.control);
    gsl_root_fsolver_free(f.solver);
    gsl_set_error_handler(handler);
}
