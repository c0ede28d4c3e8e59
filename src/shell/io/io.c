/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* fopencookie */
#include "io/io.h"
#include "domino_quad.h"
#include "io/terminal.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
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

const volatile sig_atomic_t *io_interrupt;

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

int io_open(const char *path, int flags, mode_t mode)
{
    const struct timespec moment = {.tv_nsec = 10000000};
    struct stat status;
    int file;
    do
        file = open(path, flags | O_NONBLOCK | O_CLOEXEC | O_NOCTTY, mode);
    while (file < 0 &&
           (errno == EINTR || (errno == ENXIO && stat(path, &status) == 0 && S_ISFIFO(status.st_mode))) &&
           io_wait(-1, false, &moment, io_interrupt));
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

/* ---- Streams ---- */

/* Opens a stream with a copy of the cookie, which functions.close must free. */
static FILE *cookie_stream(const void *cookie, size_t size, const char *mode, cookie_io_functions_t functions)
{
    void *copy = malloc(size);
    FILE *stream = copy ? fopencookie(memcpy(copy, cookie, size), mode, functions) : NULL;
    if (!stream)
        free(copy);
    return stream;
}

struct channel {
    int file;
    const volatile sig_atomic_t *interrupt;
    int error; /* errno of the first write that failed, or 0 */
};

/* Reads the bytes that are available. If there are none, another program may be waiting for our answers
 * before it sends its next command. The buffered answers are therefore written first. */
static ssize_t channel_read(void *cookie, char *bytes, size_t size)
{
    const struct channel *c = cookie;
    struct pollfd ready = {.fd = c->file, .events = POLLIN};
    if (poll(&ready, 1, 0) != 1)
        io_stdout_flush();
    ssize_t n = -1;
    do
        if (!io_wait(c->file, false, NULL, c->interrupt))
            return -1;
    while ((n = read(c->file, bytes, size)) < 0 && (errno == EAGAIN || errno == EINTR));
    return n;
}

/* After a failure, nothing is written any more, so that the file has no gap in its text. */
static ssize_t channel_write(void *cookie, const char *bytes, size_t size)
{
    struct channel *c = cookie;
    if (!c->error && !io_write(c->file, bytes, size, c->interrupt))
        c->error = errno;
    errno = c->error ? c->error : errno;
    return c->error ? 0 : (ssize_t)size;
}

static int channel_close(void *cookie)
{
    const struct channel *c = cookie;
    const int error = c->error, closed = close(c->file);
    free(cookie);
    errno = error ? error : errno;
    return error ? -1 : closed;
}

static FILE *channel_stream(int file, const char *mode, const volatile sig_atomic_t *interrupt,
                            cookie_write_function_t *write_function)
{
    const struct channel channel = {.file = file, .interrupt = interrupt};
    return cookie_stream(
        &channel, sizeof channel, mode,
        (cookie_io_functions_t){.read = channel_read, .write = write_function, .close = channel_close});
}

FILE *io_stream(int file, const char *mode)
{
    FILE *stream = channel_stream(file, mode, io_interrupt, channel_write);
    if (!stream)
        close(file);
    return stream;
}

FILE *io_open_read(const char *path)
{
    struct stat status;
    int file = io_open(path, O_RDONLY, 0);
    if (file >= 0 && fstat(file, &status) == 0 && S_ISDIR(status.st_mode)) {
        close(file);
        errno = EISDIR;
        return NULL;
    }
    return file >= 0 ? io_stream(file, "r") : NULL;
}

FILE *io_stdin(void)
{
    static FILE *in;
    static struct channel channel = {.file = STDIN_FILENO};
    struct stat status;
    if (!in) {
        channel.interrupt = io_interrupt;
        /* When the program ends, stdin leaves the unread lines of a regular file to the next program. */
        bool is_regular = fstat(STDIN_FILENO, &status) == 0 && S_ISREG(status.st_mode);
        in = is_regular ? stdin : fopencookie(&channel, "r", (cookie_io_functions_t){.read = channel_read});
    }
    if (in)
        clearerr(in); /* after ^D on a terminal, the next command can read again */
    return in;
}

/* ---- Standard output ---- */

enum { HELD_MOST = 1 << 16 };
#define ROW_SECONDS 0.2

void (*io_copy)(const char *bytes, size_t count);
static FILE *standard;
static double flushed; /* when standard output was last flushed, as terminal_clock() */

static ssize_t standard_write(void *cookie, const char *bytes, size_t size)
{
    if (io_copy)
        io_copy(bytes, size);
    return channel_write(cookie, bytes, size);
}

FILE *io_stdout(const volatile sig_atomic_t *interrupt)
{
    if (!standard) {
        standard = channel_stream(STDOUT_FILENO, "w", interrupt, standard_write);
        if (standard)
            setvbuf(standard, NULL, isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF, HELD_MOST);
        terminal_standard(standard);
    }
    return standard ? standard : stdout;
}

void io_stdout_flush(void)
{
    fflush(standard ? standard : stdout);
    flushed = terminal_clock();
}

_Thread_local bool io_is_worker;

void io_row(FILE *out)
{
    if (!io_is_worker && terminal_clock() - flushed > ROW_SECONDS) {
        fflush(out);
        io_stdout_flush();
    }
}

/* ---- Memory ---- */

struct memory {
    char **text;
    size_t *size;
};

static ssize_t memory_write(void *cookie, const char *bytes, size_t count)
{
    const struct memory *m = cookie;
    char *text = realloc(*m->text, *m->size + count + 1);
    if (!text)
        return 0;
    memcpy(text + *m->size, bytes, count);
    *m->text = text;
    *m->size += count;
    text[*m->size] = '\0';
    return (ssize_t)count;
}

static int memory_close(void *cookie)
{
    free(cookie);
    return 0;
}

FILE *io_memory(char **text, size_t *size)
{
    const struct memory memory = {text, size};
    *text = NULL;
    *size = 0;
    return cookie_stream(&memory, sizeof memory, "w",
                         (cookie_io_functions_t){.write = memory_write, .close = memory_close});
}
