/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands that go through cycles: as a table, and event by event. */
#include "commands/tables.h"
#include "commands/walk.h"
#include "language/quad.h"

enum { CYCLES_MAX = 1000 };

static const struct column walk_columns[] = {
    {"cycle", "", "number of the cycle, from 1", 0},
    {"event", "", "the last event that was passed", 6},
    {"theta", "rad", "tilt of the head", 0},
    {"t", "s", "time since the launch of this cycle", 0},
    {"omega", "rad/s", "angular velocity of the head (21; c3)", 0},
    {"before", "mgh/2", "kinetic energy before the collision", 0},
    {"lost", "mgh/2", "kinetic energy lost in the collision (22; c4)", 0},
    {"gained", "mgh/2", "fuel set free since then: H(0) - H(theta); negative: climbed", 0},
    {"fallen", "mgh/2", "part of the gain that comes from dominoes that detached", 0},
    {"kinetic", "mgh/2", "kinetic energy now: before - lost + gained", 0},
    {"potential", "mgh/2", "potential energy now, H(theta) - H(0)", 0},
    {"rubbed", "mgh/2", "what friction has taken since the launch", 0},
    {NULL, NULL, NULL, 0},
};

/* Begins the walk of the session's train if there is none; *begun is then true.  False: an error was
 * reported. */
static bool walk_ready(struct session *session, struct answer *answer, bool *begun)
{
    struct walk *w = &session->walk;
    *begun = false;
    if (walk_now(session))
        return true;
    if (w->count > 0)
        answer_say(answer, "The parameters have changed: the walk begins again.");
    *w = (struct walk){
        .train = session->train, .compute = session->compute, .tol = session->compute.tol, .cycle = 1};
    /* The sentences have six digits, which are right at any tolerance. */
    w->compute.tol = quad_smaller(
        w->compute.tol, quad_larger(domq_arithmetic(w->compute.precision)->tol_floor, (domq_real)1e-9));
    w->verdict = domq_cycle_events(&w->train, &w->compute, w->events, &w->count);
    *begun = true;
    return w->verdict == DOM_OK || w->verdict == DOM_STOPS || w->verdict == DOM_NO_FUEL ||
           session_status(session, w->verdict);
}

static bool walk_answer(struct session *session, const struct call *call)
{
    const struct walk *w = &session->walk;
    struct answer *a = call->answer;
    struct domq_state s;
    struct domq_compute compute = w->compute;
    compute.errors = session->style.errors;
    if (!domq_law(&w->train)->dissipates)
        answer_leave_out(a, "rubbed");
    if (w->verdict == DOM_NO_FUEL) {
        struct cell none = cell_real(DOMQ_NAN);
        answer_row(a, ROW(none, none, none, none, none, none, none, none, none, none, none, none),
                   walk_no_start);
        return true;
    }
    enum dom_status status = domq_cycle_state(&w->train, &compute, w->theta, &s);
    if (status != DOM_OK)
        return session_status(session, status);
    struct walk_units u = walk_units(session, w->cycle);
    walk_say(session, w, &s, a);
    walk_columns_in(session, a);
    answer_cells(
        a, cell_count(w->cycle), cell_word(dom_event_text(w->events[w->event].kind)), cell_real(s.theta),
        CELL_TIMES(s, time, u.tau), cell_omega(s.omegasq, s.error.omegasq, u.tau),
        CELL_TIMES(s, before, u.energy), CELL_TIMES(s, lost, u.energy),
        cell_bound((0 - s.climbed) * u.energy, s.error.climbed * u.energy),
        cell_bound((0 - s.fallen) * u.energy, s.error.fallen * u.energy), CELL_TIMES(s, kinetic, u.energy),
        CELL_TIMES(s, climbed, u.energy), cell_bound(s.friction_work * u.energy, DOMQ_NAN));
    if (w->cycle > 1 && !(session_mass(session) > 0))
        answer_say(a, "Energies are in mgh/2 of the first head; 'set mass' gives them in J.");
    domq_real open = s.before - s.lost - s.climbed - s.friction_work - s.kinetic;
    if (quad(fabs)(open) > 100 * w->compute.tol * (s.before + quad(fabs)(s.climbed)))
        answer_say(a, "The ledger is open by %.4g %s, since the paper's fuel is not a balance of energy.",
                   (double)(open * u.energy), u.energy_unit);
    return true;
}

/* Moves the walk one event on; false if there is none. */
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
        return session_no_answer(session, "this is the launch of the first cycle; 'step' goes on");
    return w->verdict == DOM_STOPS
               ? session_no_answer(session,
                                   "the train has stopped; 'why' says more, 'goto launch' begins again")
               : session_no_answer(session,
                                   "after %d cycles the walk ends; 'goto launch' and 'back' lead back",
                                   CYCLES_MAX);
}

/* Moves the walk by the call's steps; if it ends before them, answers for those that it made, then says why.
 */
static bool walk_by(struct session *session, const struct call *call, bool forward)
{
    bool moved; /* a walk that has just begun is at its first launch */
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
        if (!walk_answer(session, call))
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
    return walk_ready(session, call->answer, &begun) && walk_answer(session, call);
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
    domq_real place = call->number[0];
    if (!walk_ready(session, call->answer, &begun))
        return false;
    if (w->verdict == DOM_NO_FUEL)
        return walk_answer(session, call);
    int found = -1;
    for (int k = 0; k < w->count; k++)
        if (place < 0 ? w->events[k].kind == (enum dom_event_kind)(-1 - (int)place)
                      : w->events[k].theta <= place)
            found = k;
    if (found < 0)
        return session_no_answer(session, "there is no '%s' in this cycle; 'cycle' lists its events",
                                 dom_event_text((enum dom_event_kind)(-1 - (int)place)));
    if (place > w->events[w->count - 1].theta)
        return session_no_answer(session,
                                 "the train stops before that, at theta = %.10g %s; 'goto stop' goes there",
                                 (double)style_angle(&session->style, w->events[w->count - 1].theta),
                                 style_angle_unit(&session->style));
    w->event = found;
    w->theta = place < 0 ? w->events[found].theta : place;
    return walk_answer(session, call);
}

const struct command walk_commands[] = {
    {.name = "cycle",
     .synonyms = "table time trace",
     .train = true,
     .argument = {{.name = "N", .kind = ARGUMENT_COUNT, .optional = true},
                  {.name = "BY",
                   .kind = ARGUMENT_CHOICE,
                   .of = "way to space rows",
                   .choices = cycle_by,
                   .optional = true}},
     .summary = "one cycle in N rows, with equal steps of time or tilt",
     .equation = "(12; b8) (21; c3)",
     .help = "12 rows with equal steps of time, unless N and BY say otherwise; the events have rows of their "
             "own. "
             "Energies are in J where 'mass' or 'density' is set.",
     .example = "cycle 5 tilt",
     .see = "step omega duration",
     .rows = true,
     ANSWER(cycle)},
    {.name = "step",
     .synonyms = "next walk forward",
     .train = true,
     .argument = {{.name = "N", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "go to the next event: what happens, and its ledger of energy",
     .equation = "(2; a2) (21; c3) (22; c4) (24; c6) (25; c7) (26; c8) (41; A17)",
     .help = "The first step is to the launch of the first cycle; after the hit the next, larger and slower "
             "cycle begins. The ledger: before - lost + gained = kinetic.",
     .example = "step; step",
     .see = "back goto where why",
     .columns = walk_columns,
     .run = run_step},
    {.name = "back",
     .synonyms = "undo previous walk",
     .train = true,
     .argument = {{.name = "N", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "go back to the event before",
     .example = "step 2; back",
     .see = "step goto",
     .columns = walk_columns,
     .run = run_back},
    {.name = "goto",
     .synonyms = "jump walk",
     .train = true,
     .argument = {{.name = "PLACE", .kind = ARGUMENT_PLACE, .of = "event", .choices = event_names}},
     .summary = "go to a tilt, or to the launch, top, fall, stop or hit",
     .example = "goto 0.3",
     .see = "step where",
     .columns = walk_columns,
     .run = run_goto},
    {.name = "where",
     .synonyms = "position walk",
     .train = true,
     .summary = "where the walk is",
     .example = "where",
     .see = "step goto",
     .columns = walk_columns,
     .principal = "theta",
     .run = run_where},
    {.name = "why",
     .synonyms = "reason explain stop",
     .train = true,
     .summary = "why the train goes on or stops",
     .equation = "(24; c6) (25; c7) (26; c8)",
     .example = "why",
     .see = "barrier rmax step",
     .principal = "margin",
     ANSWER(why)},
    {.name = NULL},
};
