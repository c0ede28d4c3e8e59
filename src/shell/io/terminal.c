/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/terminal.h"
#include <langinfo.h>
#include <locale.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

/* Streams that pass their text on to standard output; NULL for none. */
static const FILE *lent[3];

void terminal_lend(const FILE *stream, bool on)
{
    int i = 0;
    while (i < 2 && lent[i] != (on ? NULL : stream))
        i++;
    lent[i] = on ? stream : NULL;
}

/* Returns true for a terminal; the three files that a program begins with are asked once. */
static bool is_terminal(int file)
{
    static atomic_schar known[STDERR_FILENO + 1]; /* 1: a terminal, -1: none */
    if (file < 0 || file > STDERR_FILENO)
        return file >= 0 && isatty(file);
    if (known[file] == 0)
        known[file] = isatty(file) ? 1 : -1;
    return known[file] > 0;
}

/* Returns the file of the terminal that shows what the stream takes, or -1. */
static int shown_on(FILE *stream)
{
    bool passes = stream == lent[0] || stream == lent[1] || stream == lent[2];
    int file = fileno(passes ? stdout : stream);
    return is_terminal(file) ? file : -1;
}

bool terminal_colour(FILE *stream)
{
    if (shown_on(stream) < 0)
        return false;
    const char *term = getenv("TERM"), *no = getenv("NO_COLOR");
    return !(no && *no) && term && *term && strcmp(term, "dumb") != 0;
}

bool terminal_size(FILE *stream, int *width, int *height)
{
    struct winsize size = {0};
    int file = shown_on(stream);
    bool known = file >= 0 && ioctl(file, TIOCGWINSZ, &size) == 0;
    *width = size.ws_col;
    *height = size.ws_row;
    return known;
}

int terminal_width(FILE *stream)
{
    int width, height;
    return terminal_size(stream, &width, &height) ? width : 0;
}

bool terminal_utf8(void)
{
    static bool begun; /* the files of the locale are read where letters matter, not at every start */
    if (!begun)
        setlocale(LC_CTYPE, ""); /* never LC_NUMERIC: the decimal point is a point */
    begun = true;
    return strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
}

bool terminal_decimal_comma(void)
{
    locale_t locale = newlocale(LC_NUMERIC_MASK, "", (locale_t)0);
    bool comma = locale && *nl_langinfo_l(RADIXCHAR, locale) == ',';
    if (locale)
        freelocale(locale);
    return comma;
}

int terminal_columns(const char *text)
{
    int columns = 0;
    for (; *text; text++)
        columns += ((unsigned char)*text & 0xc0) != 0x80;
    return columns;
}

double terminal_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Overwrites the line with blanks, because a dumb terminal has no control sequences. */
static void wipe(void)
{
    fprintf(stderr, "\r%*s\r", 30, "");
}

/* ---- The ticker: a signal handler that writes a few bytes ---- */

/* Written by the handler, and by whichever thread has the first row. */
static atomic_int ticks, ticker_quiet;

/* True while the ticker uses SIGALRM; and the handler that it replaced. */
static bool ticking;
static struct sigaction alarm_before;

static void on_tick(int number)
{
    (void)number;
    if (ticker_quiet || ticks > 99999)
        return;
    char text[] = "\r      s; ^C stops it ";
    int n = ++ticks;
    for (char *digit = text + 5; n > 0; n /= 10)
        *digit-- = (char)('0' + n % 10);
    (void)!write(STDERR_FILENO, text, sizeof text - 1);
}

static void ticker_set(long first)
{
    const struct itimerval timer = {.it_value = {.tv_sec = first}, .it_interval = {.tv_sec = first}};
    setitimer(ITIMER_REAL, &timer, NULL);
}

void ticker_start(void)
{
    if (!is_terminal(STDERR_FILENO))
        return;
    const struct sigaction action = {.sa_handler = on_tick, .sa_flags = SA_RESTART};
    ticks = 0;
    ticker_quiet = 0;
    if (!ticking)
        sigaction(SIGALRM, &action, &alarm_before);
    ticking = true;
    ticker_set(1);
}

void ticker_stop(void)
{
    if (!ticking)
        return;
    ticker_set(0);
    sigaction(SIGALRM, &alarm_before, NULL);
    ticking = false;
    if (ticks > 0 && !ticker_quiet)
        wipe();
    ticks = 0;
}

static _Thread_local bool muted;

bool progress_mute(bool mute)
{
    bool before = muted;
    muted = mute;
    return before;
}

void progress_show(struct progress *p, double fraction)
{
    if (muted)
        return;
    double now = terminal_clock();
    if (ticks > 0 && !ticker_quiet && is_terminal(STDERR_FILENO))
        wipe();
    ticker_quiet = 1;
    if (p->begun == 0)
        p->begun = now;
    if (fraction >= 1 && p->shown > 0) {
        wipe();
        p->shown = 0;
    }
    if (fraction >= 1 || now - p->begun < 1 || now - p->shown < 0.2 || !is_terminal(STDERR_FILENO))
        return;
    p->shown = now;
    fprintf(stderr, "\r%.0f %%, %.0f s left ", 100 * fraction, (now - p->begun) * (1 / fraction - 1));
    fflush(stderr);
}
