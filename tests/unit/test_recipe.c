/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: explain */
/* The paper's recipe against the library's own method. */
#include "domino_proof.h"
#include "support.h"

TEST(a_cycle_agrees)
{
    const struct dom_train train = dom_train_default();
    struct dom_compute compute = dom_compute_default();
    struct dom_launch launch, by_paper;
    struct dom_barrier ours, other;
    compute.tol = 1e-5;
    assert_status(dom_launch_find(&train, &compute, &launch), DOM_OK);
    assert_status(dom_barrier_find(&train, &compute, &ours), DOM_OK);
    assert_status(dom_paper_launch(&train, &compute, &by_paper), DOM_OK);
    assert_status(dom_paper_barrier(&train, &compute, &other), DOM_OK);
    assert_near("fuel", by_paper.fuel, launch.fuel, 1e-4);
    assert_near("J0", by_paper.J0, launch.J0, 1e-4);
    assert_near("barrier", other.barrier, ours.barrier, 1e-3);
    assert_near("kinetic", other.kinetic, ours.kinetic, 1e-3);
}

/* Checks the recipe if the growth is limited by 1/s, for equal dominoes, and if the train stops. */
TEST(the_ends)
{
    struct dom_train train = dom_train_default();
    struct dom_compute compute = dom_compute_default();
    struct dom_limit limit;
    struct dom_barrier barrier;
    train.s = 0.95;
    compute.tol = 1e-4;
    assert_status(dom_paper_rmax(&train, &compute, &limit), DOM_OK);
    assert_true(limit.ends == DOM_END_REACH && limit.r_max == 1 / 0.95);
    train.s = 0.4;
    train.r = 1; /* the sums of the paper are infinite */
    assert_status(dom_paper_barrier(&train, &compute, &barrier), DOM_TOO_LONG);
    train.r = 1.7;
    assert_status(dom_paper_barrier(&train, &compute, &barrier), DOM_STOPS);
}

/* Checks that the recipe has no answer for a train with an effect that changes its motion. Walls change
 * nothing but tau. */
TEST(effects)
{
    const struct dom_train plain = dom_train_default();
    struct dom_train train[] = {plain, plain, plain, plain, plain, plain};
    struct dom_compute compute = dom_compute_default();
    struct dom_launch launch;
    struct dom_barrier barrier;
    struct dom_limit limit, boxes;
    compute.tol = 1e-4;
    train[0].mu = 0.1;
    train[1].alpha = 0.01;
    train[2].rho = 0.01;
    train[3].air = 0.002;
    train[4].s = 2;
    train[5].walls = 0.02;
    for (int k = 0; k < 5; k++) {
        const enum dom_status status = k == 4 ? DOM_BAD_S : DOM_NO_METHOD;
        assert_status(dom_paper_launch(&train[k], &compute, &launch), status);
        assert_status(dom_paper_barrier(&train[k], &compute, &barrier), status);
        assert_status(dom_paper_rmax(&train[k], &compute, &limit), status);
    }
    assert_status(dom_paper_rmax(&train[5], &compute, &boxes), DOM_OK);
    assert_status(dom_paper_rmax(&plain, &compute, &limit), DOM_OK);
    assert_true(boxes.r_max == limit.r_max);
}
