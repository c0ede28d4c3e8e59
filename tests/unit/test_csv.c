/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: tables */
/* The reader of csv files: separators, quotes, line ends, units, decimal marks, limits, and errors. */
#include "suite.h"

#include "tables/csv.h"
#include <math.h>
#include <string.h>

#define LENGTH "m", "m, mm", "mm", "write a length"

static const struct csv_column columns[] = {
    {"size", CSV_REQUIRED, LENGTH, CSV_ABOVE_0, 1000, "up to 1000 m"},
    {"gap", CSV_REQUIRED | CSV_NOT_FIRST, LENGTH, 0, 1000, "up to 1000 m"},
    {"count", CSV_EMPTY | CSV_WHOLE, "", "none", "", "write a number", 1, 9, "1 .. 9"},
};
static const struct csv_kind kind = {columns, 3, 3, "size, gap", NULL};

/* Writes the table: all rows as "size gap count others; ...", and then the error, if there is one, as
 * "line:column: ...". */
static void rows_show(const char *text, size_t length, const struct csv_kind *of, char *shown, size_t size)
{
    FILE *in = fmemopen((void *)(uintptr_t)text, length, "r"), *out = fmemopen(shown, size, "w");
    assert_non_null(in);
    assert_non_null(out);
    struct csv_table *csv = csv_open(in, NULL, of);
    assert_non_null(csv);
    while (!*csv->file.problem.text && csv_next(csv)) {
        for (int k = 0; k < 3; k++)
            fprintf(out, isnan(csv->value[k]) ? "- " : "%.10g ", (double)csv->value[k]);
        for (int i = 0; i < csv->head.cells; i++)
            if (csv->of[i] < 0) {
                const char *cell = i < csv->row.cells ? csv->row.cell[i].text : "",
                           *quote = strpbrk(cell, ",;\t\"\n#") ? "\"" : "";
                fprintf(out, ",%s", quote);
                for (; *cell; cell++)
                    fputs(*cell == '"' ? "\"\"" : (char[]){*cell, '\0'}, out);
                fputs(quote, out);
            }
        fputs("; ", out);
    }
    if (*csv->file.problem.text)
        fprintf(out, "%ld:%d: %s", csv->file.problem.at.line, csv->file.problem.at.column,
                csv->file.problem.text);
    csv_close(csv);
    fclose(in);
    fclose(out);
}

struct reading {
    const char *text, *shown; /* `shown` is the beginning of the expected output of rows_show */
};

static void rows_check(const struct reading *cases, size_t count, const struct csv_kind *of)
{
    for (size_t i = 0; i < count; i++) {
        char shown[2048] = "";
        rows_show(cases[i].text, strlen(cases[i].text), of, shown, sizeof shown);
        if (strncmp(shown, cases[i].shown, strlen(cases[i].shown)) != 0)
            fail_msg("%s\nexpected: %s\nobtained: %s", cases[i].text, cases[i].shown, shown);
    }
}
#define CHECK(cases, of) rows_check(cases, sizeof cases / sizeof *cases, of)

/* Checks two rows in the many forms in which people and spreadsheets write them. */
TEST(one_table)
{
    static const char *const texts[] = {
        "size (mm),gap (mm),count,word\n1500,,2,a\n2,0.25,,b\n",
        "size (mm), gap (mm), count, word\r\n1500, -, 2, a\r\n2, .25, -, b",
        "size (mm)\tgap (mm)\tcount\tword\r1500\t\t2\ta\r2\t0.25\t\tb\r",
        "size (mm),\tgap (mm),\tcount,\tword\n1500,\t-,\t2,\ta\n2,\t0.25,\t,\tb\n",
        "\xef\xbb\xbfsep=;\r\n\"size, mm\";\"gap, mm\";count;word\r\n1500;-;2;a\r\n2;0,25;;b;;;\r\n",
        "\"sep=\t\"\nsize, mm\tgap, mm\tcount\tword\n1500\t\t2\ta\n2\t0,25\t\tb\n",
        "size in mm\tgap mm\tcount\tword\n1500\t\u2013\t2\ta\n2\t0,25\t\tb\n",
        "# a comment\n\n ,,, \nSIZE [mm],Gap_mm,Count,Word\n1500,,2,a\n# \"\n\n,,,\n2,\"0.25\",,b\n",
        "\"size\n(m)\",Abstand,count,word\n1.5 m,,6/3,a\n2 mm,\"hypot(0.2 mm, 0.15 mm)\",,b\n",
        "Size (mm);\u00c9cart mm;count;word\n1500;;2;a\n2;hypot(0,0.25);;b\n",
        "word,count,gap (mm),size (mm)\na,2,,1500\n\"b\" ,,0.25,2",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        const struct reading one = {texts[i], "1.5 - 2 ,a; 0.002 0.00025 - ,b; "};
        rows_check(&one, 1, &kind);
        char shown[256] = "";
        rows_show(texts[i], strlen(texts[i]), &kind, shown, sizeof shown);
        assert_string_equal(shown, one.shown);
    }
}

TEST(quotes)
{
#define HEAD "size (m),gap (m),note\n"
    static const struct reading cases[] = {
        {HEAD "1,,\"a \"\"b\"\", c\"", "1 - - ,\"a \"\"b\"\", c\"; "},
        {HEAD "1,,\"a\nb\"\n2,3,5\" wide\n2,x", "1 - - ,\"a\nb\"; 2 3 - ,\"5\"\" wide\"; 5:3: gap at 'x'"},
        {HEAD "1,,\"a\r\nb\rc\"", "1 - - ,\"a\nb\nc\"; "},
        {HEAD "1,,\" # no comment \"", "1 - - ,\"# no comment\"; "},
        {HEAD "1,,C# is no comment", "1 - - ,\"C# is no comment\"; "},
        {HEAD "1,,RAL #7", "1 - - ,\"RAL #7\"; "},
        {HEAD " # a comment\n1,,#7", "1 - - ,\"#7\"; "},
        {"#,size (m),gap (m)\n1,2,3\n#2,3,\n", "2 3 - ,1; "},
        {HEAD "1,,\"é\"\"\",é,x", "2:10: too many cells: 5"},
        {HEAD "1,,\"\"", "1 - - ,; "},
        {HEAD "1,,\"a\n\nb", "2:4: this '\"' is never closed"},
        {HEAD "1,,\"a\"b", "2:7: a ',' is missing after the closing '\"'"},
        {HEAD "1,\"2\"\"\",", "2:5: unexpected '\"' after the value of gap"},
    };
    CHECK(cases, &kind);
}

TEST(decimal_marks)
{
#define SEMICOLONS "size (m);gap (m);count\n"
#define TABS       "size (m)\tgap (m)\tcount\n"
    static const struct reading cases[] = {
        {SEMICOLONS "1,234;;\n1,5;2;", "1.234 - - ; 1.5 2 - ; "},
        {SEMICOLONS "1.234;;\n1.5;0.125;", "1.234 - - ; 1.5 0.125 - ; "},
        {SEMICOLONS "1,5;;\n2.5;0;",
         "1.5 - - ; 3:1: this number has a decimal point, but a number above has a comma"},
        {SEMICOLONS "1.5;;\n2;0,125;", "1.5 - - ; 3:3: this number has a decimal comma"},
        {SEMICOLONS "1.234,5;;", "2:1: this number has a decimal comma"},
        {SEMICOLONS "1,234,567;;", "2:6: unexpected '.567' after the value of size"},
        {SEMICOLONS "48,;;", "2:3: unexpected ',' after the value of size"},
        {TABS "1,234\t\t\n1,5\t,5\t", "1.234 - - ; 1.5 0.5 - ; "},
        {TABS "2,5e2\t\t\n1,234 mm\t0\t", "250 - - ; 0.001234 0 - ; "},
        {TABS "hypot(0.3,0,4)\t\t\n", "2:1: size at 'hypot"},
        {HEAD "\"1,5\",,", "2:3: unexpected ',5' after the value of size"},
        {HEAD "\"max(1.500,2)\",,", "2 - - ,; "},
        {HEAD "1,,x\n48,5,7,x",
         "1 - - ,x; 3:8: too many cells: 4, but the first line has 3; the separator is ','"},
    };
    CHECK(cases, &kind);
}

TEST(units)
{
    static const struct reading cases[] = {
        {"size,gap\n1,2", "2:1: size has no unit: '1' would mean 1 m; write 'size (mm)' in the first line"},
        {"size,gap\n1 mm,0", "0.001 0 - ; "},
        {"size (g),gap\n", "1:1: '(g)' is not a unit of size; its units are: m, mm"},
        {"size (mm,gap\n1,2 m", "0.001 2 - ; "},
        {"size,gap,count (m)", "1:10: '(m)' is not a unit of count; its units are: none"},
        {"size,gap\nmm,mm\n", "2:1: size at 'mm'"},
        {"size (m),gap (m)\n50 %,0", "2:1: size: this is a percentage; write a length"},
        {"size (m),gap (m)\n1 g,0", "2:1: size: this is a mass; write a length"},
        {"size (m),gap (m)\nh,0", "2:1: size at 'h': 'h' has no value in a csv file; write a length"},
    };
    CHECK(cases, &kind);
}

TEST(names)
{
    static const struct reading cases[] = {
        {"", "1:1: the file has no rows; its first line must name size, gap"},
        {"# only\n\n", "3:1: the file has no rows"},
        {"size (m),gap (m)\n", "2:1: the file has no rows"},
        {"size", "1:1: the column 'gap' is missing; the first line must name size, gap, separated by"},
        {"siz,gap", "1:1: unknown column 'siz'; did you mean 'size'?"},
        {"size,gap,é,coun", "1:12: unknown column 'coun'; did you mean 'count'?"},
        {"size,other", "1:1: the column 'gap' is missing; the first line must name size, gap"},
        {"size,gap,spacing",
         "1:10: column name 'spacing' stands for the gap, but so does column 2; rename one of the two"},
        {"1,2", "1:1: the first line has a number, but must name size, gap, with their units"},
        {"size m,gap m,count\n1,2,0", "2:5: count = 0 is too small; the range of count is 1 .. 9"},
        {"size m,gap m,count\n1,2,1.5", "2:5: count = 1.5 is not a whole number"},
        {"size m,gap m,count\n1,-2,1\n1,-2,1",
         "1 -2 1 ; 3:3: gap = -2 m is negative; the range of gap is up to 1000 m"},
        {"size m,gap m,count\n1,2\n1", "1 2 - ; 3:1: gap is missing; write a length"},
        {"size m,gap m,count\n1,,\n-,", "1 - - ; 3:1: size is missing; write a length"},
        {"size m,gap m\n1,1\n1,1\n1,1\n1,1\n", "1 1 - ; 1 1 - ; 1 1 - ; 5:1: there are more than 3 rows"},
    };
    CHECK(cases, &kind);
}

/* Checks headers and rows with the largest number of cells, one cell less and one more, and NUL bytes. */
TEST(limits)
{
    enum { SIZE = 4096, CELLS = CSV_CELLS_MOST };
    char text[SIZE], shown[2048];
    static const struct {
        int head, row; /* number of cells, two of which are columns of the table */
        const char *shown;
    } cases[] = {
        {CELLS - 1, CELLS - 1, "1 2 - ,"},
        {CELLS - 1, CELLS, "2:161: too many cells: 80, but the first line has 79"},
        {CELLS, CELLS - 1, "1 2 - ,"},
        {CELLS, CELLS, "1 2 - ,"},
        {CELLS, CELLS + 1, "2:163: the line has more than 80 cells"},
        {CELLS + 1, 2, "1:318: the line has more than 80 cells"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        int n = sprintf(text, "size m,gap m");
        for (int i = 2; i < cases[k].head; i++)
            n += sprintf(text + n, ",x%d", i);
        n += sprintf(text + n, "\n1 m,2");
        for (int i = 2; i < cases[k].row; i++)
            n += sprintf(text + n, ",é");
        rows_show(text, (size_t)n, &kind, shown, sizeof shown);
        assert_memory_equal(shown, cases[k].shown, strlen(cases[k].shown));
    }
    static const char nul[] = "size m,gap m\n1,2\n1,\0";
    rows_show(nul, sizeof nul, &kind, shown, sizeof shown);
    assert_string_equal(shown, "1 2 - ; 3:3: the line contains a NUL byte; a csv file is text in UTF-8");
}
