/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "prompt/hint.h"
#include "interpreter/preview.h"
#include "io/escape.h"
#include "io/terminal.h"
#include <stdlib.h>
#include <string.h>

#include <readline/history.h>
#include <readline/readline.h>

enum { HINT = 256 };

/* True while a hint is on the screen, where the cursor is. */
static bool shown;

/* The rest of an earlier line, which keys accept; "" for none. */
static char rest[HINT];

/* Finds the last line of the history that begins as the line does; writes what follows there. */
static void find_rest(const char *line)
{
    size_t length = strlen(line);
    *rest = '\0';
    if (!line[strspn(line, " \t")])
        return;
    for (int i = history_length - 1; i >= 0; i--) {
        const HIST_ENTRY *entry = history_get(history_base + i);
        if (entry && strncmp(entry->line, line, length) == 0 && entry->line[length] &&
            !escape_needed(entry->line)) {
            snprintf(rest, sizeof rest, "%s",
                     strlen(entry->line + length) < sizeof rest ? entry->line + length : "");
            return;
        }
    }
}

/* Writes the arguments that may still follow, by the usage of the command at the end of the line. */
static void usage_rest(struct session *session, const char *line, char usage[HINT])
{
    struct offer e = {.lists = 0};
    bool is_apart = strchr(" \t", line[strlen(line) - 1]);
    line_preview(session, line, strlen(line), is_apart ? PREVIEW_CURSOR : " " PREVIEW_CURSOR, &e);
    const struct command *c = e.command;
    const struct parameter *p = e.parameter;
    size_t n = 0;
    *usage = '\0';
    if (!c || c->argument[0].kind == ARGUMENT_GRID || (!is_apart && !e.argument && e.typed < strlen(c->name)))
        return;
    for (int i = e.argument; i < ARGUMENTS_MAX && c->argument[i].kind && n < HINT; i++) {
        const struct argument *a = &c->argument[i];
        const struct domq_effect_argument *value =
            a->kind == ARGUMENT_VALUE && p ? parameter_value(p, i - 1) : NULL;
        const char *name = value ? value->name : a->name;
        char range[64];
        if (a->kind == ARGUMENT_VALUE && p && !value)
            return;
        if (value && !p->effect) { /* its name stands in the line already */
            parameter_range(&session->state, p, 0, range, sizeof range);
            name = range;
        }
        n +=
            (size_t)snprintf(usage + n, HINT - n, (value ? value->optional : a->optional) ? "%s[%s]" : "%s%s",
                             i > e.argument || !is_apart ? " " : "", name);
    }
}

/* Returns true if the terminal and what Readline does leave room for a hint after the end of the line. */
static bool possible(const struct session *session)
{
    const unsigned long busy = RL_STATE_ISEARCH | RL_STATE_NSEARCH | RL_STATE_SEARCH | RL_STATE_NUMERICARG |
                               RL_STATE_METANEXT | RL_STATE_VIMOTION;
    const char *clear = rl_get_termcap("ce");
    bool moved = rl_last_func == rl_get_previous_history || rl_last_func == rl_get_next_history;
    return session->state.settings.hints && terminal_colour(session->output->out) && clear &&
           strncmp(clear, "\033[", 2) == 0 && rl_end > 0 && rl_point == rl_end && !RL_ISSTATE(busy) &&
           !moved && !rl_done;
}

void hint_show(struct session *session)
{
    char usage[HINT];
    const char *hint = rest;
    if (RL_ISSTATE(RL_STATE_MULTIKEY)) /* the rest of a key that may take the hint is still to come */
        return;
    *rest = '\0';
    if (!possible(session))
        return;
    int width = terminal_width(session->output->out),
        used = session->prompt_width + terminal_columns(rl_line_buffer);
    find_rest(rl_line_buffer);
    if (!*rest) {
        usage_rest(session, rl_line_buffer, usage);
        hint = usage;
    }
    /* The last column stays free: a cursor there is on no row or on two. */
    int room = width - used - 1;
    if (!*hint || room < 1)
        return;
    size_t bytes = 0;
    for (; hint[bytes] && room >= 0; bytes++)
        room -= ((unsigned char)hint[bytes] & 0xc0) != 0x80;
    bytes -= room < 0;
    /* No wrapping, and the place of the cursor is kept: a prompt may be wider than it seems. */
    fprintf(rl_outstream, "\0337\033[?7l\033[2m%.*s\033[m\033[?7h\0338", (int)bytes, hint);
    fflush(rl_outstream);
    shown = true;
}

void hint_remove(void)
{
    if (shown)
        fputs("\033[J", rl_outstream);
    shown = false;
}

/* ---- Keys ---- */

/* Inserts so many bytes of the rest of the earlier line; returns false if there is none here. */
static bool take(size_t bytes)
{
    if (!*rest || rl_point != rl_end)
        return false;
    rest[bytes] = '\0';
    rl_insert_text(rest);
    *rest = '\0';
    return true;
}

static int take_or_forward(int count, int key)
{
    return take(strlen(rest)) ? 0 : rl_forward_char(count, key);
}

static int take_or_end(int count, int key)
{
    return take(strlen(rest)) ? 0 : rl_end_of_line(count, key);
}

static int take_word_or_forward(int count, int key)
{
    size_t blanks = strspn(rest, " ");
    return take(blanks + strcspn(rest + blanks, " ")) ? 0 : rl_forward_word(count, key);
}

/* Binds the keys of one function to another in the keymaps in which lines are typed. */
static void rebind(rl_command_func_t *from, rl_command_func_t *to)
{
    enum { MAPS = 2 };
    const Keymap maps[MAPS] = {emacs_standard_keymap, vi_insertion_keymap};
    for (int i = 0; i < MAPS; i++) {
        char **keys = rl_invoking_keyseqs_in_map(from, maps[i]);
        for (char **key = keys; key && *key; key++) {
            rl_bind_keyseq_in_map(*key, to, maps[i]);
            free(*key);
        }
        free(keys);
    }
}

void hint_begin(void)
{
    rebind(rl_forward_char, take_or_forward);
    rebind(rl_end_of_line, take_or_end);
    rebind(rl_forward_word, take_word_or_forward);
}
