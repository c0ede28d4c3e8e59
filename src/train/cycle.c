/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands about one cycle of the train, from one collision to the next. */
#include "language/quad.h"
#include "session/parameters.h"
#include "train/train.h"
#include <ctype.h>

static const struct column thetac_columns[] = {
    {"theta_c", "rad", "the head hits the next domino (2; a2)", 0},
    {"theta_u", "rad", "a single domino just tips over (4; b1)", 0},
    {"theta_inf", "rad", "followers far behind the head (40; A16)", 0},
    {"theta_f", "rad", "the largest tilt of a follower: (42; A18) if it detaches, otherwise theta_inf", 0},
    {"theta_leave", "rad", "tilt of a domino when its follower detaches", 0},
    {"detaches", "", "whether followers become too short to lean on their leaders, and detach (41; A17)", 9},
    {NULL, NULL, NULL, 0},
};

static bool run_thetac(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_angles angles;
    if (!query_status(query, problem, any_angles_find(&query->scene->train, query_compute(query), &angles)))
        return false;
    if (angles.detaches) /* only then is theta_f another angle than theta_inf */
        a->details.brief = "*";
    return answer_cells(a, cell_computed(angles.theta_c), cell_computed(angles.theta_u),
                        cell_computed(angles.theta_inf), cell_computed(angles.theta_f),
                        cell_computed(angles.theta_leave), cell_flag(angles.detaches));
}

static const struct column theta1_columns[] = {
    {"theta", "rad", "tilt of the head", 0},
    {"theta_1", "rad", "tilt of the first follower (12; b8)", 0},
    {"slope", "", "d theta_1 / d theta = a / b (14; b10)", 0},
    {"arm_a", "h", "lever arm of the contact force on the head", 0},
    {"arm_b", "h", "lever arm of the contact force on the first follower", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_theta1(const struct query *query, struct answer *a, struct problem *problem)
{
    domq_real theta = query->given->number[0];
    struct domq_contact c;
    if (!query_status(query, problem,
                      any_contact_find(&query->scene->train, query_compute(query), theta, &c)))
        return false;
    const char *why =
        isnan(c.arm_a) ? "the lever arms have no value because the follower has detached; its tilt is theta_f"
                       : NULL;
    return answer_row(a,
                      ROW(cell_real(theta), cell_computed(c.theta_1), cell_computed(c.slope),
                          cell_computed(c.arm_a), cell_computed(c.arm_b)),
                      why);
}

static const struct column chain_columns[] = {
    {"i", "", "number of the domino; 0 is the head", 5},
    {"theta_i", "rad", "tilt of this domino (27; A2)", 0},
    {"slope_i", "", "d theta_i / d theta (33; A9)", 0},
    {"arm_a", "h", "lever arm of the force from this domino's follower", 0},
    {"arm_b", "h", "lever arm of the reaction force on the follower", 0},
    {"weight", "", "r^(-q i), the weight of this domino in the energy (19; c1)", 0},
    {NULL, NULL, NULL, 0},
};

static bool chain_row(const struct domq_link *k, void *context)
{
    answer_cells(context, cell_count((domq_real)k->i), cell_computed(k->theta), cell_computed(k->slope),
                 cell_computed(k->arm_a), cell_computed(k->arm_b), cell_computed(k->weight));
    return !answer_lost(context);
}

static bool run_chain(const struct query *query, struct answer *a, struct problem *problem)
{
    domq_real theta = query->given->number[0];
    enum dom_status status = any_chain_walk(&query->scene->train, query_compute(query), theta, chain_row, a);
    return query_status(query, problem, status);
}

static const struct column energy_columns[] = {
    {"theta", "rad", "tilt of the head", 0},
    {"dH", "mgh/2", "potential energy of the train, H(theta) - H(0) (19; c1)", 0},
    {"J", "", "inertia: kinetic energy = J tau^2 omega^2 (20; c2)", 0},
    {"J0", "", "inertia at theta = 0 (50; d8, corrected)", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_energy(const struct query *query, struct answer *a, struct problem *problem)
{
    domq_real theta = query->given->number[0];
    struct domq_energy e;
    if (!query_status(query, problem, any_energy_find(&query->scene->train, query_compute(query), theta, &e)))
        return false;
    return answer_cells(a, cell_real(theta), cell_computed(e.dH), cell_computed(e.J), cell_computed(e.J0));
}

static const struct column fuel_columns[] = {
    {"fuel", "mgh/2", "P by the formula that 'set fuel' chooses, minus the energy lost in the cycle", 0},
    {"fuel_exact", "mgh/2", "P from the energy balance over one cycle", 0},
    {"fuel_paper", "mgh/2", "the paper's closed form, 1 - cos theta_f - d sin theta_f (25; c7)", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_fuel(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_fuels f;
    enum dom_status status = any_fuel_find(&query->scene->train, query_compute(query), &f);
    if (status != DOM_OK)
        return query_status(query, problem, status);
    const bool has_paper = query->scene->train.rho == 0 && query->scene->train.alpha == 0;
    struct cell exact = cell_computed(f.exact),
                paper = has_paper ? cell_computed(f.paper) : cell_real(DOMQ_NAN);
    struct cell used = query->scene->train.fuel == DOM_FUEL_PAPER ? paper : exact;
    struct domq_launch launch;
    if (domq_dissipates(&query->scene->train)) {
        status = any_launch_find(&query->scene->train, &query->scene->compute, &launch);
        if (status != DOM_OK && status != DOM_NO_FUEL)
            return query_status(query, problem, status);
        used = cell_computed(launch.fuel);
    }
    const char *reason = has_paper ? NULL
                                   : "fuel_paper has no value: the paper's closed form is for sharp edges on "
                                     "a level floor";
    return answer_row(a, ROW(used, exact, paper), used.number > 0 ? reason : verdict_reason(DOM_NO_FUEL));
}

/* If the status is a verdict, there is still an answer, and *why is the reason for its missing numbers. For
 * every other status, *why is NULL. Returns false, and sets *problem, if there is no answer. */
static bool missing_explain(const struct query *query, enum dom_status status, struct problem *problem,
                            const char **why)
{
    const bool is_verdict = status == DOM_NO_FUEL || status == DOM_STOPS || status == DOM_LOCKS;
    *why = is_verdict ? verdict_reason(status) : NULL;
    return is_verdict || query_status(query, problem, status);
}

struct cell cell_omega(domq_real omegasq, domq_real tau)
{
    return cell_computed(quad(sqrt)(omegasq) / tau);
}

static const struct column launch_columns[] = {
    {"omega0sq", "", "tau^2 omega(0)^2 after the collision (24; c6)", 0},
    {"omega0", "rad/s", "omega(0), angular velocity of the head", 0},
    {"kinetic", "mgh/2", "kinetic energy, J(0) tau^2 omega(0)^2", 0},
    {"J0", "", "inertia of the train, J(0) (50; d8, corrected)", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_launch(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_launch l = {.J0 = DOMQ_NAN, .omegasq = DOMQ_NAN, .kinetic = DOMQ_NAN};
    const char *why;
    enum dom_status status = any_launch_find(&query->scene->train, query_compute(query), &l);
    if (!missing_explain(query, status, problem, &why))
        return false;
    domq_real tau = domq_scale_tau(&query->scene->scale, &query->scene->train);
    return answer_row(a,
                      ROW(cell_computed(l.omegasq), cell_omega(l.omegasq, tau), cell_computed(l.kinetic),
                          cell_computed(l.J0)),
                      why);
}

static const struct column omega_columns[] = {
    {"theta", "rad", "tilt of the head", 0},
    {"omegasq", "", "tau^2 omega(theta)^2 (21; c3)", 0},
    {"omega", "rad/s", "omega(theta), angular velocity of the head", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_omega(const struct query *query, struct answer *a, struct problem *problem)
{
    domq_real theta = query->given->number[0];
    domq_real omegasq;
    const char *why;
    enum dom_status status = any_cycle_omegasq(&query->scene->train, query_compute(query), theta, &omegasq);
    if (!missing_explain(query, status, problem, &why))
        return false;
    domq_real tau = domq_scale_tau(&query->scene->scale, &query->scene->train);
    return answer_row(a, ROW(cell_real(theta), cell_computed(omegasq), cell_omega(omegasq, tau)), why);
}

static const struct column barrier_columns[] = {
    {"theta_m", "rad", "tilt of the head at the top of the barrier", 0},
    {"barrier", "mgh/2", "the energy that the train needs (26; c8)", 0},
    {"kinetic", "mgh/2", "the energy that the train has (24; c6)", 0},
    {"margin", "mgh/2", "kinetic - barrier; not negative if the train keeps falling (26; c8, corrected)", 0},
    {"verdict", "", "'goes on', 'stops', 'locks' (by friction) or 'no fuel' (no energy is released)", 7},
    {NULL, NULL, NULL, 0},
};

static bool run_barrier(const struct query *query, struct answer *a, struct problem *problem)
{
    struct domq_barrier b = {
        .theta_m = DOMQ_NAN, .barrier = DOMQ_NAN, .kinetic = DOMQ_NAN, .margin = DOMQ_NAN};
    const char *why;
    enum dom_status status = any_barrier_find(&query->scene->train, query_compute(query), &b);
    if (!missing_explain(query, status, problem, &why))
        return false;
    answer_set_verdict(a, status == DOM_OK);
    verdict_train_say(query, a, status, &b);
    const bool good = answer_row(a,
                                 ROW(cell_computed(b.theta_m), cell_computed(b.barrier),
                                     cell_computed(b.kinetic), cell_computed(b.margin), verdict_cell(status)),
                                 answer_for_people(a) ? NULL : why);
    if (why && *why)
        answer_detail(a, "%c%s.", toupper((unsigned char)*why), why + 1);
    return good;
}

static const struct column duration_columns[] = {
    {"duration", "tau", "t_f / tau, from one collision to the next", 0},
    {"tau", "s", "unit of time (1; a1); for a solid block sqrt((h^2+d^2)/(3gh))", 0},
    {"seconds", "s", "t_f in seconds; the next cycle takes sqrt(r) times as long", 0},
    {"speed", "m/s", "speed at which the front advances in this cycle, (s+d) r h / t_f", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_duration(const struct query *query, struct answer *a, struct problem *problem)
{
    domq_real duration = DOMQ_NAN;
    domq_real tau = domq_scale_tau(&query->scene->scale, &query->scene->train);
    const char *why;
    enum dom_status status = any_cycle_duration(&query->scene->train, query_compute(query), &duration);
    if (!missing_explain(query, status, problem, &why))
        return false;
    domq_real speed = why ? DOMQ_NAN : domq_scale_speed(&query->scene->scale, &query->scene->train, duration);
    return answer_row(
        a, ROW(cell_computed(duration), cell_real(tau), cell_computed(duration * tau), cell_computed(speed)),
        why);
}

/* ---- The table of a cycle ---- */

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

struct cycle_table {
    const struct query *query;
    struct answer *answer;
    struct domq_angles angles;
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
                 cell_computed(s->time * u.tau), cell_narrow(s->theta, 4), cell_narrow(theta[1], 4),
                 cell_narrow(theta[2], 4), cell_omega(s->omegasq, u.tau),
                 cell_computed(s->kinetic * u.energy), cell_computed(s->climbed * u.energy));
    return !answer_lost(table->answer);
}

static const char *cycle_by(const void *context, int k)
{
    (void)context;
    return k == DOM_BY_TIME ? "time" : k == DOM_BY_TILT ? "tilt" : NULL;
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
        return answer_row(a, (const struct cell[ANSWER_COLUMNS]){cell_word("")}, verdict_reason(verdict));
    if (table.status != DOM_OK || (verdict != DOM_OK && verdict != DOM_STOPS))
        return query_status(query, problem, table.status != DOM_OK ? table.status : verdict);
    if (verdict == DOM_STOPS)
        answer_say(a,
                   "The train stops, because it has too little energy to keep falling; 'why' explains it.");
    return true;
}

#define TILT .name = "T", .kind = ARGUMENT_TILT

const struct command cycle_commands[] = {
    {.name = "thetac",
     TRAIN_COMMAND,
     .synonyms = "angles tip tipping collision",
     .summary = "the tilts at which a cycle begins, changes and ends",
     .equation = "(2; a2) (4; b1) (40; A16) (41; A17) (42; A18)",
     .example = "thetac",
     .see = "theta1 chain",
     .principal = "theta_c",
     .brief = "theta_c theta_u theta_inf",
     ANSWER(thetac)},
    {.name = "theta1",
     TRAIN_COMMAND,
     .synonyms = "lean contact",
     .argument = {{TILT}},
     .summary = "how the first follower leans on the head at tilt T",
     .equation = "(12; b8) (14; b10)",
     .example = "theta1 10 deg",
     .see = "thetac chain",
     .principal = "theta_1",
     ANSWER(theta1)},
    {.name = "chain",
     TRAIN_COMMAND,
     .synonyms = "profile shape lean",
     .argument = {{TILT}},
     .summary = "the tilts of the followers behind a head with tilt T",
     .equation = "(27; A2) (31; A6) (33; A9)",
     .help = "The number of dominoes in the list depends on the tolerance: see 'help tol'.",
     .example = "set tol 1e-3; chain 0.1",
     .see = "theta1 energy",
     .rows = true,
     ANSWER(chain)},
    {.name = "energy",
     TRAIN_COMMAND,
     .synonyms = "height weight",
     .argument = {{TILT}},
     .summary = "potential energy and inertia of the train at tilt T",
     .equation = "(19; c1) (20; c2) (50; d8)",
     .example = "energy 0.1",
     .see = "barrier omega",
     .principal = "dH",
     ANSWER(energy)},
    {.name = "fuel",
     TRAIN_COMMAND,
     .synonyms = "energy",
     .summary = "the energy that one cycle releases",
     .equation = "(25; c7)",
     .help = "The paper gives two formulas for the fuel (25; c7). The first is a sum over the train, which "
             "follows from the energy balance. The second is a closed form, which the paper uses for its "
             "figures. It leaves out the weights r^(-q i) and is right only for r = 1. After 'set fuel "
             "paper' the program computes with the closed form.",
     .example = "fuel",
     .see = "launch rmax",
     .principal = "fuel",
     ANSWER(fuel)},
    {.name = "launch",
     TRAIN_COMMAND,
     .synonyms = "impact hit start",
     .summary = "the speed and energy with which a cycle begins, after the collision",
     .equation = "(22; c4) (23; c5) (24; c6)",
     .example = "launch",
     .see = "fuel barrier",
     .principal = "omega0sq",
     ANSWER(launch)},
    {.name = "omega",
     TRAIN_COMMAND,
     .synonyms = "speed velocity fast",
     .argument = {{TILT}},
     .summary = "angular velocity of the head at tilt T",
     .equation = "(21; c3)",
     .example = "omega 0.1",
     .see = "launch duration",
     .principal = "omega",
     ANSWER(omega)},
    {.name = "barrier",
     TRAIN_COMMAND,
     .synonyms = "stop tip tipping topple climb energy",
     .summary = "the energy that the train needs, and whether it has enough",
     .equation = "(26; c8)",
     .help =
         "Without friction, the barrier is the largest rise of the train's potential energy in the whole "
         "cycle, H(theta) - H(0). Near r s = 1 the potential energy may decrease at first, and rise later, "
         "when the head's follower has detached. With friction, the barrier is the kinetic energy that "
         "the train needs just after the collision.",
     .example = "barrier",
     .see = "launch rmax",
     .principal = "barrier",
     .holds = "the train keeps falling",
     .brief = "kinetic barrier",
     ANSWER(barrier)},
    {.name = "duration",
     TRAIN_COMMAND,
     .synonyms = "time fast velocity seconds",
     .summary = "how long a cycle takes, and how fast the front advances",
     .equation = "(1; a1) (21; c3)",
     .help =
         "Times in seconds are for solid blocks, unless the effect 'walls' is on. A hollow box has a larger "
         "moment of inertia and falls more slowly: see 'help walls'.",
     .example = "duration",
     .see = "omega",
     .principal = "duration",
     ANSWER(duration)},
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
    {.name = NULL},
};
