/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parallel/progress.h"
#include "io/io.h"
#include "io/terminal.h"
#include <stdatomic.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

static atomic_int seconds; /* how long the command has been running, in s */
static atomic_int done;    /* progress of the command in millionths, or 0 if it is not known */

/* Writes a number and returns a pointer to the byte after the number. */
static char *number_write(char *to, long number)
{
    if (number >= 10)
        to = number_write(to, number / 10);
    *to = (char)('0' + number % 10);
    return to + 1;
}

/* The handler of SIGALRM, which arrives once a second. It must not call printf. */
static void on_tick(int number)
{
    const int all = 1000000;
    char text[80] = "\r", *end = text + 1;
    int now = ++seconds, part = done;
    (void)number;
    if (part > 0) {
        end = stpcpy(number_write(end, 100L * part / all), " %, ");
        end = stpcpy(number_write(end, (long)now * (all - part) / part), " s left      ");
    } else
        end = stpcpy(number_write(end, now), " s; ^C stops it ");
    (void)!write(STDERR_FILENO, text, (size_t)(end - text));
}

void progress_line(bool begins)
{
    static bool is_ticking;
    const struct itimerval every = {{begins, 0}, {begins, 0}};
    const struct sigaction action = {.sa_handler = on_tick, .sa_flags = SA_RESTART};
    if (is_ticking || (begins && terminal_shows(stderr))) {
        setitimer(ITIMER_REAL, &every, NULL);
        if (seconds >
            0) /* overwrites the line with blanks, because a dumb terminal has no control sequences */
            fprintf(stderr, "\r%*s\r", 30, "");
        seconds = done = 0;
        if (begins && !is_ticking)
            sigaction(SIGALRM, &action, NULL);
        is_ticking = begins;
    }
}

void progress_show(double fraction)
{
    if (!io_is_worker)
        done = fraction < 1 ? (int)(1e6 * fraction) : 0;
}
