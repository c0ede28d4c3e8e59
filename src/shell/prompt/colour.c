/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "prompt/colour.h"
#include "interpreter/preview.h"
#include "io/terminal.h"
#include <string.h>

#include <readline/readline.h>

/* A longer line is not coloured. */
enum { LINE_LONGEST = 2000 };

/* True once a part of the line on the screen has a colour. */
static bool coloured;

static bool variable_is_on(const char *name)
{
    const char *value = rl_variable_value(name);
    return value && strcmp(value, "on") == 0;
}

/* Returns true if the places of all characters on the screen are known. */
static bool places_known(const struct session *session, int width, int height)
{
    const unsigned long busy = RL_STATE_ISEARCH | RL_STATE_NSEARCH | RL_STATE_SEARCH | RL_STATE_NUMERICARG |
                               RL_STATE_METANEXT | RL_STATE_MULTIKEY;
    const char *up = rl_get_termcap("up"), *clear = rl_get_termcap("ce");
    for (const char *c = rl_line_buffer; *c; c++)
        if (*c < ' ' || *c > '~')
            return false;
    int end = session->prompt_width + rl_end;
    return session->prompt_width > 0 && terminal_colour(session->output->out) && up && clear &&
           strncmp(clear, "\033[", 2) == 0 && !RL_ISSTATE(busy) && !rl_done && rl_end > 0 &&
           rl_end <= LINE_LONGEST && !rl_mark_active_p() && !variable_is_on("show-mode-in-prompt") &&
           !variable_is_on("horizontal-scroll-mode") && !variable_is_on("mark-modified-lines") &&
           width > session->prompt_width && end / width < height &&
           (session->prompt_width + rl_point) % width != 0; /* else the cursor is on no row, or on two */
}

/* Writes the part of the line from `from`, which is in one row and has one colour. */
static void part_write(const struct session *session, int width, int from, int length, bool mark)
{
    int at = session->prompt_width + from, up = (session->prompt_width + rl_point) / width - at / width;
    fputs("\0338", rl_outstream); /* to the cursor */
    if (up != 0)
        fprintf(rl_outstream, "\033[%d%c", up > 0 ? up : -up, up > 0 ? 'A' : 'B');
    putc('\r', rl_outstream);
    if (at % width > 0)
        fprintf(rl_outstream, "\033[%dC", at % width);
    fprintf(rl_outstream, mark ? "\033[36m%.*s\033[m" : "%.*s", length, rl_line_buffer + from);
}

void colour_show(struct session *session)
{
    int width, height;
    bool mark[LINE_LONGEST] = {false};
    if (!terminal_size(session->output->out, &width, &height) || !places_known(session, width, height))
        return;
    line_preview(session, rl_line_buffer, (size_t)rl_end, "", &(struct offer){.is_command = mark});
    if (!coloured && !memchr(mark, 1, (size_t)rl_end))
        return;
    coloured = memchr(mark, 1, (size_t)rl_end) != NULL;
    fputs("\0337\033[?7l", rl_outstream); /* keeps the place of the cursor; no wrapping */
    for (int from = 0, to; from < rl_end; from = to) {
        int row = (session->prompt_width + from) / width;
        for (to = from + 1;
             to < rl_end && mark[to] == mark[from] && (session->prompt_width + to) / width == row;)
            to++;
        part_write(session, width, from, to - from, mark[from]);
    }
    fputs("\0338\033[?7h", rl_outstream);
    fflush(rl_outstream);
}
