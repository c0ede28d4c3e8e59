/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands that go through one cycle: as a table, and event by event. */
#include "command.h"
#include "walk.h"
#include "wide.h"
#include <string.h>

/* ---- cycle ---- */

static const struct column cycle_columns[] = {
    {"event", "", "launch, fall, top, stop, hit: see 'step'", 6},
    {"t", "s", "time since the launch", 0},
    {"theta", "rad", "tilt of the head", 7},
    {"theta_1", "rad", "of the first follower (b8)", 7},
    {"theta_2", "rad", "of the second", 7},
    {"omega", "rad/s", "angular velocity of the head (c3)", 0},
    {"kinetic", "mgh/2", "kinetic energy of the train, in J where a mass is known", 0},
    {"potential", "mgh/2", "H(theta) - H(0), in J where a mass is known", 0},
    {NULL, NULL, NULL, 0},
};

/* The same columns in joules. */
static void columns_in_joules(const struct column *from, struct column *to)
{
    for (;; from++, to++) {
        *to = *from;
        if (!from->key)
            return;
        if (strcmp(from->unit, "mgh/2") == 0)
            to->unit = "J";
    }
}

enum { COLUMNS_ROOM = 16, CYCLES_MAX = 1000 };

/* Energies in J where they are known in J; false where they stay in m g h / 2. */
static void answer_units(const struct session *session, struct answer *a, struct column room[COLUMNS_ROOM])
{
    if (strcmp(walk_units(session, 1).energy_unit, "J") != 0)
        return;
    columns_in_joules(a->columns, room);
    a->columns = room;
}

/* The first followers of the head. */
struct followers {
    dom_real theta[3];
};

static bool follower_seen(const struct dom_link *k, const struct dom_link *error, void *context)
{
    (void)error;
    struct followers *f = context;
    f->theta[k->i] = k->theta;
    return k->i < 2;
}

/* omega from tau^2 omega^2 and the bound of that; at rest the bound is that of a root near 0. */
static struct cell cell_omega(dom_real omegasq, dom_real error, dom_real tau)
{
    return cell_bound(sqrt(omegasq) / tau,
                      (omegasq > error ? error / (2 * sqrt(omegasq - error)) : sqrt(error)) / tau);
}

/* An angle that a narrow column shows with four digits. */
static struct cell cell_angle(dom_real theta)
{
    struct cell cell = cell_real(theta);
    cell.digits = 4;
    return cell;
}

static enum dom_status cycle_row(const struct session *session, struct answer *a, dom_real theta,
                                 const char *event)
{
    struct walk_units u = walk_units(session, 1);
    struct dom_state s, e = {0};
    struct dom_angles angles;
    enum dom_status status = dom_cycle_state(&session->train, theta, &s, ERROR_OF(session, e));
    if (status == DOM_OK)
        status = dom_angles_find(&session->train, &angles, NULL);
    /* Whoever is not leaned on any more lies at theta_f. */
    struct followers f = {{theta, angles.theta_f, angles.theta_f}};
    if (status == DOM_OK)
        status = dom_chain_walk(&session->train, theta, false, follower_seen, &f);
    if (status != DOM_OK)
        return status;
    answer_row(a,
               ROW(cell_word(event), cell_bound(s.time * u.tau, e.time * u.tau), cell_angle(theta),
                   cell_angle(f.theta[1]), cell_angle(f.theta[2]), cell_omega(s.omegasq, e.omegasq, u.tau),
                   cell_bound(s.kinetic * u.energy, e.kinetic * u.energy),
                   cell_bound(s.climbed * u.energy, e.climbed * u.energy)),
               NULL);
    return DOM_OK;
}

enum { BY_TIME, BY_TILT };

static const char *cycle_by(const void *context, int k)
{
    static const char *const names[] = {[BY_TIME] = "time", [BY_TILT] = "tilt", NULL};
    (void)context;
    return names[k];
}

/* N rows evenly in time or tilt, and one for each event, in order. */
static enum dom_status cycle_rows(const struct session *session, const struct call *call,
                                  const struct dom_event *events, int count)
{
    const struct dom_train *train = &session->train;
    dom_real rows = call->count > 0 ? call->number[0] : 12;
    bool by_tilt = call->count > 1 && (int)call->number[1] == BY_TILT;
    const struct dom_event *last = &events[count - 1];
    enum dom_status status = DOM_OK;
    int next = 0;
    for (dom_real k = 0; k < rows && status == DOM_OK && !answer_lost(call->answer); k++) {
        dom_real part = rows > 1 ? k / (rows - 1) : 1, theta = part * last->theta;
        if (!by_tilt && part > 0 && part < 1)
            status = dom_cycle_tilt(train, part * last->time, &theta);
        for (; next < count && status == DOM_OK && events[next].theta <= theta; next++)
            status = cycle_row(session, call->answer, events[next].theta, dom_event_text(events[next].kind));
        if (status == DOM_OK && theta > events[next > 0 ? next - 1 : 0].theta && next < count)
            status = cycle_row(session, call->answer, theta, "");
    }
    return status;
}

static const char no_start[] =
    "no domino effect: the fuel P is not positive (c7), no cycle begins; 'why' says more";

static bool run_cycle(struct session *session, const struct call *call)
{
    struct column room[COLUMNS_ROOM];
    struct dom_event events[DOM_EVENTS_MAX];
    int count;
    struct answer *a = call->answer;
    enum dom_status verdict = dom_cycle_events(&session->train, events, &count), status = verdict;
    answer_units(session, a, room);
    if (verdict == DOM_NO_FUEL) {
        struct cell none = cell_real(DOM_NAN);
        answer_row(a, ROW(cell_word(""), none, none, none, none, none, none, none), no_start);
        a->columns = cycle_columns;
        return true;
    }
    if (status == DOM_OK || status == DOM_STOPS)
        status = cycle_rows(session, call, events, count);
    a->columns = cycle_columns;
    if (status != DOM_OK)
        return walk_status(session, status);
    struct walk_contact contact;
    if (answer_for_people(a) && walk_contact(&session->train, &contact) == DOM_OK && isfinite(contact.force))
        answer_say(
            a, "Dominoes stay in contact: the smallest contact force is %.4g times the weight of its domino.",
            (double)contact.force);
    if (verdict == DOM_STOPS)
        answer_say(a, "The train stops below its barrier; 'why' says more.");
    return true;
}

/* ---- The walk ---- */

static const struct column walk_columns[] = {
    {"cycle", "", "its number, from 1", 0},
    {"event", "", "the last one that was passed", 0},
    {"theta", "rad", "tilt of the head", 0},
    {"t", "s", "time since the launch of this cycle", 0},
    {"omega", "rad/s", "angular velocity of the head (c3)", 0},
    {"before", "mgh/2", "kinetic energy before the collision", 0},
    {"lost", "mgh/2", "of that in the collision, the share 1/J(0) (c4)", 0},
    {"gained", "mgh/2", "fuel set free since: H(0) - H(theta); negative: climbed", 0},
    {"fallen", "mgh/2", "the part of that from dominoes that fell off since", 0},
    {"kinetic", "mgh/2", "kinetic energy now: before - lost + gained", 0},
    {"potential", "mgh/2", "potential energy now, H(theta) - H(0)", 0},
    {NULL, NULL, NULL, 0},
};

static bool same_train(const struct dom_train *a, const struct dom_train *b)
{
    return a->s == b->s && a->r == b->r && a->d == b->d && a->q == b->q && a->fuel == b->fuel &&
           a->tol == b->tol && a->precision == b->precision;
}

/* The walk of the session's train, begun if there is none; *begun tells.  False: an error was reported. */
static bool walk_ready(struct session *session, struct answer *answer, bool *begun)
{
    struct walk *w = &session->walk;
    *begun = false;
    if (w->count > 0 && same_train(&w->asked, &session->train))
        return true;
    if (w->count > 0)
        answer_say(answer, "The parameters have changed: the walk begins anew.");
    *w = (struct walk){.train = session->train, .asked = session->train, .cycle = 1};
    /* Its sentences have six digits: they are to be right at any tolerance. */
    w->train.tol = fmin(w->train.tol, fmax(dom_arithmetic(w->train.precision)->tol_floor, (dom_real)1e-9));
    w->verdict = dom_cycle_events(&w->train, w->events, &w->count);
    *begun = true;
    return w->verdict == DOM_OK || w->verdict == DOM_STOPS || w->verdict == DOM_NO_FUEL ||
           walk_status(session, w->verdict);
}

static bool walk_answer(struct session *session, const struct call *call, bool words)
{
    const struct walk *w = &session->walk;
    struct column room[COLUMNS_ROOM];
    struct answer *a = call->answer;
    struct dom_state s, e = {0};
    if (w->verdict == DOM_NO_FUEL) {
        struct cell none = cell_real(DOM_NAN);
        answer_row(a, ROW(none, none, none, none, none, none, none, none, none, none, none), no_start);
        return true;
    }
    enum dom_status status = dom_cycle_state(&w->train, w->theta, &s, ERROR_OF(session, e));
    if (status != DOM_OK)
        return walk_status(session, status);
    struct walk_units u = walk_units(session, w->cycle);
    if (words)
        walk_say(session, w, &s, a);
    answer_units(session, a, room);
    struct cell energies[] = {
        cell_bound(s.before * u.energy, e.before * u.energy),
        cell_bound(s.lost * u.energy, e.lost * u.energy),
        cell_bound((0 - s.climbed) * u.energy, e.climbed * u.energy),
        cell_bound((0 - s.fallen) * u.energy, e.fallen * u.energy),
        cell_bound(s.kinetic * u.energy, e.kinetic * u.energy),
        cell_bound(s.climbed * u.energy, e.climbed * u.energy),
    };
    answer_row(a,
               ROW(cell_count(w->cycle), cell_word(dom_event_text(w->events[w->event].kind)),
                   cell_real(s.theta), cell_bound(s.time * u.tau, e.time * u.tau),
                   cell_omega(s.omegasq, e.omegasq, u.tau), energies[0], energies[1], energies[2],
                   energies[3], energies[4], energies[5]),
               NULL);
    a->columns = walk_columns;
    if (w->cycle > 1 && strcmp(u.energy_unit, "J") != 0)
        answer_say(a, "Energies are in mgh/2 of the first head; 'set mass' gives them in J.");
    dom_real open = s.before - s.lost - s.climbed - s.kinetic;
    if (fabs(open) > 100 * w->train.tol * (s.before + fabs(s.climbed)))
        answer_say(a, "The ledger is open by %.4g %s: the paper's fuel is no balance of energy.",
                   (double)(open * u.energy), u.energy_unit);
    return true;
}

/* One event on; false, with *done, where there is none. */
static bool walk_forward(struct walk *w)
{
    if (w->event + 1 < w->count) {
        w->event++;
    } else if (w->verdict == DOM_OK && w->cycle < CYCLES_MAX) {
        w->cycle++;
        w->event = 0;
    } else {
        return false;
    }
    w->theta = w->events[w->event].theta;
    return true;
}

static bool walk_backward(struct walk *w)
{
    if (w->theta > w->events[w->event].theta) {
        /* from between two events to the one before */
    } else if (w->event > 0) {
        w->event--;
    } else if (w->cycle > 1) {
        w->cycle--;
        w->event = w->count - 1;
    } else {
        return false;
    }
    w->theta = w->events[w->event].theta;
    return true;
}

static bool walk_end(struct session *session, bool forward)
{
    const struct walk *w = &session->walk;
    if (!forward)
        return session_error(session, "this is the launch of the first cycle; 'step' goes on");
    return w->verdict == DOM_STOPS
               ? session_error(session,
                               "the train has stopped, it comes no further; 'why' says more, 'goto launch' "
                               "begins again")
               : session_error(session, "after %d cycles the walk ends; 'goto launch' and 'back' lead back",
                               CYCLES_MAX);
}

/* Where the walk ends before the steps do, it answers for those that it could make, then says why. */
static bool walk_by(struct session *session, const struct call *call, bool forward)
{
    bool moved; /* a walk that has just begun stands at its first launch */
    struct walk *w = &session->walk;
    long steps = call->count > 0 ? (long)call->number[0] : 1;
    if (!walk_ready(session, call->answer, &moved))
        return false;
    steps -= moved && forward;
    bool open = w->verdict != DOM_NO_FUEL;
    for (; open && steps > 0; steps--) {
        open = forward ? walk_forward(w) : walk_backward(w);
        moved = moved || open;
    }
    bool short_of = !open && w->verdict != DOM_NO_FUEL;
    if (moved || !short_of)
        if (!walk_answer(session, call, true))
            return false;
    return !short_of || walk_end(session, forward);
}

static bool run_step(struct session *session, const struct call *call)
{
    return walk_by(session, call, true);
}

static bool run_back(struct session *session, const struct call *call)
{
    return walk_by(session, call, false);
}

static bool run_where(struct session *session, const struct call *call)
{
    bool begun;
    return walk_ready(session, call->answer, &begun) && walk_answer(session, call, true);
}

static const char *event_names(const void *context, int k)
{
    (void)context;
    return k <= DOM_EVENT_HIT ? dom_event_text((enum dom_event_kind)k) : NULL;
}

static bool run_goto(struct session *session, const struct call *call)
{
    bool begun;
    struct walk *w = &session->walk;
    dom_real place = call->number[0];
    if (!walk_ready(session, call->answer, &begun))
        return false;
    if (w->verdict == DOM_NO_FUEL)
        return walk_answer(session, call, true);
    int found = -1;
    for (int k = 0; k < w->count; k++)
        if (place < 0 ? w->events[k].kind == (enum dom_event_kind)(-1 - (int)place)
                      : w->events[k].theta <= place)
            found = k;
    if (found < 0)
        return session_error(session, "there is no '%s' in this cycle; 'cycle' lists its events",
                             dom_event_text((enum dom_event_kind)(-1 - (int)place)));
    if (place > w->events[w->count - 1].theta)
        return session_error(session,
                             "the train stops at theta = %.10g %s, it does not come as far; 'goto stop' does",
                             (double)style_angle(&session->style, w->events[w->count - 1].theta),
                             style_angle_unit(&session->style));
    w->event = found;
    w->theta = place < 0 ? w->events[found].theta : place;
    return walk_answer(session, call, true);
}

/* ---- why ---- */

static const struct column why_columns[] = {
    {"verdict", "", "goes on, stops, or no fuel", 0},
    {"fuel", "mgh/2", "P, set free by one cycle (c7)", 0},
    {"J0", "", "J(0): the collision keeps the share 1 - 1/J(0) (c4)", 0},
    {"kinetic", "mgh/2", "K after the collision, P T/(r^q (1+T) - T), T = J(0) - 1 (c6)", 0},
    {"barrier", "mgh/2", "B, to climb (c8)", 0},
    {"margin", "mgh/2", "K - B", 0},
    {"r_max", "", "largest growth at this s: there K = B, or r s = 1", 0},
    {NULL, NULL, NULL, 0},
};

static void why_say(const struct session *session, struct answer *a, enum dom_status verdict,
                    const struct dom_barrier *b, const struct dom_limit *limit)
{
    const struct dom_train *t = &session->train;
    if (verdict == DOM_NO_FUEL) {
        answer_say(
            a,
            "No cycle begins: (c7) decides. The fuel P = H(0) - H(theta_c) is not positive, so a cycle sets "
            "no energy free: the dominoes that lean down the train lie no lower than they stood, or the "
            "larger one in front takes up more than the smaller ones behind give.");
    } else if (b->barrier == 0) {
        answer_say(a, "It goes on: there is no barrier (c8), H falls from the first moment on, and any K > 0 "
                      "is enough.");
    } else {
        bool goes = verdict == DOM_OK;
        answer_say(
            a,
            "It %s: (c8) decides, K %s B. After the collision the train has %.4g times the energy that it "
            "needs to climb to theta_m = %.6g %s; K - B is %.3g times B.",
            goes ? "goes on" : "stops", goes ? ">=" : "<", (double)(b->kinetic / b->barrier),
            (double)style_angle(&session->style, b->theta_m), style_angle_unit(&session->style),
            (double)(b->margin / b->barrier));
    }
    if (limit->ends == DOM_END_NONE)
        answer_say(a, "At s = %.6g no growth r >= 1 is possible.", (double)t->s);
    else if (limit->ends == DOM_END_REACH)
        answer_say(a,
                   "At s = %.6g growth ends by reach: beyond r = 1/s = %.6g the head falls past the next "
                   "domino (a2).",
                   (double)t->s, (double)limit->r_max);
    else
        answer_say(a,
                   "At s = %.6g K falls below B at r_max = %.10g: a larger r weighs the head against a "
                   "lighter train.",
                   (double)t->s, (double)limit->r_max);
}

/* The paper's assumption along the cycle. */
static void contact_say(const struct session *session, struct answer *a, const struct walk_contact *c)
{
    bool holds = c->force > 0 && c->impulse > 0;
    if (!isfinite(c->force) || !isfinite(c->impulse))
        answer_say(
            a, "Contact: at r s = 1 the head is hit at its own hinge, the arm of the contact is 0 (b10), and "
               "the model's impulse has no bound: there its assumption fails.");
    else
        answer_say(
            a,
            "%s: on the way the smallest contact force is %.4g of the weight of domino %zu, which it pushes, "
            "at "
            "theta = %.4g %s, and every impulse of the collision pushes. So the paper's assumption, dominoes "
            "stay in contact, %s.",
            holds ? "Contact holds" : "Contact is lost", (double)c->force, c->domino,
            (double)style_angle(&session->style, c->theta), style_angle_unit(&session->style),
            holds ? "is met" : "fails there");
}

static bool run_why(struct session *session, const struct call *call)
{
    struct column room[COLUMNS_ROOM];
    struct walk_units u = walk_units(session, 1);
    struct dom_launch l, l_error = {0};
    struct dom_barrier b, b_error = {0};
    struct dom_limit limit, limit_error = {.r_max = 0};
    struct answer *a = call->answer;
    enum dom_status verdict = dom_barrier_find(&session->train, &b, ERROR_OF(session, b_error)),
                    status = verdict;
    if (verdict == DOM_OK || verdict == DOM_STOPS || verdict == DOM_NO_FUEL)
        status = dom_launch_find(&session->train, &l, ERROR_OF(session, l_error));
    if (status == DOM_OK || status == DOM_NO_FUEL)
        status = dom_limit_rmax(&session->train, &limit, ERROR_OF(session, limit_error), NULL);
    if (status != DOM_OK)
        return walk_status(session, status);
    why_say(session, a, verdict, &b, &limit);
    struct walk_contact contact;
    struct dom_event events[DOM_EVENTS_MAX];
    int count;
    dom_cycle_events(&session->train, events, &count);
    if (answer_for_people(a) && count > 0 && walk_contact(&session->train, &contact) == DOM_OK)
        contact_say(session, a, &contact);
    answer_units(session, a, room);
    answer_row(a,
               ROW(cell_word(verdict == DOM_OK      ? "goes on"
                             : verdict == DOM_STOPS ? "stops"
                                                    : "no fuel"),
                   cell_bound(l.fuel * u.energy, l_error.fuel * u.energy), cell_bound(l.J0, l_error.J0),
                   cell_bound(b.kinetic * u.energy, b_error.kinetic * u.energy),
                   cell_bound(b.barrier * u.energy, b_error.barrier * u.energy),
                   cell_bound(b.margin * u.energy, b_error.margin * u.energy),
                   cell_bound(limit.r_max, limit_error.r_max)),
               NULL);
    a->columns = why_columns;
    return true;
}

const struct command walk_commands[] = {
    {.name = "cycle",
     .argument = {{.name = "N", .kind = ARGUMENT_COUNT, .optional = true},
                  {.name = "BY",
                   .kind = ARGUMENT_CHOICE,
                   .of = "way to space rows",
                   .choices = cycle_by,
                   .optional = true}},
     .summary = "one cycle in N rows, even in time or in tilt",
     .equation = "(b8) (c3)",
     .help = "12 rows, even in time, unless N and BY say otherwise; the events have rows of their own. "
             "Energies are "
             "in J where 'mass' or 'density' is set.",
     .example = "cycle 5 tilt",
     .see = "step omega duration",
     .columns = cycle_columns,
     .principal = -1,
     .rows = true,
     .run = run_cycle},
    {.name = "step",
     .argument = {{.name = "N", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "to the next event: what happens, and its ledger of energy",
     .equation = "(a2) (c3) (c4) (c6) (c7) (c8) (A17)",
     .help = "The first step is to the launch of the first cycle; behind the hit the next, larger and slower "
             "cycle "
             "begins. The ledger: before - lost + gained = kinetic.",
     .example = "step; step",
     .see = "back goto where why",
     .columns = walk_columns,
     .principal = -1,
     .run = run_step},
    {.name = "back",
     .argument = {{.name = "N", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "back to the event before",
     .example = "step 3; back",
     .see = "step goto",
     .columns = walk_columns,
     .principal = -1,
     .run = run_back},
    {.name = "goto",
     .argument = {{.name = "PLACE", .kind = ARGUMENT_PLACE, .of = "event", .choices = event_names}},
     .summary = "to a tilt, or to the launch, top, fall, stop or hit",
     .example = "goto 0.3",
     .see = "step where",
     .columns = walk_columns,
     .principal = -1,
     .run = run_goto},
    {.name = "where",
     .summary = "where the walk stands",
     .example = "goto top; where",
     .see = "step goto",
     .columns = walk_columns,
     .principal = 2,
     .run = run_where},
    {.name = "why",
     .summary = "why the train goes on or stops: the term that decides",
     .equation = "(c6) (c7) (c8)",
     .example = "why",
     .see = "barrier rmax step",
     .columns = why_columns,
     .principal = 5,
     .run = run_why},
    {.name = NULL},
};
