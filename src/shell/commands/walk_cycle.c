/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command cycle, which prints one cycle of the train as a table. */
#include "commands/tables.h"
#include "commands/walk.h"

const struct column cycle_columns[] = {
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

/* The tilts of the head and its first two followers. */
struct followers {
    domq_real theta[3];
};

static bool follower_add(const struct domq_link *k, void *context)
{
    struct followers *f = context;
    f->theta[k->i] = k->theta;
    return k->i < 2;
}

/* Returns a cell with an angle in four digits, for a narrow column. */
static struct cell cell_angle(domq_real theta)
{
    struct cell cell = cell_real(theta);
    cell.digits = 4;
    return cell;
}

/* The context of the callback cycle_row. */
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
    /* domq_chain_walk stops at the first domino that has detached. Detached dominoes lie at theta_f. */
    struct followers f = {{s->theta, table->angles.theta_f, table->angles.theta_f}};
    table->status = domq_chain_walk(&query->scene->train, &query->scene->compute, s->theta, follower_add, &f);
    if (table->status != DOM_OK)
        return false;
    answer_cells(table->answer, cell_word(event ? dom_event_text(event->kind) : ""),
                 CELL_TIMES(*s, time, u.tau), cell_angle(s->theta), cell_angle(f.theta[1]),
                 cell_angle(f.theta[2]), cell_omega(s->omegasq, s->error.omegasq, u.tau),
                 CELL_TIMES(*s, kinetic, u.energy), CELL_TIMES(*s, climbed, u.energy));
    table->last = *s;
    return !answer_lost(table->answer);
}

const char *cycle_by(const void *context, int k)
{
    static const char *const names[] = {[DOM_BY_TIME] = "time", [DOM_BY_TILT] = "tilt", NULL};
    (void)context;
    return names[k];
}

bool run_cycle(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct domq_compute compute = query_compute(query);
    struct cycle_table table = {.query = query, .answer = a};
    size_t rows = query->given->count > 0 ? (size_t)query->given->number[0] : 12;
    enum dom_spacing by = query->given->count > 1 ? (enum dom_spacing)query->given->number[1] : DOM_BY_TIME;
    walk_columns_in(query, a);
    enum dom_status verdict = domq_angles_find(&query->scene->train, &query->scene->compute, &table.angles);
    if (verdict == DOM_OK)
        verdict = domq_cycle_walk(&query->scene->train, &compute, rows, by, cycle_row, &table);
    if (verdict == DOM_NO_FUEL) {
        struct cell none = cell_real(DOMQ_NAN);
        answer_row(a, ROW(cell_word(""), none, none, none, none, none, none, none), walk_no_start);
        return true;
    }
    if (table.status != DOM_OK || (verdict != DOM_OK && verdict != DOM_STOPS))
        return problem_status(problem, query->scene, table.status != DOM_OK ? table.status : verdict);
    if (domq_law(&query->scene->train)->dissipates)
        answer_say(a, "Friction between dominoes has dissipated %.4g %s since the launch.",
                   (double)(table.last.friction_work * walk_units(query, 1).energy),
                   walk_units(query, 1).energy_unit);
    struct domq_least_force contact;
    if (answer_for_people(a) &&
        domq_cycle_least_force(&query->scene->train, &query->scene->compute, &contact) == DOM_OK &&
        isfinite(contact.force))
        answer_say(a, "The smallest contact force is %s times the weight of the domino that it pushes%s.",
                   measured(contact.force, "", 4).text,
                   contact.force > 0 ? ": the dominoes stay in contact" : "");
    if (verdict == DOM_STOPS)
        answer_say(a,
                   "The train stops, because it has too little energy to keep falling; 'why' explains it.");
    return true;
}
