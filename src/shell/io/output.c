/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/output.h"
#include "io/standard.h"
#include <stdlib.h>

struct output output_standard(FILE *out)
{
    return (struct output){.kind = OUTPUT_STANDARD, .out = out, .messages = stderr};
}

void output_push(struct output **top, struct output *o)
{
    o->below = *top;
    if (!o->messages)
        o->messages = *top ? (*top)->messages : stderr;
    *top = o;
}

const char *output_pop(struct output **top, bool keep)
{
    struct output *o = *top;
    const char *wrong = o->pop(o, keep);
    *top = o->below;
    free(o);
    return wrong;
}

void output_flush(struct output *o)
{
    fflush(o->out);
    standard_flush();
}

struct output **output_find(struct output **top, enum output_kind kind)
{
    while (*top && (*top)->kind != kind)
        top = &(*top)->below;
    return *top ? top : NULL;
}

struct output *output_end(struct output *o)
{
    while (o->kind == OUTPUT_LOG || o->kind == OUTPUT_TEE || o->kind == OUTPUT_PAGER)
        o = o->below;
    return o;
}

struct output *output_base(struct output *o)
{
    while (o->kind == OUTPUT_FILE || o->kind == OUTPUT_PAGER)
        o = o->below;
    return o;
}
