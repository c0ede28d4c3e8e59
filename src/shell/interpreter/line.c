/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/line.h"
#include "interpreter/command.h"
#include "language/text.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

void line_stream(struct session *session, FILE *in, const char *name)
{
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
    int reason = ferror(in) || errno == ENOMEM ? errno : 0;
    if (reason && reason != ECANCELED)
        session_error(session, "cannot read the next line: %s", strerror(reason));
    free(text);
    session->source = outer.source;
    session->line = outer.line;
    session->prompt_width = outer.prompt_width;
    session->command = outer.command;
    if (reason == ECANCELED) /* of the command that reads the stream, not of one of its lines */
        session_status(session, DOM_INTERRUPTED);
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
