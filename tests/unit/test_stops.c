/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows chance sweeps */
/*
 * ^C in the shell, without a clock. The library's check of the flag and the shell's function for the lean of
 * a domino are replaced by functions that count their calls, and that raise the flag at the k-th. Whatever k
 * is, a long command must end soon after this call.
 */
#define _GNU_SOURCE /* fopencookie */
#include "io/io.h"
#include "support.h"

#include "domino_quad.h"
#include "interpreter/question.h"
#include "session/session.h"
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The checks that may follow: those of a search that evaluates a function once more before it returns. */
enum { ROW = 150, FURTHER = 64 };

static struct session session;
static volatile sig_atomic_t flag;
static size_t checks, raise_at;

static void count_check(void)
{
    if (++checks >= raise_at)
        flag = 1;
}

bool __wrap_dom_interrupted(const volatile sig_atomic_t *raised);
bool __wrap_dom_interrupted(const volatile sig_atomic_t *raised)
{
    (void)raised;
    count_check();
    return flag;
}

void __real_domq_lean_limits(const struct domq_domino *domino, domq_real alpha, domq_real rho,
                             domq_real *lean);
void __wrap_domq_lean_limits(const struct domq_domino *domino, domq_real alpha, domq_real rho,
                             domq_real *lean);
void __wrap_domq_lean_limits(const struct domq_domino *domino, domq_real alpha, domq_real rho,
                             domq_real *lean)
{
    count_check();
    __real_domq_lean_limits(domino, alpha, rho, lean);
}

/* A line of output counts as a check. */
static ssize_t line_count(void *cookie, const char *bytes, size_t size)
{
    (void)cookie;
    for (size_t i = 0; i < size; i++)
        if (bytes[i] == '\n')
            count_check();
    return (ssize_t)size;
}

static void session_begin(void)
{
    features_register(every_feature);
    session_init(&session, fopencookie(&session, "w", (cookie_io_functions_t){.write = line_count}));
    setvbuf(session.output->out, NULL, _IOLBF, BUFSIZ);
    assert_non_null(session.output->out);
    session.state.scene.compute.interrupt = io_interrupt = &flag;
}

/* Runs a line and raises the flag at check number `at`, or before the line if `at` is 0. Returns the number
 * of checks. */
static size_t checks_of(const char *line, size_t at)
{
    flag = at == 0;
    checks = 0;
    raise_at = at;
    session.errors = 0;
    const int messages = dup(STDERR_FILENO), none = open("/dev/null", O_WRONLY);
    dup2(none, STDERR_FILENO);
    command_run_text(&session, line);
    dup2(messages, STDERR_FILENO);
    close(messages);
    close(none);
    return checks;
}

/* Checks that a line ends soon after the flag is raised at one of several checks. */
static void line_stops(const char *line)
{
    const size_t all = checks_of(line, SIZE_MAX);
    if (session.errors > 0 || all < 10)
        fail_msg("'%s' has %ld errors and %zu checks", line, session.errors, all);
    for (size_t i = 0; i <= 12; i++) {
        const size_t at = i < 4 ? 1 + i : all * (i - 3) / 10;
        const size_t made = at < all ? checks_of(line, at) : at;
        if (made > at + FURTHER || (at < all && session.errors == 0))
            fail_msg("'%s', interrupted at check %zu of %zu: %ld errors, %zu more checks", line, at, all,
                     session.errors, made - at);
    }
}

/* Even before its first domino falls, a command looks at every domino of a long row. */
TEST(long_rows)
{
    static const char *const lines[] = {"row",          "tolerance", "placement 8",
                                        "budget 0.5 8", "fall",      "verdict",
                                        "rowmax",       "mend",      "sweep friction 0 0.2 3 : verdict"};
    char row[80];
    session_begin();
    snprintf(row, sizeof row, "set r 1; set row %d; set placement 1 mm; set threads 1; set output csv", ROW);
    checks_of(row, SIZE_MAX);
    assert_int_equal(session.errors, 0);
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        line_stops(lines[i]);
    checks_of("change all gap +1 mm", 0);
    assert_int_equal(session.errors, 1);
}

/* Writes a line into a new file, several times. Puts the name of the file, which the caller removes, into
 * `path`, which ends with XXXXXX. */
static void file_make(char *path, const char *head, const char *line, int times)
{
    const int file = mkstemp(path);
    FILE *out = file >= 0 ? fdopen(file, "w") : NULL;
    assert_non_null(out);
    fputs(head, out);
    for (int i = 0; i < times; i++)
        fputs(line, out);
    fclose(out);
}

TEST(a_long_file)
{
    char line[] = "set row /tmp/domino.XXXXXX", *path = line + strlen("set row ");
    file_make(path, "height (mm),thickness (mm),gap (mm)\n", "48,7.5,20\n", ROW);
    checks_of(line, SIZE_MAX);
    assert_int_equal(session.errors, 0);
    checks_of(line, 0);
    assert_int_equal(session.errors, 1);
    unlink(path);
}

/* ^C between two commands of a file is reported, too. */
TEST(a_sourced_file)
{
    char line[] = "source /tmp/domino.XXXXXX", *path = line + strlen("source ");
    file_make(path, "", "help tol\n", 30);
    line_stops(line);
    unlink(path);
}
