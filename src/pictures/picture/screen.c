/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "domino_common.h"
#include "io/io.h"
#include "io/terminal.h"
#include "pictures/picture/picture.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

static struct {
    FILE *out;
    int terminal;
    struct termios before, keys; /* the modes of the terminal */
    int escaped;                 /* how many bytes of an arrow key have been read */
} screen;

#define SCREEN_ENTER "\033[?1049h\033[?25l"
#define SCREEN_LEAVE "\033[?25h\033[?1049l"

FILE *screen_begin(FILE *out)
{
    /* Keys are read without blocking: ^C discards keys, and a read would then wait for the next one. */
    const int terminal =
        terminal_shows(out) ? open("/dev/tty", O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC) : -1;
    FILE *stream = terminal >= 0 ? fopen("/dev/tty", "we") : NULL;
    memset(&screen, 0, sizeof screen);
    if (!stream || tcgetpgrp(terminal) != getpgrp() || tcgetattr(terminal, &screen.before) != 0) {
        if (stream)
            fclose(stream);
        if (terminal >= 0)
            close(terminal);
        return NULL;
    }
    screen.out = stream;
    screen.terminal = terminal;
    screen.keys = screen.before;
    screen.keys.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
    screen.keys.c_cc[VMIN] = 1;
    screen.keys.c_cc[VTIME] = 0;
    screen.keys.c_cc[VSUSP] = _POSIX_VDISABLE; /* ^Z would leave the second screen on the terminal */
    progress_end();
    tcsetattr(terminal, TCSANOW, &screen.keys);
    fputs(SCREEN_ENTER, stream);
    fflush(stream);
    return stream;
}

void screen_end(void)
{
    fputs(SCREEN_LEAVE, screen.out);
    fflush(screen.out);
    tcsetattr(screen.terminal, TCSADRAIN, &screen.before);
    fclose(screen.out);
    close(screen.terminal);
}

/* Reads a byte of a key. An arrow is "ESC [ A" to "ESC [ D", with an 'O' instead of '[' on some terminals. */
static int byte_read(void)
{
    char key;
    const ssize_t n = read(screen.terminal, &key, 1);
    if (n != 1)
        return n < 0 && (errno == EAGAIN || errno == EINTR) ? KEY_NONE : KEY_END;
    const bool is_arrow = screen.escaped == 2 && key >= 'A' && key <= 'D',
               is_inside = screen.escaped == 1 && (key == '[' || key == 'O');
    screen.escaped = key == '\033' ? 1 : is_inside ? 2 : 0;
    return is_arrow                      ? KEY_UP + (key - 'A')
           : screen.escaped              ? KEY_NONE
           : key == 'q' || key == '\004' ? KEY_END
                                         : key;
}

int screen_key(double seconds)
{
    struct pollfd typed = {.fd = screen.terminal, .events = POLLIN};
    /* An interrupt can come just before poll, so poll does not wait for ever. */
    const int wait = seconds > 0.2 ? 200
                     : seconds > 0 ? (int)(1000 * seconds) + 1
                                   : 0,
              ready = poll(&typed, 1, wait);
    if (dom_raised(io_interrupt) || (ready < 0 && errno != EINTR) ||
        (ready > 0 && (typed.revents & (POLLHUP | POLLERR)) != 0))
        return KEY_END;
    return ready > 0 ? byte_read() : KEY_NONE;
}
