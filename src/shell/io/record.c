/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'log' and 'tee' copy all output into a file. Each of them is a level of the stack of outputs
 * (see output.h), which passes its text on to the level below. */
#include "domino_quad.h"
#include "io/io.h"
#include "io/output.h"
#include "io/system.h"
#include "io/target.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>

struct record {
    /* must be the first member, so that a pointer to it is also a pointer to struct record */
    struct output output;
    struct target target;
    FILE *file;
    bool in_line;        /* the last line in the file is incomplete so far */
    const char *waiting; /* commands that have not been written yet, or NULL */
    int waiting_length;
    /* the kind of control sequence that the last character belongs to */
    enum sequence { NONE, ESCAPE, CONTROL, STRING } sequence;
};

/* Returns false for a carriage return and for the characters of a control sequence. *sequence keeps the state
 * between calls. */
static bool is_text(enum sequence *sequence, char c)
{
    const enum sequence before = *sequence;
    if (c == '\033')
        *sequence = ESCAPE;
    else if (before == ESCAPE)
        *sequence = c == '[' ? CONTROL : strchr("P_]^X", c) ? STRING : NONE;
    else if ((before == CONTROL && c >= '@' && c <= '~') || (before == STRING && c == '\a'))
        *sequence = NONE;
    return before == NONE && c != '\033' && c != '\r';
}

static void commands_write(struct record *r, bool failed)
{
    if (r->waiting)
        fprintf(r->file, "%s%.*s\n", failed ? "# " : "", r->waiting_length, r->waiting);
    r->waiting = NULL;
}

/* Passes text on to the level below and writes a copy without control sequences into the file. In a log,
 * each line of the copy becomes a comment, so that the log can be run as a script. */
static ssize_t record_write(void *record, const char *bytes, size_t count)
{
    struct record *r = record;
    FILE *below = r->output.below->out;
    commands_write(r, false);
    for (size_t i = 0; i < count; i++) {
        if (!is_text(&r->sequence, bytes[i]))
            continue;
        if (r->output.kind == OUTPUT_LOG && !r->in_line && bytes[i] != '\n')
            fputs("# ", r->file);
        r->in_line = bytes[i] != '\n';
        putc(bytes[i], r->file);
    }
    return fwrite(bytes, 1, count, below) == count && fflush(below) == 0 ? (ssize_t)count : 0;
}

static const char *record_pop(struct output *o, bool keep)
{
    struct record *r = (struct record *)o;
    (void)keep;
    fclose(o->out);
    commands_write(r, false);
    fclose(r->file);
    target_end(&r->target);
    return NULL;
}

const char *record_push(struct output **top, enum output_kind kind, const char *path,
                        const volatile sig_atomic_t *interrupt)
{
    bool is_log = kind == OUTPUT_LOG;
    struct output **before = output_find(top, kind);
    struct record *r = calloc(1, sizeof *r);
    if (!r)
        return strerror(ENOMEM);
    const char *wrong =
        target_begin(&r->target, path, false, before ? &((struct record *)*before)->target : NULL);
    if (wrong) {
        free(r);
        return wrong;
    }
    int file = io_open(path, O_WRONLY | O_CREAT | (is_log ? O_APPEND : O_TRUNC), 0666, interrupt);
    r->file = file < 0 ? NULL : io_stream(file, is_log ? "a" : "w", interrupt);
    FILE *out = r->file ? system_stream(r, "w", (struct system_stream){.write = record_write}) : NULL;
    if (!out) {
        wrong = strerror(errno);
        target_end(&r->target);
        if (r->file)
            fclose(r->file);
        free(r);
        return wrong;
    }
    if (before)
        output_pop(before, true);
    r->output = (struct output){.kind = kind, .out = out, .pop = record_pop};
    output_push(top, &r->output);
    if (is_log)
        fputs("# A log of domino " DOM_VERSION ": 'source' it to run its commands again.\n", r->file);
    return NULL;
}

const char *records_flush(struct output **top)
{
    const char *wrong = NULL;
    for (struct output **at = top; *at;) {
        struct record *r = (struct record *)*at;
        bool is_record = (*at)->kind == OUTPUT_LOG || (*at)->kind == OUTPUT_TEE;
        errno = 0;
        if (is_record)
            commands_write(r, false);
        if (is_record && (fflush(r->file) != 0 || ferror(r->file))) {
            wrong = target_error(errno);
            output_pop(at, true);
        } else
            at = &(*at)->below;
    }
    return wrong;
}

/* ---- Functions of a log only ---- */

static struct record *log_find(struct output **top)
{
    struct output **at = output_find(top, OUTPUT_LOG);
    return at ? (struct record *)*at : NULL;
}

void log_commands(struct output **top, const char *commands, size_t length, bool at_once)
{
    struct record *r = log_find(top);
    if (!r)
        return;
    r->waiting = commands;
    r->waiting_length = (int)length;
    if (at_once)
        commands_write(r, false);
}

void log_message(struct output **top, const char *text, bool failed)
{
    struct record *r = log_find(top);
    if (!r)
        return;
    commands_write(r, failed);
    fprintf(r->file, "# %s\n", text);
}
