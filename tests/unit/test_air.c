/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: proof pictures */
/* Air: a domino that tips over, the work of the drag, and trains; test_row compares rows with Newton's
 * equations, and long rows with trains. */
#include "domino_proof.h"
#include "run.h"
#include "support.h"

/* ---- A domino that tips over ---- */

/* With and without air, with sharp and with rounded edges, and on a slope: the same motion as that of a
 * domino that is released just past its edge. Rounded edges that are nearly sharp change nothing. */
TEST(tipping_is_the_limit_of_a_release)
{
    for (int i = 0; i < 4; i++) {
        static struct run run;
        make_row(&run, 2, 0.4, 1.3, 0);
        run.row.push = DOMQ_NAN;
        run.row.alpha = i == 3 ? 0.02 : 0;
        run.row.air = i == 1 || i == 2 ? 5 : 0;
        run.row.rho = i == 2 ? 1e-7 : 0;
        assert_status(run_whole(&run), DOM_OK);
        const double tipped = (double)run.fall[1].omega, lost = (double)run.fall[0].friction_work;
        assert_true(run.row.air == 0 ? lost == 0 : lost > 0);
        run.row.push = 0;
        run.row.rho = 0;
        run.row.release = tips_at(run.domino) - (double)run.row.alpha + 1e-7;
        assert_status(run_whole(&run), DOM_OK);
        assert_near("omega", tipped, (double)run.fall[1].omega, 1e-5);
        if (lost > 0)
            assert_near("lost", lost, (double)run.fall[0].friction_work, 1e-4);
    }
}

/* ---- The energy that is lost is the work of the drag ---- */

/* The torque of the drag over omega^2, in SI units. */
static double torque_of(const struct domq_domino *d, double air, double drag)
{
    const double h = (double)d->height, w = d->width > 0 ? (double)d->width : h / 2;
    return air * drag * w * pow(h, 4) / 8;
}

/* Almost without gravity, a plate keeps the part exp(-2 k D) of its energy when it turns by the angle D. */
TEST(a_plate_without_gravity)
{
    for (int i = 0; i < 3; i++) {
        static struct run run;
        make_row(&run, 2, 0.9, 1.2, 0);
        const double air = i == 1 ? 40 : 1.2, drag = i == 2 ? 2 : 1.2;
        struct domq_domino giant = {.height = 8, .thickness = 1.17, .mass = 1200, .width = 4};
        run.domino[0] = giant;
        giant.gap = 7;
        run.domino[1] = giant;
        run.row.g = 1e-8;
        run.row.push = 1;
        run.row.air = air;
        run.row.drag = i == 2 ? drag : 0;
        run_whole(&run);
        const double inertia = 1200 * (64 + 1.17 * 1.17) / 3 + air * acos(-1) * 16 * 512 / 12,
                     k = torque_of(&giant, air, drag) / inertia, lost = (double)run.fall[0].friction_work;
        assert_near("kinetic", (double)run.fall[0].kinetic, inertia / 2, 1e-12);
        assert_near("kept", 1 - lost / (inertia / 2), exp(-2 * k * (double)run.fall[0].theta), 1e-8);
        assert_true(run.fall[0].theta > 1);
    }
}

struct work {
    const struct run *run;
    double air, sum; /* of the power */
};

static bool work_seen(const struct dom_moment *m, void *context)
{
    struct work *work = context;
    double power = 0;
    for (size_t k = 0; k < work->run->row.count; k++)
        power += torque_of(&work->run->domino[k], work->air, 1.2) * pow(m->omega[k], 3);
    work->sum += power;
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
            sum += work.sum * lasts / STEPS;
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

/* The search for a pair begins at the growth at which domino 1 only just tips over. Rounding decides whether
 * it tips over there before it hits, and it has no energy either way. */
TEST(pair_that_only_just_tips_over)
{
    struct setup train = setup_default();
    struct domq_limit limit, airless;
    train.d = 0.55;
    for (int i = 1; i <= 100; i++) {
        train.s = (domq_real)0.0025 * i;
        train.air = 0;
        assert_status(ask_limit_pair(&train, &airless), DOM_OK);
        train.air = 1e-6;
        assert_status(ask_limit_pair(&train, &limit), DOM_OK);
        assert_int_equal(limit.ends, airless.ends);
        if (limit.ends != DOM_END_NONE)
            assert_near("r_max", (double)limit.r_max, (double)airless.r_max, 1e-4);
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
