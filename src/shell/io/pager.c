/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Shows an answer that is longer than the terminal with a pager program. As long as the answer fits on the
 * screen, no program is started. An answer that comes slowly is shown while it comes; once it is longer than
 * the screen, the pager begins with it from its first line.
 */
#define _GNU_SOURCE /* the mode "e" of popen */
#include "io/io.h"
#include "io/output.h"
#include "io/terminal.h"
#include <errno.h>
#include <limits.h>
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

static struct {
    FILE *program;      /* the pipe to the pager program, or NULL while there is none */
    bool is_left;       /* the user has closed the pager */
    FILE *held, *notes; /* streams that write to `text` and `messages` */
    char *text, *messages;
    size_t text_size, messages_size;
    size_t shown; /* the number of bytes that are already on the terminal */
    double begun; /* the terminal_clock time when the first text arrived; 0 before that */
    int width;
    long height, rows; /* the height of the terminal, and how many of its rows the text fills so far */
    bool has_head;
    struct termios modes;  /* the terminal modes before the pager program was started */
    struct sigaction stop; /* what ^Z did then */
} pager;

/* Returns how many rows of the terminal a text of whole lines occupies. Escape sequences for colours take no
 * columns. */
static long rows_of(const char *text, const char *end)
{
    long rows = 0;
    bool is_escape = false;
    for (int columns = 0; text < end; text++) {
        is_escape = *text == '\033' || (is_escape && text[-1] != 'm');
        columns += !is_escape && ((unsigned char)*text & 0xc0) != 0x80;
        if (*text == '\n') {
            rows += pager.width > 0 && columns - 1 > pager.width
                        ? (columns - 1 + pager.width - 1) / pager.width
                        : 1;
            columns = 0;
        }
    }
    return rows;
}

static bool text_show(void)
{
    const size_t from = pager.shown;
    pager.shown = pager.text_size;
    return pager.text_size == from ||
           io_write(STDOUT_FILENO, pager.text + from, pager.text_size - from, NULL);
}

/* Starts the pager program and sends it the text so far. If the terminal is too simple for less, and there is
 * no $PAGER, the text goes to the terminal. Returns false if the program has already ended. */
static bool program_open(void)
{
    const char *term = getenv("TERM"), *command = getenv("PAGER");
    bool can_run = (command && *command) || (term && *term && strcmp(term, "dumb") != 0);
    progress_end();
    if (can_run && tcgetattr(STDIN_FILENO, &pager.modes) == 0) {
        signal(SIGPIPE, SIG_DFL); /* the programs of a pipe in $PAGER end by this signal */
        /* With LESSSECURE, less ignores ^Z. The session must not stop alone, with less still at the terminal.
         */
        sigaction(SIGTSTP, NULL, &pager.stop);
        if (!(command && *command))
            signal(SIGTSTP, SIG_IGN);
        pager.program = popen(pager.has_head ? HEAD PAGER : PAGER, "we");
        signal(SIGPIPE, SIG_IGN);
        if (!pager.program)
            sigaction(SIGTSTP, &pager.stop, NULL);
    }
    if (!pager.program) {
        pager.height = LONG_MAX;
        return text_show();
    }
    return fwrite(pager.text, 1, pager.text_size, pager.program) == pager.text_size &&
           fflush(pager.program) == 0;
}

/* Waits until the pager program has ended. If it has been killed, it has not restored the terminal modes. If
 * the session is in the background, another job is using the terminal, and its modes must not change. */
static void program_close(void)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN}, before;
    sigaction(SIGINT, &ignore, &before);
    pclose(pager.program);
    sigaction(SIGINT, &before, NULL);
    sigaction(SIGTSTP, &pager.stop, NULL);
    if (tcgetpgrp(STDIN_FILENO) == getpgrp())
        tcsetattr(STDIN_FILENO, TCSADRAIN, &pager.modes);
}

static bool pager_write(const char *bytes, size_t count)
{
    FILE *to = pager.program ? pager.program : pager.held;
    const double now = terminal_clock();
    pager.begun = pager.begun > 0 ? pager.begun : now;
    bool is_written = !pager.is_left && fwrite(bytes, 1, count, to) == count && fflush(to) == 0;
    if (is_written && !pager.program) {
        pager.rows += rows_of(bytes, bytes + count);
        if (pager.rows >= pager.height)
            is_written = program_open();
        else if (pager.shown > 0 || now - pager.begun > HOLD_SECONDS)
            is_written = text_show();
    }
    pager.is_left = !is_written && pager.program;
    errno = is_written ? errno : EPIPE;
    return is_written;
}

bool pager_begin(bool has_head)
{
    FILE *out = io_stdout(NULL);
    int width, height;
    if (io_taps.page || !isatty(STDIN_FILENO) || !terminal_size(out, &width, &height) || width <= 0 ||
        height <= 0)
        return false;
    fflush(out);
    memset(&pager, 0, sizeof pager);
    pager.width = width;
    pager.height = height;
    pager.has_head = has_head;
    pager.held = io_memory(&pager.text, &pager.text_size);
    if (!pager.held)
        return false;
    pager.notes = io_memory(&pager.messages, &pager.messages_size);
    io_taps.page = pager_write;
    io_taps.messages = pager.notes;
    return true;
}

bool pager_end(void)
{
    FILE *out = io_stdout(NULL);
    fflush(out);
    io_taps.page = NULL;
    io_taps.messages = NULL;
    fclose(pager.held);
    if (pager.program)
        program_close();
    else
        text_show();
    if (pager.is_left)
        clearerr(out);
    /* Messages are shown after the pager has ended. */
    if (pager.notes)
        fclose(pager.notes);
    if (pager.messages)
        fwrite(pager.messages, 1, pager.messages_size, io_stderr());
    free(pager.messages);
    free(pager.text);
    return !pager.is_left;
}
