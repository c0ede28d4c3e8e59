/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/redirect.h"
#include "domino_quad.h"
#include "io/escape.h"
#include "io/io.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The files that are being written and appear when they are complete, the latest first. */
static struct redirect *opened;

/* Returns true if an answer that is being written will take the place of this one. */
static bool is_open(const char *path)
{
    for (const struct redirect *r = opened; r; r = r->below)
        if (strcmp(r->path, path) == 0)
            return true;
    return false;
}

/* ---- A draft does not survive the program ---- */

/* The drafts that there are, the latest first; changed only while all signals are blocked. */
static struct redirect *drafts;

static void on_end(int number)
{
    for (const struct redirect *r = drafts; r; r = r->outer)
        unlink(r->draft);
    signal(number, SIG_DFL);
    raise(number);
}

/* Returns true if a signal without a handler ends a program; SIGKILL cannot be handled. */
static bool ends(int number)
{
    static const int others[] = {SIGCHLD, SIGCONT, SIGURG,  SIGWINCH, SIGTSTP,
                                 SIGTTIN, SIGTTOU, SIGSTOP, SIGKILL};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (number == others[i])
            return false;
    return true;
}

/* Makes the signals that end a program remove the drafts, if they have no handler; or restores these
 * signals. */
static void guard(bool on)
{
    for (int number = 1; number <= SIGRTMAX; number++) {
        struct sigaction now, handler = {.sa_handler = on ? on_end : SIG_DFL};
        if (ends(number) && sigaction(number, NULL, &now) == 0 && now.sa_handler == (on ? SIG_DFL : on_end))
            sigaction(number, &handler, NULL);
    }
}

/* Makes the draft of a file, guarded from its first moment on; -1 with errno. */
static int draft_make(struct redirect *r)
{
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    int file = mkostemp(r->draft, O_CLOEXEC), reason = errno;
    if (file >= 0) {
        r->outer = drafts;
        drafts = r;
        if (!r->outer)
            guard(true);
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    errno = reason;
    return file;
}

/* Gives the draft the name of the file, or removes it.  True if it has the name. */
static bool draft_end(struct redirect *r, bool keep)
{
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    bool kept = keep && rename(r->draft, r->path) == 0;
    int reason = errno;
    if (!kept)
        unlink(r->draft);
    struct redirect **at = &drafts;
    while (*at != r)
        at = &(*at)->outer;
    *at = r->outer;
    if (!drafts)
        guard(false);
    sigprocmask(SIG_SETMASK, &before, NULL);
    free(r->draft);
    r->draft = NULL;
    errno = reason;
    return kept;
}

/* ---- Files ---- */

/* Returns the path of the file after all links are followed, the last of which may point at nothing; NULL
 * with errno. */
static char *real_path(const char *path)
{
    enum { LINKS = 40 };
    char target[PATH_MAX], *real = realpath(path, NULL), *at = real ? NULL : strdup(path);
    for (int links = 0; at; links++) {
        ssize_t length = readlink(at, target, sizeof target - 1);
        if (length < 0)
            return at;
        if (links == LINKS) {
            free(at);
            errno = ELOOP;
            return NULL;
        }
        target[length] = '\0';
        char *slash = strrchr(at, '/'), *next;
        int folder = slash && *target != '/' ? (int)(slash + 1 - at) : 0;
        if (asprintf(&next, "%.*s%s", folder, at, target) < 0)
            next = NULL;
        free(at);
        at = next;
    }
    return real;
}

/* Opens a draft beside the file, to take its place with its group and mode; NULL if it may not be there. */
static FILE *draft_beside(struct redirect *r, const struct stat *now)
{
    mode_t mask = umask(0);
    umask(mask);
    if (asprintf(&r->draft, "%s.XXXXXX", r->path) < 0) {
        r->draft = NULL;
        return NULL;
    }
    int file = draft_make(r);
    if (file < 0) {
        free(r->draft);
        r->draft = NULL;
        return NULL;
    }
    /* The group first: its change takes away bits of the mode. */
    bool like = (!now || fchown(file, (uid_t)-1, now->st_gid) == 0) &&
                fchmod(file, now ? now->st_mode & 0777 : 0666 & ~mask) == 0;
    FILE *stream = like ? fdopen(file, "w") : NULL;
    if (!stream) {
        close(file);
        draft_end(r, false);
    }
    return stream;
}

/* Opens a draft without a name, to be copied into the file; NULL if that may not be made. */
static FILE *draft_apart(const char *path, bool exists)
{
    /* Found out now, before the work; a file that is made to try may be one that another program has just
     * found. */
    const char *slash = strrchr(path, '/');
    char *folder = slash ? strndup(path, (size_t)(slash + 1 - path)) : strdup(".");
    bool may = exists || (folder && access(folder, W_OK | X_OK) == 0);
    free(folder);
    return may ? tmpfile() : NULL;
}

const char *redirect_open(struct redirect *r, const char *path, bool append,
                          const volatile sig_atomic_t *interrupt)
{
    struct stat now, out;
    if (escape_needed(path)) /* what a script asks for must be what its reader sees */
        return "the name has control characters, or is not UTF-8; no such file is written";
    bool exists = stat(path, &now) == 0;
    *r = (struct redirect){.path = real_path(path), .append = append, .interrupt = interrupt};
    bool ours =
        exists && fstat(STDOUT_FILENO, &out) == 0 && out.st_dev == now.st_dev && out.st_ino == now.st_ino;
    if (!r->path || (exists && access(path, W_OK) != 0))
        goto failed;
    if (is_open(r->path)) {
        free(r->path);
        return "the answer of a command around this one goes there; choose another file";
    }
    if (ours) {
        fflush(stdout);
        r->file = fdopen(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0), "a");
    } else if (exists && !S_ISREG(now.st_mode)) { /* such as a device or a FIFO: written as it comes */
        int file = io_open(path, O_WRONLY, 0, interrupt);
        r->file = file >= 0 ? io_stream(file, "w", interrupt) : NULL;
    } else {
        /* A file with several names, or of another owner, keeps its place: the draft is copied into it. */
        bool replace = !append && !(exists && (now.st_nlink > 1 || now.st_uid != geteuid()));
        r->file = replace ? draft_beside(r, exists ? &now : NULL) : NULL;
        r->copy = !r->file && (exists || append);
        if (r->copy)
            r->file = draft_apart(r->path, exists);
    }
    if (r->file && (r->draft || r->copy)) {
        r->below = opened;
        opened = r;
    }
    if (r->file)
        return NULL;
failed:;
    const char *why = strerror(errno);
    free(r->path);
    return why;
}

/* ---- Copies ---- */

/* Copies the draft into an open file, from its current place; false with errno. */
static bool draft_copy(FILE *draft, int to)
{
    char block[4096];
    size_t n;
    rewind(draft);
    while ((n = fread(block, 1, sizeof block, draft)) > 0)
        if (!io_write(to, block, n))
            return false;
    return !ferror(draft);
}

/*
 * Copies the draft into the file, or appends it. If there is no room, the file stays as it was: room is taken
 * before the first byte is written over, and rows that were appended only in part are removed.
 */
static bool file_fill(const struct redirect *r, int file)
{
    struct stat old, draft;
    if (fstat(file, &old) != 0 || fstat(fileno(r->file), &draft) != 0)
        return false;
    if (!r->append && draft.st_size > 0) {
        int reason = posix_fallocate(file, 0, draft.st_size);
        if (reason != 0 && reason != EINVAL && reason != EOPNOTSUPP) {
            (void)!ftruncate(file, old.st_size);
            errno = reason;
            return false;
        }
    }
    bool whole = draft_copy(r->file, file);
    int reason = errno;
    if (r->append ? !whole : whole) {
        if (ftruncate(file, r->append ? old.st_size : draft.st_size) != 0 && whole)
            return false;
    }
    errno = reason;
    return whole;
}

/* Copies the draft into the file, which is locked meanwhile, and which no signal leaves half done. */
static bool redirect_copy(const struct redirect *r)
{
    enum { SECONDS = 10 };
    int file = io_open(r->path, O_WRONLY | O_CREAT | (r->append ? O_APPEND : 0), 0666, r->interrupt);
    if (file < 0)
        return false;
    bool locked = io_lock(file, SECONDS, r->interrupt);
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    bool whole = locked && file_fill(r, file);
    int reason = errno;
    if (close(file) != 0 && whole) {
        whole = false;
        reason = errno;
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    errno = reason;
    return whole;
}

const char *redirect_close(struct redirect *r, bool keep)
{
    if (opened == r)
        opened = r->below;
    errno = 0;
    bool whole = !ferror(r->file) && fflush(r->file) == 0;
    if (!whole && dom_raised(r->interrupt))
        errno = ECANCELED;
    if (whole && keep && r->copy)
        whole = redirect_copy(r);
    int reason = errno;
    if (fclose(r->file) != 0 && whole) {
        whole = false;
        reason = errno;
    }
    if (r->draft && !draft_end(r, whole && keep) && whole && keep) {
        whole = false;
        reason = errno;
    }
    free(r->path);
    if (whole)
        return NULL;
    return reason == EWOULDBLOCK ? "another program has locked it"
           : reason              ? strerror(reason)
                                 : "the device is full, or not there any more";
}
