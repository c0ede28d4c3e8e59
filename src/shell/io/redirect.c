/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/redirect.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- A draft does not survive the program ---- */

static char draft[PATH_MAX];

static void on_end(int number)
{
    unlink(draft);
    signal(number, SIG_DFL);
    raise(number);
}

static const int ending[] = {SIGINT, SIGTERM, SIGHUP};

/* Where nobody else handles these signals, they remove the draft; path NULL gives them back. */
static void draft_guard(const char *path)
{
    snprintf(draft, sizeof draft, "%s", path ? path : "");
    for (size_t i = 0; i < sizeof ending / sizeof *ending; i++) {
        struct sigaction now, guard = {.sa_handler = path ? on_end : SIG_DFL};
        sigaction(ending[i], NULL, &now);
        if (now.sa_handler == (path ? SIG_DFL : on_end))
            sigaction(ending[i], &guard, NULL);
    }
}

/* ---- Files ---- */

/* Opens a draft beside the file, to take its place; NULL if it may not be there. */
static FILE *draft_beside(struct redirect *r, const struct stat *now)
{
    mode_t mask = umask(0);
    umask(mask);
    if (!r->path || asprintf(&r->draft, "%s.XXXXXX", r->path) < 0) {
        r->draft = NULL;
        return NULL;
    }
    /* No signal may come between the making of the draft and its guard. */
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    int file = mkstemp(r->draft);
    if (file >= 0)
        draft_guard(r->draft);
    sigprocmask(SIG_SETMASK, &before, NULL);
    if (file >= 0 && fchmod(file, now ? now->st_mode & 0777 : 0666 & ~mask) == 0)
        return fdopen(file, "w");
    if (file >= 0) {
        close(file);
        unlink(r->draft);
        draft_guard(NULL);
    }
    free(r->draft);
    r->draft = NULL;
    return NULL;
}

/* Opens a draft without a name, to be copied into the file; NULL if that may not be made. */
static FILE *draft_apart(const char *path, bool exists)
{
    /* Found out now, before the work. */
    int probe = exists ? -1 : open(path, O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (!exists && probe < 0)
        return NULL;
    if (!exists) {
        close(probe);
        unlink(path);
    }
    return tmpfile();
}

const char *redirect_open(struct redirect *r, const char *path, bool append)
{
    struct stat now, out;
    bool exists = stat(path, &now) == 0;
    /* What a link points at is the file. */
    char *real = realpath(path, NULL);
    *r = (struct redirect){.path = real ? real : strdup(path), .append = append};
    bool ours =
        exists && fstat(STDOUT_FILENO, &out) == 0 && out.st_dev == now.st_dev && out.st_ino == now.st_ino;
    if (exists && access(path, W_OK) != 0)
        goto failed;
    if (ours) {
        fflush(stdout);
        r->file = fdopen(dup(STDOUT_FILENO), "a");
    } else if (exists && !S_ISREG(now.st_mode)) {
        r->file = fopen(path, "w"); /* a device is written as it comes */
    } else {
        /* A file of many names, or of somebody else, keeps its place: the draft is copied into it. */
        bool replace = !append && !(exists && (now.st_nlink > 1 || now.st_uid != geteuid()));
        r->file = replace ? draft_beside(r, exists ? &now : NULL) : NULL;
        r->copy = !r->file && (exists || append);
        if (r->copy)
            r->file = draft_apart(r->path, exists);
    }
    if (r->file)
        return NULL;
failed:;
    const char *why = strerror(errno);
    free(r->path);
    free(r->draft);
    return why;
}

/* The draft's text into the file, or behind what is in it. */
static bool redirect_copy(struct redirect *r)
{
    char block[BUFSIZ];
    size_t n;
    FILE *to = fopen(r->path, r->append ? "a" : "w");
    rewind(r->file);
    while (to && (n = fread(block, 1, sizeof block, r->file)) > 0)
        fwrite(block, 1, n, to);
    bool whole = to && !ferror(to) && !ferror(r->file);
    return to && fclose(to) == 0 && whole;
}

const char *redirect_close(struct redirect *r, bool keep)
{
    errno = 0;
    bool whole = !ferror(r->file) && fflush(r->file) == 0;
    if (whole && keep && r->copy)
        whole = redirect_copy(r);
    if (fclose(r->file) != 0)
        whole = false;
    bool moved = whole && keep && r->draft;
    if (moved)
        whole = moved = rename(r->draft, r->path) == 0;
    const char *wrong = whole ? NULL : errno ? strerror(errno) : "the device is full, or not there any more";
    if (r->draft && !moved)
        unlink(r->draft);
    if (r->draft)
        draft_guard(NULL);
    free(r->path);
    free(r->draft);
    return wrong;
}
