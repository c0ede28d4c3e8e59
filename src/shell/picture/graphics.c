/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/graphics.h"
#include "io/io.h"
#include "io/terminal.h"
#include "picture/canvas.h"
#include "picture/stage.h"
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

/* ---- Which terminal it is ---- */

/* Reads the terminal's reply, up to the 'c' that ends it. */
static void answer_read(int terminal, char *answer, size_t size)
{
    enum { WAIT = 1000 /* time limit for a character in ms, long enough even for a slow connection */ };
    size_t n = 0;
    struct pollfd ready = {.fd = terminal, .events = POLLIN};
    while (n + 1 < size && poll(&ready, 1, WAIT) > 0 && read(terminal, answer + n, 1) == 1) {
        answer[++n] = '\0';
        if (answer[n - 1] == 'c')
            return;
    }
}

/* Returns true if a reply such as "ESC [ ? 62 ; 4 ; 22 c" contains the attribute 4, sixel. */
static bool has_sixel(const char *answer)
{
    const char *at = strstr(answer, "[?");
    for (at = at ? at + 1 : NULL; at && *at && *at != 'c'; at = strpbrk(at, ";c")) {
        char *end;
        if (strtol(++at, &end, 10) == 4 && (*end == ';' || *end == 'c'))
            return true;
    }
    return false;
}

/* Asks the terminal for its attributes (DA1). Returns true if it can show sixel. */
static bool ask_sixel(void)
{
    char answer[64] = "";
    struct termios before, quiet;
    int terminal = open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC);
    struct pollfd typed = {.fd = terminal, .events = POLLIN};
    bool can_ask = terminal >= 0 && tcgetpgrp(terminal) == getpgrp() && tcgetattr(terminal, &before) == 0;
    if (can_ask) {
        quiet = before;
        quiet.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
        quiet.c_cc[VMIN] = 1;
        quiet.c_cc[VTIME] = 0;
        tcsetattr(terminal, TCSANOW, &quiet);
        /* If the user has already typed something, do not ask: these characters would be lost. */
        if (poll(&typed, 1, 0) == 0 && write(terminal, "\033[c", 3) == 3)
            answer_read(terminal, answer, sizeof answer);
        tcsetattr(terminal, TCSANOW, &before);
    }
    if (terminal >= 0)
        close(terminal);
    return has_sixel(answer);
}

enum graphics graphics_of(FILE *stream)
{
    static const char *const kitty[] = {"xterm-kitty", "xterm-ghostty", NULL};
    /* Multiplexers. They may pass sixel images on to the terminal, but not the images of kitty's protocol. */
    static const char *const inside[] = {"tmux", "screen", NULL};
    static const char *const candidates[] = {"xterm", "foot",   "mlterm", "wezterm", "contour",
                                             "tmux",  "screen", "yaft",   NULL};
    static int sixel = -1; /* -1 until the terminal has been asked, which happens only once */
    const char *wanted = getenv("DOMINO_GRAPHICS");
    if (!terminal_colour(stream))
        return GRAPHICS_NONE;
    if (wanted && *wanted)
        return strcmp(wanted, "kitty") == 0   ? GRAPHICS_KITTY
               : strcmp(wanted, "sixel") == 0 ? GRAPHICS_SIXEL
                                              : GRAPHICS_NONE;
    if (term_begins(kitty) || (getenv("KITTY_WINDOW_ID") && !term_begins(inside)))
        return GRAPHICS_KITTY;
    if (sixel < 0)
        sixel = term_begins(candidates) && ask_sixel();
    return sixel ? GRAPHICS_SIXEL : GRAPHICS_NONE;
}

/* ---- The picture ---- */

void graphics_size(FILE *stream, int *width, int *height)
{
    struct winsize size = {0};
    int columns, rows;
    terminal_size(stream, &columns, &rows);
    (void)ioctl(fileno(stream), TIOCGWINSZ, &size);
    int wide = size.ws_xpixel ? size.ws_xpixel : 10 * columns,
        tall = size.ws_ypixel ? size.ws_ypixel : 20 * rows;
    *width = wide > 1200 ? 1200 : wide < 320 ? 320 : wide;
    *height = rows > 4 ? tall * (rows - 3) / rows : tall;
    *height = *height > 2 * *width / 3 ? 2 * *width / 3 : *height < 200 ? 200 : *height;
}

void graphics_terminal(FILE *stream, int width, int height, bool stage, char *terminal, size_t size)
{
    /* The text of a stage is scaled with the picture. The text of a chart has its normal size, but is smaller
     * in a small picture, so that there is room for the curves. */
    double scale = stage ? 0.72 * width / SHEET_WIDTH : fmin(fmin(width / 660.0, height / 440.0), 1);
    snprintf(terminal, size, "%s size %d,%d font 'sans,%d' fontscale %.3g",
             graphics_of(stream) == GRAPHICS_KITTY ? "pngcairo" : "sixelgd truecolor", width, height,
             stage ? 14 : 13, scale);
}

/* Sends a PNG file to the terminal by kitty's graphics protocol, which requires base64 in chunks of at most
 * 4096 characters. */
static bool kitty_write(FILE *png, FILE *out)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    enum { PIECE = 3072 };
    unsigned char bytes[PIECE + 2];
    size_t n, next;
    rewind(png);
    n = fread(bytes, 1, PIECE, png);
    for (bool first = true; n > 0; first = false, n = next) {
        unsigned char now[PIECE + 2] = {0};
        memcpy(now, bytes, n);
        next = fread(bytes, 1, PIECE, png);
        fprintf(out, first ? "\033_Gf=100,a=T,q=2,m=%d;" : "\033_Gm=%d;", next > 0);
        for (size_t i = 0; i < n; i += 3) {
            unsigned three = (unsigned)now[i] << 16 | (unsigned)now[i + 1] << 8 | now[i + 2];
            for (size_t k = 0; k < 4; k++)
                putc(i + k > n ? '=' : digits[three >> (18 - 6 * k) & 63], out);
        }
        fputs("\033\\", out);
    }
    putc('\n', out);
    return !ferror(png);
}

bool graphics_write(FILE *drawing, FILE *out)
{
    if (graphics_of(out) == GRAPHICS_KITTY)
        return kitty_write(drawing, out);
    io_copy(drawing, out);
    putc('\n', out);
    return !ferror(drawing);
}
