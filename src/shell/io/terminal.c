/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/terminal.h"
#include <langinfo.h>
#include <locale.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

static const FILE *standard; /* see terminal_standard */

void terminal_standard(const FILE *stream)
{
    standard = stream;
}

/* Returns the descriptor of the terminal that shows the stream. If no terminal shows the stream, returns -1.
 * The results of isatty for the standard streams are cached. */
static int shown_on(FILE *stream)
{
    static atomic_schar known[STDERR_FILENO + 1]; /* 1: a terminal, -1: not a terminal, 0: not known yet */
    int file = fileno(stream == standard ? stdout : stream);
    if (file < 0 || file > STDERR_FILENO)
        return file >= 0 && isatty(file) ? file : -1;
    if (known[file] == 0)
        known[file] = isatty(file) ? 1 : -1;
    return known[file] > 0 ? file : -1;
}

bool terminal_shows(FILE *stream)
{
    return shown_on(stream) >= 0;
}

bool terminal_size(FILE *stream, int *width, int *height)
{
    struct winsize size = {0};
    int file = shown_on(stream);
    bool known = file >= 0 && ioctl(file, TIOCGWINSZ, &size) == 0;
    *width = size.ws_col;
    *height = size.ws_row;
    return known;
}

int terminal_width(FILE *stream)
{
    int width, height;
    return terminal_size(stream, &width, &height) ? width : 0;
}

bool terminal_utf8(void)
{
    static bool is_set; /* the locale is loaded only when it is needed, so that the program starts faster */
    if (!is_set)
        /* LC_NUMERIC must not be set, because it would change the decimal point of printf */
        setlocale(LC_CTYPE, "");
    is_set = true;
    return strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
}

/* Returns the number of terminal columns of the first `length` bytes of a UTF-8 text. */
static int utf8_width(const char *text, size_t length)
{
    int columns = 0;
    for (size_t i = 0; i < length; i++)
        columns += ((unsigned char)text[i] & 0xc0) != 0x80;
    return columns;
}

int utf8_columns(const char *text)
{
    return utf8_width(text, strlen(text));
}

/* ---- Lines ---- */

size_t line_break(const char *text, int columns)
{
    size_t n = strcspn(text, " \n");
    while (n > 1 && (utf8_width(text, n) > columns || ((unsigned char)text[n] & 0xc0) == 0x80))
        n--;
    for (size_t next = n; text[next] == ' ';) {
        next += 1 + strcspn(text + next + 1, " \n");
        if (utf8_width(text, next) > columns)
            break;
        if (text[next] != ' ' || (text[next - 1] != '=' && strncmp(text + next, " = ", 3) != 0))
            n = next;
    }
    return n;
}

void write_wrapped(FILE *out, const char *text, int left, int right)
{
    enum { BELOW = 4 };
    int longest = 0;
    text += strspn(text, " ");
    for (const char *word = text; *word && right; word += *word != '\0') {
        const size_t n = strcspn(word, " \n");
        const int columns = utf8_width(word, n);
        longest = columns > longest ? columns : longest;
        word += n;
    }
    /* If the longest word does not fit between `left` and `right`, the text begins on the next line, with
     * less indentation. */
    if (right && left > BELOW && left + longest > right) {
        left = BELOW;
        fprintf(out, "\n%*s", left, "");
    }
    while (*text) {
        size_t n = strlen(text);
        if (right) {
            size_t word = strcspn(text, " \n"), fitting = line_break(text, right - left);
            n = word > fitting ? word : fitting;
        }
        const char *end = text + n + strspn(text + n, " ");
        while (n > 0 && text[n - 1] == ' ')
            n--;
        fwrite(text, 1, n, out);
        bool is_broken = *end != '\0';
        text = end + (*end == '\n');
        if (is_broken)
            fprintf(out, "\n%*s", *text ? left : 0, "");
    }
}

/* ---- Time and progress ---- */

double terminal_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void (*progress_hook)(bool begins);

void progress_begin(void)
{
    if (progress_hook)
        progress_hook(true);
}

void progress_end(void)
{
    if (progress_hook)
        progress_hook(false);
}
