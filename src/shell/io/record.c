/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/record.h"
#include "io/escape.h"
#include "io/io.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>

const char *record_open(struct record *r, const char *path, bool append,
                        const volatile sig_atomic_t *interrupt)
{
    if (escape_needed(path))
        return "the name has control characters, or is not UTF-8; no such file is written";
    int file = io_open(path, O_WRONLY | O_CREAT | (append ? O_APPEND : O_TRUNC), 0666, interrupt);
    FILE *stream = file >= 0 ? io_stream(file, append ? "a" : "w", interrupt) : NULL;
    if (!stream)
        return strerror(errno);
    *r = (struct record){.file = stream};
    return NULL;
}

/* Follows the control sequences of a terminal; returns true for a byte that belongs to none. */
static bool is_text(struct record *r, char c)
{
    switch (r->state) {
    case RECORD_TEXT:
        r->state = c == '\033' ? RECORD_ESCAPE : RECORD_TEXT;
        return c != '\033' && c != '\r';
    case RECORD_ESCAPE:
        r->state = c == '[' ? RECORD_CONTROL : strchr("P_]^X", c) ? RECORD_STRING : RECORD_TEXT;
        break;
    case RECORD_CONTROL:
        r->state = c >= '@' && c <= '~' ? RECORD_TEXT : RECORD_CONTROL;
        break;
    case RECORD_STRING:
        r->state = c == '\033' ? RECORD_STRING_ESCAPE : c == '\a' ? RECORD_TEXT : RECORD_STRING;
        break;
    case RECORD_STRING_ESCAPE:
        r->state = c == '\\' ? RECORD_TEXT : RECORD_STRING;
        break;
    }
    return false;
}

void record_commands(struct record *r, bool failed)
{
    if (r->file && r->pending)
        fprintf(r->file, "%s%.*s\n", failed ? "# " : "", r->pending_length, r->pending);
    r->pending = NULL;
}

void record_write(struct record *r, const char *bytes, size_t count)
{
    record_commands(r, false);
    for (size_t i = 0; r->file && i < count; i++) {
        if (!is_text(r, bytes[i]))
            continue;
        if (r->comments && !r->within && bytes[i] != '\n')
            fputs("# ", r->file);
        r->within = bytes[i] != '\n';
        putc(bytes[i], r->file);
    }
}

const char *record_flush(struct record *r)
{
    errno = 0;
    record_commands(r, false);
    if (!r->file || (fflush(r->file) == 0 && !ferror(r->file)))
        return NULL;
    const char *why = errno ? strerror(errno) : "the device is full, or not there any more";
    record_close(r);
    return why;
}

void record_close(struct record *r)
{
    record_commands(r, false);
    if (r->file)
        fclose(r->file);
    r->file = NULL;
}

/* The stream that is written to, and its records. */
struct split {
    FILE *out;
    struct record *log, *tee;
};

static ssize_t split_write(void *cookie, const char *bytes, size_t count)
{
    const struct split *s = cookie;
    record_write(s->log, bytes, count);
    record_write(s->tee, bytes, count);
    return fwrite(bytes, 1, count, s->out) == count && fflush(s->out) == 0 ? (ssize_t)count : 0;
}

static int split_close(void *cookie)
{
    free(cookie);
    return 0;
}

FILE *record_stream(FILE *out, struct record *log, struct record *tee)
{
    const cookie_io_functions_t functions = {.write = split_write, .close = split_close};
    struct split *split = malloc(sizeof *split);
    if (!split)
        return NULL;
    *split = (struct split){out, log, tee};
    FILE *stream = fopencookie(split, "w", functions);
    if (!stream)
        free(split);
    return stream;
}
