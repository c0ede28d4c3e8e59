/* SPDX-License-Identifier: GPL-3.0-or-later */
/* While Readline waits for a key, a faint hint after the cursor suggests how the line may continue. Readline
 * does not know of the hint, so the cursor must return to the place where Readline left it. */
#include "interpreter/preview.h"
#include "io/escape.h"
#include "io/terminal.h"
#include "language/text.h"
#include "prompt/input.h"
#include <stdlib.h>
#include <string.h>

#include <readline/history.h>
#include <readline/readline.h>

enum { HINT = 256 };

#define SAVE_CURSOR    "\0337\033[?7l" /* saves the cursor position, and turns line wrapping off */
#define RESTORE_CURSOR "\033[?7h\0338"

static bool is_hinted;

/* The hint from the history: the remainder of an earlier line, or "" if there is no such hint. Some keys
 * insert it. */
static char rest[HINT];

/* Returns true if the terminal has colours, and the user has begun to type a line. During a search, for
 * example, Readline shows other text, so the result is false. */
static bool is_plain(const struct session *session)
{
    const unsigned long busy = RL_STATE_ISEARCH | RL_STATE_NSEARCH | RL_STATE_SEARCH | RL_STATE_NUMERICARG |
                               RL_STATE_METANEXT | RL_STATE_MULTIKEY | RL_STATE_VIMOTION;
    const char *clear = rl_get_termcap("ce");
    return terminal_colour(session->output->out) && clear && strncmp(clear, "\033[", 2) == 0 && rl_end > 0 &&
           !RL_ISSTATE(busy) && !rl_done;
}

/* Finds the most recent line that begins with the typed line and stores its remainder in `rest`. */
static void rest_find(const char *line)
{
    size_t length = strlen(line);
    for (int i = history_length - 1; i >= 0 && line[strspn(line, " \t")]; i--) {
        const HIST_ENTRY *entry = history_get(history_base + i);
        if (entry && strncmp(entry->line, line, length) == 0 && entry->line[length] &&
            !escape_needed(entry->line)) {
            if (strlen(entry->line + length) < sizeof rest)
                snprintf(rest, sizeof rest, "%s", entry->line + length);
            return;
        }
    }
}

/* Writes the arguments that may still follow on the line, with brackets around those that are optional. If
 * there is nothing to show, writes "". */
static void usage_rest(struct session *session, const char *line, char usage[HINT])
{
    struct offer o = {.lists = 0};
    bool is_apart = strchr(" \t", line[strlen(line) - 1]);
    line_preview(session, line, strlen(line), is_apart ? PREVIEW_CURSOR : " " PREVIEW_CURSOR, &o);
    const struct command *c = o.command;
    const struct parameter *p = o.parameter;
    *usage = '\0';
    if (!c || c->argument[0].kind == ARGUMENT_GRID ||
        (!is_apart && o.argument == 0 && o.typed < strlen(c->name)))
        return;
    for (int i = o.argument; i < ARGUMENTS_MAX && c->argument[i].kind; i++) {
        const struct argument *a = &c->argument[i];
        const struct domq_effect_argument *value =
            a->kind == ARGUMENT_VALUE && p ? parameter_argument(p, i - 1) : NULL;
        if (a->kind == ARGUMENT_VALUE && p && !value)
            return;
        /* The range is more useful than the name, which is already on the line. */
        const char *name = !value      ? a->name
                           : p->effect ? value->name
                                       : parameter_range(&session->state, p, 0);
        bool is_optional = value ? value->optional : a->optional;
        text_add(usage, HINT, is_optional ? "%s[%s]" : "%s%s", i > o.argument || !is_apart ? " " : "", name);
    }
}

static void hint_show(struct session *session)
{
    char usage[HINT];
    const char *hint = rest;
    rest_find(rl_line_buffer);
    if (!*rest) {
        usage_rest(session, rl_line_buffer, usage);
        hint = usage;
    }
    /* The last column stays free, because a character there may move the cursor to the next row. */
    int room = terminal_width(session->output->out) - session->source.prompt_width -
               utf8_columns(rl_line_buffer) - 1;
    size_t bytes = 0;
    if (!*hint || room < 1)
        return;
    for (; hint[bytes] && room >= 0; bytes++)
        room -= ((unsigned char)hint[bytes] & 0xc0) != 0x80;
    bytes -= room < 0;
    fprintf(rl_outstream, SAVE_CURSOR "\033[2m%.*s\033[m" RESTORE_CURSOR, (int)bytes, hint);
    is_hinted = true;
}

void overlay_show(struct session *session)
{
    bool is_recalled = rl_last_func == rl_get_previous_history || rl_last_func == rl_get_next_history;
    /* A key may send several bytes. The hint is kept until all of them have been read, because the key may be
     * one that accepts the hint. */
    if (!RL_ISSTATE(RL_STATE_MULTIKEY))
        *rest = '\0';
    if (!is_plain(session))
        return;
    if (session->state.settings.hints && rl_point == rl_end && !is_recalled)
        hint_show(session);
    fflush(rl_outstream);
}

void overlay_remove(void)
{
    if (is_hinted)
        fputs("\033[J", rl_outstream);
    is_hinted = false;
}

/* ---- Keys that accept a hint ---- */

/* Inserts the first `bytes` bytes of the hint from the history. Returns false if no such hint is shown. */
static bool rest_accept(size_t bytes)
{
    if (!*rest || rl_point != rl_end)
        return false;
    rest[bytes] = '\0';
    rl_insert_text(rest);
    *rest = '\0';
    return true;
}

static int accept_or_forward(int count, int key)
{
    return rest_accept(strlen(rest)) ? 0 : rl_forward_char(count, key);
}

static int accept_or_end(int count, int key)
{
    return rest_accept(strlen(rest)) ? 0 : rl_end_of_line(count, key);
}

static int accept_word_or_forward(int count, int key)
{
    size_t blanks = strspn(rest, " ");
    return rest_accept(blanks + strcspn(rest + blanks, " ")) ? 0 : rl_forward_word(count, key);
}

/* Makes all keys that call `from` call `to` instead, in the keymaps for typing a line. */
static void rebind(rl_command_func_t *from, rl_command_func_t *to)
{
    const Keymap maps[] = {emacs_standard_keymap, vi_insertion_keymap};
    for (int i = 0; i < 2; i++) {
        char **keys = rl_invoking_keyseqs_in_map(from, maps[i]);
        for (char **key = keys; key && *key; key++) {
            rl_bind_keyseq_in_map(*key, to, maps[i]);
            free(*key);
        }
        free(keys);
    }
}

void overlay_begin(void)
{
    rebind(rl_forward_char, accept_or_forward);
    rebind(rl_end_of_line, accept_or_end);
    rebind(rl_forward_word, accept_word_or_forward);
}
