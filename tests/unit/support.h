/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tools for unit tests: cmocka, tables of reference values, and comparisons with a name for messages. */
#ifndef TEST_SUPPORT_H
#define TEST_SUPPORT_H

#include "ask.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Checks |value / expected - 1| <= bound, or that the value is 0 if 0 is expected. */
#define assert_near(what, value, expected, bound) near_(what, value, expected, bound, __FILE__, __LINE__)

static inline void near_(const char *what, double value, double expected, double bound, const char *file,
                         int line)
{
    double error = expected == 0 ? fabs(value) : fabs(value - expected) / fabs(expected);
    if (error <= bound)
        return;
    fprintf(stderr, "%s:%d: %s = %.17g, expected %.17g: relative error %.2g > %.2g\n", file, line, what,
            value, expected, error, bound);
    _fail(file, line);
}

/* Checks that the numbers of the two public headers agree to a relative difference. Both may be NaN. */
#define assert_in_both(what, value, wide, bound) same_(what, value, wide, bound, __FILE__, __LINE__)

static inline void same_(const char *what, double value, domq_real wide, double bound, const char *file,
                         int line)
{
    if (value == (double)wide || (isnan(value) && isnan((double)wide)) ||
        fabs(value - (double)wide) <= bound * fabs(value))
        return;
    fprintf(stderr, "%s:%d: %s = %.17g, but %.17g in <domino_quad.h>\n", file, line, what, value,
            (double)wide);
    _fail(file, line);
}

#define assert_status(status, expected)                                                                      \
    assert_string_equal(dom_status_text(status), dom_status_text(expected))

/* Fails with a number and the train that gave it. */
static inline void fail_train(const char *what, const struct setup *t, double got, double expected)
{
    fail_msg("%s: %.17g, expected %.17g at s %.17g r %.17g d %.17g q %.17g mu %.17g alpha %.17g rho %.17g",
             what, got, expected, (double)t->s, (double)t->r, (double)t->d, (double)t->q, (double)t->mu,
             (double)t->alpha, (double)t->rho);
}

enum { CSV_COLUMNS = 32, CSV_LINE = 2048 };

/* A reference table, which is read row by row. Fields are found by the names in the first line. */
struct csv {
    FILE *file;
    char head[CSV_LINE], row[CSV_LINE];
    char *name[CSV_COLUMNS], *field[CSV_COLUMNS];
    int columns;
};

static inline int csv_split(char *line, char **field)
{
    int n = 0;
    line[strcspn(line, "\r\n")] = '\0';
    for (char *rest = line; rest && n < CSV_COLUMNS;)
        field[n++] = strsep(&rest, ",");
    return n;
}

static inline struct csv *csv_open(const char *path)
{
    static struct csv csv;
    csv.file = fopen(path, "r");
    assert_non_null(csv.file);
    assert_non_null(fgets(csv.head, sizeof csv.head, csv.file));
    csv.columns = csv_split(csv.head, csv.name);
    return &csv;
}

static inline bool csv_next(struct csv *csv)
{
    if (!fgets(csv->row, sizeof csv->row, csv->file)) {
        fclose(csv->file);
        return false;
    }
    assert_int_equal(csv_split(csv->row, csv->field), csv->columns);
    return true;
}

static inline const char *csv_text(const struct csv *csv, const char *name)
{
    for (int i = 0; i < csv->columns; i++)
        if (strcmp(csv->name[i], name) == 0)
            return csv->field[i];
    fail_msg("no column %s", name);
    return "";
}

/* Returns the number in a field, or NaN if the field is empty. */
static inline double csv_number(const struct csv *csv, const char *name)
{
    const char *text = csv_text(csv, name);
    return *text ? strtod(text, NULL) : DOMQ_NAN;
}

static inline struct setup csv_train(const struct csv *csv)
{
    struct setup train = setup_default();
    train.s = csv_number(csv, "s");
    train.q = csv_number(csv, "q");
    return train;
}

/* Returns the next random number in [0, 1). A seed gives the same numbers on every machine (SplitMix64). */
static inline double random_unit(uint64_t *seed)
{
    uint64_t z = *seed += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static inline double random_log(uint64_t *seed, double lo, double hi)
{
    return lo * pow(hi / lo, random_unit(seed));
}

/* Returns a random train with r s <= 1. One in four is close to the reach. */
static inline struct setup random_train(uint64_t *seed)
{
    struct setup train = setup_default();
    train.tol = 1e-15;
    train.s = random_log(seed, 3e-3, 1);
    train.d = random_log(seed, 1e-4, 2);
    train.q = 1 + 5 * random_unit(seed);
    double reach = fmin(1 / train.s, 50);
    train.r = random_unit(seed) < 0.25 ? reach * (1 - random_log(seed, 1e-12, 1e-2))
                                       : pow(reach, random_unit(seed));
    train.r = fmax(train.r, 1);
    return train;
}

#endif
