/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Feeds arbitrary bytes to the reader of csv files. Some bytes stand for long texts, which bring headers,
 * rows and lines to their limits. */
#include "io/io.h"
#include "rows/rows.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Writes the text for which a byte stands. */
static void byte_write(FILE *out, uint8_t byte)
{
    static const struct {
        const char *text;
        int times;
    } texts[] = {
        {"height (mm),thickness (mm),gap (mm)", 1},
        {"height;thickness;gap\nmm;mm;mm\n", 1},
        {"\n48,7.5,20", 1},
        {"\n48,5;7,5;20", 1},
        {",x", CSV_CELLS_MOST - 3},
        {";1", CSV_CELLS_MOST - 4},
        {"y", 65000},
        {"", 0},
    };
    if (byte < sizeof texts / sizeof *texts)
        for (int i = 0; i < texts[byte].times; i++)
            fputs(texts[byte].text, out);
    else
        putc(byte == 0xff ? '\0' : byte, out);
}

/* Reads a row. Returns NULL if the row is rejected. Aborts if there is no message that says why. */
static struct row_file *row_read(const char *text, size_t size)
{
    FILE *in = fmemopen((void *)(uintptr_t)text, size, "r");
    struct csv_table *csv = in ? csv_open(in, NULL, &rowfile_kind) : NULL;
    if (!csv)
        abort();
    struct row_file *row = *csv->file.problem.text ? NULL : rowfile_read(csv, 0);
    if ((row != NULL) == (*csv->file.problem.text != '\0') ||
        (!row && (csv->file.problem.at.line < 1 || csv->file.problem.at.column < 1)))
        abort();
    csv_close(csv);
    fclose(in);
    return row;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    for (size_t i = 0; i < size && ftell(out) < 1 << 20; i++)
        byte_write(out, data[i]);
    fclose(out);
    struct row_file *row = length > 0 ? row_read(text, length) : NULL;
    for (size_t k = 0; row && k < row->count; k++)
        if (!(row->domino[k].height > 0 && row->domino[k].thickness > 0 && row->domino[k].gap >= 0 &&
              row->domino[k].mass > 0))
            abort();
    rowfile_drop(row);
    free(text);
    return 0;
}
