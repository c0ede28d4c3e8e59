/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf, mkostemp */
#include "domino_quad.h"
#include "io/io.h"
#include "io/system.h"
#include "io/terminal.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
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

/* ---- Files ---- */

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

/* Closes the file of a channel that is not freed. */
static int channel_end(void *cookie)
{
    const struct channel *c = cookie;
    const int closed = close(c->file);
    errno = c->error ? c->error : errno;
    return c->error ? -1 : closed;
}

static int channel_close(void *cookie)
{
    const int closed = channel_end(cookie);
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
    const struct channel channel = {.file = file, .interrupt = interrupt};
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
        channel = (struct channel){.file = STDIN_FILENO, .interrupt = interrupt};
        in = may_wait(STDIN_FILENO, "r") ? system_stream(&channel, "r", functions) : stdin;
    }
    if (in)
        clearerr(in); /* after ^D on a terminal, the next command can read again */
    return in;
}

/* ---- Standard output and standard error ---- */

enum { HELD_MOST = 1 << 16 };
#define ROW_SECONDS 0.2

static FILE *standard, *messages;
static double flushed; /* when standard output was last flushed, as terminal_clock() */

/* Returns *stream, which it opens at the first call, or `other` if it cannot be opened. */
static FILE *stream_once(FILE **stream, struct channel *channel, int buffering, FILE *other)
{
    /* Standard error stays open for what comes after the program's last message. */
    const struct system_stream functions = {.write = channel_write,
                                            .close = other == stderr ? NULL : channel_end};
    if (!*stream) {
        *stream = system_stream(channel, "w", functions);
        if (*stream)
            setvbuf(*stream, NULL, buffering, HELD_MOST);
    }
    return *stream ? *stream : other;
}

FILE *io_stdout(const volatile sig_atomic_t *interrupt)
{
    static struct channel channel = {.file = STDOUT_FILENO};
    if (!standard)
        channel.interrupt = interrupt;
    return stream_once(&standard, &channel, isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF, stdout);
}

FILE *io_stderr(void)
{
    static struct channel channel = {.file = STDERR_FILENO};
    return stream_once(&messages, &channel, _IONBF, stderr);
}

void io_stderr_end(void)
{
    if (messages)
        fclose(messages);
    messages = NULL;
}

void io_stdout_flush(void)
{
    fflush(standard ? standard : stdout);
    flushed = terminal_clock();
}

void io_row(FILE *out)
{
    if (terminal_clock() - flushed > ROW_SECONDS) {
        fflush(out);
        io_stdout_flush();
    }
}

/* ---- Temporary files ---- */

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
    const struct system_stream functions = {.write = memory_write, .close = memory_close};
    const struct memory memory = {text, size};
    *text = NULL;
    *size = 0;
    return cookie_stream(&memory, sizeof memory, "w", functions);
}
