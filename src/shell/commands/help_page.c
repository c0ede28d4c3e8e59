/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/help_page.h"
#include "answer/answer.h"
#include "answer/wrap.h"
#include "io/terminal.h"
#include <stdarg.h>

int help_width(FILE *out)
{
    int width = terminal_width(out);
    return width && width < 100 ? width : 100;
}

void help_say(FILE *out, const char *format, ...)
{
    char said[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(said, sizeof said, format, arguments);
    va_end(arguments);
    write_wrapped(out, said, 0, help_width(out));
    putc('\n', out);
}

void help_entry(FILE *out, const char *typed, int column, const char *does)
{
    enum { ROOM = 30, INDENT = 6 }; /* columns for the text beside; blanks before the text below */
    int width = help_width(out), below = width < column + ROOM;
    if (below)
        fprintf(out, "%s\n%*s", typed, INDENT, "");
    else
        fprintf(out, "%-*s", column, typed);
    write_wrapped(out, does, below ? INDENT : column, width);
    putc('\n', out);
}

void help_text(FILE *out, const char *text)
{
    putc('\n', out);
    write_wrapped(out, text, 0, help_width(out));
    putc('\n', out);
}
