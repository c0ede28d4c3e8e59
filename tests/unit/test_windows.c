/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows */
/* Windows: the verdict changes at the ends of a window, and all dominoes fall between them. */
#include "run.h"
#include "support.h"

enum { MOST = ROW_MOST };
static struct dom_window windows[MOST];

/* Finds all windows of one kind. Returns the number of passes. */
static double find(struct run *run, enum dom_window_of of, struct dom_window *found)
{
    struct dom_work work = {0};
    run->row.domino = run->domino;
    run->row.work = &work;
    assert_status(ask_row_windows(&run->row, of, NULL, NULL, found), DOM_OK);
    run->row.work = NULL;
    return (double)work.passes;
}

static void random_row(struct run *run, uint64_t *seed)
{
    size_t count = 3 + (size_t)(5 * random_unit(seed));
    make_row(run, count, 0.2 + 0.4 * random_unit(seed), 1.1 + 0.4 * random_unit(seed),
             random_unit(seed) < 0.7 ? 0 : 0.3 * random_unit(seed));
    for (size_t k = 0; k < count; k++) {
        run->domino[k].gap *= 0.8 + 0.4 * random_unit(seed);
        run->domino[k].thickness *= 0.7 + 0.6 * random_unit(seed);
    }
    run->row.push *= random_log(seed, 0.6, 3);
}

/* Changes one value of the row as a builder would, without the library, and returns true if the row falls. */
static bool falls_changed(const struct run *run, enum dom_window_of of, const struct dom_window *w,
                          double value)
{
    static struct run other;
    other = *run;
    struct domq_domino *d = &other.domino[w->domino ? w->domino - 1 : 0];
    if (of == DOM_WINDOW_GAP) {
        d->gap = value;
    } else if (of == DOM_WINDOW_PLACE) {
        domq_real by = value - w->now;
        d->gap = fmax((double)(d->gap + by), 0);
        if (w->domino < other.row.count)
            d[1].gap = fmax((double)(d[1].gap - by), 0);
    } else if (of == DOM_WINDOW_HEIGHT) {
        d->mass *= value / d->height;
        d->height = value;
    } else if (of == DOM_WINDOW_LEAN) {
        d->lean = value;
    } else if (of == DOM_WINDOW_THICKNESS) {
        d->mass *= value / d->thickness;
        d->thickness = value;
    } else {
        other.row.mu = value;
    }
    other.row.domino = other.domino;
    return ask_row_run(&other.row, false, NULL, NULL, &other.verdict) == DOM_OK &&
           other.verdict.end == DOM_ROW_FALLS;
}

/* Checks that a value can be typed with seven digits. */
static void check_digits(double value)
{
    char digits[32];
    snprintf(digits, sizeof digits, "%.7g", value);
    assert_true(strtod(digits, NULL) == value);
}

/* Checks that all dominoes fall with the values of a window, but not with values just outside, unless the
 * window ends at the limit of the range. */
static void check_window(const struct run *run, enum dom_window_of of, const struct dom_window *w,
                         int ends[2])
{
    double low = (double)w->low, high = (double)w->high;
    const double size = fmax(fabs(low), fabs(high)), digit = pow(10, floor(log10(fmax(size, 1e-3))) - 6),
                 outside = of == DOM_WINDOW_GAP ? 2 * digit : 20 * digit + 1e-9 * size;
    /* Gaps have a limit on either side, unless they reach 0. Other windows may end at the end of the range.
     */
    const bool ends_below = of == DOM_WINDOW_GAP ? low > 0 : !falls_changed(run, of, w, low - outside),
               ends_above = of == DOM_WINDOW_GAP || !falls_changed(run, of, w, high + outside);
    assert_true(of != DOM_WINDOW_GAP || (low >= 0 && high <= (double)run->domino[w->domino - 2].height));
    assert_true(low <= high);
    for (int part = 0; part <= 8; part++)
        assert_true(falls_changed(run, of, w, low + (high - low) * part / 8));
    if (ends_below && of <= DOM_WINDOW_HEIGHT)
        check_digits(low);
    if (ends_below)
        assert_false(falls_changed(run, of, w, low - outside));
    if (ends_above)
        assert_false(falls_changed(run, of, w, high + outside));
    ends[0] += ends_below;
    ends[1] += ends_above;
}

/* Checks a gap of a row that does not fall: no gap between the present one and the window mends the row, and
 * if there is no window, none does. */
static void check_nearer(const struct run *run, const struct dom_window *w)
{
    enum { FINE = 40 };
    const double tall = (double)run->domino[w->domino - 2].height, from = isnan(w->low) ? 0 : w->now,
                 to = isnan(w->low)     ? tall
                      : w->now < w->low ? w->low
                                        : w->high;
    for (int j = 0; j < FINE; j++)
        if (falls_changed(run, DOM_WINDOW_GAP, w, from + (to - from) * 0.9999 * j / (FINE - 1)))
            fail_msg("domino %zu falls with a gap nearer to %g than %g", w->domino, w->now, to);
}

TEST(the_verdict_changes_at_the_ends)
{
    static struct run run;
    uint64_t seed = 41;
    /* at least so many windows end where the verdict changes, and not at the end of the range */
    static const int least[DOM_WINDOW_THICKNESS + 1][2] = {{45, 81}, {52, 63}, {103, 98},
                                                           {19, 15}, {75, 75}, {53, 80}};
    int ends[DOM_WINDOW_THICKNESS + 1][2] = {{0}}, beside = 0, none = 0;
    for (int i = 0; i < 30; i++) {
        random_row(&run, &seed);
        run.row.alpha = random_unit(&seed) < 0.8 ? 0 : 0.05;
        run.domino[run.row.count / 2].height *= i % 3 ? 1 : 2;
        /* rounded edges leave taller dominoes no foot to stand on */
        run.row.rho = i % 5 == 1 && run.row.alpha == 0 ? 0.02 : 0;
        for (size_t k = 0; k < run.row.count; k++) {
            run.domino[k].radius = i % 10 == 1 ? run.domino[k].thickness / 3 : 0;
            run.domino[k].lean = i % 5 == 2 && run.row.alpha == 0 ? 0.01 : 0;
        }
        bool falls = row_end(&run) == DOM_ROW_FALLS;
        const size_t count = run.row.count, ends_at = run.verdict.domino;
        for (enum dom_window_of of = DOM_WINDOW_GAP; of <= DOM_WINDOW_THICKNESS; of++) {
            if (of == DOM_WINDOW_LEAN && run.row.rho != 0)
                continue;
            size_t first = of <= DOM_WINDOW_PLACE ? 1 : 0;
            size_t end = of == DOM_WINDOW_FRICTION ? 1 : count;
            find(&run, of, windows);
            for (size_t k = first; k < end; k++) {
                const struct dom_window *w = &windows[k - first];
                assert_int_equal(w->domino, of == DOM_WINDOW_FRICTION ? 0 : k + 1);
                none += isnan((double)w->low);
                if (of == DOM_WINDOW_GAP && !falls)
                    check_nearer(&run, w);
                if (isnan((double)w->low)) {
                    assert_false(falls);
                    continue;
                }
                assert_true(of != DOM_WINDOW_GAP || w->now == (double)run.domino[k].gap);
                assert_true(of != DOM_WINDOW_GAP || falls || w->domino <= ends_at + 1);
                assert_true(!falls || (w->low <= w->now && w->now <= w->high));
                assert_true(falls || w->now < w->low || w->now > w->high);
                check_window(&run, of, w, ends[of]);
                beside += !falls;
            }
        }
    }
    for (int of = DOM_WINDOW_GAP; of <= DOM_WINDOW_THICKNESS; of++) {
        print_message("# kind %d: %d ends below, %d above\n", of, ends[of][0], ends[of][1]);
        assert_true(ends[of][0] >= least[of][0] && ends[of][1] >= least[of][1]);
    }
    print_message("# %d beside, %d have none\n", beside, none);
    assert_true(beside > 5 && none > 5);
}

/* Checks that a trial runs only the part of the row that the change affects: a row twice as long takes little
 * more than twice as many passes, whereas runs of the whole row would take at least four times as many. */
TEST(work_grows_with_the_row)
{
    static struct run part, whole;
    make_row(&part, 20, 0.5, 1, 0);
    make_row(&whole, 40, 0.5, 1, 0);
    const double few = find(&part, DOM_WINDOW_GAP, windows), many = find(&whole, DOM_WINDOW_GAP, windows);
    print_message("# %.0f passes for 20 dominoes, %.0f for 40\n", few, many);
    assert_true(many < 2.6 * few && few > 1e4);
}

/* Checks that a window takes less work if the domino equals the one before it. If the dominoes differ by
 * rounding errors, the whole range is searched, and the windows must be the same. */
TEST(equal_dominoes)
{
    static const struct {
        double mu, alpha, rho, lean;
    } rows[] = {{0, 0, 0, 0}, {0.1, 0.01, 0, 0}, {0, 0, 0, 0.01}, {0, 0, 0.01, 0}};
    static struct run equal, differ;
    static struct dom_window one[MOST], other[MOST];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (enum dom_window_of of = DOM_WINDOW_GAP; of <= DOM_WINDOW_THICKNESS; of++) {
            if (of == DOM_WINDOW_FRICTION || (of == DOM_WINDOW_LEAN && rows[i].rho != 0) || (of + i) % 2)
                continue;
            make_row(&equal, 20, 0.4, 1, rows[i].mu);
            equal.row.alpha = (domq_real)rows[i].alpha;
            equal.row.rho = (domq_real)rows[i].rho;
            for (size_t k = 0; k < 20; k++)
                equal.domino[k].lean = (domq_real)rows[i].lean;
            differ = equal;
            for (size_t k = 0; k < 20; k++)
                differ.domino[k].mass *= (domq_real)(1 + 1e-14 * (double)k);
            const double few = find(&equal, of, one), many = find(&differ, of, other);
            print_message("# row %zu, kind %d: %.0f passes, %.0f without a guess\n", i, (int)of, few, many);
            assert_true(few < many / 2);
            for (size_t k = 0; k < (of <= DOM_WINDOW_PLACE ? 19 : 20); k++) {
                const double digit = pow(10, floor(log10((double)one[k].high)) - 6);
                assert_true(fabs((double)(one[k].low - other[k].low)) < 1.5 * digit);
                assert_true(fabs((double)(one[k].high - other[k].high)) < 1.5 * digit);
                assert_true(one[k].now == other[k].now);
            }
        }
}

/* Checks a long row that stops, in which only the gap after the last domino that is hit and the 30 gaps
 * before it are tried. */
TEST(a_long_row_that_stops)
{
    static struct run run;
    make_row(&run, 60, 0.3, 1, 0);
    run.domino[49].height *= 3;
    run.domino[49].thickness *= 3;
    run.domino[49].mass *= 200;
    assert_int_equal(row_end(&run), DOM_ROW_STOPS);
    assert_int_equal(run.verdict.domino, 50);
    find(&run, DOM_WINDOW_GAP, windows);
    for (size_t k = 0; k < 59; k++)
        assert_true(isnan(windows[k].low) || (windows[k].domino >= 21 && windows[k].domino <= 51));
}

static void progress_seen(size_t done, size_t of, void *context)
{
    size_t *before = context;
    assert_true(done == *before + 1 && done <= of);
    *before = done;
}

/* Checks that a single domino has no window, that progress is reported for every domino, and that places are
 * measured from the back of the first domino to the back of each domino. */
TEST(few_dominoes)
{
    static struct run run;
    size_t done = 0;
    double place = 0;
    make_row(&run, 1, 0.3, 1, 0);
    find(&run, DOM_WINDOW_GAP, windows);
    make_row(&run, 4, 0.3, 1.2, 0);
    run.row.domino = run.domino;
    assert_status(ask_row_windows(&run.row, DOM_WINDOW_PLACE, progress_seen, &done, windows), DOM_OK);
    assert_int_equal(done, 3);
    for (size_t k = 1; k < 4; k++) {
        place += (double)(run.domino[k - 1].thickness + run.domino[k].gap);
        assert_near("place", (double)windows[k - 1].now, place, 1e-14);
    }
}
