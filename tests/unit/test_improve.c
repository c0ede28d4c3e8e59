/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: chance planning */
/* Improved rows: a result is never worse than the given row, and it is within the limits, even after an
 * interrupt. A study with an error that all dominoes share is also compared with studies of fixed values. */
#include "support.h"
#include <string.h>

enum { COUNT = 4, ROWS = 24 };

static struct dom_domino given[COUNT], found[COUNT];
static struct dom_row row;
static struct dom_placement placement;
static struct dom_limits limits;
static struct dom_study study[2];
static volatile sig_atomic_t interrupt;
static size_t interrupt_at, steps;

static double length_of(const struct dom_domino *d)
{
    double length = d[COUNT - 1].height;
    for (size_t k = 0; k < COUNT; k++)
        length += d[k].gap + d[k].thickness;
    return length;
}

/* Makes a row that often stops at its second domino, since the gap after it is almost as wide as the domino
 * is tall. */
static void scene_begin(void)
{
    struct dom_train train = dom_train_default();
    const struct dom_scale scale = dom_scale_default();
    train.q = 3;
    train.s = 0.45;
    train.r = 1.6;
    dom_row_of_train(&train, &scale, 1, given, COUNT);
    given[2].gap = 0.97 * given[1].height;
    row = dom_row_default();
    row.domino = given;
    row.count = COUNT;
    placement = (struct dom_placement){.seed = 1, .first = 1, .rows = ROWS};
    placement.error[DOM_ERROR_gap].size = 0.003;
    limits = (struct dom_limits){.sizes = true, .q = 3, .hall = length_of(given)};
    interrupt = 0;
    interrupt_at = 0;
    steps = 0;
}

static void step_seen(size_t done, size_t of, void *context)
{
    (void)context;
    assert_in_range(done, 1, of);
    if (++steps == interrupt_at)
        interrupt = 1;
}

static enum dom_status improve(void)
{
    struct dom_compute compute = dom_compute_default();
    compute.interrupt = &interrupt;
    memset(found, 0, sizeof found);
    return dom_row_improve(&row, &compute, &placement, &limits, step_seen, NULL, found, study);
}

/* Counts how many rows fall, independently of the tested function. */
static size_t falls(const struct dom_domino *domino)
{
    struct dom_row other = row;
    struct dom_study count;
    other.domino = domino;
    assert_int_equal(dom_placement_study(&other, NULL, &placement, &count, NULL), DOM_OK);
    return count.fall;
}

static void check(void)
{
    assert_int_equal(study[0].fall, falls(given));
    assert_int_equal(study[1].fall, falls(found));
    assert_true(study[1].fall >= study[0].fall);
    assert_true(length_of(found) <= limits.hall * (1 + 1e-9));
    assert_memory_equal(&found[0], &given[0], sizeof *given);
    assert_true(found[COUNT - 1].height == given[COUNT - 1].height);
    for (size_t k = 1; k + 1 < COUNT; k++) {
        const double x = found[k].height / given[k].height;
        if (limits.boards == 0 && limits.grid == 0)
            assert_true(fabs(found[k].thickness / given[k].thickness / x - 1) < 1e-9);
        assert_true(limits.boards > 0 || limits.grid > 0 ||
                    fabs(found[k].mass / given[k].mass / (x * x) - 1) < 1e-9);
    }
}

static bool is_multiple(double length, double of)
{
    return fabs(length / of - round(length / of)) < 1e-6;
}

TEST(more_rows_fall)
{
    scene_begin();
    assert_int_equal(improve(), DOM_OK);
    check();
    assert_true(study[1].fall >= study[0].fall + ROWS / 8);
    limits.sizes = false;
    assert_int_equal(improve(), DOM_OK);
    check();
    for (size_t k = 0; k < COUNT; k++)
        assert_true(found[k].height == given[k].height);
}

TEST(limits_are_kept)
{
    const double board[] = {0.007, 0.012, 0.025};
    scene_begin();
    limits.hall *= 0.97;
    limits.grid = 0.001;
    limits.board = board;
    limits.boards = 3;
    assert_int_equal(improve(), DOM_OK);
    assert_true(memcmp(found, given, sizeof given) != 0);
    check();
    for (size_t k = 1; k < COUNT; k++) {
        assert_true(is_multiple(found[k].gap, limits.grid));
        if (k + 1 == COUNT)
            continue;
        assert_true(is_multiple(found[k].height, limits.grid));
        assert_true(found[k].thickness == board[0] || found[k].thickness == board[1] ||
                    found[k].thickness == board[2]);
    }
    limits.hall = given[COUNT - 1].height;
    assert_int_equal(improve(), DOM_BAD_HALL);
    /* the walls do not fit into any board: no row is within the limits */
    scene_begin();
    row.walls = given[0].thickness / 3;
    limits.board = &row.walls;
    limits.boards = 1;
    assert_int_equal(improve(), DOM_OK);
    assert_int_equal(study[1].rows, 0);
    assert_memory_equal(found, given, sizeof given);
}

TEST(interrupted_search)
{
    scene_begin();
    assert_int_equal(improve(), DOM_OK);
    const size_t all = steps;
    interrupt = 1;
    assert_int_equal(improve(), DOM_INTERRUPTED);
    assert_int_equal(study[0].rows, 0);
    for (size_t third = 0; third < 3; third++) {
        interrupt = 0;
        steps = 0;
        interrupt_at = 1 + third * all / 3;
        assert_int_equal(improve(), DOM_INTERRUPTED);
        assert_int_equal(study[0].rows, ROWS);
        check();
    }
}

TEST(nothing_to_improve)
{
    scene_begin();
    placement.error[DOM_ERROR_gap].size = 1e-6; /* all rows fall */
    assert_int_equal(improve(), DOM_OK);
    assert_memory_equal(found, given, sizeof given);
    assert_int_equal(study[1].fall, ROWS);
    row.mu = 3; /* no row falls */
    placement.error[DOM_ERROR_gap].size = 0.001;
    assert_int_equal(improve(), DOM_OK);
    assert_memory_equal(found, given, sizeof given);
    assert_int_equal(study[1].fall, 0);
    row.count = 1;
    row.push = 0.01; /* too weak to turn the single domino over */
    assert_int_equal(improve(), DOM_OK);
    assert_memory_equal(found, given, sizeof *given);
    limits.q = 0;
    assert_int_equal(improve(), DOM_BAD_Q);
}

/* Checks that the share of rows that fall with a uniformly distributed friction is the mean of the shares
 * with fixed frictions. */
TEST(common_error_is_a_mixture)
{
    enum { FIXED = 20, EACH = 50 };
    const double mu = 0.3, size = 0.3;
    struct dom_study count;
    size_t mixed = 0;
    scene_begin();
    given[2].gap = 0.45 * given[2].height;
    placement.rows = FIXED * EACH;
    row.mu = mu;
    placement.error[DOM_ERROR_friction] = (struct dom_random_error){.size = size, .uniform = true};
    assert_int_equal(dom_placement_study(&row, NULL, &placement, &count, NULL), DOM_OK);
    placement.error[DOM_ERROR_friction].size = 0;
    placement.rows = EACH;
    for (size_t i = 0; i < FIXED; i++) {
        row.mu = mu + size * (2 * ((double)i + 0.5) / FIXED - 1);
        placement.first = 1 + i * EACH;
        mixed += falls(given);
    }
    assert_in_range(mixed, FIXED * EACH / 5, FIXED * EACH * 9 / 10); /* friction matters */
    /* Each share has a standard deviation of at most 0.016. */
    assert_true(fabs((double)count.fall - (double)mixed) < 0.07 * FIXED * EACH);
}

/* Checks that a row is changed if it is outside the limits, even if it always falls. */
TEST(limits_of_a_row_that_falls)
{
    scene_begin();
    given[2].gap = 0.45 * given[2].height;
    placement.error[DOM_ERROR_gap].size = 1e-6;
    limits.grid = 0.001;
    assert_int_equal(improve(), DOM_OK);
    check();
    assert_int_equal(study[0].fall, ROWS);
    for (size_t k = 1; k < COUNT; k++)
        assert_true(is_multiple(found[k].gap, limits.grid));
    for (size_t k = 1; k + 1 < COUNT; k++)
        assert_true(is_multiple(found[k].height, limits.grid) &&
                    is_multiple(found[k].thickness, limits.grid));
    memcpy(given, found, sizeof found); /* it is within the limits now */
    assert_int_equal(improve(), DOM_OK);
    assert_memory_equal(found, given, sizeof found);
}
