/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions that turn statuses and other enumerators into text. All precisions share them. */
#include "numerics/api.h"

const char *dom_version(void)
{
    return DOM_VERSION;
}

/* A number that is not in the enumeration may be negative. */
#define TEXT_AT(text, k) ((size_t)(k) < sizeof(text) / sizeof *(text) ? (text)[k] : "unknown")
#define TEXT(name, text) (text),

const char *dom_status_text(enum dom_status status)
{
    static const char *const text[] = {DOM_STATUSES(TEXT)};
    return TEXT_AT(text, status);
}

const char *dom_row_end_text(enum dom_row_end end)
{
    static const char *const text[] = {DOM_ROW_ENDS(TEXT)};
    return TEXT_AT(text, end);
}

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
