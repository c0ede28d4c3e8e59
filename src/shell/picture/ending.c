/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/ending.h"
#include <string.h>
#include <strings.h>

/* The font is what fontconfig or a browser takes for 'sans', which a bare Debian has; letters are large
 * enough to be read where a telephone shrinks the picture. */
#define SVG "svg size 720,540 dynamic font 'sans,17' background rgb 'white'"
#define PNG "pngcairo size 960,720 font 'sans,17'"
#define PDF "pdfcairo size 16cm,12cm font 'sans,11'"

#define ENDING_OF_FORMAT(name) {"." #name, ENDING_DATA, &format_##name, NULL},
static const struct ending endings[] = {
    FORMATS(ENDING_OF_FORMAT){".txt", ENDING_TEXT, NULL, NULL},
    {".svg", ENDING_PICTURE, NULL, SVG},
    {".png", ENDING_PICTURE, NULL, PNG},
    {".pdf", ENDING_PICTURE, NULL, PDF},
};

const struct ending *ending_of(const char *path)
{
    static const struct ending none = {.kind = ENDING_NONE}, other = {.kind = ENDING_OTHER};
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    if (!dot || dot == name || dot[1] == '\0') /* '.hidden' is a name */
        return &none;
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++)
        if (strcasecmp(endings[i].text, dot) == 0)
            return &endings[i];
    return &other;
}
