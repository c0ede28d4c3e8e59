/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/line.h"
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

/* The file may have twice as many lines as are kept, so that it is not written again at every start. */
enum { HISTORY_LINES = 2000, HISTORY_FILE = 2 * HISTORY_LINES };

/* A person does not wait longer for another session; without the lock a line is still written whole. */
#define LOCK_SECONDS 1.0

/* Where lines go; "" for nowhere. */
static char history_file[PATH_MAX];

static void cannot(struct session *session, const char *reason)
{
    session_error(session, "cannot keep the history in '%s': %s", history_file, reason);
    *history_file = '\0';
}

/* Returns true if the file can keep lines. If not, reports that, unless the file is a device. */
static bool is_regular(struct session *session, const struct stat *status)
{
    if (S_ISREG(status->st_mode))
        return true;
    if (S_ISCHR(status->st_mode) || S_ISBLK(status->st_mode))
        *history_file = '\0';
    else
        cannot(session, S_ISDIR(status->st_mode) ? strerror(EISDIR) : "it is not a regular file");
    return false;
}

/* ---- Reading ---- */

/* Replaces the file by the lines that are kept. */
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

/* Reads the lines; returns how many there are. */
static long lines_read(FILE *in)
{
    char *text = NULL;
    size_t size = 0;
    long lines = 0;
    for (; text_read(&text, &size, in) != -1; lines++)
        add_history(text);
    free(text);
    return lines;
}

void history_load(struct session *session)
{
    const volatile sig_atomic_t *interrupt = session->state.scene.compute.interrupt;
    const char *own = getenv("DOMINO_HISTORY");
    struct stat status;
    using_history();
    stifle_history(HISTORY_LINES);
    bool known = own ? snprintf(history_file, PATH_MAX, "%s", own) < PATH_MAX
                     : line_path("XDG_STATE_HOME", ".local/state", "history", history_file, PATH_MAX);
    if (!known)
        *history_file = '\0';
    /* Not opened before it is known to be regular: a device or a FIFO would notice. */
    if (!*history_file || stat(history_file, &status) != 0 || !is_regular(session, &status))
        return;
    int file = io_open(history_file, O_RDONLY, 0, interrupt), locked = file >= 0 ? dup(file) : -1;
    FILE *in = file >= 0 ? io_stream(file, "r", interrupt) : NULL;
    /* Both use one lock: no other process adds a line between the reading of the file and its replacement. */
    bool alone = in && locked >= 0 && io_lock(locked, LOCK_SECONDS, interrupt);
    const char *wrong = in && lines_read(in) > HISTORY_FILE && alone ? file_shorten(interrupt) : NULL;
    if (in)
        fclose(in);
    if (locked >= 0)
        close(locked);
    if (wrong)
        cannot(session, wrong);
}

/* ---- Writing ---- */

/* Makes the folders that lead to a path. */
static void make_folders(char *path)
{
    for (char *c = strchr(path + 1, '/'); c; c = strchr(c + 1, '/')) {
        *c = '\0';
        mkdir(path, 0700);
        *c = '/';
    }
}

/* Opens and locks the file that has the name now: another session may have replaced it. -1 with errno. */
static int file_open(const volatile sig_atomic_t *interrupt)
{
    enum { TRIES = 10 };
    int file = -1;
    for (int i = 0; i < TRIES; i++) {
        struct stat opened, named;
        /* The lines that a person types are private; the mode of an existing file is the choice of its
         * owner. */
        file = io_open(history_file, O_RDWR | O_APPEND | O_CREAT, 0600, interrupt);
        if (file < 0)
            return -1;
        (void)io_lock(file, LOCK_SECONDS, interrupt);
        if (fstat(file, &opened) != 0 || stat(history_file, &named) != 0 ||
            (opened.st_dev == named.st_dev && opened.st_ino == named.st_ino))
            return file;
        if (i + 1 < TRIES)
            close(file);
    }
    return file;
}

/* Appends the line whole or not at all; false with errno. */
static bool line_append(int file, off_t size, const char *text)
{
    char last = '\n', *line = NULL;
    if (size > 0)
        (void)!pread(file, &last, 1, size - 1);
    /* A line that another program left half done does not join this one. */
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
        cannot(session, strerror(errno));
        return;
    }
    if (fstat(file, &status) == 0 && is_regular(session, &status) && !line_append(file, status.st_size, text))
        cannot(session, strerror(errno));
    close(file);
}

void history_keep(struct session *session, const char *text)
{
    HIST_ENTRY *last = history_length ? history_get(history_base + history_length - 1) : NULL;
    if (!text[strspn(text, " \t")] || (last && strcmp(last->line, text) == 0))
        return;
    add_history(text);
    if (*history_file)
        file_add(session, text);
}
