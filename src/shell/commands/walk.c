/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/walk.h"
#include "language/quad.h"
#include "session/session.h"
#include <string.h>

struct walk_units walk_units(const struct query *query, int cycle)
{
    const struct domq_train *t = &query->scene->train;
    domq_real mass = scene_mass(query->scene), grown = quad(pow)(t->r, (domq_real)(cycle - 1)),
              heavier = quad(pow)(grown, t->q);
    struct domq_scale scale = query->scene->scale;
    scale.h *= grown;
    bool known = mass > 0;
    return (struct walk_units){
        .height = scale.h,
        .tau = domq_scale_tau(&scale, t),
        .energy = known ? heavier * mass * scale.g * query->scene->scale.h / 2 : heavier,
        .energy_unit = known       ? "J"
                       : cycle > 1 ? "mgh/2 of the first head"
                                   : "mgh/2",
        .weight = (known ? mass * scale.g : 1) * heavier / grown,
        .weight_unit = known       ? "N"
                       : cycle > 1 ? "(m g of the first head)"
                                   : "m g",
    };
}

/* Compares everything that an answer depends on with what the session had when the walk began. */
static bool same_train(const struct walk *walk, const struct scene *scene)
{
    const struct domq_train *a = &walk->train, *b = &scene->train;
    return a->s == b->s && a->r == b->r && a->d == b->d && a->q == b->q && a->fuel == b->fuel &&
#define SAME(name, member, status) a->member == b->member &&
           DOM_DYNAMICS(SAME)
#undef SAME
                   walk->tol == scene->compute.tol &&
           walk->compute.precision == scene->compute.precision &&
           walk->compute.method == scene->compute.method;
}

const struct walk *walk_now(const struct query *query)
{
    const struct walk *walk = &query->scene->walk;
    return walk->count > 0 && same_train(walk, query->scene) ? walk : NULL;
}

const char walk_no_start[] =
    "no domino effect: falling sets no energy free, so no cycle begins (25; c7); 'why' says more";

void columns_in_joules(struct answer *a)
{
    for (struct column *c = answer_columns(a, a->columns); c->key; c++)
        if (strcmp(c->unit, "mgh/2") == 0)
            c->unit = "J";
}

void walk_columns_in(const struct query *query, struct answer *a)
{
    if (scene_mass(query->scene) > 0)
        columns_in_joules(a);
}

/* ---- In words ---- */

/* Holds the first impulses of the collision, as text. */
struct impulses {
    const struct walk_units *units;
    char text[160];
    int seen;
    bool bounded;
};

static bool impulse_seen(const struct domq_force *f, void *context)
{
    struct impulses *i = context;
    size_t used = strlen(i->text);
    if (f->i > 0 && isnan(f->impulse)) /* no domino leans on the last */
        return false;
    i->bounded = i->bounded && isfinite(f->impulse);
    snprintf(i->text + used, sizeof i->text - used, "%s%.4g", i->seen ? ", " : "",
             (double)(f->impulse * i->units->weight * i->units->tau));
    return ++i->seen < 4;
}

/* Holds an angular velocity as text, in the session's unit of angles. */
struct spoken {
    char text[WIDE_TEXT + 8];
};

static struct spoken spoken_omega(const struct query *query, domq_real omega)
{
    struct spoken s;
    snprintf(s.text, sizeof s.text, "%.6g %s/s", (double)style_angle(&query->state->settings.style, omega),
             style_angle_unit(&query->state->settings.style));
    return s;
}

static void say_launch(const struct query *query, const struct walk *w, const struct domq_state *s,
                       struct answer *a)
{
    struct walk_units u = walk_units(query, w->cycle);
    struct domq_launch l;
    struct domq_barrier b;
    struct impulses impulses = {.units = &u, .bounded = true};
    enum dom_status found = domq_barrier_find(&w->train, &w->compute, &b);
    if (domq_launch_find(&w->train, &w->compute, &l) != DOM_OK || (found != DOM_OK && found != DOM_STOPS) ||
        domq_cycle_forces(&w->train, &w->compute, 0, impulse_seen, &impulses) != DOM_OK)
        return;
    domq_real omega = quad(sqrt)(l.omegasq) / u.tau;
    bool rubs = domq_law(&w->train)->dissipates;
    bool rounds = w->train.rho != 0;
    const char *inertia = rubs ? "A(0)" : "J(0)", *own = rounds ? "i(0)" : "1";
    answer_say(
        a,
        "Hit and launch, theta = 0. Domino 1 turns with %s and hits the head, domino 0, %s tall. From then "
        "on all move as one train, and the head turns with %s: %s omega(0) = (%s - %s) omega_1(theta_c), "
        "%s%s = %.6g (22; c4), (24; c6).",
        spoken_omega(query, omega / l.velocity_ratio).text, measured(u.height, "m", 6).text,
        spoken_omega(query, omega).text, inertia, inertia, own, inertia, rounds ? "/i(0)" : "",
        (double)(1 / (1 - l.velocity_ratio)));
    if (rubs)
        answer_say(a,
                   "A(0) = sum r^-(q+1)i S_i %stheta_i' is J(0) with friction; S_i is the share that the "
                   "contacts pass on.",
                   rounds ? "i(theta_i) " : "");
    if (rounds)
        answer_say(a,
                   "i(theta) is the inertia of a domino with rounded edges, about its line of contact with "
                   "the floor, over that with sharp edges.");
    if (impulses.bounded)
        answer_say(a, "The impulses from contact to contact down the train: %s%s %s s; all push (> 0).",
                   impulses.text, impulses.seen >= 4 ? ", ..." : "", u.weight_unit);
    else
        answer_say(a, "At r s = 1 the head is hit at its own hinge: the arm of the contact is 0, and its "
                      "impulse has no bound in this model (14; b10).");
    answer_say(a, "The collision takes %.4g %% of the kinetic energy%s; %.6g %s are left.",
               (double)(100 * s->lost / s->before),
               rubs     ? ""
               : rounds ? ", the share i(0)/J(0)"
                        : ", the share 1/J(0)",
               (double)(l.kinetic * u.energy), u.energy_unit);
    if (b.theta_m == 0)
        answer_say(a, "There is nothing to climb: the train goes down from the first moment on (26; c8).");
    else
        answer_say(a,
                   "The train has %s of the energy that it needs to go on: it must climb %.6g %s, up to a "
                   "tilt of %.6g "
                   "%s%s, and it %s by %.6g %s (26; c8).",
                   measured_share(b.kinetic / b.barrier, 3).text, (double)(b.barrier * u.energy),
                   u.energy_unit, (double)style_angle(&query->state->settings.style, b.theta_m),
                   style_angle_unit(&query->state->settings.style),
                   rubs ? ", friction on the way included" : "",
                   b.margin >= 0 ? "clears the barrier" : "misses the top",
                   (double)(quad(fabs)(b.margin) * u.energy), u.energy_unit);
}

static void say_top(const struct query *query, const struct walk *w, const struct domq_state *s,
                    struct answer *a)
{
    struct walk_units u = walk_units(query, w->cycle);
    if (domq_law(&w->train)->dissipates) {
        answer_say(
            a,
            "The hardest tilt, theta_m = %.6g %s: the train has climbed %.6g %s, friction has taken %.6g, "
            "and %.6g %s of motion are left. From now on it gains more than friction takes (26; c8).",
            (double)style_angle(&query->state->settings.style, s->theta),
            style_angle_unit(&query->state->settings.style), (double)(s->climbed * u.energy), u.energy_unit,
            (double)(s->friction_work * u.energy), (double)(s->kinetic * u.energy), u.energy_unit);
        return;
    }
    answer_say(
        a,
        "Top of the barrier, theta_m = %.6g %s. The train is at its highest: it has climbed %.6g %s, and "
        "%.6g %s of motion are left, the margin. From now on it goes down (26; c8).",
        (double)style_angle(&query->state->settings.style, s->theta),
        style_angle_unit(&query->state->settings.style), (double)(s->climbed * u.energy), u.energy_unit,
        (double)(s->kinetic * u.energy), u.energy_unit);
}

/* Returns the energy of position of a domino, h(theta), in m g h / 2 above the floor at its foot. */
static domq_real height_of(const struct domq_train *train, domq_real theta)
{
    const domq_real rho = train->rho, alpha = train->alpha, from_plumb = theta + alpha;
    return 2 * rho * (quad(cos)(alpha) - theta * quad(sin)(alpha)) + (1 - 2 * rho) * quad(cos)(from_plumb) +
           (train->d - 2 * rho) * quad(sin)(from_plumb);
}

static void say_fall(const struct query *query, const struct walk *w, const struct domq_state *s,
                     struct answer *a)
{
    struct walk_units u = walk_units(query, w->cycle);
    struct domq_angles angles;
    size_t domino = w->events[w->event].domino;
    if (domq_angles_find(&w->train, &w->compute, &angles) != DOM_OK)
        return;
    const domq_real weight = quad(pow)(w->train.r, -w->train.q * (domq_real)domino);
    answer_say(
        a,
        "Domino %zu detaches from domino %zu, which has come to theta_leave = %.6g %s: the arm of its "
        "force is 0. It comes to rest at theta_f = %.6g %s with all that follow it, and pushes no more "
        "(%s41; A17%s42; A18). Of the energy set free since the launch %.6g %s came from it; it keeps %.6g.",
        domino, domino - 1, (double)style_angle(&query->state->settings.style, angles.theta_leave),
        style_angle_unit(&query->state->settings.style),
        (double)style_angle(&query->state->settings.style, angles.theta_f),
        style_angle_unit(&query->state->settings.style), w->train.rho != 0 ? "as in " : "",
        w->train.rho != 0 ? " and " : "), (", (double)((0 - s->fallen) * u.energy), u.energy_unit,
        (double)(weight * height_of(&w->train, angles.theta_f) * u.energy));
}

static void say_stop(const struct query *query, const struct walk *w, const struct domq_state *s,
                     struct answer *a)
{
    struct walk_units u = walk_units(query, w->cycle);
    struct domq_barrier b;
    if (domq_barrier_find(&w->train, &w->compute, &b) != DOM_STOPS)
        return;
    answer_say(
        a,
        "The train stops at theta = %.6g %s: all its kinetic energy, %.6g %s, has gone into %s. The top "
        "of the barrier is at theta_m = %.6g %s, %.6g %s higher (26; c8). There is no next hit; 'why' says "
        "more.",
        (double)style_angle(&query->state->settings.style, s->theta),
        style_angle_unit(&query->state->settings.style), (double)(b.kinetic * u.energy), u.energy_unit,
        domq_law(&w->train)->dissipates ? "the climb and friction" : "the climb",
        (double)style_angle(&query->state->settings.style, b.theta_m),
        style_angle_unit(&query->state->settings.style), (double)(-b.margin * u.energy), u.energy_unit);
}

static void say_hit(const struct query *query, const struct walk *w, const struct domq_state *s,
                    struct answer *a)
{
    struct walk_units u = walk_units(query, w->cycle), next = walk_units(query, w->cycle + 1);
    answer_say(a,
               "The head reaches the next domino, %s tall, at theta_c = %.6g %s: %s (2; a2). "
               "It turns "
               "with %s; the cycle has set free %.6g %s, the fuel P (25; c7), and lasted %s.",
               measured(next.height, "m", 6).text,
               (double)style_angle(&query->state->settings.style, s->theta),
               style_angle_unit(&query->state->settings.style),
               w->train.rho != 0 ? "rho theta_c + (1 - 2 rho) sin theta_c = r s, as" : "sin theta_c = r s",
               spoken_omega(query, quad(sqrt)(s->omegasq) / u.tau).text, (double)(-s->climbed * u.energy),
               u.energy_unit, measured(s->time * u.tau, "s", 6).text);
    if (domq_law(&w->train)->dissipates)
        answer_say(a, "Friction between dominoes has taken %.6g %s of it.",
                   (double)(s->friction_work * u.energy), u.energy_unit);
    answer_say(a,
               "'step' begins the next cycle: the same angles, lengths times r, times longer by sqrt(r), "
               "%s (23; c5).",
               measured(s->time * next.tau, "s", 6).text);
}

static void say_between(const struct query *query, const struct walk *w, const struct domq_state *s,
                        struct answer *a)
{
    struct walk_units u = walk_units(query, w->cycle);
    bool climbs = s->acceleration < 0;
    answer_say(a, "On the way, theta = %.6g %s: the train %s, and the head turns with %s (21; c3).",
               (double)style_angle(&query->state->settings.style, s->theta),
               style_angle_unit(&query->state->settings.style), climbs ? "slows down" : "gathers speed",
               spoken_omega(query, quad(sqrt)(s->omegasq) / u.tau).text);
}

void walk_say(const struct query *query, const struct walk *walk, const struct domq_state *state,
              struct answer *answer)
{
    static void (*const say[])(const struct query *, const struct walk *, const struct domq_state *,
                               struct answer *) = {
        [DOM_EVENT_LAUNCH] = say_launch, [DOM_EVENT_FALL] = say_fall, [DOM_EVENT_TOP] = say_top,
        [DOM_EVENT_STOP] = say_stop,     [DOM_EVENT_HIT] = say_hit,
    };
    const struct domq_event *e = &walk->events[walk->event];
    answer_say(answer, "Cycle %d, event %d of %d", walk->cycle, walk->event + 1, walk->count);
    (walk->theta == e->theta ? say[e->kind] : say_between)(query, walk, state, answer);
}

bool train_comes_to(const struct query *query, struct problem *problem, domq_real theta)
{
    struct domq_value omegasq, stop = {.value = DOMQ_NAN};
    const struct answer_style *style = &query->state->settings.style;
    enum dom_status status =
        domq_cycle_omegasq(&query->scene->train, &query->scene->compute, theta, &omegasq);
    if (status == DOM_NO_FUEL)
        return problem_error(problem, "no domino effect: the fuel P is not positive, nothing moves; 'fuel' "
                                      "says why, 'rmax' how large r may be");
    if (status == DOM_STOPS)
        status = domq_cycle_stop(&query->scene->train, &query->scene->compute, &stop);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    /* The end may have been rounded up to the 6 digits of a table: a picture does not show the difference. */
    if (stop.value < theta * (1 - (domq_real)1e-5))
        return problem_error(
            problem, "the train does not come to T = %.10g %s: it stops at %.10g %s, below the barrier",
            (double)style_angle(style, theta), style_angle_unit(style),
            (double)style_angle(style, stop.value), style_angle_unit(style));
    return true;
}
