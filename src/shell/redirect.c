/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "redirect.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char *redirect_open(struct redirect *r, const char *path, bool append)
{
    struct stat now;
    bool exists = stat(path, &now) == 0, in_place = append || (exists && !S_ISREG(now.st_mode));
    *r = (struct redirect){.path = strdup(path)};
    if (exists && access(path, W_OK) != 0)
        goto failed;
    if (in_place) {
        r->file = fopen(path, append ? "a" : "w");
    } else if (asprintf(&r->draft, "%s.XXXXXX", path) > 0) {
        int file = mkstemp(r->draft);
        mode_t mask = umask(0);
        umask(mask);
        if (file >= 0 && fchmod(file, exists ? now.st_mode & 0777 : 0666 & ~mask) == 0)
            r->file = fdopen(file, "w");
    }
    if (r->path && r->file)
        return NULL;
failed:;
    const char *why = strerror(errno);
    free(r->path);
    free(r->draft);
    return why;
}

const char *redirect_close(struct redirect *r, bool keep)
{
    const char *wrong = NULL;
    errno = 0;
    bool lost = ferror(r->file) != 0;
    if (fclose(r->file) != 0 || lost)
        wrong = errno ? strerror(errno) : "the device is full, or not there any more";
    if (r->draft && (wrong || !keep))
        unlink(r->draft);
    else if (r->draft && rename(r->draft, r->path) != 0)
        wrong = strerror(errno);
    free(r->path);
    free(r->draft);
    return wrong;
}
