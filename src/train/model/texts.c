/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions that turn statuses and other enumerators into text. All precisions share them. */
#include "numerics/api.h"

const char *dom_version(void)
{
    return DOM_VERSION;
}

const char *dom_status_text(enum dom_status status)
{
    switch (status) {
#define TEXT(name, text)                                                                                     \
    case DOM_##name:                                                                                         \
        return text;
        DOM_STATUSES(TEXT)
#undef TEXT
    }
    return "unknown status";
}

static const char *text_at(const char *const *text, size_t count, size_t k)
{
    return k < count ? text[k] : "unknown";
}

#define TEXT_AT(text, k) text_at(text, sizeof(text) / sizeof *(text), (size_t)(k))

const char *dom_end_text(enum dom_end end)
{
    static const char *const text[] = {
        [DOM_END_NONE] = "none", [DOM_END_BARRIER] = "barrier", [DOM_END_REACH] = "reach"};
    return TEXT_AT(text, end);
}

const char *dom_event_text(enum dom_event_kind kind)
{
    static const char *const text[] = {[DOM_EVENT_LAUNCH] = "launch",
                                       [DOM_EVENT_DETACH] = "fall",
                                       [DOM_EVENT_TOP] = "top",
                                       [DOM_EVENT_STOP] = "stop",
                                       [DOM_EVENT_HIT] = "hit"};
    return TEXT_AT(text, kind);
}

const char *dom_row_end_text(enum dom_row_end end)
{
    static const char *const text[] = {
#define END_TEXT(name, text) [DOM_ROW_##name] = text,
        DOM_ROW_ENDS(END_TEXT)
#undef END_TEXT
    };
    return TEXT_AT(text, end);
}
