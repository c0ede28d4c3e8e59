/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "walk.h"
#include "session.h"
#include "wide.h"
#include <string.h>

/* The mass of the first domino in kg; 0 where it is not known. */
static dom_real first_mass(const struct session *session)
{
    dom_real h = session->scale.h;
    return session->mass > 0 ? session->mass : session->density * h * h * session->train.d * h / 2;
}

struct walk_units walk_units(const struct session *session, int cycle)
{
    const struct dom_train *t = &session->train;
    dom_real mass = first_mass(session), grown = pow(t->r, (dom_real)(cycle - 1)), heavier = pow(grown, t->q);
    struct dom_scale scale = session->scale;
    scale.h *= grown;
    bool known = mass > 0;
    return (struct walk_units){
        .height = scale.h,
        .tau = dom_scale_tau(&scale, t->d),
        .energy = known ? heavier * mass * scale.g * session->scale.h / 2 : heavier,
        .energy_unit = known ? "J" : "mgh/2",
        .weight = (known ? mass * scale.g : 1) * heavier / grown,
        .weight_unit = known ? "N" : "mg",
    };
}

/* ---- Contact ---- */

static bool contact_seen(const struct dom_force *f, void *context)
{
    struct walk_contact *c = context;
    if (f->of_own < c->force) {
        c->force = f->of_own;
        c->domino = f->i;
    }
    c->impulse = isfinite(f->impulse) ? fmin(c->impulse, f->impulse) : c->impulse;
    return true;
}

enum dom_status walk_contact(const struct dom_train *train, dom_real end, struct walk_contact *contact)
{
    enum { SAMPLES = 64 };
    *contact = (struct walk_contact){.force = (dom_real)INFINITY, .impulse = (dom_real)INFINITY};
    for (int k = 0; k <= SAMPLES; k++) {
        struct walk_contact here = *contact;
        dom_real theta = end * k / SAMPLES;
        enum dom_status status = dom_cycle_forces(train, theta, contact_seen, &here);
        if (status != DOM_OK)
            return status;
        if (here.force < contact->force)
            here.theta = theta;
        *contact = here;
    }
    return DOM_OK;
}

/* ---- In words ---- */

static double percent(dom_real part, dom_real whole)
{
    return (double)(100 * part / whole);
}

/* The first impulses of the collision, in text. */
struct impulses {
    const struct walk_units *units;
    char text[160];
    int seen;
};

static bool impulse_seen(const struct dom_force *f, void *context)
{
    struct impulses *i = context;
    size_t used = strlen(i->text);
    snprintf(i->text + used, sizeof i->text - used, "%s%.4g", i->seen ? ", " : "",
             (double)(f->impulse * i->units->weight * i->units->tau));
    return ++i->seen < 4;
}

static void say_launch(const struct session *session, const struct walk *w, const struct dom_state *s,
                       struct answer *a)
{
    struct walk_units u = walk_units(session, w->cycle);
    struct dom_launch l;
    struct dom_barrier b;
    struct impulses impulses = {.units = &u};
    if (dom_launch_find(&w->train, &l, NULL) != DOM_OK ||
        dom_barrier_find(&w->train, &b, NULL) == DOM_NO_FUEL ||
        dom_cycle_forces(&w->train, 0, impulse_seen, &impulses) != DOM_OK)
        return;
    dom_real omega = sqrt(l.omegasq) / u.tau;
    answer_say(
        a,
        "Hit and launch, theta = 0. Domino 1 comes with omega_1(theta_c) = %.6g rad/s and hits the head, "
        "domino 0, %.6g m tall. All move on as one train: J(0) omega(0) = (J(0) - 1) omega_1(theta_c) (c4) "
        "with J(0) = %.6g, so omega(0) = %.6g rad/s (c6).",
        (double)(omega * l.J0 / (l.J0 - 1)), (double)u.height, (double)l.J0, (double)omega);
    answer_say(
        a,
        "The impulse runs down the train, from contact to contact: %s%s %s s; all push (> 0). The collision "
        "takes the share 1/J(0) = %.4g %% of the kinetic energy; %.6g %s are left.",
        impulses.text, impulses.seen >= 4 ? ", ..." : "", u.weight_unit, percent(s->lost, s->before),
        (double)(l.kinetic * u.energy), u.energy_unit);
    if (b.theta_m == 0)
        answer_say(a, "Nothing is left to climb: H falls from the first moment on, theta_m = 0 (c8).");
    else
        answer_say(
            a,
            "To climb: %.6g %s up to theta_m = %.6g %s (c8). What is left is %.4g times that: it %s by "
            "%.6g %s.",
            (double)(b.barrier * u.energy), u.energy_unit, (double)style_angle(&session->style, b.theta_m),
            style_angle_unit(&session->style), (double)(b.kinetic / b.barrier),
            b.margin >= 0 ? "clears the barrier" : "misses the top", (double)(fabs(b.margin) * u.energy),
            u.energy_unit);
}

static void say_top(const struct session *session, const struct walk *w, const struct dom_state *s,
                    struct answer *a)
{
    struct walk_units u = walk_units(session, w->cycle);
    answer_say(
        a,
        "Top of the barrier, theta_m = %.6g %s (c8). The train stands highest: it has climbed %.6g %s, and "
        "%.6g %s of motion are left, the margin. omega is smallest here. From now on it runs downhill.",
        (double)style_angle(&session->style, s->theta), style_angle_unit(&session->style),
        (double)(s->climbed * u.energy), u.energy_unit, (double)(s->kinetic * u.energy), u.energy_unit);
}

static void say_fall(const struct session *session, const struct walk *w, const struct dom_state *s,
                     struct answer *a)
{
    struct walk_units u = walk_units(session, w->cycle);
    struct dom_angles angles;
    size_t domino = w->events[w->event].domino;
    if (dom_angles_find(&w->train, &angles, NULL) != DOM_OK)
        return;
    answer_say(a,
               "Domino %zu falls off domino %zu, which has come to theta_leave = %.6g %s (A17): the arm of "
               "its force "
               "is 0. It lies at theta_f = %.6g %s (A18) with all behind it, pushes no more, and keeps its "
               "energy: %.6g %s of what was set free stay in it.",
               domino, domino - 1, (double)style_angle(&session->style, angles.theta_leave),
               style_angle_unit(&session->style), (double)style_angle(&session->style, angles.theta_f),
               style_angle_unit(&session->style), (double)(-s->fallen * u.energy), u.energy_unit);
}

static void say_stop(const struct session *session, const struct walk *w, const struct dom_state *s,
                     struct answer *a)
{
    struct walk_units u = walk_units(session, w->cycle);
    struct dom_barrier b;
    if (dom_barrier_find(&w->train, &b, NULL) != DOM_STOPS)
        return;
    answer_say(
        a,
        "The train stops at theta = %.6g %s: all its kinetic energy, %.6g %s, has gone into the climb (c3). "
        "The "
        "barrier stands at theta_m = %.6g %s, %.6g %s higher (c8). There is no next hit; 'why' says more.",
        (double)style_angle(&session->style, s->theta), style_angle_unit(&session->style),
        (double)(b.kinetic * u.energy), u.energy_unit, (double)style_angle(&session->style, b.theta_m),
        style_angle_unit(&session->style), (double)(-b.margin * u.energy), u.energy_unit);
}

static void say_hit(const struct session *session, const struct walk *w, const struct dom_state *s,
                    struct answer *a)
{
    struct walk_units u = walk_units(session, w->cycle), next = walk_units(session, w->cycle + 1);
    answer_say(
        a,
        "The head reaches the next domino, %.6g m tall, at theta_c = %.6g %s: sin theta_c = r s (a2). It "
        "comes "
        "with omega = %.6g rad/s; the cycle has set free the fuel P = %.6g %s (c7) and lasted t_f = %.6g s.",
        (double)next.height, (double)style_angle(&session->style, s->theta),
        style_angle_unit(&session->style), (double)(sqrt(s->omegasq) / u.tau),
        (double)(-s->climbed * u.energy), u.energy_unit, (double)(s->time * u.tau));
    answer_say(
        a,
        "'step' begins the next cycle: the same angles, lengths times r, times longer by sqrt(r) (c5): "
        "%.6g s.",
        (double)(s->time * next.tau));
}

static void say_between(const struct session *session, const struct walk *w, const struct dom_state *s,
                        struct answer *a)
{
    struct walk_units u = walk_units(session, w->cycle);
    bool climbs = s->acceleration < 0;
    answer_say(a, "On the way, theta = %.6g %s: the train %s, at omega = %.6g rad/s (c3).",
               (double)style_angle(&session->style, s->theta), style_angle_unit(&session->style),
               climbs ? "slows down" : "gathers speed", (double)(sqrt(s->omegasq) / u.tau));
}

void walk_say(const struct session *session, const struct walk *walk, const struct dom_state *state,
              struct answer *answer)
{
    static void (*const say[])(const struct session *, const struct walk *, const struct dom_state *,
                               struct answer *) = {
        [DOM_EVENT_LAUNCH] = say_launch, [DOM_EVENT_FALL] = say_fall, [DOM_EVENT_TOP] = say_top,
        [DOM_EVENT_STOP] = say_stop,     [DOM_EVENT_HIT] = say_hit,
    };
    const struct dom_event *e = &walk->events[walk->event];
    answer_say(answer, "Cycle %d, event %d of %d", walk->cycle, walk->event + 1, walk->count);
    (walk->theta == e->theta ? say[e->kind] : say_between)(session, walk, state, answer);
}
