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

/* The number of lines that are kept. A file is shortened when it has twice as many. */
enum { HISTORY_LINES = 2000 };

/* The path of the history file without symbolic links, or "" if no history is kept. */
static char history_file[PATH_MAX];

static void history_fails(struct session *session, const char *reason)
{
    session_error(session, "cannot keep the history in '%s': %s", history_file, reason);
    *history_file = '\0';
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
    const char *chosen = getenv("DOMINO_HISTORY");
    struct stat status;
    using_history();
    stifle_history(HISTORY_LINES);
    bool known = chosen ? snprintf(history_file, PATH_MAX, "%s", chosen) < PATH_MAX
                        : line_path("XDG_STATE_HOME", ".local/state", "history", history_file, PATH_MAX);
    if (!known)
        *history_file = '\0';
    if (!*history_file || stat(history_file, &status) != 0)
        return;
    if (S_ISCHR(status.st_mode)) { /* a device such as /dev/null means that no history is wanted */
        *history_file = '\0';
        return;
    }
    if (!S_ISREG(status.st_mode)) {
        history_fails(session, "it is not a regular file");
        return;
    }
    char *real = realpath(history_file, NULL); /* a link must stay a link when the file is shortened */
    if (real)
        snprintf(history_file, sizeof history_file, "%s", real);
    free(real);
    int reason = read_history(history_file);
    if (reason == 0 && history_base + history_length > 2 * HISTORY_LINES &&
        (reason = history_truncate_file(history_file, HISTORY_LINES)) == 0)
        (void)chmod(history_file, status.st_mode & 0777);
    if (reason && reason != EACCES) /* a line that cannot be added is reported when it is typed */
        history_fails(session, strerror(reason));
}

/* Appends a line to the file, in one write, because other sessions may append lines at the same time. Makes
 * the file and its folders if they are missing; typed lines are private. If the whole line cannot be written,
 * appends nothing. Returns an error number, or 0. */
static int file_add(const char *text)
{
    struct stat status;
    char *line = NULL;
    int no_folder = 0; /* why a folder could not be made */
    for (char *c = strchr(history_file + 1, '/'); c; c = strchr(c + 1, '/')) {
        *c = '\0';
        if (mkdir(history_file, 0700) != 0 && errno != EEXIST && !no_folder)
            no_folder = errno;
        *c = '/';
    }
    const int file = open(history_file, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0)
        return errno == ENOENT && no_folder ? no_folder : errno;
    /* A session that was killed may have left a line without a newline. */
    const bool is_ready = fstat(file, &status) == 0 &&
                          asprintf(&line, "%s%s\n", io_ends_in_line(history_file) ? "\n" : "", text) >= 0;
    const int reason = is_ready && io_write(file, line, strlen(line), NULL) ? 0 : errno;
    if (is_ready && reason)
        (void)!ftruncate(file, status.st_size);
    if (is_ready)
        free(line);
    close(file);
    return reason;
}

void history_keep(struct session *session, const char *text)
{
    HIST_ENTRY *last = history_length ? history_get(history_base + history_length - 1) : NULL;
    if (!text[strspn(text, " \t\r")] || (last && strcmp(last->line, text) == 0))
        return;
    add_history(text);
    /* written at once, so that the line is kept if the session crashes */
    const int reason = *history_file ? file_add(text) : 0;
    if (reason)
        history_fails(session, strerror(reason));
}
