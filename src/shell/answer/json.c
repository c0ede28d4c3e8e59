/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The json format. Each row of an answer is written as an object on a line of its own, and so is an error. If
 * a command has no rows, an object with only the name of the command shows that the command has finished. */
#define _GNU_SOURCE /* fputs_unlocked */
#include "answer/answer.h"
#include "io/escape.h"

static void cell_write(const struct answer *a, struct cell cell)
{
    char text[CELL_TEXT];
    if (cell.kind == CELL_WORD)
        escape_json(a->out, cell.word);
    else
        fputs_unlocked(cell.kind == CELL_NONE ? "null" : cell_plain(&a->style, cell, text), a->out);
}

static void json_row(struct answer *a, const struct cell *cells, const char *reason)
{
    char text[CELL_TEXT];
    fprintf(a->out, "{\"command\":\"%s\"", a->command);
    for (int i = 0; a->columns[i].key; i++) {
        fprintf(a->out, ",\"%s\":", a->columns[i].key);
        cell_write(a, cells[i]);
        if (answer_has_error(a, i))
            fprintf(a->out, ",\"%s_error\":%s", a->columns[i].key,
                    cell_plain_error(&a->style, cells[i], "null", text));
    }
    if (reason) {
        fputs_unlocked(",\"reason\":", a->out);
        cell_write(a, cell_word(*reason ? reason : NULL));
    }
    if (a->note) {
        fputs_unlocked(",\"note\":", a->out);
        cell_write(a, cell_word(a->note));
    }
    fputs_unlocked("}\n", a->out);
}

static void json_done(FILE *out, const char *command)
{
    fprintf(out, "{\"command\":\"%s\"}\n", command);
}

static void json_failed(FILE *out, const struct failure *f)
{
    fprintf(out, f->command ? "{\"command\":\"%s\"" : "{\"command\":null", f->command);
    fputs(",\"error\":", out);
    escape_json(out, f->text);
    fputs(",\"source\":", out);
    escape_json(out, f->source);
    fprintf(out, f->column ? ",\"line\":%ld,\"column\":%d}\n" : ",\"line\":%ld,\"column\":null}\n", f->line,
            f->column);
}

const struct format format_json = {
    .escapes = true, .row = json_row, .done = json_done, .failed = json_failed};
