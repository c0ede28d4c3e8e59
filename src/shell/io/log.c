/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'log' copies all that goes to standard output into a file. */
#include "domino_quad.h"
#include "io/io.h"
#include "io/output.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>

static struct log {
    struct target target;
    FILE *file;
    bool in_line;     /* the last line in the file is incomplete so far */
    bool in_sequence; /* the last character belongs to a control sequence: ESC, '[', numbers and a letter */
    const char *waiting; /* commands that have not been written yet, or NULL */
    int waiting_length;
} * current; /* NULL if there is no log */

static void commands_write(bool failed)
{
    if (current->waiting)
        fprintf(current->file, "%s%.*s\n", failed ? "# " : "", current->waiting_length, current->waiting);
    current->waiting = NULL;
}

/* Writes text without the control sequences of a terminal. Each line becomes a comment, so that the log can
 * be run as a script. */
static void log_copy(const char *bytes, size_t count)
{
    struct log *l = current;
    commands_write(false);
    for (const char *c = bytes; c < bytes + count; c++) {
        const bool is_control = l->in_sequence || *c == '\033' || *c == '\r';
        l->in_sequence = *c == '\033' || (l->in_sequence && (*c < '@' || *c == '['));
        if (is_control)
            continue;
        if (!l->in_line && *c != '\n')
            fputs("# ", l->file);
        l->in_line = *c != '\n';
        putc(*c, l->file);
    }
}

const char *log_begin(const char *path, const volatile sig_atomic_t *interrupt)
{
    struct log *l = malloc(sizeof *l);
    if (!l)
        return strerror(ENOMEM);
    *l = (struct log){.waiting = NULL};
    const char *wrong = target_begin(&l->target, path, false, current ? &current->target : NULL);
    if (!wrong) {
        io_stdout_flush(); /* the answers before this command do not belong in the log */
        if (current)
            fflush(current->file);
        l->in_line = io_ends_in_line(path);
        const int file = io_open(path, O_WRONLY | O_CREAT | O_APPEND, 0666, interrupt);
        l->file = file < 0 ? NULL : io_stream(file, "a", interrupt);
        wrong = l->file ? NULL : strerror(errno);
        if (wrong)
            target_end(&l->target);
    }
    if (wrong) {
        free(l);
        return wrong;
    }
    log_end();
    fprintf(l->file, "%s# A log of domino " DOM_VERSION ": 'source' it to run its commands again.\n",
            l->in_line ? "\n" : "");
    l->in_line = false;
    current = l;
    io_copy = log_copy;
    return NULL;
}

const char *log_flush(void)
{
    if (!current)
        return NULL;
    io_stdout_flush();
    commands_write(false);
    return fflush(current->file) == 0 && !ferror(current->file) ? NULL : log_end();
}

const char *log_end(void)
{
    if (!current)
        return NULL;
    io_stdout_flush();
    commands_write(false);
    const char *wrong = fclose(current->file) == 0 ? NULL : strerror(errno);
    target_end(&current->target);
    free(current);
    current = NULL;
    io_copy = NULL;
    return wrong;
}

void log_commands(const char *commands, size_t length, bool at_once)
{
    if (!current)
        return;
    io_stdout_flush();
    current->waiting = commands;
    current->waiting_length = (int)length;
    if (at_once)
        commands_write(false);
}

void log_message(const char *text, bool failed)
{
    if (!current)
        return;
    commands_write(failed);
    fprintf(current->file, "# %s\n", text);
}
