/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: errors */
/*
 * The errors that the calculator shows (src/errors), compared with the tables of 40 digits
 * in tests/reference. The parameters are the decimal numbers of the tables, so the errors also contain what
 * is lost when they are rounded to double. tests/hard/test_sweep.c does the same for random trains.
 */
#include "support.h"

#include "interpreter/question.h"
#include "language/quad.h"
#include "session/session.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct session session;
static char *text;
static size_t length;

/* Runs a line in the session and returns what it has printed. */
static const char *answer_to(const char *line)
{
    rewind(session.output->out);
    command_run_text(&session, line);
    fflush(session.output->out);
    return text;
}

static void begin(void)
{
    features_register(every_feature);
    session_init(&session, open_memstream(&text, &length));
    answer_to("set output json; set errors on");
    assert_int_equal(session.errors, 0);
}

/* Returns the number after a key, or NaN if it is null. */
static domq_real number_of(const char *answer, const char *key, const char *suffix)
{
    char member[64];
    snprintf(member, sizeof member, "\"%s%s\":", key, suffix);
    const char *at = strstr(answer, member);
    if (!at)
        fail_msg("no %s in %s", member, answer);
    at = at ? at + strlen(member) : "";
    return strncmp(at, "null", 4) == 0 ? DOMQ_NAN : quad_read(at, NULL);
}

/* Counts the numbers that have been compared. */
static int compared;

/* Checks that the error of a number covers its difference from the table. `digits` is the relative accuracy
 * of the table. */
static void covered(const char *answer, const char *key, const struct csv *csv, const char *column,
                    double digits)
{
    const char *field = csv_text(csv, column);
    const domq_real got = number_of(answer, key, ""), error = number_of(answer, key, "_error");
    if (!*field)
        return;
    const domq_real want = quad_read(field, NULL), off = quad(fabs)(got - want);
    if (isnan(error))
        fail_msg("%s has no error in %s", key, answer);
    if (!(off <= error + (domq_real)digits * quad(fabs)(want)))
        fail_msg("%s is off by %.3g, with an error of %.3g, in %s", key, (double)off, (double)error, answer);
    compared++;
}

static const char *ask(const char *format, ...) __attribute__((format(printf, 1, 2)));
static const char *ask(const char *format, ...)
{
    char line[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    return answer_to(line);
}

/* The tables have 25 digits, but only 14 for durations. */
static const double all = 1e-19;

static const struct {
    const char *command, *key, *column;
    double digits;
    bool tilted; /* the command takes the tilt of the table */
} asked[] = {
    {"thetac", "theta_c", "theta_c", 1e-19, false},
    {"thetac", "theta_f", "theta_f", 1e-19, false},
    {"thetac", "theta_leave", "theta_leave", 1e-19, false},
    {"theta1", "theta_1", "theta_1", 1e-19, true},
    {"theta1", "slope", "dtheta_1", 1e-19, true},
    {"energy", "J0", "J0", 1e-19, true},
    {"energy", "J", "J", 1e-19, true},
    {"energy", "dH", "dH", 1e-19, true},
    {"fuel", "fuel_exact", "fuel_exact", 1e-19, false},
    {"fuel", "fuel_paper", "fuel_paper", 1e-19, false},
    {"barrier", "theta_m", "theta_m", 1e-19, false},
    {"barrier", "barrier", "barrier", 1e-19, false},
    {"launch", "omega0sq", "omega0sq_exact", 1e-19, false},
    {"duration", "duration", "duration_exact", 1e-13, false},
};

static void points(const char *precision)
{
    struct csv *csv = csv_open("tests/reference/points.csv");
    compared = 0;
    while (csv_next(csv)) {
        ask("reset; set output json; set errors on; set precision %s; s = %s; r = %s; q = %s; d = %s",
            precision, csv_text(csv, "s"), csv_text(csv, "r"), csv_text(csv, "q"), csv_text(csv, "d"));
        for (size_t i = 0; i < sizeof asked / sizeof *asked; i++) {
            const char *a = ask("%s %s", asked[i].command, asked[i].tilted ? csv_text(csv, "theta") : "");
            /* a train that has no fuel or stops has no launch or duration */
            if (i + 2 < sizeof asked / sizeof *asked || !isnan(number_of(a, asked[i].key, "")))
                covered(a, asked[i].key, csv, asked[i].column, asked[i].digits);
        }
    }
    print_message("# %s: %d numbers\n", precision, compared);
    assert_true(compared > 180);
}

TEST(errors_cover_the_differences_from_the_tables)
{
    begin();
    points("float");
    points("double");
}

/* This table is for the numbers in double precision that are nearest to its parameters. */
TEST(errors_with_friction)
{
    struct csv *csv = csv_open("tests/reference/friction.csv");
    compared = 0;
    while (csv_next(csv)) {
        ask("reset; set output json; set errors on; s = %.60g; r = %.60g; q = %.60g; d = %.60g; effect "
            "friction %.60g",
            csv_number(csv, "s"), csv_number(csv, "r"), csv_number(csv, "q"), csv_number(csv, "d"),
            csv_number(csv, "mu"));
        covered(ask("launch"), "omega0sq", csv, "omegasq_0", all);
        covered(ask("omega %.60g", csv_number(csv, "theta_1")), "omegasq", csv, "omegasq_1", all);
        covered(ask("omega %.60g", csv_number(csv, "theta_2")), "omegasq", csv, "omegasq_2", all);
        covered(ask("duration"), "duration", csv, "duration", all);
        covered(ask("rmax"), "r_max", csv, "r_max", all);
    }
    print_message("# %d numbers\n", compared);
    assert_true(compared > 100);
}

TEST(errors_of_growths)
{
    struct csv *csv = csv_open("tests/reference/rmax.csv");
    compared = 0;
    while (csv_next(csv)) {
        ask("reset; set output json; set errors on; s = %s; q = %s; d = %s; set fuel %s", csv_text(csv, "s"),
            csv_text(csv, "q"), csv_text(csv, "d"), csv_text(csv, "fuel"));
        /* The table has 18 digits of a growth in double precision. */
        covered(ask("rmax"), "r_max", csv, "r_max", 2e-15);
    }
    assert_true(compared > 40);
}
