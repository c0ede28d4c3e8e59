/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/picture/play.h"
#include "answer/extension.h"
#include "io/io.h"
#include "io/terminal.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

struct frame {
    char *text;
    size_t size;
};

struct player {
    FILE *out, *screen; /* the stream of the answer, and the terminal itself */
    int terminal;
    struct termios before, playing; /* the modes of the terminal */
    struct sigaction stop;          /* what ^Z did before */
    volatile sig_atomic_t is_back;  /* ^Z has stopped the program, and it goes on */
    double delay, next;             /* in s: the time between two frames, and when the next frame is due */
    const volatile sig_atomic_t *interrupt;
    struct frame *frame; /* all frames so far */
    size_t count, room, at;
    int escaped; /* how many bytes of an arrow key have been read */
    bool is_stopped, has_ended, failed;
};

/* A second screen, without a cursor. */
#define SCREEN_ENTER "\033[?1049h\033[?25l"
#define SCREEN_LEAVE "\033[?25h\033[?1049l"

static struct player *playing; /* for the signal handler */

/* ^Z stops the program at once, also while a frame is being made. The shell gets the terminal as it was
 * before the animation. All functions that are called here may be called in a signal handler. */
static void on_stop(int number)
{
    const int reason = errno;
    const struct sigaction action = {.sa_handler = SIG_DFL};
    struct sigaction ours;
    (void)!write(playing->terminal, SCREEN_LEAVE, strlen(SCREEN_LEAVE));
    tcsetattr(playing->terminal, TCSADRAIN, &playing->before);
    sigaction(number, &action, &ours);
    raise(number); /* the program stops here until SIGCONT */
    sigaction(number, &ours, NULL);
    tcsetattr(playing->terminal, TCSADRAIN, &playing->playing);
    (void)!write(playing->terminal, SCREEN_ENTER, strlen(SCREEN_ENTER));
    playing->is_back = 1;
    errno = reason;
}

/* Shows the second screen, where keys are read one by one and are not echoed. */
static void screen_begin(struct player *p)
{
    /* With SA_NODEFER, the signal that stops the program is not blocked in the handler. */
    const struct sigaction action = {.sa_handler = on_stop, .sa_flags = SA_RESTART | SA_NODEFER};
    p->playing = p->before;
    p->playing.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
    p->playing.c_cc[VMIN] = 1;
    p->playing.c_cc[VTIME] = 0;
    playing = p;
    sigaction(SIGTSTP, NULL, &p->stop);
    if (p->stop.sa_handler == SIG_DFL)
        sigaction(SIGTSTP, &action, NULL);
    tcsetattr(p->terminal, TCSANOW, &p->playing);
    fputs(SCREEN_ENTER, p->screen);
    fflush(p->screen);
}

static void screen_end(struct player *p)
{
    fputs(SCREEN_LEAVE, p->screen);
    fflush(p->screen);
    tcsetattr(p->terminal, TCSADRAIN, &p->before);
    sigaction(SIGTSTP, &p->stop, NULL);
    fclose(p->screen);
}

struct player *player_begin(FILE *out, int delay, const volatile sig_atomic_t *interrupt,
                            struct problem *problem)
{
    const int terminal = terminal_shows(out) ? open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC) : -1;
    struct player *p = calloc(1, sizeof *p);
    FILE *screen = terminal >= 0 ? fdopen(terminal, "w") : NULL;
    if (!p || !screen || tcgetpgrp(terminal) != getpgrp() || tcgetattr(terminal, &p->before) != 0) {
        if (screen)
            fclose(screen);
        free(p);
        problem_error(problem,
                      "an animation can be shown only on a terminal; enter 'animate > film.gif' for a "
                      "file");
        return NULL;
    }
    *p = (struct player){.out = out,
                         .screen = screen,
                         .terminal = terminal,
                         .before = p->before,
                         .delay = delay / 100.0,
                         .interrupt = interrupt};
    progress_end();
    screen_begin(p);
    p->next = terminal_clock();
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
            p->is_stopped ? "(stopped: space goes on, arrows go frame by frame, q ends)"
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

/* Reads a byte of a key. Returns true if the next frame must be made. */
static bool key_read(struct player *p)
{
    char key;
    if (read(p->terminal, &key, 1) != 1)
        return false;
    /* An arrow is "ESC [ C", or "ESC O C" on some terminals. */
    const bool is_arrow = p->escaped == 2 && (key == 'C' || key == 'D');
    const bool is_inside = p->escaped == 1 && (key == '[' || key == 'O');
    p->escaped = key == '\033' ? 1 : is_inside ? 2 : 0;
    if (is_arrow)
        return frame_move(p, key == 'C');
    p->has_ended = key == 'q' || key == '\004';
    if (key != ' ')
        return p->has_ended;
    p->is_stopped = !p->is_stopped;
    p->next = terminal_clock();
    screen_show(p);
    return !p->is_stopped && p->at + 1 == p->count;
}

/* Waits for the time of the next frame, and handles keys. Returns when the next frame must be made. */
static void frames_play(struct player *p)
{
    for (;;) {
        const double left = p->next - terminal_clock();
        struct pollfd typed = {.fd = p->terminal, .events = POLLIN};
        /* An interrupt can come just before poll, so poll does not wait for ever. */
        const int wait = p->is_stopped || left > 0.2 ? 200 : left > 0 ? (int)(1000 * left) + 1 : 0;
        const int ready = poll(&typed, 1, wait);
        p->has_ended = p->has_ended || dom_raised(p->interrupt) || (ready < 0 && errno != EINTR) ||
                       (ready > 0 && (typed.revents & (POLLHUP | POLLERR)) != 0);
        if (p->has_ended || (ready > 0 && key_read(p)))
            return;
        if (p->is_back) {
            p->is_back = 0;
            p->next = terminal_clock() + p->delay;
            screen_show(p);
        }
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
    p->next = (p->next > now - p->delay ? p->next : now) + p->delay; /* after a slow frame, a new start */
    screen_show(p);
    frames_play(p);
    return !p->has_ended;
}

bool player_end(struct player *p, struct problem *problem)
{
    const bool done = !p->failed && !dom_raised(p->interrupt);
    screen_end(p);
    if (done && p->count > 0)
        fputs(p->frame[p->at].text, p->out);
    for (size_t k = 0; k < p->count; k++)
        free(p->frame[k].text);
    const bool failed = p->failed;
    free(p->frame);
    free(p);
    return done || problem_error(problem, "%s", dom_status_text(failed ? DOM_NO_MEMORY : DOM_INTERRUPTED));
}
