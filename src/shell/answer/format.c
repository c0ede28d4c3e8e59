/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/format.h"
#include <string.h>
#include <strings.h>

#define FORMAT_POINTER(name) &format_##name,
const struct format *const formats[] = {FORMATS(FORMAT_POINTER)};

#define EXTENSION_OF_FORMAT(name) {.text = "." #name, .kind = EXTENSION_DATA, .format = &format_##name},
static const struct extension extensions[] = {
    FORMATS(EXTENSION_OF_FORMAT){.text = ".txt", .kind = EXTENSION_TEXT},
    {.text = ".svg", .kind = EXTENSION_SHEET, .terminal = "svg"},
    {.text = ".png", .kind = EXTENSION_SHEET, .terminal = "pngcairo"},
    {.text = ".pdf", .kind = EXTENSION_SHEET, .terminal = "pdfcairo"},
    {.text = ".gp", .kind = EXTENSION_SHEET, .terminal = "pdfcairo", .is_script = true},
    {.text = ".gif", .kind = EXTENSION_FILM},
};

const struct extension *extension_of(const char *path)
{
    static const struct extension none = {.kind = EXTENSION_NONE}, other = {.kind = EXTENSION_OTHER};
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    if (!dot || dot == name || dot[1] == '\0') /* '.hidden' has no extension */
        return &none;
    for (size_t i = 0; i < sizeof extensions / sizeof *extensions; i++)
        if (strcasecmp(extensions[i].text, dot) == 0)
            return &extensions[i];
    return &other;
}
