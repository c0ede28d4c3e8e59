/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The history of the prompt, which all sessions share. Each line is appended to the file before it runs. */
#define _GNU_SOURCE /* asprintf */
#include "io/io.h"
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

/* The path of the history file without symbolic links, or "" if no history is kept. */
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

/* Makes the folders of the history file that are missing, and locks its folder. Not the file, because
 * Readline replaces it. Returns the folder, which must be closed, or -1 and sets errno. */
static int folder_lock(const volatile sig_atomic_t *interrupt)
{
    char path[PATH_MAX];
    int folder, reason = 0;
    snprintf(path, sizeof path, "%s", strchr(history_file, '/') ? history_file : "./");
    for (char *c = strchr(path + 1, '/'); c; c = strchr(c + 1, '/')) {
        *c = '\0';
        if (mkdir(path, 0700) != 0 && errno != EEXIST && !reason)
            reason = errno;
        *c = '/';
    }
    char *name = strrchr(path, '/');
    name[name == path] = '\0';
    folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0)
        (void)io_lock(folder, LOCK_SECONDS, interrupt);
    else if (reason) /* why the folder is missing */
        errno = reason;
    return folder;
}

void history_load(struct session *session)
{
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
    char *real = realpath(history_file, NULL);
    if (real)
        snprintf(history_file, sizeof history_file, "%s", real);
    free(real);
    int folder = folder_lock(session->state.scene.compute.interrupt);
    int reason = read_history(history_file);
    if (reason == 0 && history_base + history_length > HISTORY_FILE &&
        (reason = history_truncate_file(history_file, HISTORY_LINES)) == 0)
        (void)chmod(history_file, status.st_mode & 0777);
    if (folder >= 0)
        close(folder);
    if (reason && reason != EACCES) /* a line that cannot be added is reported when it is typed */
        history_fails(session, strerror(reason));
}

/* Appends a line to the file. If the whole line cannot be written, appends nothing. */
static void file_add(struct session *session, const char *text)
{
    struct stat status;
    char *line = NULL;
    int folder = folder_lock(session->state.scene.compute.interrupt), reason = 0;
    /* Typed lines are private, so a new file gets mode 0600. */
    int file =
        folder < 0 ? -1 : open(history_file, O_WRONLY | O_APPEND | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0600);
    /* A session that was killed may have left a line without a newline. */
    if (file < 0 || fstat(file, &status) != 0 ||
        asprintf(&line, "%s%s\n", io_ends_in_line(history_file) ? "\n" : "", text) < 0) {
        reason = errno;
        line = NULL;
    } else if (is_regular(session, &status) && !io_write(file, line, strlen(line), NULL)) {
        reason = errno;
        (void)!ftruncate(file, status.st_size);
    }
    free(line);
    if (file >= 0)
        close(file);
    if (folder >= 0)
        close(folder);
    if (reason)
        history_fails(session, strerror(reason));
}

void history_keep(struct session *session, const char *text)
{
    HIST_ENTRY *last = history_length ? history_get(history_base + history_length - 1) : NULL;
    if (!text[strspn(text, " \t\r")] || (last && strcmp(last->line, text) == 0))
        return;
    add_history(text);
    if (*history_file) /* written at once, so that the line is kept if the session crashes */
        file_add(session, text);
}
