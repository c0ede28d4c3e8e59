/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Shows an answer that is longer than the terminal with a pager program. As long as the answer fits on the
 * screen, no program is started. An answer that comes slowly is shown while it comes; once it is longer than
 * the screen, the pager begins with it from its first line.
 */
#include "io/io.h"
#include "io/output.h"
#include "io/system.h"
#include "io/terminal.h"
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

/* The text is held back for this time, so that a quick answer appears only once. */
#define HOLD_SECONDS 0.5

/* Runs $PAGER or, if there is no such program, less. The option -P of less sets its prompt, in which '?e'
 * tests for the end of the text and ':' means "else". HEAD keeps the first line of a table in sight, if less
 * has the option --header (version 600). Without $PAGER, a key pressed by mistake must not write a file or
 * run a program. */
#define HEAD "less --help 2>&1 | grep -q -- --header && h=--header=1; "
#define PAGER                                                                                                \
    "export LESS=\"${LESS--FRX $h -Ps?e(end) q\\: back:space\\: more, q\\: back.}\"; set -- $PAGER; "        \
    "if command -v \"$1\" >/dev/null; then eval \"$PAGER\"; "                                                \
    "elif command -v less >/dev/null; then LESSSECURE=1 LESSHISTFILE=- less; else cat; fi"

struct pager {
    /* must be the first member, so that a pointer to it is also a pointer to struct pager */
    struct output output;
    enum { HELD, SHOWN, PROGRAM, LEFT } state;
    FILE *to; /* memory, and the pipe to the pager program in the state PROGRAM */
    char *text, *messages;
    size_t text_size, messages_size;
    size_t shown; /* the number of bytes that are already on the terminal */
    double begun; /* the terminal_clock time when the first text arrived; 0 before that */
    int width, height;
    long rows; /* the number of terminal rows that the text fills so far */
    bool has_head;
    struct termios modes; /* the terminal modes before the pager program was started */
};

/* Returns how many rows of the terminal a text of whole lines occupies. Escape sequences for colours take no
 * columns. */
static long rows_of(const char *text, const char *end, int width)
{
    long rows = 0;
    bool is_escape = false;
    for (int columns = 0; text < end; text++) {
        is_escape = *text == '\033' || (is_escape && text[-1] != 'm');
        columns += !is_escape && ((unsigned char)*text & 0xc0) != 0x80;
        if (*text == '\n') {
            rows += width > 0 && columns - 1 > width ? (columns - 1 + width - 1) / width : 1;
            columns = 0;
        }
    }
    return rows;
}

static void text_show(struct pager *p)
{
    FILE *terminal = p->output.below->out;
    if (p->text_size > p->shown)
        fwrite(p->text + p->shown, 1, p->text_size - p->shown, terminal);
    fflush(terminal);
    p->shown = p->text_size;
    p->state = SHOWN;
}

/* Starts the pager program and sends it the text so far. If the terminal is too simple for less, and there is
 * no $PAGER, the text goes to the terminal. Returns false if the program has already ended. */
static bool program_open(struct pager *p)
{
    const char *term = getenv("TERM"), *command = getenv("PAGER");
    bool can_run = (command && *command) || (term && *term && strcmp(term, "dumb") != 0);
    FILE *pipe = NULL;
    progress_end();
    if (can_run && tcgetattr(STDIN_FILENO, &p->modes) == 0) {
        signal(SIGPIPE, SIG_DFL); /* the programs of a pipe in $PAGER end by this signal */
        pipe = popen(p->has_head ? HEAD PAGER : PAGER, "we");
        signal(SIGPIPE, SIG_IGN);
    }
    if (!pipe) {
        text_show(p);
        return true;
    }
    fclose(p->to);
    p->to = pipe;
    p->state = PROGRAM;
    return fwrite(p->text, 1, p->text_size, pipe) == p->text_size && fflush(pipe) == 0;
}

/* Waits until the pager program has ended. If it has been killed, it has not restored the terminal modes. If
 * the session is in the background, another job is using the terminal, and its modes must not change. */
static void program_close(struct pager *p)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN}, before;
    sigaction(SIGINT, &ignore, &before);
    pclose(p->to);
    sigaction(SIGINT, &before, NULL);
    if (tcgetpgrp(STDIN_FILENO) == getpgrp())
        tcsetattr(STDIN_FILENO, TCSADRAIN, &p->modes);
}

/* ---- The level ---- */

static ssize_t pager_write(void *pager, const char *text, size_t size)
{
    struct pager *p = pager;
    double now = terminal_clock();
    p->begun = p->begun > 0 ? p->begun : now;
    bool is_written = p->state != LEFT && fwrite(text, 1, size, p->to) == size && fflush(p->to) == 0;
    if (is_written && p->state != PROGRAM) {
        p->rows += rows_of(text, text + size, p->width);
        if (p->rows >= p->height)
            is_written = program_open(p);
        else if (p->state == SHOWN || now - p->begun > HOLD_SECONDS)
            text_show(p);
    }
    if (is_written)
        return (ssize_t)size;
    p->state = p->state == PROGRAM ? LEFT : p->state;
    errno = EPIPE;
    return 0;
}

static const char *pager_pop(struct output *o, bool keep)
{
    struct pager *p = (struct pager *)o;
    (void)keep;
    fclose(o->out);
    bool was_left = p->state == LEFT;
    if (was_left || p->state == PROGRAM)
        program_close(p);
    else {
        text_show(p);
        fclose(p->to);
    }
    /* Messages are shown after the pager has ended. */
    if (o->messages != o->below->messages)
        fclose(o->messages);
    if (p->messages)
        fwrite(p->messages, 1, p->messages_size, o->below->messages);
    free(p->messages);
    free(p->text);
    return was_left ? "the pager was closed before the end" : NULL;
}

bool pager_push(struct output **top, bool has_head)
{
    FILE *terminal = (*top)->out;
    int width, height;
    if (!isatty(STDIN_FILENO) || !terminal_size(terminal, &width, &height) || width <= 0 || height <= 0)
        return false;
    struct pager *p = malloc(sizeof *p);
    if (!p)
        return false;
    *p = (struct pager){.output = {.kind = OUTPUT_PAGER, .pop = pager_pop},
                        .width = width,
                        .height = height,
                        .has_head = has_head};
    p->to = io_memory(&p->text, &p->text_size);
    p->output.out = p->to ? system_stream(p, "w", (struct system_stream){.write = pager_write}) : NULL;
    if (!p->output.out) {
        if (p->to)
            fclose(p->to);
        free(p);
        return false;
    }
    p->output.messages = io_memory(&p->messages, &p->messages_size);
    setvbuf(p->output.out, NULL, _IOLBF, BUFSIZ);
    output_push(top, &p->output);
    return true;
}
