/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A walk through the cycles of the train, event by event: step, back, goto and where. */
#include "language/quad.h"
#include "train/train.h"
#include <string.h>

/* Returns true if the train has not changed since the walk began. */
static bool walk_is_of(const struct walk *walk, const struct scene *scene)
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

/* ---- In words ---- */

/* Prints what happens at the event that the walk has reached, and between two events how the train moves. */
static void event_say(const struct query *query, struct answer *a, const struct walk *w,
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
    const struct domq_event *e = &w->events[w->event];
    char what[240] = "the top of the barrier; from here on the train gains energy";
    if (w->theta != e->theta) {
        answer_say(a, "Cycle %d, between the %s and the %s: the train %s.", w->cycle, dom_event_text(e->kind),
                   dom_event_text(e[1].kind), s->acceleration < 0 ? "slows down" : "gathers speed");
        return;
    }
    if (e->kind == DOM_EVENT_LAUNCH)
        snprintf(what, sizeof what, "domino 1 hits the head, which is %s tall, and all move as one train",
                 measured(walk_units(query, w->cycle).height, "m", 6).text);
    else if (e->kind == DOM_EVENT_DETACH)
        snprintf(what, sizeof what, "domino %zu detaches from domino %zu and comes to rest", e->domino,
                 e->domino - 1);
    else if (e->kind == DOM_EVENT_STOP)
        snprintf(what, sizeof what, "the train stops below the top of its barrier; 'why' explains it");
    else if (e->kind == DOM_EVENT_HIT)
        snprintf(what, sizeof what,
                 "the head hits the next domino, which is %s tall; 'step' begins its cycle",
                 measured(walk_units(query, w->cycle + 1).height, "m", 6).text);
    answer_say(a, "Cycle %d, event %d of %d: %s.", w->cycle, w->event + 1, w->count, what);
    answer_detail(a, "%s", detail[e->kind]);
}

/* Prints the energies of the cycle as a sum: before - lost + gained - rubbed = kinetic. The loss is written
 * so that the sum of the printed numbers is exact. */
static void ledger_say(struct answer *a, const struct walk *w, const struct domq_state *s,
                       const struct walk_units *u)
{
    const domq_real open = s->before - s->lost - s->climbed - s->friction_work - s->kinetic;
    if (quad(fabs)(open) > 100 * w->compute.tol * (s->before + quad(fabs)(s->climbed))) {
        answer_say(a,
                   "The energies are out of balance by %.4g %s, because the paper's closed form of "
                   "the fuel does not follow from the energy balance.",
                   (double)(open * u->energy), u->energy_unit);
        return;
    }
    const double unit = (double)u->energy, before = (double)s->before * unit;
    const int decimals = (int)fmax(0, 4 - floor(log10(before))); /* five digits of the first number */
    const double step = pow(10, decimals), gained = round(-(double)s->climbed * unit * step) / step,
                 rubbed = round((double)s->friction_work * unit * step) / step,
                 kinetic = round((double)s->kinetic * unit * step) / step;
    if (!(before > 0) || decimals > 15)
        return;
    char change[64] = "", loss[64] = "";
    if (gained != 0)
        snprintf(change, sizeof change, " %c %.*f", gained < 0 ? '-' : '+', decimals, fabs(gained));
    if (rubbed != 0)
        snprintf(loss, sizeof loss, " - %.*f", decimals, rubbed);
    answer_say(a, "Kinetic energy, before - lost%s%s: %.*f - %.*f%s%s = %.*f %s.",
               gained < 0   ? " - climbed"
               : gained > 0 ? " + gained"
                            : "",
               *loss ? " - rubbed" : "", decimals, before, decimals,
               round(before * step) / step + gained - rubbed - kinetic, change, loss, decimals, kinetic,
               u->energy_unit);
}

/* ---- step, back, goto and where ---- */

enum {
    CYCLES_MAX = 1000,
    EVENT_START = DOM_EVENT_HIT + 1 /* for 'step to start': the launch of the first cycle */
};

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

/* Finds the events of the walk with the options of the query. Begins a new walk, and sets *begun to true,
 * unless the session already has a walk with the present parameters. An event that has been reached stays
 * reached. */
static bool walk_ready(const struct query *query, struct answer *answer, struct problem *problem,
                       struct walk *w, bool *begun)
{
    const struct walk before = *w;
    const bool is_event = w->count > 0 && w->theta == w->events[w->event].theta;
    *begun = !walk_now(query) && !(query->reference && w->count > 0 && walk_is_of(w, query->scene));
    if (*begun && w->count > 0)
        answer_say(answer, "The parameters have changed, so the steps begin again at the launch.");
    if (*begun)
        *w = (struct walk){.cycle = 1};
    w->train = query->scene->train;
    w->compute = query->scene->compute;
    w->tol = w->compute.tol;
    /* The digits of the sentences have to be right whatever the session's tolerance. */
    w->compute.tol =
        quad_smaller(w->tol, quad_larger(any_arithmetic(w->compute.precision).tol_floor, (domq_real)1e-9));
    w->verdict = any_cycle_events(&w->train, &w->compute, w->events, &w->count);
    if (w->verdict != DOM_OK && w->verdict != DOM_STOPS && w->verdict != DOM_NO_FUEL)
        return query_status(query, problem, w->verdict);
    if (!*begun && is_event)
        w->theta = w->events[w->event].theta;
    return *begun || (w->verdict == before.verdict && w->count == before.count);
}

static bool walk_answer(const struct query *query, struct answer *a, struct problem *problem,
                        const struct walk *w)
{
    const struct walk_units units = walk_units(query, w->cycle), *u = &units;
    struct domq_state state, *s = &state;
    if (!domq_dissipates(&w->train))
        answer_leave_out(a, "rubbed");
    if (w->verdict == DOM_NO_FUEL)
        return answer_row(a, (const struct cell[ANSWER_COLUMNS]){{.kind = CELL_NONE}},
                          verdict_reason(w->verdict));
    if (!query_status(query, problem, any_cycle_state(&w->train, &w->compute, w->theta, s)))
        return false;
    event_say(query, a, w, s);
    ledger_say(a, w, s, u);
    walk_columns_in(query, a);
    answer_cells(a, cell_count(w->cycle), cell_word(dom_event_text(w->events[w->event].kind)),
                 cell_real(s->theta), cell_computed(s->time * u->tau), cell_omega(s->omegasq, u->tau),
                 cell_computed(s->before * u->energy), cell_computed(s->lost * u->energy),
                 cell_computed((0 - s->climbed) * u->energy), cell_computed((0 - s->fallen) * u->energy),
                 cell_computed(s->kinetic * u->energy), cell_computed(s->climbed * u->energy),
                 cell_computed(s->friction_work * u->energy));
    return true;
}

/* ---- Moving ---- */

/* Moves by the number of steps in the arguments, backward if `back` is true. If the walk ends earlier, prints
 * an answer for the steps made, and then reports why it ended. */
static bool walk_by(const struct query *query, struct answer *a, struct problem *problem, struct walk *w,
                    bool begun, bool back)
{
    const long steps = query->given->count > 0 ? (long)query->given->number[0] : 1,
               last = (w->verdict == DOM_OK ? CYCLES_MAX : 1) * (long)w->count - 1,
               from = (w->cycle - 1) * (long)w->count + w->event;
    const bool is_between = w->theta > w->events[w->event].theta;
    /* A new walk begins at the launch of the first cycle. Going there counts as the first step forward. */
    const long to = back ? from - steps + is_between : from + steps - begun, at = to < 0      ? 0
                                                                                  : to > last ? last
                                                                                              : to;
    const bool moved = begun || at != from || (back && is_between);
    w->cycle = (int)(at / w->count) + 1;
    w->event = (int)(at % w->count);
    if (moved)
        w->theta = w->events[w->event].theta;
    if (moved && !walk_answer(query, a, problem, w))
        return false;
    if (to < 0)
        return problem_no_answer(problem,
                                 "this is the launch of the first cycle; 'step' goes to the next event");
    if (to > last && w->verdict == DOM_STOPS)
        return problem_no_answer(
            problem, "the train has stopped; 'why' explains it, and 'step to start' begins again");
    return to <= last ||
           problem_no_answer(problem, "the steps end after %d cycles; enter 'step to start' or 'step back'",
                             CYCLES_MAX);
}

/* Moves to the tilt in the first argument. A negative argument -1 - k stands for the event of kind k. */
static bool walk_to(const struct query *query, struct answer *a, struct problem *problem, struct walk *w)
{
    domq_real place = query->given->number[0];
    if (place == -1 - EVENT_START) {
        w->cycle = 1;
        place = -1 - DOM_EVENT_LAUNCH;
    }
    enum dom_event_kind kind = (enum dom_event_kind)(-1 - (int)place);
    int found = -1;
    for (int k = 0; k < w->count; k++)
        if (place < 0 ? w->events[k].kind == kind : w->events[k].theta <= place)
            found = k;
    if (found < 0)
        return problem_no_answer(problem, "there is no '%s' in this cycle; 'cycle' lists its events",
                                 dom_event_text(kind));
    if (place > w->events[w->count - 1].theta)
        return problem_no_answer(problem,
                                 "the train stops before that, at theta = %s; 'step to stop' goes there",
                                 angle_text(query, w->events[w->count - 1].theta, 10).text);
    w->event = found;
    w->theta = place < 0 ? w->events[found].theta : place;
    return walk_answer(query, a, problem, w);
}

enum move { MOVE_STEP, MOVE_BACK, MOVE_GOTO, MOVE_NOT };

static bool walk_move(const struct query *query, struct answer *a, struct problem *problem, enum move move)
{
    struct walk walk = *query->walk;
    bool begun;
    bool done = walk_ready(query, a, problem, &walk, &begun);
    if (done && (move == MOVE_NOT || walk.verdict == DOM_NO_FUEL))
        done = walk_answer(query, a, problem, &walk);
    else if (done)
        done = move == MOVE_GOTO ? walk_to(query, a, problem, &walk)
                                 : walk_by(query, a, problem, &walk, begun, move == MOVE_BACK);
    /* The walk is saved even if a problem is reported, for example that the walk has ended. */
    if (query->next)
        *query->walk = walk;
    return done;
}

static bool run_step(const struct query *query, struct answer *a, struct problem *problem)
{
    return walk_move(query, a, problem, MOVE_STEP);
}

static bool run_back(const struct query *query, struct answer *a, struct problem *problem)
{
    return walk_move(query, a, problem, MOVE_BACK);
}

static bool run_goto(const struct query *query, struct answer *a, struct problem *problem)
{
    return walk_move(query, a, problem, MOVE_GOTO);
}

static bool run_where(const struct query *query, struct answer *a, struct problem *problem)
{
    return walk_move(query, a, problem, MOVE_NOT);
}

static const char *event_names(const void *context, int k)
{
    (void)context;
    return k <= DOM_EVENT_HIT ? dom_event_text((enum dom_event_kind)k) : k == EVENT_START ? "start" : NULL;
}

#define WALK_COMMAND                                                                                         \
    TRAIN_COMMAND, .in_joules = scene_has_mass, .brief = "theta t omega", .columns = walk_columns

const struct command walk_commands[] = {
    {.name = "step",
     WALK_COMMAND,
     .synonyms = "next walk forward",
     .argument = {{.name = "N", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "go to the next event, and explain what happens there",
     .equation = "(2; a2) (21; c3) (22; c4) (24; c6) (25; c7) (26; c8) (41; A17)",
     .help = "The first 'step' goes to the launch of the first cycle. The hit begins the next cycle, whose "
             "dominoes are larger and fall more slowly. The table shows the energy balance: before - lost "
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
