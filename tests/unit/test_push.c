/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The weakest push with which a row falls. */
#include "run.h"
#include "support.h"

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
