/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/preview.h"
#include "interpreter/question.h"
#include <stdlib.h>
#include <string.h>

/* Parses the command at the reader, and the '>' after it. */
static bool command_preview(struct reader *r)
{
    struct question question;
    problem_begin(r->problem, NULL);
    bool good = command_parse(r, &question);
    if (good && *r->at == '>') {
        r->at = skip_blanks(r->at + 1 + (r->at[1] == '>'));
        offer_kind(r, OFFER_FILE);
    }
    const char *end = r->text->line + strlen(r->text->line);
    return good || (question.command && r->problem->column >= text_column(r->text, end));
}

bool line_preview(struct session *session, const char *line, size_t length, const char *tail,
                  struct offer *offer)
{
    struct means means = session->means;
    struct query query = session_query(session);
    struct problem problem;
    struct text text;
    struct arena arena = {.block = NULL};
    char *whole = NULL;
    int size = asprintf(&whole, "%.*s%s", (int)length, line, tail);
    if (size < 0 || !text_make(&text, whole, (size_t)size)) {
        free(size < 0 ? NULL : whole);
        return false;
    }
    means.note = NULL;
    query.means = &means;
    struct reader r = {.query = &query,
                       .problem = &problem,
                       .text = &text,
                       .arena = &arena,
                       .evaluates = !offer,
                       .offer = offer};
    if (offer)
        offer->cursor = text.line + strlen(text.line) - 1;
    bool good = true;
    for (const char *begin = text.line, *end;; begin = end + 1) {
        r.at = begin = skip_blanks(begin);
        end = text_end(begin, ";");
        good = begin == end || command_preview(&r);
        arena_free(&arena);
        if (*end != ';')
            break;
    }
    text_free(&text);
    free(whole);
    return good;
}
