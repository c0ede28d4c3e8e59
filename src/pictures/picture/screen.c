/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "domino_common.h"
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
    struct termios before, keys;   /* the modes of the terminal */
    struct sigaction stop;         /* what ^Z did before */
    volatile sig_atomic_t is_back; /* the program has continued after ^Z */
    int escaped;                   /* how many bytes of an arrow key have been read */
} screen;

#define SCREEN_ENTER "\033[?1049h\033[?25l"
#define SCREEN_LEAVE "\033[?25h\033[?1049l"

/* ^Z stops the program at once, also while it computes. All functions that are called here may be called in a
 * signal handler. */
static void on_stop(int number)
{
    const int reason = errno;
    const struct sigaction action = {.sa_handler = SIG_DFL};
    struct sigaction ours;
    (void)!write(screen.terminal, SCREEN_LEAVE, strlen(SCREEN_LEAVE));
    tcsetattr(screen.terminal, TCSADRAIN, &screen.before);
    sigaction(number, &action, &ours);
    raise(number); /* the program stops here until SIGCONT */
    sigaction(number, &ours, NULL);
    tcsetattr(screen.terminal, TCSADRAIN, &screen.keys);
    (void)!write(screen.terminal, SCREEN_ENTER, strlen(SCREEN_ENTER));
    screen.is_back = 1;
    errno = reason;
}

FILE *screen_begin(FILE *out)
{
    /* With SA_NODEFER, the signal that stops the program is not blocked in the handler. */
    const struct sigaction action = {.sa_handler = on_stop, .sa_flags = SA_RESTART | SA_NODEFER};
    const int terminal = terminal_shows(out) ? open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC) : -1;
    FILE *stream = terminal >= 0 ? fdopen(terminal, "w") : NULL;
    memset(&screen, 0, sizeof screen);
    if (!stream || tcgetpgrp(terminal) != getpgrp() || tcgetattr(terminal, &screen.before) != 0) {
        if (stream)
            fclose(stream);
        return NULL;
    }
    screen.out = stream;
    screen.terminal = terminal;
    screen.keys = screen.before;
    screen.keys.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
    screen.keys.c_cc[VMIN] = 1;
    screen.keys.c_cc[VTIME] = 0;
    progress_end();
    sigaction(SIGTSTP, NULL, &screen.stop);
    if (screen.stop.sa_handler == SIG_DFL)
        sigaction(SIGTSTP, &action, NULL);
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
    sigaction(SIGTSTP, &screen.stop, NULL);
    fclose(screen.out);
}

/* Reads a byte of a key. An arrow is "ESC [ A" to "ESC [ D", with an 'O' instead of '[' on some terminals. */
static int byte_read(void)
{
    char key;
    if (read(screen.terminal, &key, 1) != 1)
        return KEY_END;
    const bool is_arrow = screen.escaped == 2 && key >= 'A' && key <= 'D',
               is_inside = screen.escaped == 1 && (key == '[' || key == 'O');
    screen.escaped = key == '\033' ? 1 : is_inside ? 2 : 0;
    return is_arrow                      ? KEY_UP + (key - 'A')
           : screen.escaped              ? KEY_NONE
           : key == 'q' || key == '\004' ? KEY_END
                                         : key;
}

int screen_key(double seconds, const volatile sig_atomic_t *interrupt)
{
    struct pollfd typed = {.fd = screen.terminal, .events = POLLIN};
    /* An interrupt can come just before poll, so poll does not wait for ever. */
    const int wait = seconds > 0.2 ? 200
                     : seconds > 0 ? (int)(1000 * seconds) + 1
                                   : 0,
              ready = poll(&typed, 1, wait);
    if (dom_raised(interrupt) || (ready < 0 && errno != EINTR) ||
        (ready > 0 && (typed.revents & (POLLHUP | POLLERR)) != 0))
        return KEY_END;
    if (screen.is_back) {
        screen.is_back = 0;
        return KEY_BACK;
    }
    return ready > 0 ? byte_read() : KEY_NONE;
}
