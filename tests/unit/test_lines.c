/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: whole */
/* Fast paths for reading and writing lines. Each must give the same result as the general path, or as the C
 * library. */
#include "support.h"

#include "answer/answer.h"
#include "interpreter/question.h"
#include "io/escape.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "language/text.h"
#include "session/parameters.h"
#include "session/session.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Returns a pseudo-random number, from a sequence that is the same in every run. */
static unsigned bits(unsigned most)
{
    static unsigned long state = 1;
    state = state * 6364136223846793005UL + 1442695040888963407UL;
    return (unsigned)(state >> 40) % most;
}

#if defined DOMQ_REAL_FLOAT128
extern domq_real strtof128(const char *restrict text, char **restrict end);
#define PLAIN_READ strtof128
#else
#define PLAIN_READ strtold
#endif

TEST(numbers_read_as_by_the_c_library)
{
    static const char letters[] = "0123456789012345678901234567890123456789..eE+-x_m ";
    int equal = 0;
    for (int k = 0; k < 200000; k++) {
        char text[24], *stop, *plain;
        size_t n = 1 + bits(20);
        for (size_t i = 0; i < n; i++)
            text[i] = letters[bits(i < 2 || k % 2 ? sizeof letters - 1 : 42)];
        text[n] = '\0';
        domq_real value = quad_read(text, &stop), known = PLAIN_READ(text, &plain);
        if (stop != plain || !(value == known))
            fail_msg("'%s': read up to %d, not %d", text, (int)(stop - text), (int)(plain - text));
        equal += plain > text && known != 0;
    }
    assert_true(equal > 100000);
}

/* Checks that a text of ASCII characters has the same columns as after a Greek letter, which makes it take
 * the general path. */
TEST(a_line_in_ascii_has_the_columns_of_its_letters)
{
    static const char typed[] = "rmax 0.4; print theta # and so on, until this line is longer than a short "
                                "one: rmax 0.4; rmax 0.4; rmax 0.4; rmax 0.4; rmax 0.4; rmax 0.4; rmax";
    for (size_t n = 0; n < sizeof typed; n++) {
        char greek[sizeof typed + 2];
        struct text text, wide;
        int length = snprintf(greek, sizeof greek, "π%.*s", (int)n, typed);
        assert_true(text_make(&text, typed, n));
        assert_true(text_make(&wide, greek, (size_t)length));
        assert_string_equal(text.line, wide.line + 2);
        for (size_t k = 0; k <= n; k++) {
            assert_int_equal(text_column(&text, text.line + k) + 1, text_column(&wide, wide.line + 2 + k));
            assert_ptr_equal(text_typed(&text, text.line + k), typed + k);
            assert_ptr_equal(text_typed(&wide, wide.line + 2 + k), greek + 2 + k);
        }
        text_free(&text);
        text_free(&wide);
    }
}

/* Returns the output of write_wrapped, which the caller frees. */
static char *wrapped(const char *text, int right)
{
    char *written = NULL;
    size_t size;
    FILE *out = open_memstream(&written, &size);
    assert_non_null(out);
    write_wrapped(out, text, 2, right);
    fclose(out);
    return written;
}

TEST(a_text_without_a_right_end_is_one_line)
{
    for (int k = 0; k < 20000; k++) {
        char text[16], wide[16 * ESCAPE_PIECE], cut[12];
        size_t n = bits(sizeof text);
        for (size_t i = 0; i < n; i++)
            text[i] = " a b\tc"[bits(6)];
        text[n] = '\0';
        char *one = wrapped(text, 0), *far = wrapped(text, 1000);
        assert_string_equal(one, far);
        free(one);
        free(far);
        /* A text that fits is not truncated. */
        escape_text(text, wide, sizeof wide);
        const char *shown = escape_text(text, cut, sizeof cut);
        if (strlen(wide) < sizeof cut)
            assert_string_equal(shown, wide);
        else
            assert_true(strlen(shown) < sizeof cut && strcmp(shown + strlen(shown) - 3, "...") == 0 &&
                        strncmp(shown, wide, strlen(shown) - 3) == 0);
    }
}

/* Finds the end letter by letter, following the definition. */
static const char *end_of(const char *c, const char *ends)
{
    for (bool blank = true, quoted = false; *c; c++) {
        if (!quoted && (strchr(ends, *c) || (*c == '#' && blank)))
            return c;
        blank = isspace((unsigned char)*c);
        quoted = *c == '"' ? !quoted : quoted;
    }
    return c;
}

TEST(a_command_ends_where_its_letters_say)
{
    int inside = 0;
    for (int k = 0; k < 200000; k++) {
        char text[16];
        size_t n = bits(sizeof text);
        for (size_t i = 0; i < n; i++)
            text[i] = "a #;\"\t"[bits(6)];
        text[n] = '\0';
        assert_ptr_equal(text_end(text, ";"), end_of(text, ";"));
        assert_ptr_equal(text_end(text, ""), end_of(text, ""));
        inside += *text_end(text, ";") == '#';
    }
    assert_true(inside > 10000);
}

/* Reads the command at the beginning of a line. *at receives the position of its arguments, or -1 after an
 * error. */
static const struct command *command_of(struct session *session, const char *line, int *at, int *column)
{
    struct text text;
    struct problem problem = {.kind = PROBLEM_NONE};
    const struct query query = session_query(session);
    struct arena arena = {.block = NULL};
    assert_true(text_make(&text, line, strlen(line)));
    struct reader r = {.query = &query, .problem = &problem, .text = &text, .at = text.line, .arena = &arena};
    const struct command *c = command_read(&r);
    *column = problem.place;
    *at = problem.kind == PROBLEM_NONE ? (int)(r.at - text.line) : -1;
    text_free(&text);
    arena_free(&arena);
    return c;
}

/* Checks that a name, a blank and a digit always begin a command, so that the name alone decides. */
TEST(a_command_before_a_number_is_that_command)
{
    static const char *const more[] = {"ans", "ans2", "_", "__", "x", "pi", "sin", "m", "prin", "to", "let"};
    static struct session session;
    FILE *null = fopen("/dev/null", "w");
    int commands = 0;
    assert_non_null(null);
    features_register(every_feature);
    session_init(&session, null);
    for (int k = 0, n = 0; n < (int)(sizeof more / sizeof *more); k++) {
        char number[64], value[64];
        int at, value_at, column, value_column;
        const char *name = topic_names(NULL, k);
        if (!name)
            name = more[n++];
        snprintf(number, sizeof number, "%s 2", name);
        snprintf(value, sizeof value, "%s .2", name); /* a '.' takes the general path */
        const struct command *c = command_of(&session, number, &at, &column);
        assert_ptr_equal(c, command_of(&session, value, &value_at, &value_column));
        assert_int_equal(at, value_at);
        if (c)
            assert_int_equal(column, value_column);
        commands += c && at == (int)strlen(name);
    }
    assert_true(commands > 50);
    session_close(&session);
    fclose(null);
}
