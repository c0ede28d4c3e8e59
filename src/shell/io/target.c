/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf */
#include "io/target.h"
#include "io/escape.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct target *targets;

/* Sets the path of a target, and that of its folder. Returns false and sets errno on failure. */
static bool target_resolve(struct target *t, const char *path)
{
    struct stat status;
    t->exists = stat(path, &t->status) == 0;
    if (!t->exists && errno != ENOENT)
        return false;
    t->path = realpath(path, NULL);
    /* The path of a pipe, such as /dev/stdout, is a link to a name that does not exist. No other such link is
     * followed. */
    if (!t->path && errno == ENOENT && (t->exists || lstat(path, &status) != 0)) {
        const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
        char *folder = strndup(path, (size_t)(name - path)),
             *real = folder ? realpath(*folder ? folder : ".", NULL) : NULL;
        if (real && asprintf(&t->path, "%s/%s", real, name) < 0)
            t->path = NULL;
        free(folder);
        free(real);
    }
    t->folder = t->path ? strndup(t->path, (size_t)(strrchr(t->path, '/') + 1 - t->path)) : NULL;
    return t->folder;
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

/* Returns true if the session is already writing the file. */
static bool target_is_written(const struct target *t, const struct target *except)
{
    struct stat now;
    for (const struct target *other = targets; other; other = other->next)
        if (other != except &&
            (strcmp(other->path, t->path) == 0 ||
             (t->exists && stat(other->path, &now) == 0 && is_same_file(&now, &t->status))))
            return true;
    return false;
}

const char *target_begin(struct target *t, const char *path, bool may_be_standard,
                         const struct target *except)
{
    /* a person who reads a script must be able to see which file the script writes */
    if (escape_needed(path))
        return "the name contains control characters, or is not UTF-8; choose another name";
    *t = (struct target){.path = NULL};
    const char *wrong = target_resolve(t, path) ? NULL : strerror(errno);
    const bool is_shared = t->exists && !S_ISREG(t->status.st_mode); /* a device may have several writers */
    if (!wrong &&
        ((!may_be_standard && target_is_standard(t)) || (!is_shared && target_is_written(t, except))))
        wrong = "this session is already writing to it; choose another file";
    t->next = targets;
    targets = t;
    if (wrong)
        target_end(t);
    return wrong;
}

void target_end(struct target *t)
{
    struct target **at = &targets;
    while (*at != t)
        at = &(*at)->next;
    *at = t->next;
    free(t->path);
    free(t->folder);
}

const char *target_error(int reason)
{
    return reason == EWOULDBLOCK ? "another program has locked it"
           : reason              ? strerror(reason)
                                 : "the device is full, or no longer there";
}
