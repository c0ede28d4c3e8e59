/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session.h"
#include "interpreter/question.h"
#include "io/escape.h"
#include "io/io.h"
#include "session/session.h"
#include <ctype.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>

static volatile sig_atomic_t enough;

static void on_timer(int number)
{
    (void)number;
    enough = 1;
}

/* Returns the text after a json value, which is a string, a number, true, false or null. Returns NULL if the
 * value is wrong. */
static const char *json_value(const char *c)
{
    if (*c == '"') {
        for (c++; *c && *c != '"'; c++)
            c += *c == '\\' && c[1];
        return *c ? c + 1 : NULL;
    }
    for (const char *const *word = (const char *const[]){"true", "false", "null", NULL}; *word; word++)
        if (strncmp(c, *word, strlen(*word)) == 0)
            return c + strlen(*word);
    c += *c == '-';
    if (!isdigit((unsigned char)*c))
        return NULL;
    return c + strspn(c, "0123456789.e+-");
}

/* Checks the keys and values of one line, in which nothing is nested. */
static bool json_object(const char *c)
{
    if (*c++ != '{')
        return false;
    for (;;) {
        c = *c == '"' ? json_value(c) : NULL;
        if (!c || *c != ':')
            return false;
        c = json_value(c + 1);
        if (!c || (*c != ',' && *c != '}'))
            return false;
        if (*c++ == '}')
            return *c == '\0';
    }
}

/* Checks the output line by line. */
static void judge(char *out)
{
    for (char *rest = out, *line; (line = strsep(&rest, "\n")) != NULL;)
        if (escape_needed(line) || (strncmp(line, "{\"", 2) == 0 && !json_object(line))) {
            fprintf(stderr, "this is no answer: %s\n", line);
            abort();
        }
}

void fuzz_session(const void *text, size_t size, bool safe)
{
    struct session session;
    char *out = NULL;
    size_t length = 0;
    /* A long computation, such as a curve of ten million rows, is not an error. It is interrupted as if by
     * ^C. */
    const struct itimerval limit = {.it_value = {.tv_usec = 20000}};
    signal(SIGVTALRM, on_timer);
    FILE *in = fmemopen((void *)(uintptr_t)text, size, "r"), *to = open_memstream(&out, &length);
    if (!in || !to)
        abort();
    features_register(every_feature);
    session_init(&session, to);
    session.run_context.safe = safe;
    session.state.scene.compute.interrupt = &enough;
    enough = 0;
    setitimer(ITIMER_VIRTUAL, &limit, NULL);
    line_stream(&session, in, "fuzz");
    fclose(in);
    session_close(&session);
    fclose(to);
    if (strlen(out) == length) /* the output contains no NUL */
        judge(out);
    else
        abort();
    free(out);
}
