/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What stands around the function of a command: checks of its arguments, and the precision of its answer. */
#include "interpreter/question.h"
#include "language/quad.h"
#include "session/parameters.h"
#include "session/row.h"
#include <string.h>

static bool out_of_range(struct problem *problem, const struct argument *a, domq_real value, const char *is,
                         const char *range)
{
    return problem_no_answer(problem, "%s = %s is %s; %s is %s", a->name, quad_text(value, 10), is, a->name,
                             range);
}

/* Checks a tilt. A tilt without a unit is in the session's unit of angles. */
static bool tilt_check(const struct query *query, const struct argument *a, struct quantity q,
                       domq_real *number, struct problem *problem)
{
    const struct answer_style *style = &query->state->settings.style;
    struct domq_angles angles;
    domq_real theta = q.angle == 1 || style->angle == ANGLE_RAD ? q.value : q.value * (QUAD_PI / 180);
    enum dom_status status = any_angles_find(&query->scene->train, &query->scene->compute, &angles);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    /* If the user has copied theta_c from an answer in degrees, the value may have been rounded up. */
    domq_real slack = 2 * (domq_real)any_arithmetic(query->scene->compute.precision).epsilon * angles.theta_c;
    char degrees[96] = "";
    if (q.angle != 1 && style->angle == ANGLE_RAD && theta > 0 && theta * (QUAD_PI / 180) <= angles.theta_c)
        snprintf(degrees, sizeof degrees, "; for degrees, write '%.40s deg'", quad_text(theta, 10));
    if (!(theta >= 0 && theta <= angles.theta_c + slack))
        return problem_no_answer(problem,
                                 "%s = %s %s is outside the cycle; %s is an angle in [0, theta_c] = [0, "
                                 "%.17g] %s; 'thetac' gives theta_c%s",
                                 a->name, quad_text(style_angle(style, theta), 10), style_angle_unit(style),
                                 a->name, (double)style_angle(style, angles.theta_c), style_angle_unit(style),
                                 degrees);
    *number = quad_smaller(quad(fabs)(theta), angles.theta_c); /* fabs turns -0 into 0. */
    return true;
}

/* Checks the unit of a value. `p` is the parameter of which the argument is a value, or NULL. */
static bool unit_check(const struct query *query, const struct argument *a, const struct parameter *p,
                       struct quantity *q, struct problem *problem)
{
    const char *of = p ? p->value[a->which].unit : "";
    const struct quantity length = {.length = 1}, speed = {.length = 1, .time = -1}, per_time = {.time = -1},
                          unit = p ? expression_unit(of)
                                   : (struct quantity){.length = a->kind == ARGUMENT_HEIGHT,
                                                       .angle = a->kind == ARGUMENT_TILT ||
                                                                a->kind == ARGUMENT_PLACE};
    /* Parameters with the unit "h", such as s and d, are fractions of the height. If the user enters a length
     * instead, this length is divided by the height of domino 1. In a row from a file, only the radius of the
     * edges is such a fraction. */
    const bool is_share = strcmp(of, "h") == 0, is_edges = p && p->share == SHARE_edges;
    if (is_share && quantity_alike(*q, length))
        *q = (struct quantity){
            .value = q->value / (is_edges ? scene_first_height(query->scene) : query->scene->scale.h)};
    /* The push may be entered as the speed of the first domino's upper edge. */
    const bool is_push = p && p->share == SHARE_push;
    if (is_push && quantity_alike(*q, speed))
        *q = (struct quantity){.value = q->value / scene_first_height(query->scene)};
    /* An angular velocity may be entered without radians, as in 8*sqrt(g/h). */
    if (unit.angle == 1 && unit.time == -1 && quantity_alike(*q, per_time))
        q->angle = 1;
    if (quantity_is_number(*q) || quantity_alike(*q, unit))
        return true;
    const char *example = expression_example(unit);
    return problem_error(problem, "%s is %s, not %s; enter %s%s%s", a->name, expression_kind(unit),
                         expression_kind(*q),
                         example    ? "a value such as '"
                         : is_share ? "it without a unit, or as a length"
                         : is_push  ? "it without a unit, or as the speed of the top, such as 0.5 m/s"
                                    : "it without a unit",
                         example ? example : "", example ? "'" : "");
}

bool argument_check(const struct query *query, const struct argument *a, struct quantity q, domq_real *number,
                    struct problem *problem)
{
    const struct parameter *p = a->kind == ARGUMENT_VALUE_OF ? parameter_find(a->parameter) : NULL;
    const struct domq_effect_argument *of = p ? &p->value[a->which] : NULL;
    const bool is_own = p && strcmp(a->name, of->name) == 0, /* not another name for a value of it */
        is_length = p && share_length(p, &q).m > 0 && a->which == 0;
    char range[96];
    if (a->kind != ARGUMENT_ANY && !quantity_is_number(q) && !unit_check(query, a, p, &q, problem))
        return false;
    *number = q.value;
    switch (a->kind) {
    case ARGUMENT_TILT:
    case ARGUMENT_PLACE:
        return tilt_check(query, a, q, number, problem);
    case ARGUMENT_HEIGHT:
        return q.value > 0 ||
               out_of_range(problem, a, q.value, "not a height", "a length in metres, larger than 0");
    case ARGUMENT_COUNT:
        return (q.value >= 1 && q.value <= COUNT_MAX && q.value == quad(floor)(q.value)) ||
               out_of_range(problem, a, q.value, "not a count", "an integer in 1 .. 10000000");
    case ARGUMENT_VALUE_OF:
        if (is_length && is_own && q.value > 0)
            return true; /* another h may put this length into the range */
        if (p && !is_own && !(q.value >= of->lowest && q.value <= of->highest)) {
            snprintf(range, sizeof range, "a value of %s, %g .. %g", p->name, (double)of->lowest,
                     (double)of->highest);
            return out_of_range(problem, a, q.value, "out of range", range);
        }
        return parameter_check(query->state, p, a->which, q.value, problem);
    default:
        return true;
    }
}

struct answer answer_kept(const struct query *query, const struct command *c, struct cell kept[ANSWER_CELLS])
{
    memset(kept, 0, ANSWER_CELLS * sizeof *kept);
    return (struct answer){
        .style = state_style(query->state), .columns = c->columns, .rows = c->rows, .kept = kept};
}

/* ---- Answers ---- */

bool command_answer(const struct command *c, const struct query *query, struct answer *answer,
                    struct problem *problem)
{
    struct scene scene;
    struct query in_double = *query;
    if (c->precision == PRECISION_DOUBLE) {
        scene = *query->scene; /* shares the memory of the original */
        scene.compute.tol = (domq_real)compute_in_double(&scene.compute).tol;
        scene.compute.precision = IN_DOUBLE;
        in_double.scene = &scene;
        answer->in_double = true;
    }
    return c->run(&in_double, answer, problem) &&
           (!c->sweep.needs_yes || !query->run_context->seeks_yes || answer->verdict != ANSWER_NO ||
            problem_no_answer(problem, "the verdict of '%s' is no%s%s", c->name,
                              *answer->late_reason ? ": " : "", answer->late_reason));
}
