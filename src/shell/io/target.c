/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf */
#include "io/target.h"
#include "io/escape.h"
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct target *targets;

/* Returns the absolute path of a file without symbolic links, as realpath does. Unlike realpath, accepts a
 * file that does not exist yet. Returns NULL and sets errno on failure. */
static char *real_path(const char *path)
{
    char target[PATH_MAX], *next, *real = realpath(path, NULL);
    if (real || errno != ENOENT)
        return real;
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    int folder = (int)(name - path);
    ssize_t n = readlink(path, target, sizeof target - 1);
    if (n >= 0) {
        target[n] = '\0';
        if (asprintf(&next, "%.*s%s", *target == '/' ? 0 : folder, path, target) < 0)
            return NULL;
        real = real_path(next);
    } else {
        if (asprintf(&next, "%.*s.", folder, path) < 0)
            return NULL;
        char *above = realpath(next, NULL);
        if (above && asprintf(&real, "%s/%s", above, name) < 0)
            real = NULL;
        free(above);
    }
    free(next);
    return real;
}

static bool is_same_file(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

bool target_is_standard(const struct target *t)
{
    struct stat out;
    return t->exists && fstat(STDOUT_FILENO, &out) == 0 && is_same_file(&out, &t->status);
}

const char *target_begin(struct target *t, const char *path, bool may_be_standard,
                         const struct target *except)
{
    /* a person who reads a script must be able to see which file the script writes */
    if (escape_needed(path))
        return "the name contains control characters, or is not UTF-8; choose another name";
    *t = (struct target){.path = real_path(path), .next = targets};
    t->exists = t->path && stat(path, &t->status) == 0;
    if (!t->path || (!t->exists && errno != ENOENT)) {
        free(t->path);
        return strerror(errno);
    }
    bool is_written = !may_be_standard && target_is_standard(t);
    bool is_regular = !t->exists || S_ISREG(t->status.st_mode); /* several writers may share a device */
    for (const struct target *other = targets; other && is_regular && !is_written; other = other->next) {
        struct stat now;
        bool hard_link = t->exists && stat(other->path, &now) == 0 && is_same_file(&now, &t->status);
        is_written = other != except && (hard_link || strcmp(other->path, t->path) == 0);
    }
    if (is_written) {
        free(t->path);
        return "this session is already writing to it; choose another file";
    }
    targets = t;
    return NULL;
}

void target_end(struct target *t)
{
    struct target **at = &targets;
    while (*at != t)
        at = &(*at)->next;
    *at = t->next;
    free(t->path);
}

const char *target_error(int reason)
{
    return reason == EWOULDBLOCK ? "another program has locked it"
           : reason              ? strerror(reason)
                                 : "the device is full, or no longer there";
}
