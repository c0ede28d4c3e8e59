/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plays an animation in the terminal, in characters. The space bar stops and continues it, the arrow keys
 * show the frame before or after, and 'q' ends it. */
#include "pictures/drawing/play.h"
#include "answer/extension.h"
#include "io/io.h"
#include "io/terminal.h"
#include "pictures/picture/screen.h"
#include <stdlib.h>
#include <string.h>

struct frame {
    char *text;
    size_t size;
};

struct player {
    FILE *out, *screen; /* the stream of the answer, and the screen */
    double delay, next; /* in s: the time between two frames, and when the next frame is due */
    const volatile sig_atomic_t *interrupt;
    struct frame *frame; /* all frames so far */
    size_t count, room, at;
    bool is_stopped, has_ended, failed;
};

struct player *player_begin(FILE *out, int delay, const volatile sig_atomic_t *interrupt,
                            struct problem *problem)
{
    struct player *p = calloc(1, sizeof *p);
    FILE *screen = p ? screen_begin(out) : NULL;
    if (!screen) {
        free(p);
        problem_error(problem,
                      "an animation can be shown only on a terminal; enter 'animate > film.gif' for a file");
        return NULL;
    }
    *p = (struct player){.out = out,
                         .screen = screen,
                         .delay = delay / 100.0,
                         .next = terminal_clock(),
                         .interrupt = interrupt};
    return p;
}

static void screen_show(struct player *p)
{
    const struct frame *f = &p->frame[p->at];
    fputs("\033[H", p->screen);
    for (const char *line = f->text, *end = line + f->size; line < end;) {
        const char *line_end = memchr(line, '\n', (size_t)(end - line));
        line_end = line_end ? line_end : end;
        fprintf(p->screen, "%.*s\033[K\r\n", (int)(line_end - line), line);
        line = line_end + 1;
    }
    fprintf(p->screen, "%s\033[J",
            p->is_stopped ? "(stopped: space continues, arrows go frame by frame, q ends)"
                          : "(space stops, q ends)");
    fflush(p->screen);
}

/* Moves by one frame in either direction. Returns true if the next frame has yet to be made. */
static bool frame_move(struct player *p, bool forwards)
{
    p->is_stopped = true;
    if (forwards && p->at + 1 == p->count)
        return true;
    p->at += forwards ? 1 : p->at > 0 ? (size_t)-1 : 0;
    screen_show(p);
    return false;
}

/* Handles a key. Returns true if the next frame must be made. */
static bool key_take(struct player *p, int key)
{
    if (key == KEY_RIGHT || key == KEY_LEFT)
        return frame_move(p, key == KEY_RIGHT);
    p->is_stopped = p->is_stopped != (key == ' ');
    p->next = terminal_clock() + (key == KEY_BACK ? p->delay : 0);
    screen_show(p);
    return key == ' ' && !p->is_stopped && p->at + 1 == p->count;
}

/* Waits for the time of the next frame, and handles keys. Returns when the next frame must be made. */
static void frames_play(struct player *p)
{
    for (;;) {
        const int key = screen_key(p->is_stopped ? 1 : p->next - terminal_clock(), p->interrupt);
        p->has_ended = key == KEY_END;
        if (p->has_ended ||
            ((key == ' ' || key == KEY_BACK || key == KEY_LEFT || key == KEY_RIGHT) && key_take(p, key)))
            return;
        if (p->is_stopped || terminal_clock() < p->next)
            continue;
        if (p->at + 1 == p->count)
            return;
        p->at++;
        p->next += p->delay;
        screen_show(p);
    }
}

static bool frame_add(struct player *p, const struct stage *stage)
{
    int width, height;
    if (p->count == p->room) {
        const size_t room = 2 * p->room + 64;
        struct frame *more = realloc(p->frame, room * sizeof *more);
        if (!more)
            return false;
        p->frame = more;
        p->room = room;
    }
    struct frame *f = &p->frame[p->count];
    *f = (struct frame){.text = NULL};
    FILE *text = io_memory(&f->text, &f->size);
    if (!text)
        return false;
    terminal_size(p->out, &width, &height);
    width = width > PICTURE_LEAST_WIDTH ? width - 1 : PICTURE_LEAST_WIDTH;
    height = height > PICTURE_LEAST_HEIGHT ? height - 1 : PICTURE_LEAST_HEIGHT;
    const bool is_drawn = stage_text(stage, display_of(p->out), width, height, text);
    if (fclose(text) != 0 || !is_drawn) {
        free(f->text);
        return false;
    }
    p->at = p->count++;
    return true;
}

bool player_frame(struct player *p, const struct stage *stage)
{
    p->failed = !frame_add(p, stage);
    if (p->failed)
        return false;
    const double now = terminal_clock();
    p->next = (p->next > now - p->delay ? p->next : now) + p->delay; /* after a slow frame, wait anew */
    screen_show(p);
    frames_play(p);
    return !p->has_ended;
}

bool player_end(struct player *p, struct problem *problem)
{
    const bool done = !p->failed && !dom_raised(p->interrupt);
    screen_end();
    if (done && p->count > 0)
        fputs(p->frame[p->at].text, p->out);
    for (size_t k = 0; k < p->count; k++)
        free(p->frame[k].text);
    const bool failed = p->failed;
    free(p->frame);
    free(p);
    return done || problem_error(problem, "%s", dom_status_text(failed ? DOM_NO_MEMORY : DOM_INTERRUPTED));
}
