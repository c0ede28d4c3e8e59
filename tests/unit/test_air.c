/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: proof pictures */
/* Air: single plates against closed forms, trains; test_row compares rows with Newton's equations, and long
 * rows with trains. Without air nothing changes. */
#include "domino_proof.h"
#include "run.h"
#include "support.h"

/* The formulas of the two estimates, written out in SI units: the torque of the drag over omega^2, and the
 * moment of inertia with the air that moves along. */
static double torque_of(const struct domq_domino *d, double air, double drag)
{
    const double h = (double)d->height, w = d->width > 0 ? (double)d->width : h / 2;
    return air * drag * w * pow(h, 4) / 8;
}

static double inertia_of(const struct domq_domino *d, double air)
{
    const double h = (double)d->height, w = d->width > 0 ? (double)d->width : h / 2, t = (double)d->thickness;
    return (double)d->mass * (h * h + t * t) / 3 + air * acos(-1) * w * w * pow(h, 3) / 12;
}

/* ---- A single plate ---- */

struct moments {
    double tilt[64], omega[64], time[64];
    size_t count;
};

static bool moment_seen(const struct dom_moment *m, void *context)
{
    struct moments *seen = context;
    seen->time[seen->count] = m->time;
    seen->tilt[seen->count] = m->tilt[0];
    seen->omega[seen->count++] = m->omega[0];
    return true;
}

/* Almost without gravity, a plate keeps the part exp(-2 k D) of omega^2 when it turns by the angle D. */
TEST(single_plate_without_gravity)
{
    struct domq_domino domino = {.height = 8, .thickness = 1.17, .mass = 1200, .width = 4};
    for (int i = 0; i < 3; i++) {
        const double air = i == 1 ? 40 : 1.2, drag = i == 2 ? 2 : 1.2;
        struct row_setup row = row_setup_default(&domino, 1, 1);
        struct dom_verdict verdict;
        double times[] = {0, 0.2, 0.5, 0.9, 1.4};
        struct moments seen = {.count = 0};
        row.g = 1e-8;
        row.air = air;
        row.drag = i == 2 ? drag : 0;
        assert_status(ask_row_watch(&row, times, 5, moment_seen, &seen, &verdict), DOM_OK);
        const double k = torque_of(&domino, air, drag) / inertia_of(&domino, air);
        if (i == 0) {
            assert_near("drag", k, 0.11, 0.1); /* the giant of the model */
            assert_near("inertia", inertia_of(&domino, air) / inertia_of(&domino, 0), 1.1, 0.01);
        }
        assert_int_equal(seen.count, 5);
        for (size_t m = 1; m < seen.count; m++) {
            assert_true(seen.tilt[m] > seen.tilt[m - 1]);
            assert_near("omega^2", seen.omega[m] * seen.omega[m], exp(-2 * k * seen.tilt[m]), 1e-7);
            /* omega = 1/(1 + k t) in time */
            assert_near("in time", seen.omega[m], 1 / (1 + k * seen.time[m]), 1e-7);
        }
    }
}

/* A domino that tips over and falls alone: integrates dw/dtheta + 2 k w = torque of gravity by the classical
 * fourth-order method, from the top to the hit. Then the next domino has what the collision leaves. */
TEST(first_domino_tips_over)
{
    for (int i = 0; i < 4; i++) {
        static struct run run;
        run = (struct run){.falls = 0};
        make_row(&run, 2, 0.4, 1.3, 0);
        const double air = i < 2 ? 30 : 5;
        run.domino[0].mass *= i % 2 ? 1 : 0.05;
        run.domino[1].mass *= i % 2 ? 1 : 0.05;
        run.row.push = DOMQ_NAN;
        run.row.air = air;
        assert_status(run_whole(&run), DOM_OK);
        assert_true(run.falls == 2);
        const struct domq_domino *a = &run.domino[0], *b = &run.domino[1];
        const double h = (double)a->height, t = (double)a->thickness, I = inertia_of(a, air),
                     k = torque_of(a, air, 1.2) / I, from = atan(t / h), to = asin((double)b->gap / h),
                     m = (double)a->mass * 9.81;
        const int steps = 20000;
        const double step = (to - from) / steps;
        double w = 0;
#define RATE(theta, w) (m * (h * sin(theta) - t * cos(theta)) / I - 2 * k * (w))
        for (int n = 0; n < steps; n++) {
            const double at = from + n * step, r1 = RATE(at, w), r2 = RATE(at + step / 2, w + r1 * step / 2),
                         r3 = RATE(at + step / 2, w + r2 * step / 2), r4 = RATE(at + step, w + r3 * step);
            w += (r1 + 2 * r2 + 2 * r3 + r4) / 6 * step;
        }
#undef RATE
        const double hit = inertia_of(a, air) * w / 2;
        const double free = m * (h * (cos(from) - cos(to)) + t * (sin(from) - sin(to))) / 2;
        assert_near("lost to the air", (double)run.fall[0].friction_work, free - hit, 1e-7);
        /* Both arms are equal when the struck domino is upright, and a is then a height h cos(to). */
        const double I2 = inertia_of(b, air), arm = h * cos(to) / (h * cos(to)), ratio = I / I2 * arm * arm;
        assert_near("omega", (double)run.fall[1].omega, sqrt(w) * ratio / (1 + ratio), 1e-9);
    }
}

/* Rounded edges, with and without air, and on a slope: the same motion before the first hit as with nearly
 * sharp edges. */
TEST(round_dominoes_tip_over)
{
    for (int i = 0; i < 4; i++) {
        static struct run run;
        make_row(&run, 2, 0.4, 1.3, 0);
        run.row.push = DOMQ_NAN;
        run.row.alpha = i == 3 ? 0.02 : 0;
        run.row.air = i == 1 || i == 2 ? 5 : 0;
        run.row.rho = i == 2 ? 1e-7 : 0.02;
        assert_status(run_whole(&run), DOM_OK);
        const double round = (double)run.fall[1].omega, lost = (double)run.fall[0].friction_work;
        assert_true(run.row.air == 0 ? lost == 0 : lost > 0);
        if (i != 2)
            continue;
        run.row.rho = 0;
        assert_status(run_whole(&run), DOM_OK);
        assert_near("sharp", round, (double)run.fall[1].omega, 1e-5);
        assert_near("lost", lost, (double)run.fall[0].friction_work, 1e-4);
    }
}

/* ---- The energy that is lost is the work of the drag ---- */

struct work {
    const struct run *run;
    double air, sum[2], last_time;
    size_t steps, moving;
};

static bool work_seen(const struct dom_moment *m, void *context)
{
    struct work *work = context;
    double power = 0;
    for (size_t k = 0; k < work->run->row.count; k++)
        power += torque_of(&work->run->domino[k], work->air, 1.2) * pow(m->omega[k], 3);
    /* the trapezoidal rule, with all points and with every second point */
    work->sum[0] += power;
    work->sum[1] += work->steps++ % 2 == 0 ? power : 0;
    return true;
}

TEST(lost_energy_is_the_work_of_the_drag)
{
    enum { STEPS = 4000 };
    static double times[STEPS + 1];
    for (int i = 0; i < 3; i++) { /* sharp edges, rounded edges, and rounded edges on a slope */
        static struct run run;
        make_row(&run, 6, 0.4, 1.2, 0);
        run.row.rho = i > 0 ? 0.02 : 0;
        run.row.alpha = i > 1 ? 0.01 : 0;
        run.row.air = 10;
        for (size_t k = 0; k < 6; k++)
            run.domino[k].mass /= 20;
        assert_status(run_whole(&run), DOM_OK);
        assert_true(run.verdict.end == DOM_ROW_FALLS);
        double lost = 0, sum = 0;
        for (size_t k = 0; k < run.falls; k++) {
            /* Within one fall the speeds are smooth, unless a domino detaches. */
            const double begins = (double)run.fall[k].time, lasts = (double)run.fall[k].duration;
            struct work work = {.run = &run, .air = 10};
            struct dom_verdict verdict;
            for (int n = 0; n <= STEPS; n++) /* times just inside */
                times[n] = begins + lasts * (1e-9 + (1 - 2e-9) * n / STEPS);
            assert_status(ask_row_watch(&run.row, times, STEPS + 1, work_seen, &work, &verdict), DOM_OK);
            lost += (double)run.fall[k].friction_work;
            sum += work.sum[0] * lasts / STEPS;
        }
        assert_near("work", lost, sum, 2e-3);
        assert_true(lost > 0);
    }
}

/* ---- Trains ---- */

/* A pair of which the first tips over: it falls below the largest growth of the pair, and stops above it. */
TEST(pair_is_a_row_of_two)
{
    for (int i = 0; i < 3; i++) {
        static struct run run;
        struct setup train = setup_default();
        struct domq_limit limit;
        make_row(&run, 2, 0.4, 1.2, 0);
        train.air = (domq_real[]){0.002, 0.02, 0.07}[i];
        assert_status(ask_limit_pair(&train, &limit), DOM_OK);
        for (int side = -1; side <= 1; side += 2) {
            struct domq_scale scale = domq_scale_default();
            train.r = limit.r_max * (1 + side * (domq_real)1e-9);
            ask_row_of_train(&train, &scale, 0.01, run.domino, 2);
            const struct domq_domino *first = run.domino;
            run.row.air = train.air * first->mass / (first->height * first->thickness * first->width);
            run.row.push = DOMQ_NAN;
            assert_int_equal(row_end(&run), side < 0 ? DOM_ROW_FALLS : DOM_ROW_STOPS);
        }
    }
}

/* Air lowers r_max, more of it lowers r_max further, and r_max tends to the answer without air in proportion.
 */
TEST(rmax_in_air)
{
    struct setup train = setup_default();
    struct domq_limit none, limit;
    assert_status(ask_limit_rmax(&train, &none), DOM_OK);
    double before = (double)none.r_max, off[2];
    for (int i = 0; i < 2; i++) {
        train.air = i ? 2e-4 : 1e-4;
        assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
        off[i] = before - (double)limit.r_max;
    }
    assert_near("proportion", off[1] / off[0], 2, 1e-3);
    for (int i = 1; i < 20; i++) {
        train.air = 0.01 * i;
        assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
        assert_true((double)limit.r_max < before);
        before = (double)limit.r_max;
    }
    train.s = 0.65; /* the reach is the limit, with air as without */
    train.air = 0.002;
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
    assert_true(limit.ends == DOM_END_REACH);
    struct domq_best best, airless;
    assert_status(ask_limit_best(&train, &best), DOM_OK);
    train.air = 0;
    assert_status(ask_limit_best(&train, &airless), DOM_OK);
    assert_true(best.r_max < airless.r_max && best.r_max > airless.r_max * (1 - (domq_real)0.01));
}

TEST(refusals)
{
    struct setup train = setup_default();
    struct domq_limit limit;
    struct domq_best best;
    domq_real number;
    train.air = 0.002;
    train.q = 3;
    assert_status(ask_limit_rmax(&train, &limit), DOM_NO_AIR);
    assert_status(ask_limit_pair(&train, &limit), DOM_NO_AIR);
    assert_status(ask_limit_best(&train, &best), DOM_NO_AIR);
    assert_status(ask_cycle_duration(&train, &number), DOM_NO_AIR);
    assert_status(ask_check(&train), DOM_NO_AIR);
    train.q = 4;
    assert_status(ask_check(&train), DOM_OK);
    train.air = DOMQ_NAN; /* the mass is not known */
    assert_status(ask_check(&train), DOM_BAD_AIR);
    train.air = 0.002;
    train.drag = -1;
    assert_status(ask_check(&train), DOM_BAD_DRAG);
    train.drag = 0;
    train.fuel = DOM_FUEL_PAPER;
    assert_status(ask_limit_rmax(&train, &limit), DOM_NO_METHOD);
    train.fuel = DOM_FUEL_EXACT;
    struct dom_train proved = dom_train_default();
    struct dom_proof proof;
    proved.air = 0.002;
    assert_status(dom_prove_rmax(&proved, NULL, &proof), DOM_OK);
    assert_int_equal(proof.gap, DOM_PROOF_EFFECT);
}

/* ---- Without air ---- */

TEST(no_air_changes_nothing)
{
    static struct run run, bare;
    uint64_t seed = 1503;
    for (int i = 0; i < 40; i++) {
        row_of_kind(&run, &seed, i % 4);
        run.row.drag = 2; /* without air it has no effect */
        run.row.rho = i % 6 == 0 ? 0.01 : 0;
        bare = run;
        bare.row.drag = 0;
        assert_status(run_whole(&run), DOM_OK);
        assert_status(run_whole(&bare), DOM_OK);
        assert_int_equal(run.falls, bare.falls);
        for (size_t k = 0; k < run.falls; k++)
            assert_true(run.fall[k].omega == bare.fall[k].omega &&
                        run.fall[k].kinetic == bare.fall[k].kinetic &&
                        run.fall[k].barrier == bare.fall[k].barrier);
    }
}
