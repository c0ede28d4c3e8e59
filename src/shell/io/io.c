/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf, mkostemp */
#include "io/io.h"
#include "domino_quad.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/select.h>
#include <sys/stat.h>
#include <unistd.h>

sigset_t io_block(void)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    return before;
}

void io_unblock(const sigset_t *before)
{
    pthread_sigmask(SIG_SETMASK, before, NULL);
}

bool io_wait(int file, bool to_write, const struct timespec *longest, const volatile sig_atomic_t *interrupt)
{
    fd_set in, out;
    FD_ZERO(&in);
    FD_ZERO(&out);
    if (file >= 0)
        FD_SET(file, to_write ? &out : &in);
    sigset_t before = io_block();
    /* If a signal arrives after this check, it stays blocked until pselect is called, and then pselect
     * returns at once. */
    if (!dom_raised(interrupt))
        pselect(file + 1, &in, &out, NULL, longest, &before);
    io_unblock(&before);
    if (dom_raised(interrupt))
        errno = ECANCELED;
    return !dom_raised(interrupt);
}

int io_open(const char *path, int flags, mode_t mode, const volatile sig_atomic_t *interrupt)
{
    const struct timespec moment = {.tv_nsec = 10000000};
    struct stat status;
    int file;
    do
        file = open(path, flags | O_NONBLOCK | O_CLOEXEC | O_NOCTTY, mode);
    while (file < 0 &&
           (errno == EINTR || (errno == ENXIO && stat(path, &status) == 0 && S_ISFIFO(status.st_mode))) &&
           io_wait(-1, false, &moment, interrupt));
    return file;
}

bool io_write(int file, const char *bytes, size_t count, const volatile sig_atomic_t *interrupt)
{
    while (count > 0) {
        ssize_t n = write(file, bytes, count);
        bool is_full = n < 0 && errno == EAGAIN;
        if ((is_full && !io_wait(file, true, NULL, interrupt)) ||
            (n < 0 && !is_full && (errno != EINTR || dom_raised(interrupt))))
            return false;
        bytes += n > 0 ? n : 0;
        count -= n > 0 ? (size_t)n : 0;
    }
    return true;
}

bool io_ends_in_line(const char *path)
{
    char last = '\n';
    struct stat status;
    int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (file < 0)
        return false;
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0)
        (void)!pread(file, &last, 1, status.st_size - 1);
    close(file);
    return last != '\n';
}

void io_begin(void)
{
    for (int file = STDIN_FILENO; file <= STDERR_FILENO; file++)
        if (fcntl(file, F_GETFD) < 0)
            (void)!open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

const char *io_temporary_folder(void)
{
    const char *variable = getenv("TMPDIR");
    return variable && *variable ? variable : P_tmpdir;
}

int io_temporary(const char *folder, char **name)
{
    char *path;
    if (asprintf(&path, "%s/.domino.XXXXXX", folder ? folder : io_temporary_folder()) < 0)
        return -1;
    sigset_t before = io_block(); /* a signal must not leave a file whose name is not needed */
    int file = mkostemp(path, O_CLOEXEC);
    if (file >= 0 && !name)
        unlink(path);
    io_unblock(&before);
    if (name && file >= 0)
        *name = path;
    else
        free(path);
    return file;
}
