/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'log' copies all output into a file. A log is a level of the stack of outputs (see output.h),
 * which passes its text on to the level below. */
#include "domino_quad.h"
#include "io/io.h"
#include "io/output.h"
#include "io/system.h"
#include "io/target.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>

struct log {
    /* must be the first member, so that a pointer to it is also a pointer to struct log */
    struct output output;
    struct target target;
    FILE *file;
    bool is_plain;       /* the file gets the answers alone, not the commands, and not as comments */
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

static void commands_write(struct log *r, bool failed)
{
    if (r->waiting && !r->is_plain)
        fprintf(r->file, "%s%.*s\n", failed ? "# " : "", r->waiting_length, r->waiting);
    r->waiting = NULL;
}

/* Passes text on to the level below and writes a copy without control sequences into the file. Each
 * line of the copy becomes a comment, so that the log can be run as a script. */
static ssize_t log_write(void *log, const char *bytes, size_t count)
{
    struct log *r = log;
    FILE *below = r->output.below->out;
    commands_write(r, false);
    for (size_t i = 0; i < count; i++) {
        if (!is_text(&r->sequence, bytes[i]))
            continue;
        if (!r->is_plain && !r->in_line && bytes[i] != '\n')
            fputs("# ", r->file);
        r->in_line = bytes[i] != '\n';
        putc(bytes[i], r->file);
    }
    return fwrite(bytes, 1, count, below) == count ? (ssize_t)count : 0;
}

static const char *log_pop(struct output *o, bool keep)
{
    struct log *r = (struct log *)o;
    (void)keep;
    fclose(o->out);
    commands_write(r, false);
    fclose(r->file);
    target_end(&r->target);
    return NULL;
}

const char *log_push(struct output **top, const char *path, bool is_plain,
                     const volatile sig_atomic_t *interrupt)
{
    struct output **before = output_find(top, OUTPUT_LOG);
    struct log *r = calloc(1, sizeof *r);
    if (!r)
        return strerror(ENOMEM);
    const char *wrong =
        target_begin(&r->target, path, false, before ? &((struct log *)*before)->target : NULL);
    if (wrong) {
        free(r);
        return wrong;
    }
    if (before)
        fflush((*before)->out);
    bool ends_in_line = io_ends_in_line(path);
    int file = io_open(path, O_WRONLY | O_CREAT | O_APPEND, 0666, interrupt);
    r->is_plain = is_plain;
    r->file = file < 0 ? NULL : io_stream(file, "a", interrupt);
    FILE *out = r->file ? system_stream(r, "w", (struct system_stream){.write = log_write}) : NULL;
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
    r->output = (struct output){.kind = OUTPUT_LOG, .out = out, .pop = log_pop};
    output_push(top, &r->output);
    if (ends_in_line)
        putc('\n', r->file);
    if (!is_plain)
        fputs("# A log of domino " DOM_VERSION ": 'source' it to run its commands again.\n", r->file);
    return NULL;
}

static struct log *log_find(struct output **top)
{
    struct output **at = output_find(top, OUTPUT_LOG);
    return at ? (struct log *)*at : NULL;
}

const char *log_flush(struct output **top)
{
    struct log *r = log_find(top);
    if (!r)
        return NULL;
    commands_write(r, false);
    errno = 0;
    if (fflush(r->file) == 0 && !ferror(r->file))
        return NULL;
    const char *wrong = target_error(errno);
    output_pop(output_find(top, OUTPUT_LOG), true);
    return wrong;
}

/* ---- Commands and messages ---- */

void log_commands(struct output **top, const char *commands, size_t length, bool at_once)
{
    struct log *r = log_find(top);
    if (!r)
        return;
    r->waiting = commands;
    r->waiting_length = (int)length;
    if (at_once)
        commands_write(r, false);
}

void log_message(struct output **top, const char *text, bool failed)
{
    struct log *r = log_find(top);
    if (!r || r->is_plain)
        return;
    commands_write(r, failed);
    fprintf(r->file, "# %s\n", text);
}
