/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/io.h"
#include "domino_quad.h"
#include "io/standard.h"
#include "io/terminal.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* The time between two tries where nothing can wait: short for a person, long for the processor. */
static const struct timespec moment = {.tv_nsec = 10000000};

/* ---- Waits ---- */

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

bool io_wait(int file, short events, const struct timespec *longest, const volatile sig_atomic_t *interrupt)
{
    struct pollfd ready = {.fd = file, .events = events};
    sigset_t before = io_block();
    bool raised = dom_raised(interrupt);
    if (!raised)
        (void)ppoll(&ready, 1, longest, &before);
    io_unblock(&before);
    raised = raised || dom_raised(interrupt);
    if (raised)
        errno = ECANCELED;
    return !raised;
}

int io_open(const char *path, int flags, mode_t mode, const volatile sig_atomic_t *interrupt)
{
    struct stat status;
    for (;;) {
        int file = open(path, flags | O_NONBLOCK | O_CLOEXEC | O_NOCTTY, mode);
        int reason = errno;
        /* A FIFO without a reader, and a file that another program holds a lease of. */
        bool later = reason == EAGAIN || reason == EINTR ||
                     (reason == ENXIO && stat(path, &status) == 0 && S_ISFIFO(status.st_mode));
        errno = reason;
        if (file >= 0 || !later || !io_wait(-1, 0, &moment, interrupt))
            return file;
    }
}

bool io_lock(int file, double seconds, const volatile sig_atomic_t *interrupt)
{
    double end = terminal_clock() + seconds;
    while (flock(file, LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR)
            return true;
        if (terminal_clock() > end) {
            errno = EWOULDBLOCK;
            return false;
        }
        if (!io_wait(-1, 0, &moment, interrupt))
            return false;
    }
    return true;
}

bool io_write(int file, const char *bytes, size_t count)
{
    while (count > 0) {
        ssize_t n = write(file, bytes, count);
        if (n < 0 && errno != EINTR)
            return false;
        bytes += n > 0 ? n : 0;
        count -= n > 0 ? (size_t)n : 0;
    }
    return true;
}

/* ---- Streams ---- */

/* The file of a stream, and the flag that ends its waits. */
struct channel {
    int file;
    const volatile sig_atomic_t *interrupt;
};

/*
 * Reads what is there.  Where nothing is, the program at the other end may wait for answers before it writes
 * the next command: they are sent before this one waits, and not after each command.
 */
static ssize_t channel_read(void *cookie, char *bytes, size_t size)
{
    const struct channel *c = cookie;
    struct pollfd ready = {.fd = c->file, .events = POLLIN};
    if (poll(&ready, 1, 0) != 1)
        standard_flush();
    for (;;) {
        if (!io_wait(c->file, POLLIN, NULL, c->interrupt))
            return -1;
        ssize_t n = read(c->file, bytes, size);
        if (n >= 0 || (errno != EAGAIN && errno != EINTR))
            return n;
    }
}

/* Writes all bytes: to a stream of fopencookie fewer are an error. */
static ssize_t channel_write(void *cookie, const char *bytes, size_t size)
{
    const struct channel *c = cookie;
    size_t done = 0;
    while (done < size && io_wait(c->file, POLLOUT, NULL, c->interrupt)) {
        ssize_t n = write(c->file, bytes + done, size - done);
        if (n < 0 && errno != EAGAIN && errno != EINTR)
            break;
        done += n > 0 ? (size_t)n : 0;
    }
    return (ssize_t)done;
}

static int channel_close(void *cookie)
{
    const struct channel *c = cookie;
    int closed = close(c->file);
    free(cookie);
    return closed;
}

/* Opens a stream with these functions on a copy of the cookie, which its close frees.  NULL with errno. */
static FILE *cookie_stream(const void *cookie, size_t size, const char *mode, cookie_io_functions_t functions)
{
    void *kept = malloc(size);
    FILE *stream = kept ? fopencookie(memcpy(kept, cookie, size), mode, functions) : NULL;
    if (!stream)
        free(kept);
    return stream;
}

/* Returns true if opening the file may wait. A terminal takes what is written to it, or ^C drops it; regular
 * files never wait. */
static bool waits(int file, const char *mode)
{
    struct stat status;
    return !(fstat(file, &status) == 0 && S_ISREG(status.st_mode)) && !(*mode == 'w' && isatty(file));
}

FILE *io_stream(int file, const char *mode, const volatile sig_atomic_t *interrupt)
{
    const struct channel channel = {file, interrupt};
    const cookie_io_functions_t functions = {
        .read = channel_read, .write = channel_write, .close = channel_close};
    bool wait = waits(file, mode);
    if (!wait)
        fcntl(file, F_SETFL, fcntl(file, F_GETFL) & ~O_NONBLOCK);
    FILE *stream = wait ? cookie_stream(&channel, sizeof channel, mode, functions) : fdopen(file, mode);
    if (!stream) {
        int reason = errno;
        close(file);
        errno = reason;
    }
    return stream;
}

FILE *io_read(const char *path, const volatile sig_atomic_t *interrupt)
{
    struct stat status;
    int file = io_open(path, O_RDONLY, 0, interrupt);
    if (file >= 0 && fstat(file, &status) == 0 && S_ISDIR(status.st_mode)) {
        close(file);
        errno = EISDIR;
        return NULL;
    }
    return file >= 0 ? io_stream(file, "r", interrupt) : NULL;
}

FILE *io_stdin(const volatile sig_atomic_t *interrupt)
{
    static FILE *in;
    static struct channel channel;
    const cookie_io_functions_t functions = {.read = channel_read};
    if (!in) {
        channel = (struct channel){STDIN_FILENO, interrupt};
        in = waits(STDIN_FILENO, "r") ? fopencookie(&channel, "r", functions) : stdin;
    }
    if (in)
        clearerr(in); /* at a terminal ^D ends one reading, not all */
    return in;
}

FILE *io_temporary(const char *folder)
{
    const char *usual = secure_getenv("TMPDIR");
    char *name;
    folder = folder ? folder : usual && *usual ? usual : P_tmpdir;
    int file = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file < 0 &&
        asprintf(&name, "%s/domino.XXXXXX", folder) >= 0) { /* some file systems have no such files */
        sigset_t before = io_block();
        file = mkostemp(name, O_CLOEXEC);
        if (file >= 0)
            unlink(name);
        io_unblock(&before);
        free(name);
    }
    return file >= 0 ? fdopen(file, "w+") : NULL;
}

/* A stream into memory: the bytes at *text, and how many fit. */
struct memory {
    char **text;
    size_t *size, room;
};

static ssize_t memory_write(void *cookie, const char *bytes, size_t count)
{
    enum { FIRST = 1024 };
    struct memory *m = cookie;
    size_t room = m->room ? m->room : FIRST;
    while (room - *m->size < count)
        room *= 2;
    char *text = room > m->room ? realloc(*m->text, room) : *m->text;
    if (!text)
        return 0;
    memcpy(text + *m->size, bytes, count);
    m->room = room;
    *m->text = text;
    *m->size += count;
    return (ssize_t)count;
}

static int memory_close(void *cookie)
{
    free(cookie);
    return 0;
}

FILE *io_memory(char **text, size_t *size)
{
    const cookie_io_functions_t functions = {.write = memory_write, .close = memory_close};
    const struct memory memory = {text, size, 0};
    *text = NULL;
    *size = 0;
    return cookie_stream(&memory, sizeof memory, "w", functions);
}

void io_begin(void)
{
    /* With O_PATH a file can be neither read nor written; the lowest free number is taken. */
    for (int file = STDIN_FILENO; file <= STDERR_FILENO; file++)
        if (fcntl(file, F_GETFD) < 0)
            (void)!open("/", O_PATH);
}
