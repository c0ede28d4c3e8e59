/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "terminal.h"
#include <langinfo.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

bool terminal_colour(FILE *stream)
{
    const char *term = getenv("TERM"), *no = getenv("NO_COLOR");
    return isatty(fileno(stream)) && !(no && *no) && term && *term && strcmp(term, "dumb") != 0;
}

int terminal_width(FILE *stream)
{
    struct winsize size;
    int file = fileno(stream);
    return isatty(file) && ioctl(file, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

bool terminal_utf8(void)
{
    return strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
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

void progress_show(struct progress *p, double fraction)
{
    double now = terminal_clock();
    if (p->begun == 0)
        p->begun = now;
    if (fraction >= 1 && p->shown > 0) {
        fputs("\r\033[K", stderr);
        p->shown = 0;
    }
    if (fraction >= 1 || now - p->begun < 1 || now - p->shown < 0.2 || !isatty(STDERR_FILENO))
        return;
    p->shown = now;
    fprintf(stderr, "\r%.0f %%, %.0f s left ", 100 * fraction, (now - p->begun) * (1 / fraction - 1));
    fflush(stderr);
}
