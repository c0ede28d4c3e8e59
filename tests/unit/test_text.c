/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ends of quotes, commands and comments in a line. */
#include "support.h"

#include "language/text.h"

TEST(quotes_end)
{
    static const struct {
        const char *text;
        int behind; /* -1 if the quote is never closed */
    } cases[] = {
        {"\"\"", 2}, {"\"a b\" c", 5}, {"\"a\"\"b\"", 6}, {"\"\"\"\"x", 4}, {"\"a;#>\";\"b", 6},
        {"\"", -1},  {"\"abc", -1},    {"\"abc\"\"", -1}, {"\"\"\"", -1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *behind = text_quote(cases[i].text);
        assert_int_equal(behind ? behind - cases[i].text : -1, cases[i].behind);
    }
}

TEST(commands_end)
{
    static const struct {
        const char *text, *ends;
        int at;
    } cases[] = {
        {"", ";", 0},
        {"rmax", ";", 4},
        {"rmax; best", ";", 4},
        {"rmax > f; best", ";", 8},
        {"rmax > f; best", ";>", 5},
        {"# all of it", ";", 0},
        {"rmax # why", ";", 5},
        {"rmax\t#", ";", 5},
        {"rmax#1", ";", 6}, /* not a comment */
        {"save \"a;b #c\"; x", ";", 13},
        {"save \"a\"\";b\"; x", ";", 12},
        {"save \"a\"#b; x", ";", 10}, /* not a comment either */
        {"save \"a; b # c", ";", 14}, /* never closed */
        {"print 5\";\" ; x", ";", 11},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_int_equal(text_end(cases[i].text, cases[i].ends) - cases[i].text, cases[i].at);
}
