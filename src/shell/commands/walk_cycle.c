/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cycle: one cycle as a table. */
#include "commands/walk.h"
#include "interpreter/command.h"
#include "language/wide.h"
#include <string.h>

const struct column cycle_columns[] = {
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

const char *cycle_by(const void *context, int k)
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

bool cycle_run(struct session *session, const struct call *call)
{
    struct column room[COLUMNS_ROOM];
    struct dom_event events[DOM_EVENTS_MAX];
    int count;
    struct answer *a = call->answer;
    enum dom_status verdict = dom_cycle_events(&session->train, events, &count), status = verdict;
    walk_columns_in(session, a, room);
    if (verdict == DOM_NO_FUEL) {
        struct cell none = cell_real(DOM_NAN);
        answer_row(a, ROW(cell_word(""), none, none, none, none, none, none, none), walk_no_start);
        a->columns = cycle_columns;
        return true;
    }
    if (status == DOM_OK || status == DOM_STOPS)
        status = cycle_rows(session, call, events, count);
    a->columns = cycle_columns;
    if (status != DOM_OK)
        return walk_status(session, status);
    struct dom_state last;
    if (session->train.mu > 0 &&
        dom_cycle_state(&session->train, events[count - 1].theta, &last, NULL) == DOM_OK)
        answer_say(a, "Friction between dominoes has taken %.4g %s since the launch.",
                   (double)(last.rubbed * walk_units(session, 1).energy), walk_units(session, 1).energy_unit);
    struct walk_contact contact;
    if (answer_for_people(a) && walk_contact(&session->train, &contact) == DOM_OK && isfinite(contact.force))
        answer_say(
            a, "Dominoes stay in contact: the smallest contact force is %.4g times the weight of its domino.",
            (double)contact.force);
    if (verdict == DOM_STOPS)
        answer_say(a, "The train stops below its barrier; 'why' says more.");
    return true;
}
