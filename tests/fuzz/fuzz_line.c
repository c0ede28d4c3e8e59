/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The line interpreter on arbitrary bytes, as a stream in a safe session; see 'make fuzz'. */
#include "commands/registry.h"
#include "interpreter/line.h"
#include <stdint.h>
#include <stdlib.h>
#include <sys/time.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static volatile sig_atomic_t enough;

static void on_timer(int number)
{
    (void)number;
    enough = 1;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static FILE *null;
    struct session session;
    /* A curve of ten million rows is no bug: what takes long is interrupted, as ^C would. */
    const struct itimerval limit = {.it_value = {.tv_usec = 20000}};
    if (size == 0)
        return 0;
    if (!null) {
        null = fopen("/dev/null", "w");
        command_registry(all_commands);
        signal(SIGVTALRM, on_timer);
    }
    FILE *in = fmemopen((void *)(uintptr_t)data, size, "r");
    if (!in || !null)
        abort();
    session_init(&session, null);
    session.safe = true;
    session.train.interrupt = &enough;
    enough = 0;
    setitimer(ITIMER_VIRTUAL, &limit, NULL);
    line_stream(&session, in, "fuzz");
    fclose(in);
    session_close(&session);
    return 0;
}
