/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/output.h"
#include "io/io.h"
#include "io/terminal.h"
#include <stdlib.h>

void output_push(struct output **top, struct output *o)
{
    o->below = *top;
    if (!o->messages)
        o->messages = *top ? (*top)->messages : io_stderr();
    if (*top && o->kind != OUTPUT_FILE)
        terminal_pass((*top)->out, o->out);
    *top = o;
}

const char *output_pop(struct output **top, bool keep)
{
    struct output *o = *top;
    *top = o->below;
    if (o->kind != OUTPUT_FILE)
        terminal_pass(o->out, o->below->out);
    const char *wrong = o->pop(o, keep);
    free(o);
    return wrong;
}

void output_flush(struct output *o)
{
    fflush(o->out);
    io_stdout_flush();
}

void output_answered(struct output *o)
{
    o = *output_find(&o, OUTPUT_BASE);
    if (o->kind == OUTPUT_LOG)
        fflush(o->out);
    while (o->below)
        o = o->below;
    io_row(o->out);
}

struct output **output_find(struct output **top, unsigned kinds)
{
    while (*top && !((*top)->kind & kinds))
        top = &(*top)->below;
    return *top ? top : NULL;
}
