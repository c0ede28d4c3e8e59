/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows chance pictures */
/* Bad parameters: every function that gets a bad parameter returns the status DOM_BAD_... that names it. */
#include "support.h"

static bool returned[DOM_INTERRUPTED + 1];

/* Fails unless the status is the expected one. Records that a function has returned this status. */
#define assert_named(status, expected)                                                                       \
    do {                                                                                                     \
        enum dom_status status_ = (status);                                                                  \
        assert_status(status_, expected);                                                                    \
        returned[status_] = true;                                                                            \
    } while (0)

static bool never_link(const struct dom_link *link, void *context)
{
    (void)link, (void)context;
    fail();
    return false;
}

static bool never_state(const struct dom_state *state, const struct dom_event *event, void *context)
{
    (void)state, (void)event, (void)context;
    fail();
    return false;
}

static bool never_force(const struct dom_force *force, void *context)
{
    (void)force, (void)context;
    fail();
    return false;
}

static bool never_fall(const struct dom_fall *fall, void *context)
{
    (void)fall, (void)context;
    fail();
    return false;
}

/* ---- Every function of a train ---- */

/* Returns true if a function chooses this member itself: the limits choose r, and the best separation also s.
 */
static bool is_chosen(const char *function, const char *member)
{
    return (strncmp(function, "limit_", 6) == 0 && strcmp(member, "r") == 0) ||
           (strcmp(function, "limit_best") == 0 && strcmp(member, "s") == 0);
}

/* Calls every function with a train of which one member is bad. */
static void every_function(const struct dom_train *t, const struct dom_compute *c, const char *member,
                           enum dom_status expected)
{
    struct dom_event events[DOM_EVENTS_MAX];
    int count;
    double number;
    struct dom_floor floor;
#define FIND(name, structure)                                                                                \
    {                                                                                                        \
        struct dom_##structure result;                                                                       \
        if (!is_chosen(#name, member))                                                                       \
            assert_named(dom_##name(t, c, &result), expected);                                               \
    }
#define FIND_AT(name, structure)                                                                             \
    {                                                                                                        \
        struct dom_##structure result;                                                                       \
        assert_named(dom_##name(t, c, 0.1, &result), expected);                                              \
    }
#define NUMBER(name)    assert_named(dom_##name(t, c, &number), expected);
#define NUMBER_AT(name) assert_named(dom_##name(t, c, 0.1, &number), expected);
    DOM_FINDS(FIND)
    DOM_FINDS_AT(FIND_AT)
    DOM_NUMBERS(NUMBER)
    DOM_NUMBERS_AT(NUMBER_AT)
    assert_named(dom_chain_walk(t, c, 0.1, never_link, NULL), expected);
    assert_named(dom_cycle_events(t, c, events, &count), expected);
    assert_named(dom_cycle_walk(t, c, 3, DOM_BY_TIME, never_state, NULL), expected);
    assert_named(dom_cycle_forces(t, c, 0.1, never_force, NULL), expected);
    assert_named(dom_cycle_floor(t, c, &floor), expected);
}

/* Calls every function, and the check of <domino_quad.h>. */
static void refused(const struct dom_train *train, const struct dom_compute *compute, const char *member,
                    enum dom_status expected)
{
    every_function(train, compute, member, expected);
    const struct dom_train *a = train;
    const struct domq_train wide = {.fuel = a->fuel,
                                    DOM_TRAIN_PARAMETERS(SETUP_COPY_NUMBER) DOM_DYNAMICS(SETUP_COPY_EFFECT)};
    const struct any_compute wide_compute = {.tol = compute->tol, .precision = IN_DOUBLE};
    struct domq_angles angles;
    assert_status(any_angles_find(&wide, &wide_compute, &angles), expected);
}

/* Lists numbers outside a range. */
#define OUTSIDE(lowest, highest)                                                                             \
    nextafter(lowest, -(double)INFINITY), nextafter(highest, (double)INFINITY), (double)NAN,                 \
        (double)INFINITY, -(double)INFINITY

#define BAD_s     DOM_BAD_S
#define BAD_r     DOM_BAD_R
#define BAD_d     DOM_BAD_D
#define BAD_q     DOM_BAD_Q
#define BAD_width DOM_BAD_WIDTH
#define BAD_tol   DOM_BAD_TOL

TEST(parameters)
{
    struct dom_train train;
    struct dom_angles angles;
    struct dom_compute compute = dom_compute_default();
#define BAD(owner, name, lowest, highest, expected)                                                          \
    for (int k = 0; k < 5; k++) {                                                                            \
        const double bad[] = {OUTSIDE(lowest, highest)};                                                     \
        train = dom_train_default();                                                                         \
        compute = dom_compute_default();                                                                     \
        owner.name = bad[k];                                                                                 \
        refused(&train, &compute, #name, expected);                                                          \
    }
#define OF_TRAIN(name, default_, lowest, highest, unit, meaning) BAD(train, name, lowest, highest, BAD_##name)
#define OF_COMPUTE(name, default_, lowest, highest, unit, meaning)                                           \
    BAD(compute, name, lowest, highest, BAD_##name)
    DOM_TRAIN_PARAMETERS(OF_TRAIN)
    DOM_COMPUTE_PARAMETERS(OF_COMPUTE)
#define OF_EFFECT(effect, member, status)                                                                    \
    BAD(train, member, dom_effect_##effect.argument[0].lowest, dom_effect_##effect.argument[0].highest,      \
        status)
    DOM_DYNAMICS(OF_EFFECT)
    assert_true(dom_effect_friction.argument[0].highest == DOM_MU_HIGHEST);
#undef BAD
    train = dom_train_default();
    compute = dom_compute_default();
    compute.tol = dom_arithmetic()->tol_floor;
    assert_status(dom_angles_find(&train, &compute, &angles), DOM_OK);
    compute.tol *= 0.999;
    refused(&train, &compute, "tol", DOM_BAD_TOL);
    const struct domq_train wide = domq_train_default();
    struct domq_angles wide_angles;
    for (enum precision p = IN_FLOAT; p <= IN_QUAD; p++)
        if (any_arithmetic(p).bits) {
            struct any_compute of = {.tol = any_arithmetic(p).tol_floor, .precision = p};
            assert_status(any_angles_find(&wide, &of, &wide_angles), DOM_OK);
            of.tol *= 0.999;
            assert_status(any_angles_find(&wide, &of, &wide_angles), DOM_BAD_TOL);
        }
}

TEST(choices)
{
    struct dom_train train = dom_train_default();
    struct dom_compute compute = dom_compute_default();
    train.fuel = (enum dom_fuel)(DOM_FUEL_PAPER + 1);
    refused(&train, &compute, "", DOM_BAD_FUEL);
}

/* Checks that a member of a later version is refused, whatever is asked. */
TEST(members_of_later_versions)
{
    for (int place = 0; place < DOM_LATER; place++) {
        struct dom_train train = dom_train_default();
        struct dom_compute compute = dom_compute_default();
        assert_true(train.later[place] == 0 && compute.later[place] == 0);
        train.later[place] = 1e-9;
        every_function(&train, &compute, "", DOM_NEWER);
        train.later[place] = 0;
        compute.later[place] = 1;
        every_function(&train, &compute, "", DOM_NEWER);
    }
}

/* ---- Tilts and times ---- */

TEST(tilts_and_times)
{
    const struct dom_train t = dom_train_default();
    struct dom_angles angles;
    struct dom_contact contact;
    struct dom_energy energy;
    struct dom_state moving;
    double value;
    assert_status(dom_angles_find(&t, NULL, &angles), DOM_OK);
    const double bad[] = {-1e-300, angles.theta_c * (1 + 1e-14), (double)NAN, (double)INFINITY,
                          -(double)INFINITY};
    for (int k = 0; k < 5; k++) {
        assert_named(dom_contact_find(&t, NULL, bad[k], &contact), DOM_BAD_TILT);
        assert_named(dom_chain_walk(&t, NULL, bad[k], never_link, NULL), DOM_BAD_TILT);
        assert_named(dom_energy_find(&t, NULL, bad[k], &energy), DOM_BAD_TILT);
        assert_named(dom_cycle_omegasq(&t, NULL, bad[k], &value), DOM_BAD_TILT);
        assert_named(dom_cycle_state(&t, NULL, bad[k], &moving), DOM_BAD_TILT);
        assert_named(dom_cycle_forces(&t, NULL, bad[k], never_force, NULL), DOM_BAD_TILT);
    }
    assert_status(dom_energy_find(&t, NULL, angles.theta_c, &energy), DOM_OK);
}

/* ---- Rows ---- */

enum { ROW = 4, BAD_ONE = 2 };

/* A row that falls. A test replaces one number by a bad one. */
struct some_row {
    struct dom_domino domino[ROW];
    struct dom_row row;
};

static void row_make(struct some_row *r)
{
    struct dom_train train = dom_train_default();
    const struct dom_scale scale = dom_scale_default();
    dom_row_of_train(&train, &scale, 1, r->domino, ROW);
    r->row = (struct dom_row){.domino = r->domino, .count = ROW, .g = scale.g, .push = (double)NAN};
}

/* Writes an equal row for each growth. */
static void searches_refused(const struct dom_row *row, const struct dom_compute *compute,
                             enum dom_status expected)
{
    struct dom_window windows[ROW];
    double push = -1;
    assert_named(dom_row_windows(row, compute, DOM_WINDOW_GAP, NULL, NULL, windows), expected);
    assert_named(dom_row_weakest_push(row, compute, 100, &push), expected);
    assert_true(push == -1);
}

static void row_refused(const struct dom_row *row, const struct dom_compute *compute, size_t domino,
                        enum dom_status expected)
{
    struct dom_verdict verdict = {.domino = 99, .seconds = -1};
    struct dom_study study = {.rows = 7};
    struct dom_budget budget = {.sigma = -1};
    const struct dom_placement placement = {.error[DOM_ERROR_gap].size = 1e-3, .seed = 1, .rows = 4};
    assert_named(dom_row_run(row, compute, true, never_fall, NULL, &verdict), expected);
    assert_true(verdict.seconds == -1);
    if (domino)
        assert_int_equal(verdict.domino, domino);
    searches_refused(row, compute, expected);
    if (expected == DOM_BAD_GAP) /* a study changes gaps itself, and replaces negative ones by 0 */
        return;
    assert_named(dom_placement_study(row, compute, &placement, &study, NULL), expected);
    assert_int_equal(study.rows, 7);
    assert_named(dom_placement_budget(row, compute, &placement, DOM_ERROR_gap, 0.5, &budget), expected);
    assert_true(budget.sigma == -1);
}

TEST(rows)
{
    struct some_row r;
    struct dom_compute compute = dom_compute_default();
    const double bad[] = {0, -1, (double)NAN, (double)INFINITY};
    for (int k = 0; k < 4; k++) {
        for (int member = 0; member < 6; member++) {
            static const enum dom_status named[] = {DOM_BAD_HEIGHT, DOM_BAD_THICKNESS, DOM_BAD_MASS,
                                                    DOM_BAD_G,      DOM_BAD_GAP,       DOM_BAD_LEAN};
            row_make(&r);
            struct dom_domino *d = &r.domino[BAD_ONE];
            double *of[] = {&d->height, &d->thickness, &d->mass, &r.row.g, &d->gap, &d->lean};
            *of[member] = bad[k];
            if (member < 4 || bad[k] != 0)
                row_refused(&r.row, &compute, member != 3 ? BAD_ONE + 1 : 0, named[member]);
        }
        row_make(&r);
        r.row.rho = 0.01; /* radii are used only with rounded edges, and 0 stands for the radius of the row */
        r.domino[BAD_ONE].radius = bad[k];
        if (bad[k] != 0)
            row_refused(&r.row, NULL, BAD_ONE + 1, DOM_BAD_RADIUS);
        row_make(&r);
        r.row.push = bad[k];
        if (k == 1 || k == 3)
            row_refused(&r.row, NULL, 0, DOM_BAD_PUSH);
        row_make(&r);
        r.row.release = bad[k];
        if (!(bad[k] >= 0))
            row_refused(&r.row, NULL, 0, DOM_BAD_RELEASE);
        compute.tol = bad[k];
        row_make(&r);
        struct dom_verdict verdict; /* a study accepts a tolerance below 1e-9, and uses 1e-9 */
        assert_named(dom_row_run(&r.row, &compute, true, never_fall, NULL, &verdict), DOM_BAD_TOL);
        searches_refused(&r.row, &compute, DOM_BAD_TOL);
        compute = dom_compute_default();
    }
#define ROW_EFFECT(effect, member, status)                                                                   \
    for (int k = 0; k < 5; k++) {                                                                            \
        const double outside[] = {                                                                           \
            OUTSIDE(dom_effect_##effect.argument[0].lowest, dom_effect_##effect.argument[0].highest)};       \
        row_make(&r);                                                                                        \
        r.row.member = outside[k];                                                                           \
        row_refused(&r.row, NULL, 0, status);                                                                \
    }
    DOM_DYNAMICS(ROW_EFFECT)
    for (int place = 0; place < DOM_LATER; place++) {
        row_make(&r);
        r.row.later[place] = 1;
        row_refused(&r.row, NULL, 0, DOM_NEWER);
    }
    row_make(&r);
    r.row.count = 0;
    row_refused(&r.row, NULL, 0, DOM_BAD_COUNT);
    row_make(&r);
    const volatile sig_atomic_t now = 1;
    compute = dom_compute_default();
    compute.interrupt = &now;
    row_refused(&r.row, &compute, 0, DOM_INTERRUPTED);
}

static bool never_moment(const struct dom_moment *moment, void *context)
{
    (void)moment;
    (void)context;
    fail();
    return false;
}

/* Checks times that are not in order, that are no numbers, or that are before a push, and the largest push of
 * a search. */
TEST(times_and_searches)
{
    const double bad[][2] = {{0.1, 0.05}, {(double)NAN, 1}, {-0.1, 0}};
    struct some_row r;
    struct dom_verdict verdict;
    double push = -1;
    row_make(&r);
    r.row.push = 5;
    for (int k = 0; k < 3; k++)
        assert_named(dom_row_watch(&r.row, NULL, bad[k], 2, never_moment, NULL, &verdict), DOM_BAD_TIME);
    for (int k = 0; k < 5; k++) {
        const double limits[] = {0, -1, (double)NAN, (double)INFINITY, -(double)INFINITY};
        assert_named(dom_row_weakest_push(&r.row, NULL, limits[k], &push), DOM_BAD_PUSH);
    }
    assert_true(push == -1);
    r.row.count = 0;
    assert_named(dom_row_watch(&r.row, NULL, bad[0], 1, never_moment, NULL, &verdict), DOM_BAD_COUNT);
    const struct dom_engine engine = {.context = &r};
    const double now = 0;
    row_make(&r);
    r.row.engine = &engine;
    assert_status(dom_row_watch(&r.row, NULL, &now, 1, never_moment, NULL, &verdict), DOM_NO_METHOD);
}

TEST(placements)
{
    struct some_row r;
    struct dom_study study;
    struct dom_budget budget;
    const double bad[] = {-1e-9, (double)NAN, (double)INFINITY, -(double)INFINITY};
    row_make(&r);
    for (int k = 0; k < 4; k++) {
        struct dom_placement p = {.error[DOM_ERROR_gap].size = bad[k], .seed = 1, .rows = 4};
        assert_named(dom_placement_study(&r.row, NULL, &p, &study, NULL), DOM_BAD_ERROR);
        p.error[DOM_ERROR_gap].size = 1e-3;
        p.error[DOM_ERROR_height].size = bad[k];
        assert_named(dom_placement_study(&r.row, NULL, &p, &study, NULL), DOM_BAD_ERROR);
        assert_named(dom_placement_budget(&r.row, NULL, &p, DOM_ERROR_gap, 0.5, &budget), DOM_BAD_ERROR);
        p.error[DOM_ERROR_height].size = 0;
        assert_named(dom_placement_budget(&r.row, NULL, &p, DOM_ERROR_gap, bad[k], &budget),
                     DOM_BAD_PROBABILITY);
        assert_named(dom_placement_budget(&r.row, NULL, &p, DOM_ERROR_gap, k % 2, &budget),
                     DOM_BAD_PROBABILITY);
    }
    struct dom_placement none = {.error[DOM_ERROR_gap].size = 1e-3, .seed = 1, .rows = 0};
    assert_named(dom_placement_study(&r.row, NULL, &none, &study, NULL), DOM_BAD_ROWS);
    assert_named(dom_placement_budget(&r.row, NULL, &none, DOM_ERROR_gap, 0.5, &budget), DOM_BAD_ROWS);
    study = (struct dom_study){.rows = 0};
    assert_named(dom_study_interval(&study), DOM_BAD_ROWS);
    study = (struct dom_study){.rows = 5, .fall = 4, .unknown = 2};
    assert_named(dom_study_interval(&study), DOM_BAD_ROWS);
}

TEST(counts)
{
    const double bad[] = {0, -1, (double)NAN, (double)INFINITY};
    struct dom_count count = {.dominoes = -1};
    for (int k = 0; k < 4; k++) {
        assert_named(dom_count_find(bad[k], 112, 1.5, &count), DOM_BAD_HEIGHT);
        assert_named(dom_count_find(0.048, bad[k], 1.5, &count), DOM_BAD_HEIGHT);
        assert_named(dom_count_find(0.048, 112, bad[k], &count), DOM_BAD_R);
    }
    assert_named(dom_count_find(0.048, 112, nextafter(1, 0), &count), DOM_BAD_R);
    assert_true(count.dominoes == -1);
}

/* Checks that every status has occurred. This test must be the last one. */
TEST(all_were_returned)
{
    for (int k = DOM_BAD_S; k <= DOM_BAD_PROBABILITY; k++)
        if (!returned[k])
            fail_msg("nothing returns: %s", dom_status_text((enum dom_status)k));
}
