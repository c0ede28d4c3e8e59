/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dominoes that are not plumb, in limiting cases; test_row compares rows of them with Newton's equations. */
#include "run.h"
#include "support.h"
#include <float.h>

/* ---- Limits ---- */

/* Compares a tipped first domino with a calculation by hand: the tilt at which it touches the next domino,
 * which leans, and the energy that tips it. */
TEST(touches)
{
    static struct run run;
    for (int side = -1; side <= 1; side++) {
        make_row(&run, 2, 0.5, 1, 0);
        run.row.push = (double)NAN;
        double phi = 0.05 * side, h = run.domino[0].height, d = run.domino[0].thickness,
               gap = run.domino[1].gap;
        run.domino[1].lean = phi;
        run.domino[0].lean = -0.08;
        assert_status(run_whole(&run), DOM_OK);
        double theta = (double)run.fall[0].theta;
        /* The tip is on the line of the back face. */
        double x = h * sin(theta), z = h * cos(theta), bottom_x = gap + d - d * cos(phi),
               bottom_z = d * sin(phi);
        assert_near("on the face", (x - bottom_x) * cos(phi) + h, (z - bottom_z) * sin(phi) + h, 1e-14);
        double energy = hypot(h, d) - h * cos(-0.08) - d * sin(-0.08);
        assert_near("to tip it", run.fall[0].barrier, (double)run.domino[0].mass * 9.81 * energy / 2, 1e-13);
    }
}

/* Checks dominoes that lean backwards and pass the upright position only by a tiny angle. */
TEST(tiny_gaps)
{
    static struct run run;
    uint64_t seed = 5;
    for (int i = 0; i < 200; i++) {
        make_row(&run, 4, 0.4, 1 + 0.2 * random_unit(&seed), 0.2 * (i % 2));
        for (size_t k = 1; k < 3; k++)
            run.domino[k].lean = -(0.1 + 0.6 * random_unit(&seed)) * tips_at(&run.domino[k]);
        run.domino[3].gap = run.domino[2].height * pow(10, -17 * random_unit(&seed));
        assert_status(run_whole(&run), DOM_OK);
        assert_true(run.falls >= 3);
        assert_true(run.fall[2].theta >= 0 && run.fall[2].theta < M_PI / 2);
    }
}

/* ---- Ends and refusals ---- */

TEST(ends)
{
    static struct run run;
    /* the gap is 0.96 mm: the tip of a 48 mm domino is displaced by this much at a lean of 0.02 */
    make_row(&run, 3, 0.02, 1, 0);
    run.domino[1].lean = -0.03;
    assert_int_equal(row_end(&run), DOM_ROW_SKEWED);
    assert_int_equal(run.verdict.domino, 1);
    make_row(&run, 3, 0.02, 1, 0);
    run.domino[1].lean = 0.03;
    assert_int_equal(row_end(&run), DOM_ROW_SKEWED);
    assert_int_equal(run.verdict.domino, 2);
    make_row(&run, 3, 0, 1, 0);
    run.domino[2].lean = 0.03;
    assert_int_equal(row_end(&run), DOM_ROW_SKEWED);
    make_row(&run, 3, 0.4, 1, 0);
    run.domino[2].gap = run.domino[1].height * (1 + 1e-9);
    run.domino[2].lean = -0.03;
    assert_int_equal(row_end(&run), DOM_ROW_MISSES);
    double seconds[2];
    /* a domino that misses the next one falls in the same way, however the next one leans */
    for (int i = 0; i < 2; i++) {
        make_row(&run, 3, 0.4, 1, 0);
        run.domino[2].gap = 1.5 * run.domino[1].height;
        run.domino[2].lean = -0.03 * i;
        assert_status(run_whole(&run), DOM_OK);
        assert_int_equal(run.verdict.end, DOM_ROW_MISSES);
        seconds[i] = (double)run.fall[1].duration;
    }
    assert_near("seconds", seconds[1], seconds[0], 1e-12);
    make_row(&run, 3, 0.4, 1, 0); /* the foot of the next domino is above the edge that would hit it */
    run.domino[2].gap = run.domino[1].height * 0.999;
    run.domino[2].lean = 0.14;
    assert_int_equal(row_end(&run), DOM_ROW_SKEWED);
}

TEST(refusals)
{
    static struct run run;
    const double theta_u = atan(7.0 / 48);
    make_row(&run, 4, 0.4, 1, 0);
    for (int i = 0; i < 6; i++) { /* leans to both sides, on a level floor and on two slopes */
        domq_real limit[2], alpha = (i / 2 - 1) * 0.05;
        domq_lean_limits(&run.domino[2], alpha, 0, limit);
        assert_near("limit", limit[i % 2], (i % 2 ? theta_u : -theta_u) - (double)alpha, 1e-15);
        run.row.alpha = alpha;
        run.domino[2].lean = limit[i % 2] * (1 - 1e-9);
        assert_status(run_whole(&run), DOM_OK);
        run.domino[2].lean = limit[i % 2] * (1 + 1e-9);
        assert_status(run_whole(&run), DOM_BAD_LEAN);
        assert_int_equal(run.verdict.domino, 3);
    }
    make_row(&run, 4, 0.4, 1, 0);
    run.domino[2].lean = 0.01;
    run.row.rho = 0.01;
    assert_status(run_whole(&run), DOM_NO_LEAN);
}
