/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* functions that Linux adds to POSIX */
#include "io/system.h"
#include "system_features.h"
#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef HAVE_BSD_FUNOPEN
#include <bsd/stdio.h>
#define HAVE_FUNOPEN
#endif
#ifdef HAVE_PDEATHSIG
#include <sys/prctl.h>
#endif
#ifdef HAVE_PROCCTL
#include <sys/procctl.h>
#include <sys/wait.h>
#endif

/* ---- Streams ---- */

#ifdef HAVE_FOPENCOOKIE

FILE *system_stream(void *cookie, const char *mode, struct system_stream functions)
{
    const cookie_io_functions_t callbacks = {
        .read = functions.read, .write = functions.write, .close = functions.close};
    return fopencookie(cookie, mode, callbacks);
}

#elif defined HAVE_FUNOPEN

/* The callbacks of funopen use int for sizes. The callbacks below convert these sizes to those of a struct
 * system_stream. */
struct bsd_stream {
    void *cookie;
    struct system_stream functions;
};

static int bsd_read(void *stream, char *bytes, int size)
{
    const struct bsd_stream *s = stream;
    return (int)s->functions.read(s->cookie, bytes, (size_t)size);
}

static int bsd_write(void *stream, const char *bytes, int size)
{
    const struct bsd_stream *s = stream;
    ssize_t n = s->functions.write(s->cookie, bytes, (size_t)size);
    return n < size ? -1 : size;
}

static int bsd_close(void *stream)
{
    const struct bsd_stream *s = stream;
    int closed = s->functions.close ? s->functions.close(s->cookie) : 0, reason = errno;
    free(stream);
    errno = reason;
    return closed;
}

FILE *system_stream(void *cookie, const char *mode, struct system_stream functions)
{
    struct bsd_stream *s = malloc(sizeof *s);
    if (!s)
        return NULL;
    *s = (struct bsd_stream){cookie, functions};
    FILE *stream =
        funopen(s, *mode == 'r' ? bsd_read : NULL, *mode == 'r' ? NULL : bsd_write, NULL, bsd_close);
    if (!stream)
        free(s);
    return stream;
}

#else
#error "this system has neither fopencookie() nor funopen(); install libbsd and build with 'make PORTABLE=1'"
#endif

/* ---- Files ---- */

int system_reserve(int file, off_t from, off_t to)
{
#ifdef HAVE_FALLOCATE
    int reason = to > from ? posix_fallocate(file, from, to - from) : 0;
    return reason == EINVAL || reason == EOPNOTSUPP ? 0 : reason; /* the file system cannot reserve space */
#else
    /* Without posix_fallocate, the file is extended by writing one byte into each new block. The blocks that
     * the file already has are assumed to be allocated on the disk. */
    struct stat status;
    if (fstat(file, &status) != 0)
        return errno;
    off_t block = status.st_blksize > 0 ? (off_t)status.st_blksize : 512;
    for (off_t at = from > status.st_size ? from : status.st_size; at < to; at += block - at % block)
        if (pwrite(file, "", 1, at) != 1)
            return errno;
    return to > status.st_size && pwrite(file, "", 1, to - 1) != 1 ? errno : 0;
#endif
}

#ifdef HAVE_TMPFILE

/* The folder that has the open files of this process, which linkat(2) needs. */
#define OPEN_FILES "/proc/self/fd"

int system_unnamed(const char *folder)
{
    return access(OPEN_FILES, X_OK) == 0 ? open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600) : -1;
}

bool system_name(int file, const char *path)
{
    char unnamed[sizeof OPEN_FILES + 16];
    snprintf(unnamed, sizeof unnamed, OPEN_FILES "/%d", file);
    return linkat(AT_FDCWD, unnamed, AT_FDCWD, path, AT_SYMLINK_FOLLOW) == 0;
}

#else

int system_unnamed(const char *folder)
{
    (void)folder;
    errno = EOPNOTSUPP;
    return -1;
}

bool system_name(int file, const char *path)
{
    (void)file;
    (void)path;
    errno = EOPNOTSUPP;
    return false;
}

#endif

/* ---- Processes ---- */

void system_end_with_parent(void)
{
#if defined HAVE_PDEATHSIG
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#elif defined HAVE_PROCCTL
    int signal = SIGKILL;
    procctl(P_PID, 0, PROC_PDEATHSIG_CTL, &signal);
#endif
}

unsigned system_processors(void)
{
#ifdef HAVE_AFFINITY
    cpu_set_t allowed;
    return sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? (unsigned)CPU_COUNT(&allowed) : 1;
#else
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    return processors > 0 ? (unsigned)processors : 1;
#endif
}
