/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf, mkostemp */
#include "domino_quad.h"
#include "io/io.h"
#include "io/system.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Opens a stream that calls the given functions. Each function receives a copy of the cookie. The close
 * function must free this copy. */
static FILE *cookie_stream(const void *cookie, size_t size, const char *mode, struct system_stream functions)
{
    void *copy = malloc(size);
    FILE *stream = copy ? system_stream(memcpy(copy, cookie, size), mode, functions) : NULL;
    if (!stream)
        free(copy);
    return stream;
}

/* ---- Standard output ---- */

enum { HELD_MOST = 1 << 16, MOMENT = 10000000 /* ns */ };

/* Text that stdio has already flushed, but that has not been written to standard output yet. `held_error` is
 * the errno of the first write that failed, or 0. All of these variables are protected by `held_lock`.
 * Threads wait for this lock. The handler of the timer must not wait, because the thread that it interrupts
 * may hold the lock. */
static char held[HELD_MOST];
static size_t held_size;
static int held_error;
static atomic_flag held_lock = ATOMIC_FLAG_INIT;

static FILE *standard;
static const volatile sig_atomic_t *standard_interrupt;

static void held_begin(void)
{
    while (atomic_flag_test_and_set(&held_lock))
        sched_yield();
}

static void held_write(void)
{
    if (!held_error && !io_write(STDOUT_FILENO, held, held_size, standard_interrupt))
        held_error = errno;
    held_size = 0;
}

static void on_timer(int number)
{
    int reason = errno;
    (void)number;
    if (!atomic_flag_test_and_set(&held_lock)) {
        held_write();
        atomic_flag_clear(&held_lock);
    } else
        system_timer_start(MOMENT);
    errno = reason;
}

static ssize_t standard_write(void *cookie, const char *bytes, size_t size)
{
    (void)cookie;
    held_begin();
    for (size_t done = 0, part; done < size; done += part) {
        if (held_size == HELD_MOST)
            held_write();
        if (held_size == 0)
            system_timer_start(MOMENT);
        part = size - done < HELD_MOST - held_size ? size - done : HELD_MOST - held_size;
        memcpy(held + held_size, bytes + done, part);
        held_size += part;
    }
    int reason = held_error;
    atomic_flag_clear(&held_lock);
    errno = reason ? reason : errno;
    return reason ? 0 : (ssize_t)size;
}

void io_stdout_flush(void)
{
    fflush(standard ? standard : stdout);
    held_begin();
    held_write();
    atomic_flag_clear(&held_lock);
}

static int standard_close(void *cookie)
{
    (void)cookie;
    held_begin(); /* the lock is never released, because the timer may fire later */
    held_write();
    errno = held_error ? held_error : errno;
    return held_error ? -1 : 0;
}

FILE *io_stdout(const volatile sig_atomic_t *interrupt)
{
    const struct system_stream functions = {.write = standard_write, .close = standard_close};
    standard_interrupt = interrupt;
    if (!standard && !isatty(STDOUT_FILENO)) {
        if (system_timer(on_timer))
            standard = system_stream(NULL, "w", functions);
        else
            setvbuf(stdout, NULL, _IOLBF, BUFSIZ); /* each line is flushed immediately */
    }
    standard = standard ? standard : stdout;
    return standard;
}

/* ---- Files ---- */

struct channel {
    int file;
    const volatile sig_atomic_t *interrupt;
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

/* Writes all bytes, because the stream would treat a short count as an error. */
static ssize_t channel_write(void *cookie, const char *bytes, size_t size)
{
    const struct channel *c = cookie;
    size_t done = 0;
    while (done < size && io_wait(c->file, true, NULL, c->interrupt)) {
        ssize_t n = write(c->file, bytes + done, size - done);
        if (n < 0 && errno != EAGAIN && errno != EINTR)
            break;
        done += n > 0 ? (size_t)n : 0;
    }
    return (ssize_t)done;
}

static int channel_close(void *cookie)
{
    int closed = close(((const struct channel *)cookie)->file);
    free(cookie);
    return closed;
}

/* Returns true if reading from the file or writing to it may block. A regular file never blocks. Writing to a
 * terminal blocks if the user has stopped the terminal, but this does not count, because ^C then discards the
 * output. */
static bool may_wait(int file, const char *mode)
{
    struct stat status;
    return !(fstat(file, &status) == 0 && S_ISREG(status.st_mode)) && !(*mode == 'w' && isatty(file));
}

FILE *io_stream(int file, const char *mode, const volatile sig_atomic_t *interrupt)
{
    const struct channel channel = {file, interrupt};
    const struct system_stream functions = {
        .read = channel_read, .write = channel_write, .close = channel_close};
    bool waits = may_wait(file, mode);
    if (!waits)
        fcntl(file, F_SETFL, fcntl(file, F_GETFL) & ~O_NONBLOCK);
    FILE *stream = waits ? cookie_stream(&channel, sizeof channel, mode, functions) : fdopen(file, mode);
    if (!stream)
        close(file);
    return stream;
}

FILE *io_open_read(const char *path, const volatile sig_atomic_t *interrupt)
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
    const struct system_stream functions = {.read = channel_read};
    if (!in) {
        channel = (struct channel){STDIN_FILENO, interrupt};
        in = may_wait(STDIN_FILENO, "r") ? system_stream(&channel, "r", functions) : stdin;
    }
    if (in)
        clearerr(in); /* after ^D on a terminal, the next command can read again */
    return in;
}

const char *io_temporary_folder(void)
{
    const char *variable = getenv("TMPDIR");
    return variable && *variable ? variable : P_tmpdir;
}

FILE *io_temporary(const char *folder)
{
    char *name;
    folder = folder ? folder : io_temporary_folder();
    int file = system_unnamed(folder);
    if (file < 0 && asprintf(&name, "%s/domino.XXXXXX", folder) >= 0) {
        sigset_t before = io_block();
        file = mkostemp(name, O_CLOEXEC);
        if (file >= 0)
            unlink(name);
        io_unblock(&before);
        free(name);
    }
    return file >= 0 ? fdopen(file, "w+") : NULL;
}

void io_copy(FILE *from, FILE *to)
{
    char block[4096];
    rewind(from);
    for (size_t n; (n = fread(block, 1, sizeof block, from)) > 0;)
        fwrite(block, 1, n, to);
}

/* ---- Memory ---- */

struct memory {
    char **text;
    size_t *size;
};

static ssize_t memory_write(void *cookie, const char *bytes, size_t count)
{
    const struct memory *m = cookie;
    char *text = realloc(*m->text, *m->size + count);
    if (!text)
        return 0;
    memcpy(text + *m->size, bytes, count);
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
    const struct system_stream functions = {.write = memory_write, .close = memory_close};
    const struct memory memory = {text, size};
    *text = NULL;
    *size = 0;
    return cookie_stream(&memory, sizeof memory, "w", functions);
}
