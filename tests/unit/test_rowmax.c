/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows */
/* The largest growth of a finite row, compared with the pair, with the endless train, and with the verdicts
 * at slightly different growths. */
#include "run.h"
#include "support.h"

/* The train whose rows are made, and how often a row was made. */
struct family {
    struct setup train;
    struct domq_scale scale;
    int made;
};

static void family_make(double r, struct dom_domino *domino, size_t count, void *context)
{
    struct family *f = context;
    struct domq_domino wide[ROW_MOST];
    struct setup train = f->train;
    train.r = r;
    f->made++;
    ask_row_of_train(&train, &f->scale, 0.01, wide, count);
    for (size_t k = 0; k < count; k++)
        domino[k] = (struct dom_domino){.height = (double)wide[k].height,
                                        .thickness = (double)wide[k].thickness,
                                        .gap = (double)wide[k].gap,
                                        .mass = (double)wide[k].mass};
}

static struct family family_of(double s, double d, double q)
{
    struct family f = {.train = setup_default(), .scale = domq_scale_default()};
    f.train.s = s;
    f.train.d = d;
    f.train.q = q;
    return f;
}

static struct row_setup row_of(size_t count, domq_real push)
{
    return row_setup_default(NULL, count, push);
}

static struct dom_row_growth growth_of(struct family *f, const struct row_setup *row)
{
    struct dom_row_growth growth;
    assert_status(ask_row_rmax(row, (double)(1 / f->train.s), family_make, f, &growth), DOM_OK);
    return growth;
}

/* Returns how the family's row ends at the growth r. */
static enum dom_row_end ends_at(struct family *f, const struct row_setup *row, double r)
{
    static struct run run;
    struct setup train = f->train;
    run.row = *row;
    train.r = r;
    ask_row_of_train(&train, &f->scale, 0.01, run.domino, row->count);
    return row_end(&run);
}

/* Checks that a row of two dominoes, the first of which just tips over, has the limit of the paper's pair. */
TEST(two_are_the_pair)
{
    int limited = 0;
    for (int i = 1; i < 10; i++) {
        struct family f = family_of(0.1 * i, 7.0 / 48, i % 2 ? 3 : 4);
        struct domq_limit pair;
        struct row_setup row = row_of(2, DOMQ_NAN);
        assert_status(ask_limit_pair(&f.train, &pair), DOM_OK);
        if (pair.ends == DOM_END_NONE)
            continue;
        struct dom_row_growth growth = growth_of(&f, &row);
        assert_near("r_max", growth.r_max, pair.r_max, 1e-11);
        assert_int_equal(growth.ends, pair.ends == DOM_END_REACH ? DOM_ROW_FALLS : DOM_ROW_STOPS);
        limited += pair.ends == DOM_END_BARRIER;
    }
    assert_true(limited > 2);
}

/* Checks rows that stop at r = 1 but fall at larger growths, on slopes and with thick dominoes. A row of two
 * has the limit of the pair, and all dominoes fall from r_min on. */
TEST(falls_from_above_one)
{
    static const double scenes[][4] = {/* s, d, q, alpha */
                                       {0.5180007117763072, 0.4, 2, 0.01},
                                       {0.342, 0.24, 2, 0},
                                       {0.355, 0.257, 2, 0.01},
                                       {0.496, 0.381, 2, 0.02}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        struct family f = family_of(scenes[i][0], scenes[i][1], scenes[i][2]);
        struct domq_limit pair;
        struct row_setup row = row_of(2, DOMQ_NAN);
        row.alpha = f.train.alpha = (domq_real)scenes[i][3];
        assert_status(ask_limit_pair(&f.train, &pair), DOM_OK);
        struct dom_row_growth growth = growth_of(&f, &row);
        assert_true(pair.ends != DOM_END_NONE);
        assert_near("r_max", growth.r_max, pair.r_max, 1e-11);
        assert_true(growth.r_min > 1 && ends_at(&f, &row, 1) != DOM_ROW_FALLS);
        assert_int_equal(ends_at(&f, &row, (double)growth.r_min), DOM_ROW_FALLS);
        assert_true(ends_at(&f, &row, (double)growth.r_min * (1 - 1e-9)) != DOM_ROW_FALLS);
    }
}

/* Checks that a long row has the limit of the endless train, since the effect of a strong push decreases
 * along the row. */
TEST(long_rows_are_the_train)
{
    for (int i = 4; i < 8; i++) {
        struct family f = family_of(0.1 * i, 7.0 / 48, 3 + i % 2);
        struct domq_limit limit;
        struct row_setup row = row_of(60, 60);
        assert_status(ask_limit_rmax(&f.train, &limit), DOM_OK);
        struct dom_row_growth growth = growth_of(&f, &row);
        assert_near("r_max", growth.r_max, limit.r_max, 1e-6);
        assert_int_equal(growth.ends, limit.ends == DOM_END_REACH ? DOM_ROW_FALLS : DOM_ROW_STOPS);
    }
}

/* Checks that all dominoes fall at r_max but not at a slightly larger growth. */
TEST(falls_up_to_it)
{
    uint64_t seed = 81;
    int stopped = 0, reached = 0;
    for (int i = 0; i < 60; i++) {
        struct family f = family_of(random_log(&seed, 0.1, 0.9), random_log(&seed, 0.05, 0.3),
                                    2.5 + 2 * random_unit(&seed));
        struct row_setup row = row_of(2 + (size_t)(8 * random_unit(&seed)), i % 3 ? 6 : DOMQ_NAN);
        row.mu = i % 4 ? 0 : 0.2;
        struct dom_row_growth growth = growth_of(&f, &row);
        assert_true(f.made < 400);
        if (isnan((double)growth.r_max)) {
            assert_int_equal(ends_at(&f, &row, 1), growth.ends);
            continue;
        }
        double r_max = growth.r_max;
        assert_int_equal(ends_at(&f, &row, fmax(1, r_max * (1 - 1e-9))), DOM_ROW_FALLS);
        reached += growth.ends == DOM_ROW_FALLS;
        if (growth.ends == DOM_ROW_FALLS) {
            assert_true(growth.r_max == (double)(1 / f.train.s));
            continue;
        }
        assert_int_equal(ends_at(&f, &row, r_max * (1 + 1e-9)), growth.ends);
        assert_true(ends_at(&f, &row, r_max * 1.0001) != DOM_ROW_FALLS);
        stopped++;
    }
    print_message("# %d stop, %d reach\n", stopped, reached);
    assert_true(stopped > 20 && reached > 3);
}

/* Checks that a row of one pushed domino falls at any growth, and that equal dominoes that touch from the
 * start do not fall. */
TEST(at_the_ends)
{
    struct family f = family_of(0.4, 7.0 / 48, 4);
    struct row_setup row = row_of(1, 6);
    struct dom_row_growth growth = growth_of(&f, &row);
    assert_true(growth.r_max == (double)(1 / f.train.s) && growth.ends == DOM_ROW_FALLS);
    f = family_of(0.05, 7.0 / 48, 4);
    row = row_of(3, DOMQ_NAN);
    growth = growth_of(&f, &row);
    assert_true(isnan((double)growth.r_max) && isnan((double)growth.r_min) && growth.ends == DOM_ROW_LEANS);
    /* If `highest` is 1, the answer is 1. */
    f = family_of(1, 7.0 / 48, 4);
    row = row_of(1, 6);
    growth = growth_of(&f, &row);
    assert_true(growth.r_max == 1 && growth.ends == DOM_ROW_FALLS);
}

/* Makes a row with bad dominoes from some growth on. */
static void flat_make(double r, struct dom_domino *domino, size_t count, void *context)
{
    family_make(r, domino, count, context);
    if (r > 1.1)
        domino[0].thickness = 0;
}

TEST(a_wrong_row_is_refused)
{
    struct family f = family_of(0.4, 7.0 / 48, 3);
    const struct row_setup row = row_of(4, 6);
    struct dom_row_growth growth = {.r_max = -1};
    assert_status(ask_row_rmax(&row, 2, flat_make, &f, &growth), DOM_BAD_THICKNESS);
    assert_true(growth.r_max == -1);
}

/* ---- The weakest push with which a row falls ---- */

static bool falls_pushed(const struct run *run, double push)
{
    static struct run other;
    other = *run;
    other.row.push = push;
    return row_end(&other) == DOM_ROW_FALLS;
}

/* Checks that a single domino falls with the push that turns it over its edge. */
TEST(over_its_edge)
{
    static struct run run;
    make_row(&run, 1, 0.3, 1, 0);
    double edge = push_over(run.domino);
    double push;
    for (double own = 0; own < 1; own += 0.3) {
        run.row.push = own * edge;
        assert_status(ask_row_weakest_push(&run.row, 100, &push), DOM_OK);
        assert_true(push >= edge * (1 - 1e-12) && push <= 1.002 * edge);
    }
    /* A push stronger than needed is returned unchanged. */
    run.row.push = 2 * edge;
    assert_status(ask_row_weakest_push(&run.row, 100, &push), DOM_OK);
    assert_true(push == (double)run.row.push);
    run.row.push = 0;
    push = 0;
    assert_status(ask_row_weakest_push(&run.row, 0.99 * edge, &push), DOM_OK);
    assert_true(isnan((double)push));
}

/* Checks that all dominoes fall with the weakest push and not with 0.2 % less, even if the first domino
 * touches the second before it tips over its edge. */
TEST(the_weakest_push)
{
    static struct run run;
    uint64_t seed = 84;
    int found = 0, none = 0;
    for (int i = 0; i < 100; i++) {
        row_of_kind(&run, &seed, i % 2 ? 1 : 3);
        run.row.push = i % 2 ? DOMQ_NAN : 0.3 * push_over(run.domino);
        if (i % 3 == 0 && run.row.count > 1)
            run.domino[1].gap = 0.05 * (double)run.domino[0].height;
        if (row_end(&run) == DOM_ROW_FALLS)
            continue;
        double push;
        assert_status(ask_row_weakest_push(&run.row, 1e3, &push), DOM_OK);
        none += isnan((double)push);
        if (isnan((double)push))
            continue;
        assert_true(falls_pushed(&run, push));
        assert_false(falls_pushed(&run, 0.998 * (double)push));
        char digits[32];
        snprintf(digits, sizeof digits, "%.4g", (double)push);
        assert_near("four digits", push, strtod(digits, NULL), 1e-15);
        found++;
    }
    print_message("# %d pushes, %d rows have none\n", found, none);
    assert_true(found > 20 && none > 5);
}
