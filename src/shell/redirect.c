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
    bool exists = stat(path, &now) == 0;
    /* What a link points at is the file; a device is written as it comes. */
    char *real = realpath(path, NULL);
    *r = (struct redirect){.path = real ? real : strdup(path), .append = append};
    if (exists && access(path, W_OK) != 0)
        goto failed;
    if (exists && !S_ISREG(now.st_mode)) {
        r->file = fopen(path, "w");
    } else if (r->path && asprintf(&r->draft, "%s.XXXXXX", r->path) > 0) {
        int file = mkstemp(r->draft);
        mode_t mask = umask(0);
        umask(mask);
        if (file >= 0 && fchmod(file, exists ? now.st_mode & 0777 : 0666 & ~mask) == 0)
            r->file = fdopen(file, "w+");
    }
    if (r->file)
        return NULL;
failed:;
    const char *why = strerror(errno);
    free(r->path);
    free(r->draft);
    return why;
}

/* Behind what is in the file already. */
static bool redirect_append(struct redirect *r)
{
    char block[BUFSIZ];
    size_t n;
    FILE *to = fopen(r->path, "a");
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
    bool moved = r->draft && keep && !r->append;
    if (whole && keep && r->draft && r->append)
        whole = redirect_append(r);
    if (fclose(r->file) != 0)
        whole = false;
    if (whole && moved)
        whole = rename(r->draft, r->path) == 0;
    const char *wrong = whole ? NULL : errno ? strerror(errno) : "the device is full, or not there any more";
    if (r->draft && !(moved && whole))
        unlink(r->draft);
    free(r->path);
    free(r->draft);
    return wrong;
}
