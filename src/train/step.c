/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A walk through the cycles of the train, event by event: step, back, goto and where. */
#include "language/quad.h"
#include "train/train.h"
#include <string.h>

const struct walk *walk_now(const struct query *query)
{
    const struct walk *walk = query->walk;
    const struct domq_train *a = &walk->train, *b = &query->scene->train;
    const bool is_same = a->s == b->s && a->r == b->r && a->d == b->d && a->q == b->q &&
                         a->width == b->width &&
#define SAME(name, member, status) a->member == b->member &&
                         DOM_DYNAMICS(SAME)
#undef SAME
                                 a->fuel == b->fuel;
    return walk->cycle > 0 && is_same ? walk : NULL;
}

/* The place that a walk has reached, among the events of the cycle. */
struct place {
    struct walk walk;
    struct domq_event event[DOM_EVENTS_MAX];
    int count;               /* the number of events; 0 if there is no fuel */
    enum dom_status verdict; /* DOM_OK, DOM_STOPS or DOM_NO_FUEL */
};

/* ---- In words ---- */

/* Prints what happens at the event that the walk has reached, and between two events how the train moves. */
static void event_say(const struct query *query, struct answer *a, const struct place *p,
                      const struct domq_state *s)
{
    static const char *const detail[] = {
        [DOM_EVENT_LAUNCH] =
            "'explain launch' has the equations of the collision (24; c6), and 'barrier' the "
            "energy that the train needs (26; c8).",
        [DOM_EVENT_DETACH] =
            "Its leader has reached theta_leave, where the lever arm of the contact force is "
            "0. The detached domino and all behind it stay at theta_f and no longer push; "
            "'thetac' shows these tilts.",
        [DOM_EVENT_TOP] = "This is theta_m, the tilt that is hardest to pass (26; c8).",
        [DOM_EVENT_STOP] = "All kinetic energy is used up; 'barrier' shows how much more the train needs "
                           "(26; c8).",
        [DOM_EVENT_HIT] = "The head has reached theta_c (2; a2). The next cycle has the same angles; its "
                          "lengths are r times as large, and it lasts sqrt(r) times as long (23; c5)."};
    const struct walk *w = &p->walk;
    const struct domq_event *e = &p->event[w->event];
    char what[240] = "the top of the barrier; from here on the train gains energy";
    if (w->is_between) {
        answer_say(a, "Cycle %d, between the %s and the %s: the train %s.", w->cycle, dom_event_text(e->kind),
                   dom_event_text(e[1].kind), s->acceleration < 0 ? "slows down" : "gathers speed");
        return;
    }
    if (e->kind == DOM_EVENT_LAUNCH)
        snprintf(what, sizeof what,
                 "the first follower hits the head, which is %s tall, and all move as one train",
                 measured(walk_units(query, w->cycle).height, "m", 6).text);
    else if (e->kind == DOM_EVENT_DETACH)
        snprintf(what, sizeof what, "follower %zu detaches from the domino in front of it and comes to rest",
                 e->domino);
    else if (e->kind == DOM_EVENT_STOP)
        snprintf(what, sizeof what, "the train stops below the top of its barrier; 'why' explains it");
    else if (e->kind == DOM_EVENT_HIT)
        snprintf(what, sizeof what,
                 "the head hits the next domino, which is %s tall; 'step' begins its cycle",
                 measured(walk_units(query, w->cycle + 1).height, "m", 6).text);
    answer_say(a, "Cycle %d, event %d of %d: %s.", w->cycle, w->event + 1, p->count, what);
    answer_detail(a, "%s", detail[e->kind]);
}

static const struct column walk_columns[] = {
    {"cycle", "", "number of the cycle, from 1", 0},
    {"event", "", "the last event", 6},
    {"theta", "rad", "tilt of the head", 0},
    {"t", "s", "time since the launch of this cycle", 0},
    {"omega", "rad/s", "angular velocity of the head (21; c3), at the launch (24; c6)", 0},
    {"before", "mgh/2", "kinetic energy before the collision", 0},
    {"lost", "mgh/2", "kinetic energy lost in the collision (22; c4)", 0},
    {"gained", "mgh/2", "energy released since the launch, H(0) - H(theta); negative if H has increased", 0},
    {"fallen", "mgh/2", "energy released by dominoes that have detached, a part of 'gained'", 0},
    {"kinetic", "mgh/2", "kinetic energy now: before - lost + gained (- rubbed, with losses)", 0},
    {"potential", "mgh/2", "potential energy now, H(theta) - H(0)", 0},
    {"rubbed", "mgh/2", "energy lost since the launch, but not in the collision", 0},
    {NULL, NULL, NULL, 0},
};

/* Finds the events of the cycle, and the place of the walk among them. Begins a new walk, and sets *begun to
 * true, unless the session has one along the same train. */
static bool place_find(const struct query *query, struct answer *a, struct problem *problem, struct place *p,
                       bool *begun)
{
    const struct walk *walk = walk_now(query);
    *p = (struct place){.count = 0};
    p->verdict = any_cycle_events(&query->scene->train, query_compute(query), p->event, &p->count);
    if (p->verdict != DOM_OK && p->verdict != DOM_STOPS && p->verdict != DOM_NO_FUEL)
        return query_status(query, problem, p->verdict);
    *begun = !walk || walk->event >= p->count;
    p->walk = *begun ? (struct walk){.train = query->scene->train, .cycle = 1} : *walk;
    if (*begun && query->walk->cycle > 0)
        answer_say(a, "The parameters have changed, so the steps begin again at the launch.");
    if (!p->walk.is_between) /* another tolerance finds the event a little elsewhere */
        p->walk.theta = p->event[p->walk.event].theta;
    return true;
}

static bool place_answer(const struct query *query, struct answer *a, struct problem *problem,
                         const struct place *p)
{
    const struct walk *w = &p->walk;
    const struct walk_units units = walk_units(query, w->cycle), *u = &units;
    struct domq_state state, *s = &state;
    if (!domq_dissipates(&query->scene->train))
        answer_leave_out(a, "rubbed");
    if (p->verdict == DOM_NO_FUEL)
        return answer_row(a, (const struct cell[ANSWER_COLUMNS]){{.kind = CELL_NONE}},
                          verdict_reason(p->verdict));
    if (!query_status(query, problem,
                      any_cycle_state(&query->scene->train, query_compute(query), w->theta, s)))
        return false;
    event_say(query, a, p, s);
    if (w->cycle > 1 && !(scene_mass(query->scene) > 0))
        answer_detail(a, "Energies are in units of m g h / 2 of the first head.");
    walk_columns_in(query, a);
    return answer_cells(a, cell_count(w->cycle), cell_word(dom_event_text(p->event[w->event].kind)),
                        cell_real(s->theta), cell_computed(s->time * u->tau), cell_omega(s->omegasq, u->tau),
                        cell_computed(s->before * u->energy), cell_computed(s->lost * u->energy),
                        cell_computed((0 - s->climbed) * u->energy),
                        cell_computed((0 - s->fallen) * u->energy), cell_computed(s->kinetic * u->energy),
                        cell_computed(s->climbed * u->energy), cell_computed(s->friction_work * u->energy));
}

/* ---- step, back, goto and where ---- */

enum {
    CYCLES_MAX = 1000,
    EVENT_START = DOM_EVENT_HIT + 1 /* for 'step to start': the launch of the first cycle */
};

/* Moves to a tilt. A negative number -1 - k stands for the event of kind k. */
static bool walk_to(const struct query *query, struct problem *problem, struct place *p, domq_real tilt)
{
    const struct domq_event *last = &p->event[p->count - 1];
    int event = (int)(-1 - tilt), found = -1;
    if (tilt < 0 && event == EVENT_START) {
        p->walk.cycle = 1;
        event = DOM_EVENT_LAUNCH;
    }
    for (int k = 0; k < p->count; k++)
        if (tilt < 0 ? (int)p->event[k].kind == event : p->event[k].theta <= tilt)
            found = k;
    if (found < 0)
        return problem_no_answer(problem, "there is no '%s' in this cycle; 'cycle' lists its events",
                                 dom_event_text((enum dom_event_kind)event));
    if (tilt > last->theta)
        return problem_no_answer(problem,
                                 "the train stops before that, at theta = %s; 'step to stop' goes there",
                                 angle_text(query, last->theta, 10).text);
    p->walk.event = found;
    p->walk.is_between = tilt > p->event[found].theta;
    p->walk.theta = tilt < 0 ? p->event[found].theta : tilt;
    return true;
}

/* Answers a command: goes to the tilt or the event `place` or, if it is NULL, a number of steps forward, or
 * backward if it is negative. */
static bool walk_go(const struct query *query, struct answer *a, struct problem *problem, long steps,
                    const domq_real *place)
{
    struct place p;
    struct walk *w = &p.walk;
    bool begun = false;
    if (!place_find(query, a, problem, &p, &begun))
        return false;
    if (p.verdict == DOM_NO_FUEL)
        return place_answer(query, a, problem, &p);
    const long last = (p.verdict == DOM_OK ? CYCLES_MAX : 1) * (long)p.count - 1,
               from = (w->cycle - 1) * (long)p.count + w->event;
    /* A new walk begins at the launch of the first cycle. Going there counts as the first step forward. A
     * step back from between two events goes to the first of them. */
    const long to = from + steps - (steps > 0 && begun) + (steps < 0 && w->is_between);
    const long at = to < 0 ? 0 : to > last ? last : to;
    bool is_answered = steps == 0 || begun || at != from || (steps < 0 && w->is_between), done = true;
    if (place) {
        done = is_answered = walk_to(query, problem, &p, *place);
    } else if (steps != 0 && is_answered) {
        w->cycle = (int)(at / p.count) + 1;
        w->event = (int)(at % p.count);
        w->theta = p.event[w->event].theta;
        w->is_between = false;
    }
    done = (!is_answered || place_answer(query, a, problem, &p)) && done;
    if (done && to < 0)
        done = problem_no_answer(problem,
                                 "this is the launch of the first cycle; 'step' goes to the next event");
    else if (done && to > last && p.verdict == DOM_STOPS)
        done = problem_no_answer(
            problem, "the train has stopped; 'why' explains it, and 'step to start' begins again");
    else if (done && to > last)
        done = problem_no_answer(
            problem, "the steps end after %d cycles; enter 'step to start' or 'step back'", CYCLES_MAX);
    /* The walk is saved even if a problem is reported, for example that the walk has ended. */
    if (query->next)
        *query->walk = *w;
    return done;
}

static long steps_of(const struct query *query)
{
    return query->given->count > 0 ? (long)query->given->number[0] : 1;
}

static bool run_step(const struct query *query, struct answer *a, struct problem *problem)
{
    return walk_go(query, a, problem, steps_of(query), NULL);
}

static bool run_back(const struct query *query, struct answer *a, struct problem *problem)
{
    return walk_go(query, a, problem, -steps_of(query), NULL);
}

static bool run_where(const struct query *query, struct answer *a, struct problem *problem)
{
    return walk_go(query, a, problem, 0, NULL);
}

static bool run_goto(const struct query *query, struct answer *a, struct problem *problem)
{
    return walk_go(query, a, problem, 0, &query->given->number[0]);
}

static const char *event_names(const void *context, int k)
{
    (void)context;
    return k <= DOM_EVENT_HIT ? dom_event_text((enum dom_event_kind)k) : k == EVENT_START ? "start" : NULL;
}

#define WALK_COMMAND                                                                                         \
    TRAIN_COMMAND, .in_joules = scene_has_mass, .brief = "theta t omega kinetic", .columns = walk_columns

const struct command walk_commands[] = {
    {.name = "step",
     WALK_COMMAND,
     .synonyms = "next walk forward",
     .argument = {{.name = "N", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "go to the next event, and explain what happens there",
     .equation = "(2; a2) (21; c3) (22; c4) (24; c6) (25; c7) (26; c8) (41; A17)",
     .help = "The first 'step' goes to the launch of the first cycle. The hit begins the next cycle, whose "
             "dominoes are larger and fall more slowly. 'details' shows the energy balance: before - lost "
             "+ gained = kinetic. With losses in motion, 'rubbed' is subtracted as well.",
     .example = "step; step",
     .see = "cycle why",
     .run = run_step},
    {.name = "back",
     WALK_COMMAND,
     .typed.phrase = "step back",
     .synonyms = "undo previous walk",
     .argument = {{.name = "N", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "go back to the previous event",
     .example = "step 2; step back",
     .see = "step",
     .run = run_back},
    {.name = "goto",
     WALK_COMMAND,
     .typed.phrase = "step to",
     .synonyms = "jump walk",
     .argument = {{.name = "PLACE", .kind = ARGUMENT_PLACE, .noun = "event", .choices = event_names}},
     .summary = "go to a tilt, or to the launch, top, fall, stop, hit or start",
     .help = "'start' is the launch of the first cycle, 'launch' that of the current one.",
     .example = "step to 0.3",
     .see = "step cycle",
     .run = run_goto},
    {.name = "where",
     WALK_COMMAND,
     .typed.phrase = "step where",
     .synonyms = "position walk",
     .summary = "show the current step again",
     .example = "step where",
     .see = "step",
     .principal = "theta",
     .run = run_where},
    {.name = "why",
     .in_joules = scene_has_mass,
     TRAIN_COMMAND,
     .synonyms = "reason explain stop",
     .summary = "why the train keeps falling or stops",
     .equation = "(24; c6) (25; c7) (26; c8)",
     .example = "why",
     .see = "barrier rmax step",
     .principal = "margin",
     .brief = "kinetic barrier",
     ANSWER(why)},
    {.name = NULL},
};
