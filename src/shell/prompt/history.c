/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf */
#include "io/io.h"
#include "io/output.h"
#include "language/text.h"
#include "prompt/input.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <readline/history.h>

enum {
    HISTORY_LINES = 2000, /* the number of lines that are kept */
    /* a file with more lines is shortened; twice HISTORY_LINES, so that this seldom happens */
    HISTORY_FILE = 2 * HISTORY_LINES
};

/* How many seconds to wait for the lock. After this time, a line is appended without the lock. */
#define LOCK_SECONDS 1.0

/* The path of the history file, or "" if no history is kept. */
static char history_file[PATH_MAX];

static void history_fails(struct session *session, const char *reason)
{
    session_error(session, "cannot keep the history in '%s': %s", history_file, reason);
    *history_file = '\0';
}

/* Returns true if the history file is a regular file. If it is not, no history is kept from now on. A message
 * tells the user so, except for a device such as /dev/null. */
static bool is_regular(struct session *session, const struct stat *status)
{
    if (S_ISREG(status->st_mode))
        return true;
    if (S_ISCHR(status->st_mode) || S_ISBLK(status->st_mode))
        *history_file = '\0';
    else
        history_fails(session, S_ISDIR(status->st_mode) ? strerror(EISDIR) : "it is not a regular file");
    return false;
}

/* ---- Reading ---- */

/* Rewrites the file with the lines of the history. Returns NULL, or an error message. */
static const char *file_shorten(const volatile sig_atomic_t *interrupt)
{
    struct output *file = NULL;
    const char *wrong = file_push(&file, history_file, false, interrupt);
    if (wrong)
        return wrong;
    for (HIST_ENTRY **line = history_list(); line && *line; line++)
        fprintf(file->out, "%s\n", (*line)->line);
    return output_pop(&file, true);
}

/* Adds all lines of a file to the history and returns the number of lines. */
static long lines_read(FILE *in)
{
    char *text = NULL;
    size_t size = 0;
    long lines = 0;
    for (; text_read(&text, &size, in, NULL) != -1; lines++)
        add_history(text);
    free(text);
    return lines;
}

bool line_path(const char *variable, const char *fallback, const char *name, char *path, size_t size)
{
    const char *base = getenv(variable), *home = getenv("HOME");
    int length = -1;
    if (base && *base == '/')
        length = snprintf(path, size, "%s/domino/%s", base, name);
    else if (home && *home)
        length = snprintf(path, size, "%s/%s/domino/%s", home, fallback, name);
    return length > 0 && (size_t)length < size;
}

void history_load(struct session *session)
{
    const volatile sig_atomic_t *interrupt = session->state.scene.compute.interrupt;
    const char *chosen = getenv("DOMINO_HISTORY");
    struct stat status;
    using_history();
    stifle_history(HISTORY_LINES);
    bool known = chosen ? snprintf(history_file, PATH_MAX, "%s", chosen) < PATH_MAX
                        : line_path("XDG_STATE_HOME", ".local/state", "history", history_file, PATH_MAX);
    if (!known)
        *history_file = '\0';
    /* Opening a device or a FIFO can have side effects, so the type is checked first. */
    if (!*history_file || stat(history_file, &status) != 0 || !is_regular(session, &status))
        return;
    FILE *in = fopen(history_file, "re");
    /* While the file is being replaced, no other session may append a line to it. The line would be lost with
     * the old file. */
    bool is_locked = in && io_lock(fileno(in), LOCK_SECONDS, interrupt);
    const char *wrong = in && lines_read(in) > HISTORY_FILE && is_locked ? file_shorten(interrupt) : NULL;
    if (in)
        fclose(in);
    if (wrong)
        history_fails(session, wrong);
}

/* ---- Writing ---- */

static void make_folders(char *path)
{
    for (char *c = strchr(path + 1, '/'); c; c = strchr(c + 1, '/')) {
        *c = '\0';
        mkdir(path, 0700);
        *c = '/';
    }
}

/* Opens and locks the history file. On failure, sets errno and returns -1. */
static int file_open(const volatile sig_atomic_t *interrupt)
{
    enum { TRIES = 10 };
    int file = -1;
    for (int i = 0; i < TRIES; i++) {
        struct stat opened, named;
        /* Typed lines are private, so a new file gets mode 0600. */
        file = io_open(history_file, O_RDWR | O_APPEND | O_CREAT, 0600, interrupt);
        if (file < 0)
            return -1;
        (void)io_lock(file, LOCK_SECONDS, interrupt);
        /* Another session may have replaced the file before it was locked. */
        if (fstat(file, &opened) != 0 || stat(history_file, &named) != 0 ||
            (opened.st_dev == named.st_dev && opened.st_ino == named.st_ino))
            return file;
        if (i + 1 < TRIES)
            close(file);
    }
    return file;
}

/* Appends a line to a file of `size` bytes. If the whole line cannot be written, appends nothing, sets errno
 * and returns false. */
static bool line_append(int file, off_t size, const char *text)
{
    char last = '\n', *line = NULL;
    if (size > 0)
        (void)!pread(file, &last, 1, size - 1);
    /* A session that was killed may have left a line without a newline. */
    int length = asprintf(&line, "%s%s\n", last == '\n' ? "" : "\n", text);
    if (length < 0) {
        errno = ENOMEM;
        return false;
    }
    bool whole = io_write(file, line, (size_t)length, NULL);
    int reason = errno;
    if (!whole)
        (void)!ftruncate(file, size);
    free(line);
    errno = reason;
    return whole;
}

static void file_add(struct session *session, const char *text)
{
    struct stat status;
    make_folders(history_file);
    int file = file_open(session->state.scene.compute.interrupt);
    if (file < 0) {
        history_fails(session, strerror(errno));
        return;
    }
    if (fstat(file, &status) == 0 && is_regular(session, &status) && !line_append(file, status.st_size, text))
        history_fails(session, strerror(errno));
    close(file);
}

void history_keep(struct session *session, const char *text)
{
    HIST_ENTRY *last = history_length ? history_get(history_base + history_length - 1) : NULL;
    if (!text[strspn(text, " \t")] || (last && strcmp(last->line, text) == 0))
        return;
    add_history(text);
    if (*history_file) /* written at once, so that the line is kept if the session crashes */
        file_add(session, text);
}
