/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf */
#include "session/query.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void run_context_note(const struct run_context *run_context, const char *format, ...)
{
    char text[PROBLEM_TEXT];
    va_list arguments;
    if (!run_context->note)
        return;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    run_context->note(run_context->note_context, text);
}

char *path_beside(const struct run_context *run_context, const char *name)
{
    const char *slash = run_context->script && *name != '/' ? strrchr(run_context->script, '/') : NULL;
    char *path = NULL;
    if (slash &&
        asprintf(&path, "%.*s%s", (int)(slash + 1 - run_context->script), run_context->script, name) < 0)
        return NULL;
    if (path && access(path, F_OK) == 0)
        return path;
    free(path);
    return strdup(name);
}
