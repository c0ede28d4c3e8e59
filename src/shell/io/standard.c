/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/standard.h"
#include "domino_quad.h"
#include <errno.h>
#include <sched.h>
#include <stdatomic.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { HELD = 1 << 16, MOMENT = 10000000 /* ns */ };

/* Text that was flushed and is not written yet, and errno of the first write that failed.  They belong to
 * whoever has set `busy`: to a thread that writes, or to the signal handler, which never waits for it. */
static char held[HELD];
static size_t held_size;
static int failed;
static atomic_flag busy = ATOMIC_FLAG_INIT;

static FILE *stream;
static const volatile sig_atomic_t *interrupted;

/* The timer that ends the wait. */
static enum { UNKNOWN, NONE, THERE } timer_is;
static timer_t timer;
static atomic_bool timer_runs;

static void write_all(const char *bytes, size_t size)
{
    while (size > 0 && !failed) {
        ssize_t n = write(STDOUT_FILENO, bytes, size);
        if (n < 0 && (errno != EINTR || dom_raised(interrupted)))
            failed = errno;
        bytes += n > 0 ? n : 0;
        size -= n > 0 ? (size_t)n : 0;
    }
}

static void held_write(void)
{
    write_all(held, held_size);
    held_size = 0;
}

static void timer_start(void)
{
    const struct itimerspec moment = {.it_value = {.tv_nsec = MOMENT}};
    timer_runs = true;
    timer_settime(timer, 0, &moment, NULL);
}

static void on_moment(int number)
{
    int reason = errno;
    (void)number;
    timer_runs = false;
    if (!atomic_flag_test_and_set(&busy)) {
        held_write();
        atomic_flag_clear(&busy);
    } else
        timer_start();
    errno = reason;
}

/* Returns true if text may be held, since a timer will end that. */
static bool may_hold(void)
{
    struct sigevent event = {.sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGRTMIN};
    const struct sigaction action = {.sa_handler = on_moment, .sa_flags = SA_RESTART};
    if (timer_is == UNKNOWN)
        timer_is =
            sigaction(SIGRTMIN, &action, NULL) == 0 && timer_create(CLOCK_MONOTONIC, &event, &timer) == 0
                ? THERE
                : NONE;
    return timer_is == THERE;
}

static void busy_begin(void)
{
    while (atomic_flag_test_and_set(&busy))
        sched_yield();
}

static ssize_t stream_write(void *cookie, const char *bytes, size_t size)
{
    (void)cookie;
    busy_begin();
    bool hold = size <= HELD && may_hold();
    if (!hold || size > HELD - held_size)
        held_write();
    if (hold) {
        memcpy(held + held_size, bytes, size);
        held_size += size;
    } else
        write_all(bytes, size);
    if (hold && !timer_runs)
        timer_start();
    int reason = failed;
    atomic_flag_clear(&busy);
    errno = reason ? reason : errno;
    return reason ? 0 : (ssize_t)size;
}

void standard_flush(void)
{
    fflush(stream ? stream : stdout);
    busy_begin();
    held_write();
    atomic_flag_clear(&busy);
}

static int stream_close(void *cookie)
{
    (void)cookie;
    busy_begin();
    held_write();
    errno = failed ? failed : errno;
    return failed ? -1 : 0;
}

FILE *standard_stream(const volatile sig_atomic_t *interrupt)
{
    const cookie_io_functions_t functions = {.write = stream_write, .close = stream_close};
    interrupted = interrupt;
    if (!stream)
        stream = isatty(STDOUT_FILENO) ? stdout : fopencookie(NULL, "w", functions);
    stream = stream ? stream : stdout;
    return stream;
}
