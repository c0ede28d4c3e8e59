/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "line.h"
#include "command.h"
#include "text.h"
#include <errno.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

FILE *line_open(const char *name)
{
    struct stat status;
    FILE *in = fopen(name, "r");
    if (in && fstat(fileno(in), &status) == 0 && S_ISDIR(status.st_mode)) {
        fclose(in);
        errno = EISDIR;
        return NULL;
    }
    return in;
}

/*
 * Reads what is there.  Where nothing is, the program at the other end may wait for answers before it writes
 * the next command: they are sent before this one waits, and not after each command.
 */
static ssize_t read_on(void *cookie, char *block, size_t size)
{
    struct pollfd input = {.fd = *(const int *)cookie, .events = POLLIN};
    if (poll(&input, 1, 0) != 1)
        fflush(stdout);
    return read(input.fd, block, size);
}

/* Lets the next program that reads the same file go on behind the last line that was run. */
static int seek_on(void *cookie, off64_t *offset, int whence)
{
    *offset = lseek(*(const int *)cookie, *offset, whence);
    return *offset < 0 ? -1 : 0;
}

void line_stream(struct session *session, FILE *file, const char *name)
{
    int descriptor = fileno(file); /* a text in memory has none, and never waits */
    cookie_io_functions_t patient = {.read = read_on, .seek = seek_on};
    FILE *in = descriptor < 0 ? file : fopencookie(&descriptor, "r", patient);
    if (!in) {
        session_error(session, "cannot read '%s': %s", name, strerror(errno));
        return;
    }
    char *text = NULL;
    size_t size = 0;
    ssize_t length;
    struct session outer = *session;
    session->source = name;
    session->line = 0;
    session->prompt_width = 0;
    session->command = NULL;
    errno = 0;
    while (!session->quit && (length = text_read(&text, &size, in)) != -1) {
        long errors = session->errors;
        session->line++;
        if (strlen(text) != (size_t)length)
            session_error(session, "the line has a NUL byte; commands are text");
        else
            command_run_text(session, text);
        if (session_stops(session, errors))
            break;
        errno = 0;
    }
    if (ferror(in) || errno == ENOMEM)
        session_error(session, "cannot read on: %s", strerror(errno));
    free(text);
    fflush(in); /* takes back what was read ahead, where that can be */
    if (in != file)
        fclose(in);
    session->source = outer.source;
    session->line = outer.line;
    session->prompt_width = outer.prompt_width;
    session->command = outer.command;
}

bool line_path(const char *variable, const char *fallback, const char *name, char *path, size_t size)
{
    const char *base = getenv(variable), *home = getenv("HOME");
    int length = -1;
    if (base && *base == '/') /* XDG: relative ones do not count */
        length = snprintf(path, size, "%s/domino/%s", base, name);
    else if (home && *home)
        length = snprintf(path, size, "%s/%s/domino/%s", home, fallback, name);
    return length > 0 && (size_t)length < size;
}
