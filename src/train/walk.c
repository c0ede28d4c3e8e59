/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/quad.h"
#include "language/text.h"
#include "train/train.h"
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
    };
}

bool walk_is_of(const struct walk *walk, const struct scene *scene)
{
    const struct domq_train *a = &walk->train, *b = &scene->train;
    return a->s == b->s && a->r == b->r && a->d == b->d && a->q == b->q && a->width == b->width &&
#define SAME(name, member, status) a->member == b->member &&
           DOM_DYNAMICS(SAME)
#undef SAME
                   a->fuel == b->fuel;
}

const struct walk *walk_now(const struct query *query)
{
    const struct walk *walk = query->walk;
    const struct any_compute *compute = query_compute(query);
    return walk->count > 0 && walk_is_of(walk, query->scene) && walk->tol == compute->tol &&
                   walk->compute.precision == compute->precision
               ? walk
               : NULL;
}

const char walk_no_start[] =
    "no domino effect: falling releases no energy, so no cycle begins (25; c7); 'why' explains it";

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

struct measured angle_text(const struct query *query, domq_real theta, int digits)
{
    const struct answer_style *style = &query->state->settings.style;
    struct measured text;
    snprintf(text.text, sizeof text.text, "%.*g %s", digits, (double)style_angle(style, theta),
             style_angle_unit(style));
    return text;
}

/* ---- In words ---- */

/* The data for the sentences about the current position of a walk. */
struct place {
    const struct query *query;
    const struct walk *walk;
    const struct domq_state *state;
    struct answer *answer;
    struct walk_units units;
    bool has_losses; /* the equation of motion holds, with A instead of the inertia J */
    bool is_rounded;
};

static struct measured angle_at(const struct place *p, domq_real theta)
{
    return angle_text(p->query, theta, 6);
}

/* Formats an angular velocity omega as text such as "10.3 rad/s". The argument is tau^2 omega^2. */
static struct measured omega_at(const struct place *p, domq_real omegasq)
{
    struct measured text = angle_text(p->query, quad(sqrt)(omegasq) / p->units.tau, 6);
    text_add(text.text, sizeof text.text, "/s");
    return text;
}

static struct measured energy_at(const struct place *p, domq_real energy)
{
    struct measured text;
    snprintf(text.text, sizeof text.text, "%.6g %s", (double)(energy * p->units.energy),
             p->units.energy_unit);
    return text;
}

static void say_launch(const struct place *p)
{
    const struct walk *w = p->walk;
    struct domq_launch l;
    struct domq_barrier b;
    enum dom_status found = any_barrier_find(&w->train, &w->compute, &b);
    if (any_launch_find(&w->train, &w->compute, &l) != DOM_OK || (found != DOM_OK && found != DOM_STOPS))
        return;
    const char *inertia = p->has_losses ? "A(0)" : "J(0)", *of_head = p->is_rounded ? "i(0)" : "1";
    answer_detail(p->answer,
                  "Hit and launch, theta = 0. Domino 1 turns at %s and hits the head, domino 0, which is %s "
                  "tall. After that all dominoes move as one train, and the head turns at %s: %s omega(0) = "
                  "(%s - %s) omega_1(theta_c), with %s/%s = %.6g (22; c4), (24; c6).",
                  omega_at(p, l.omegasq / (l.velocity_ratio * l.velocity_ratio)).text,
                  measured(p->units.height, "m", 6).text, omega_at(p, l.omegasq).text, inertia, inertia,
                  of_head, inertia, of_head, (double)(1 / (1 - l.velocity_ratio)));
    if (p->has_losses || p->is_rounded)
        answer_detail(p->answer, "%s%s%s",
                      p->has_losses ? "A(0) takes the place of J(0) in the equation of motion." : "",
                      p->has_losses && p->is_rounded ? " " : "",
                      p->is_rounded
                          ? "i(theta) is the inertia of a domino about its line of contact with the "
                            "floor, divided by its inertia with sharp edges."
                          : "");
    answer_detail(p->answer, "The collision takes %.4g %% of the kinetic energy%s%s%s; %s is left.",
                  (double)(100 * p->state->lost / p->state->before), p->has_losses ? "" : " (the share ",
                  p->has_losses ? "" : of_head, p->has_losses ? "" : "/J(0))", energy_at(p, l.kinetic).text);
    if (b.theta_m == 0)
        answer_detail(p->answer, "There is no barrier: the potential energy of the train decreases "
                                 "from the start (26; c8).");
    else
        answer_detail(
            p->answer,
            "The train has %s of the energy that it needs to keep falling. Its potential energy must "
            "rise by %s, up to a tilt of %s%s; the train %s by %s (26; c8).",
            measured_share(b.kinetic / b.barrier, 3).text, energy_at(p, b.barrier).text,
            angle_at(p, b.theta_m).text, p->has_losses ? ", including losses on the way" : "",
            b.margin >= 0 ? "clears the barrier" : "fails to clear it",
            energy_at(p, quad(fabs)(b.margin)).text);
}

static void say_top(const struct place *p)
{
    const struct domq_state *s = p->state;
    answer_detail(
        p->answer,
        "%s, theta_m = %s: the potential energy has risen by %s%s%s%s%s, and a kinetic energy of %s "
        "is left. From here on, the train gains more energy than it loses (26; c8).",
        p->has_losses ? "The tilt that is hardest to pass" : "Top of the barrier", angle_at(p, s->theta).text,
        energy_at(p, s->climbed).text, p->has_losses ? ", " : "",
        p->has_losses ? losses_of(&p->walk->train) : "", p->has_losses ? " has taken " : "",
        p->has_losses ? energy_at(p, s->friction_work).text : "", energy_at(p, s->kinetic).text);
}

static void say_fall(const struct place *p)
{
    const struct walk *w = p->walk;
    struct domq_angles angles;
    size_t domino = w->events[w->event].domino;
    if (any_angles_find(&w->train, &w->compute, &angles) != DOM_OK)
        return;
    answer_detail(
        p->answer,
        "Domino %zu detaches from domino %zu, which has reached theta_leave = %s: the lever arm of the "
        "contact force is 0. Like all dominoes behind it, the detached domino comes to rest at theta_f = %s "
        "and no longer pushes the train %s. It has supplied %s of the energy released since the launch.",
        domino, domino - 1, angle_at(p, angles.theta_leave).text, angle_at(p, angles.theta_f).text,
        p->is_rounded ? "(as in equations (41; A17) and (42; A18))" : "(41; A17), (42; A18)",
        energy_at(p, 0 - p->state->fallen).text);
}

static void say_stop(const struct place *p)
{
    struct domq_barrier b;
    if (any_barrier_find(&p->walk->train, &p->walk->compute, &b) != DOM_STOPS)
        return;
    answer_detail(
        p->answer,
        "The train stops at theta = %s: all its kinetic energy, %s, has gone into %s. To pass the top "
        "of the barrier, at theta_m = %s, the train would need %s more (26; c8). There is no next "
        "hit; 'why' explains it.",
        angle_at(p, p->state->theta).text, energy_at(p, b.kinetic).text,
        p->has_losses ? "potential energy and losses" : "potential energy", angle_at(p, b.theta_m).text,
        energy_at(p, -b.margin).text);
}

static void say_hit(const struct place *p)
{
    const struct domq_state *s = p->state;
    struct walk_units next = walk_units(p->query, p->walk->cycle + 1);
    answer_detail(p->answer,
                  "The head reaches the next domino, %s tall, at theta_c = %s: %s (2; a2). The head turns at "
                  "%s; the cycle has released the fuel P = %s (25; c7), and has lasted %s.",
                  measured(next.height, "m", 6).text, angle_at(p, s->theta).text,
                  p->is_rounded ? "rho theta_c + (1 - 2 rho) sin theta_c = r s, as" : "sin theta_c = r s",
                  omega_at(p, s->omegasq).text, energy_at(p, -s->climbed).text,
                  measured(s->time * p->units.tau, "s", 6).text);
    if (p->has_losses)
        answer_detail(p->answer, "Of this energy, %s has taken %s.", losses_of(&p->walk->train),
                      energy_at(p, s->friction_work).text);
    answer_detail(
        p->answer,
        "'step' begins the next cycle. Its angles are the same, its lengths are r times as large, and "
        "it lasts sqrt(r) times as long, %s (23; c5).",
        measured(s->time * next.tau, "s", 6).text);
}

static double rounded(domq_real x, double step)
{
    return round((double)x / step) * step;
}

/* Prints the energies of the cycle as a sum: before - lost + gained - rubbed = kinetic. The loss is written
 * so that the sum of the printed numbers is exact; it is the largest term that is not printed again
 * elsewhere. */
static void ledger_say(const struct place *p)
{
    const struct domq_state *s = p->state;
    const domq_real unit = p->units.energy, before = s->before * unit,
                    term[] = {-s->climbed * unit, -s->friction_work * unit, s->kinetic * unit};
    domq_real least = before;
    for (int i = 0; i < 3; i++) {
        const domq_real size = quad(fabs)(term[i]);
        least = size > before / 1000000 && size < least ? size : least;
    }
    const int decimals = (int)fmax(0, 2 - floor(log10((double)least)));
    const double step = pow(10, -decimals), gained = rounded(term[0], step), rubbed = rounded(term[1], step),
                 kinetic = rounded(term[2], step), lost = rounded(before, step) + gained + rubbed - kinetic;
    if (!(before > 0) || decimals > 15 || fabs(lost - (double)(s->lost * unit)) >= 3 * step)
        return;
    char sum[200] = "";
    for (int i = 0; i < 2; i++)
        if ((i ? rubbed : gained) != 0)
            text_add(sum, sizeof sum, " %c %.*f", (i ? rubbed : gained) < 0 ? '-' : '+', decimals,
                     fabs(i ? rubbed : gained));
    answer_say(p->answer, "Kinetic energy, before - lost%s%s: %.*f - %.*f%s = %.*f %s.",
               s->climbed > 0   ? " - climbed"
               : s->climbed < 0 ? " + gained"
                                : "",
               s->friction_work > 0 ? " - rubbed" : "", decimals, (double)before, decimals, lost, sum,
               decimals, kinetic, p->units.energy_unit);
}

void walk_say(const struct query *query, const struct walk *w, const struct domq_state *state,
              struct answer *answer)
{
    static void (*const say[])(const struct place *) = {
        [DOM_EVENT_LAUNCH] = say_launch, [DOM_EVENT_DETACH] = say_fall, [DOM_EVENT_TOP] = say_top,
        [DOM_EVENT_STOP] = say_stop,     [DOM_EVENT_HIT] = say_hit,
    };
    const struct domq_event *e = &w->events[w->event];
    const struct place place = {.query = query,
                                .walk = w,
                                .state = state,
                                .answer = answer,
                                .units = walk_units(query, w->cycle),
                                .has_losses = domq_law(&w->train)->dissipates != NULL,
                                .is_rounded = w->train.rho != 0};
    const domq_real height =
        e->kind == DOM_EVENT_HIT ? walk_units(query, w->cycle + 1).height : place.units.height;
    const char *speed = state->acceleration < 0 ? "slows down" : "gathers speed";
    char text[200] = "";
    if (w->theta != e->theta) {
        answer_say(answer, "Cycle %d, between the %s and the %s: the train %s.", w->cycle,
                   dom_event_text(e->kind), dom_event_text(e[1].kind), speed);
        ledger_say(&place);
        answer_detail(answer,
                      "Between two events, at theta = %s: the train %s, and the head turns at %s (21; c3).",
                      angle_at(&place, state->theta).text, speed, omega_at(&place, state->omegasq).text);
        return;
    }
    if (e->kind == DOM_EVENT_DETACH)
        snprintf(text, sizeof text, "domino %zu detaches from domino %zu and comes to rest.", e->domino,
                 e->domino - 1);
    else
        snprintf(text, sizeof text,
                 e->kind == DOM_EVENT_LAUNCH
                     ? "domino 1 hits the head, which is %s tall, and all move as one train."
                 : e->kind == DOM_EVENT_TOP ? "the top of the barrier; from here on the train gains energy."
                 : e->kind == DOM_EVENT_STOP
                     ? "the train stops below the top of its barrier; 'why' explains it."
                     : "the head hits the next domino, which is %s tall; 'step' begins "
                       "its cycle.",
                 measured(height, "m", 6).text);
    answer_say(answer, "Cycle %d, event %d of %d: %s", w->cycle, w->event + 1, w->count, text);
    ledger_say(&place);
    say[e->kind](&place);
}
