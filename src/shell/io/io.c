/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/io.h"
#include "domino_quad.h"
#include "io/terminal.h"
#include <errno.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/select.h>
#include <sys/stat.h>
#include <unistd.h>

/* The delay between two attempts to open or lock a file. */
static const struct timespec moment = {.tv_nsec = 10000000};

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

/* Does not change errno. */
static bool is_fifo(const char *path)
{
    struct stat status;
    int reason = errno;
    bool fifo = stat(path, &status) == 0 && S_ISFIFO(status.st_mode);
    errno = reason;
    return fifo;
}

int io_open(const char *path, int flags, mode_t mode, const volatile sig_atomic_t *interrupt)
{
    int file;
    do
        file = open(path, flags | O_NONBLOCK | O_CLOEXEC | O_NOCTTY, mode);
    while (file < 0 && /* EAGAIN means that another program holds a lease on the file */
           (errno == EAGAIN || errno == EINTR || (errno == ENXIO && is_fifo(path))) &&
           io_wait(-1, false, &moment, interrupt));
    return file;
}

bool io_lock(int file, double seconds, const volatile sig_atomic_t *interrupt)
{
    double end = terminal_clock() + seconds;
    while (flock(file, LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR)
            return true;
        if (terminal_clock() > end || !io_wait(-1, false, &moment, interrupt))
            return false;
    }
    return true;
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
