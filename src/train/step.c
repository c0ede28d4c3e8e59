/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'cycle', 'step', 'back', 'goto' and 'where'. The command 'why' is in why.c. */
#include "language/quad.h"
#include "train/train.h"

/* ---- cycle ---- */

static const struct column cycle_columns[] = {
    {"event", "", "launch, fall, top, stop or hit: see 'step'", 6},
    {"t", "s", "time since the launch", 0},
    {"theta", "rad", "tilt of the head", 7},
    {"theta_1", "rad", "tilt of the first follower (12; b8)", 7},
    {"theta_2", "rad", "tilt of the second follower", 7},
    {"omega", "rad/s", "angular velocity of the head (21; c3)", 0},
    {"kinetic", "mgh/2", "kinetic energy of the train", 0},
    {"potential", "mgh/2", "potential energy of the train, H(theta) - H(0)", 0},
    {NULL, NULL, NULL, 0},
};

/* A callback of any_chain_walk, which stores the tilts of the head and of its first two followers. */
static bool follower_add(const struct domq_link *k, void *context)
{
    domq_real *theta = context;
    theta[k->i] = k->theta;
    return k->i < 2;
}

/* Four digits, for a narrow column. */
static struct cell cell_angle(domq_real theta)
{
    struct cell cell = cell_real(theta);
    cell.digits = 4;
    return cell;
}

struct cycle_table {
    const struct query *query;
    struct answer *answer;
    struct domq_angles angles;
    struct domq_state last;
    enum dom_status status;
};

static bool cycle_row(const struct domq_state *s, const struct domq_event *event, void *context)
{
    struct cycle_table *table = context;
    const struct query *query = table->query;
    struct walk_units u = walk_units(query, 1);
    /* any_chain_walk does not visit detached dominoes, which rest at theta_f. */
    domq_real theta[] = {s->theta, table->angles.theta_f, table->angles.theta_f};
    table->status =
        any_chain_walk(&query->scene->train, &query->scene->compute, s->theta, follower_add, theta);
    if (table->status != DOM_OK)
        return false;
    answer_cells(table->answer, cell_word(event ? dom_event_text(event->kind) : ""),
                 cell_computed(s->time * u.tau), cell_angle(s->theta), cell_angle(theta[1]),
                 cell_angle(theta[2]), cell_omega(s->omegasq, u.tau), cell_computed(s->kinetic * u.energy),
                 cell_computed(s->climbed * u.energy));
    table->last = *s;
    return !answer_lost(table->answer);
}

static const char *cycle_by(const void *context, int k)
{
    static const char *const names[] = {[DOM_BY_TIME] = "time", [DOM_BY_TILT] = "tilt", NULL};
    (void)context;
    return names[k];
}

static bool run_cycle(const struct query *query, struct answer *a, struct problem *problem)
{
    struct cycle_table table = {.query = query, .answer = a};
    size_t rows = query->given->count > 0 ? (size_t)query->given->number[0] : 12;
    enum dom_spacing by = query->given->count > 1 ? (enum dom_spacing)query->given->number[1] : DOM_BY_TIME;
    walk_columns_in(query, a);
    enum dom_status verdict = any_angles_find(&query->scene->train, &query->scene->compute, &table.angles);
    if (verdict == DOM_OK)
        verdict = any_cycle_walk(&query->scene->train, query_compute(query), rows, by, cycle_row, &table);
    if (verdict == DOM_NO_FUEL)
        return answer_row(a, (const struct cell[ANSWER_COLUMNS]){cell_word("")}, walk_no_start);
    if (table.status != DOM_OK || (verdict != DOM_OK && verdict != DOM_STOPS))
        return query_status(query, problem, table.status != DOM_OK ? table.status : verdict);
    if (domq_law(&query->scene->train)->dissipates)
        answer_detail(a, "Energy lost to %s since the launch: %.4g %s.", losses_of(&query->scene->train),
                      (double)(table.last.friction_work * walk_units(query, 1).energy),
                      walk_units(query, 1).energy_unit);
    if (verdict == DOM_STOPS)
        answer_say(a,
                   "The train stops, because it has too little energy to keep falling; 'why' explains it.");
    return true;
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
    /* The sentences print six digits, which have to be right whatever the session's tolerance. */
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
    struct domq_state s;
    if (!domq_law(&w->train)->dissipates)
        answer_leave_out(a, "rubbed");
    if (w->verdict == DOM_NO_FUEL)
        return answer_row(a, (const struct cell[ANSWER_COLUMNS]){{.kind = CELL_NONE}}, walk_no_start);
    if (!query_status(query, problem, any_cycle_state(&w->train, &w->compute, w->theta, &s)))
        return false;
    struct walk_units u = walk_units(query, w->cycle);
    walk_say(query, w, &s, a);
    walk_columns_in(query, a);
    answer_cells(a, cell_count(w->cycle), cell_word(dom_event_text(w->events[w->event].kind)),
                 cell_real(s.theta), cell_computed(s.time * u.tau), cell_omega(s.omegasq, u.tau),
                 cell_computed(s.before * u.energy), cell_computed(s.lost * u.energy),
                 cell_computed((0 - s.climbed) * u.energy), cell_computed((0 - s.fallen) * u.energy),
                 cell_computed(s.kinetic * u.energy), cell_computed(s.climbed * u.energy),
                 cell_computed(s.friction_work * u.energy));
    if (w->cycle > 1 && !(scene_mass(query->scene) > 0))
        answer_detail(a, "Energies are in mgh/2 of the first head; 'set mass' gives them in J.");
    domq_real open = s.before - s.lost - s.climbed - s.friction_work - s.kinetic;
    if (quad(fabs)(open) > 100 * w->compute.tol * (s.before + quad(fabs)(s.climbed)))
        answer_say(a,
                   "The energies are out of balance by %.4g %s, because the paper's closed form of "
                   "the fuel does not follow from the energy balance.",
                   (double)(open * u.energy), u.energy_unit);
    return true;
}

/* ---- Moving ---- */

/* Moves to the next event or, if `forward` is false, to the last event before the current position. Returns
 * false if there is no such event. */
static bool walk_step(struct walk *w, bool forward)
{
    const bool is_between = w->theta > w->events[w->event].theta;
    const int cycles = w->verdict == DOM_OK ? CYCLES_MAX : 1, at = (w->cycle - 1) * w->count + w->event +
                                                                   (forward      ? 1
                                                                    : is_between ? 0
                                                                                 : -1);
    if (at < 0 || at >= cycles * w->count)
        return false;
    w->cycle = at / w->count + 1;
    w->event = at % w->count;
    w->theta = w->events[w->event].theta;
    return true;
}

/* Sets *problem to the reason why the walk cannot move farther in this direction. Always returns false. */
static bool walk_ended(const struct walk *w, struct problem *problem, bool forward)
{
    if (!forward)
        return problem_no_answer(problem,
                                 "this is the launch of the first cycle; 'step' goes to the next event");
    if (w->verdict == DOM_STOPS)
        return problem_no_answer(
            problem, "the train has stopped; 'why' explains it, and 'step to start' begins again");
    return problem_no_answer(problem, "the steps end after %d cycles; enter 'step to start' or 'step back'",
                             CYCLES_MAX);
}

/* Moves by the number of steps in the arguments. If the walk ends earlier, prints an answer for the steps
 * made, and then reports why it ended. */
static bool walk_by(const struct query *query, struct answer *a, struct problem *problem, struct walk *w,
                    bool begun, bool forward)
{
    long steps = query->given->count > 0 ? (long)query->given->number[0] : 1;
    bool moved = begun, goes_on = true;
    /* A new walk begins at the launch of the first cycle. Going there counts as the first step forward. */
    for (steps -= begun && forward; goes_on && steps > 0; steps--) {
        goes_on = walk_step(w, forward);
        moved = moved || goes_on;
    }
    return (!(moved || goes_on) || walk_answer(query, a, problem, w)) &&
           (goes_on || walk_ended(w, problem, forward));
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
                                 : walk_by(query, a, problem, &walk, begun, move == MOVE_STEP);
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
    {.name = "cycle",
     .in_joules = scene_has_mass,
     TRAIN_COMMAND,
     .synonyms = "table time trace",
     .argument = {{.name = "N", .kind = ARGUMENT_COUNT, .optional = true},
                  {.name = "BY",
                   .kind = ARGUMENT_CHOICE,
                   .noun = "way to space rows",
                   .choices = cycle_by,
                   .optional = true}},
     .summary = "a table of one cycle, in N equal steps of time or tilt",
     .equation = "(12; b8) (21; c3)",
     .help = "By default N is 12. BY is 'time', which is the default, or 'tilt'. The table also has a line "
             "for each event. Energies are in J if 'mass' or 'density' is set.",
     .example = "cycle 5 tilt",
     .see = "step omega duration",
     .rows = true,
     .brief = "*",
     ANSWER(cycle)},
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
