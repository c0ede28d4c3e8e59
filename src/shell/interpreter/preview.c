/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf */
#include "interpreter/preview.h"
#include "interpreter/question.h"
#include <stdlib.h>
#include <string.h>

static enum preview command_preview(struct reader *r)
{
    struct question question;
    problem_begin(r->problem, NULL);
    const char *end = r->text->line + strlen(r->text->line);
    if (!command_parse(r, &question))
        return question.command && r->problem->column >= text_column(r->text, end) ? PREVIEW_OPEN
                                                                                   : PREVIEW_WRONG;
    if (*r->at == '>') {
        r->at = skip_blanks(r->at + 1 + (r->at[1] == '>'));
        offer_kind(r, OFFER_FILE);
    }
    return PREVIEW_WHOLE;
}

enum preview line_preview(struct session *session, const char *line, size_t length, const char *tail,
                          struct offer *offer)
{
    struct run_context run_context = session->run_context;
    struct query query = session_query(session);
    struct problem problem;
    struct text text;
    struct arena arena = {.block = NULL};
    char *whole = NULL;
    int size = asprintf(&whole, "%.*s%s", (int)length, line, tail);
    if (size < 0 || !text_make(&text, whole, (size_t)size)) {
        free(size < 0 ? NULL : whole);
        return PREVIEW_WRONG;
    }
    run_context.note = NULL;
    query.run_context = &run_context;
    struct reader r = {.query = &query,
                       .problem = &problem,
                       .text = &text,
                       .arena = &arena,
                       .evaluates = !offer,
                       .offer = offer};
    if (offer)
        offer->cursor = text.line + strlen(text.line) - 1;
    enum preview preview = PREVIEW_WHOLE;
    for (const char *begin = text.line, *end;; begin = end + 1) {
        r.at = begin = skip_blanks(begin);
        end = text_end(begin, ";");
        preview = begin == end ? PREVIEW_WHOLE : command_preview(&r);
        arena_free(&arena);
        if (*end != ';')
            break;
    }
    text_free(&text);
    free(whole);
    return preview;
}
