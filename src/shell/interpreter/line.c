/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/line.h"
#include "interpreter/command.h"
#include "language/text.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

/*
 * Adds the lines that continue this one, and counts them.  They end with the stream, and where the text would
 * be too long.  Returns false where one has a NUL byte, or there is no memory.
 */
static bool line_join(char **text, size_t *room, FILE *in, long *more)
{
    char *next = NULL;
    size_t size = 0, used = strlen(*text);
    ssize_t length = 0;
    bool goes_on = true, good = true;
    while (goes_on && good && used <= TEXT_MOST && (length = text_read(&next, &size, in)) != -1) {
        ++*more;
        good = strlen(next) == (size_t)length;
        goes_on = good && text_continues(next);
        size_t n = strlen(next);
        if (good && used + n >= *room) {
            char *larger = realloc(*text, used + n + 1);
            good = larger != NULL;
            *text = good ? larger : *text;
            *room = good ? used + n + 1 : *room;
        }
        if (good)
            memcpy(*text + used, next, n + 1);
        used += n;
    }
    free(next);
    return good;
}

void line_stream(struct session *session, FILE *in, const char *name)
{
    char *text = NULL;
    size_t size = 0;
    ssize_t length;
    struct session outer = *session;
    session->source = name;
    session->script = in;
    session->line = 0;
    session->prompt_width = 0;
    session->command = NULL;
    errno = 0;
    while (!session->quit && (length = text_read(&text, &size, in)) != -1) {
        long errors = session->errors, more = 0;
        session->line++;
        bool whole = strlen(text) == (size_t)length;
        if (whole && text_continues(text))
            whole = line_join(&text, &size, in, &more);
        if (whole)
            command_run_text(session, text);
        else
            session_error(session, "the line has a NUL byte; commands are text");
        session->line += more;
        if (session_stops(session, errors) || (!whole && length > TEXT_MOST))
            break;
        errno = 0;
    }
    int reason = ferror(in) || errno == ENOMEM ? errno : 0;
    if (reason && reason != ECANCELED)
        session_error(session, "cannot read the next line: %s", strerror(reason));
    free(text);
    session->source = outer.source;
    session->script = outer.script;
    session->line = outer.line;
    session->prompt_width = outer.prompt_width;
    session->command = outer.command;
    if (reason == ECANCELED &&
        session->command) { /* the problem of the command that reads the stream, not of one of its lines */
        struct problem problem = {.command = session->command};
        problem_status(&problem, &session->state.scene, DOM_INTERRUPTED);
        session_problem(session, &problem);
    }
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
