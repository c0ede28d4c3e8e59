/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The headings of columns: a name, perhaps the number of a trial, and a unit. */
#include "tables/csv_names.h"
#include "language/text.h"
#include "language/units.h"
#include <ctype.h>
#include <stdio.h>
#include <string.h>

bool csv_unit_copy(const char *text, char unit[CSV_UNIT])
{
    const char *begin = text + strspn(text, " \t(["), *end = begin + strcspn(begin, " \t)]");
    struct quantity q = {.value = 1};
    bool one = name_copy(begin, (size_t)(end - begin), unit, CSV_UNIT) && end[strspn(end, " \t)]")] == '\0';
    char *cube = strstr(unit, "\u00b3");
    if (cube) { /* "³" and "^3" both take two bytes in UTF-8 */
        cube[0] = '^';
        cube[1] = '3';
    }
    const char *stop = one && *unit ? unit_scan(unit, &q) : NULL;
    return stop && *stop == '\0';
}

/* What files call their columns: first the name of the column, then its other names in English, German, Dutch
 * and French, without accents. */
static const char *const column_words[] = {
    "height,length,hohe,hoehe,lange,laenge,hoogte,lengte,hauteur,longueur,hauteurs",
    "thickness,depth,thick,dicke,starke,staerke,tiefe,dikte,diepte,epaisseur,profondeur",
    "gap,spacing,distance,separation,abstand,lucke,luecke,afstand,tussenruimte,ecart,espacement,intervalle",
    "pitch,period,centre to centre,center to center,teilung,raster,rastermass,steek,pas,entraxe",
    ("position,positions,pos,front,front face,position of the front face,position of front face,"
     "lage,ort,positie,plaats,emplacement"),
    "dominoes,dominos,n,count,number of dominoes,no. of dominoes,anzahl,anzahl steine,aantal,nombre",
    "mass,weight,masse,gewicht,massa,poids",
    "density,dichte,dichtheid,densite",
    "width,breite,breedte,largeur",
    "radius,rounding,rayon,straal",
    "lean,plumb,tilt,neigung,helling,inclinaison",
    "relative,relativ,relatief,relatif",
    "domino,#,nr,nr.,no,no.,number,domino #,domino nr,domino no,domino no.,nummer,stein,steen,numero",
    ("time,t,times,hit,zeit,tijd,temps,total time,total,gesamtzeit,totale tijd,temps total,"
     "duration,dauer,duur,duree"),
    "angle,theta,tilt,rotation,thetar,winkel,hoek",
    "speed,velocity,v,geschwindigkeit,durchschnittsgeschwindigkeit,snelheid,vitesse",
    "frame,frames,frame number,step,bild,beeld,image",
    "rate,frame rate,framerate,fps",
    "run,trial,video,versuch,proef,essai",
    "error,errors,sigma,uncertainty,time error,angle error,speed error,fehler,fout,erreur",
    ("error %,errors %,sigma %,uncertainty %,relative error,relative error %,speed error %,time error %,"
     "fehler %,relativer fehler,fout %,erreur %"),
};

/* Words of headings that number a trial, or that say that a value is the mean of several trials. */
static const char trial_words[] = "trial,run,test,try,no,nr,versuch,messung,proef,meting,essai,mesure",
                  average_words[] =
                      "average,avg,mean,mittlere,durchschnittliche,mittel,gemiddelde,moyenne,moyen";

/* Copies a name in lower case, without accents, and with one blank between words. */
static void name_fold(const char *text, size_t length, char name[NAMES_SHOWN])
{
    /* the letters from U+00C0 to U+00FF without their accents */
    static const char plain[] = "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo/ouuuuyty";
    size_t n = 0;
    for (const char *c = text; c < text + length && n + 1 < NAMES_SHOWN; c++) {
        const unsigned char next = (unsigned char)c[1];
        const bool is_accent = (*c == '\xcc' && next >= 0x80) || (*c == '\xcd' && next < 0xb0);
        const bool is_letter = *c == '\xc3' && next >= 0x80 && next < 0xc0;
        const bool is_blank = isspace((unsigned char)*c) || *c == '_';
        if (!is_accent && !(is_blank && (n == 0 || name[n - 1] == ' ')))
            name[n++] = (char)(is_letter ? plain[next - 0x80] : is_blank ? ' ' : tolower((unsigned char)*c));
        c += is_accent || is_letter;
    }
    while (n > 0 && strchr(" /", name[n - 1]))
        n--;
    name[n] = '\0';
}

/* The words for per cent, which follow the name of a column or stand in its brackets. */
static const char percent_words[] = "%,percent,per cent,pct,prozent";

/* Cuts a word for per cent off the end of a folded name. Returns false if there is none. */
static bool percent_cut(char *name)
{
    for (char *blank = strchr(name, ' '); blank; blank = strchr(blank + 1, ' '))
        if (names_index(percent_words, ',', blank + 1) >= 0) {
            *blank = '\0';
            return true;
        }
    return false;
}

const char *csv_name_split(const char *text, char name[NAMES_SHOWN])
{
    char last[CSV_UNIT];
    size_t length = strcspn(text, "([,%"), word = strlen(text);
    while (word > 0 && !isspace((unsigned char)text[word - 1]) && text[word - 1] != '_')
        word--;
    if (text[length] == '\0' && word > 0 && csv_unit_copy(text + word, last))
        length = word;
    else if (text[length] == '\0' &&
             csv_unit_copy(text + strcspn(text, "/") + (strchr(text, '/') != NULL), last))
        length = strcspn(text, "/");
    const char *unit = text + length + strspn(text + length, " \t\n,/");
    name_fold(text, length, name);
    size_t n = strlen(name);
    if (n > 3 && strcmp(name + n - 3, " in") == 0)
        name[n - 3] = '\0';
    const char *inside = unit + strspn(unit, "([ ");
    char share[NAMES_SHOWN];
    name_fold(inside, strcspn(inside, ")]"), share);
    const bool is_word = names_index(percent_words, ',', share) >= 0 || (*unit == '\0' && percent_cut(name));
    n = strlen(name);
    if (is_word || *inside == '%')
        snprintf(name + n, NAMES_SHOWN - n, " %%");
    return is_word ? "%" : unit;
}

/* Returns true if a file may call the column by this name. */
static bool column_has(const struct csv_column *column, const char *name)
{
    bool found = strcmp(column->name, name) == 0;
    for (size_t i = 0; i < sizeof column_words / sizeof *column_words && !found; i++)
        found = names_index(column_words[i], ',', column->name) == 0 &&
                names_index(column_words[i], ',', name) > 0;
    return found;
}

/* The name of a measurement without the words that number a trial or say that it is a mean. */
struct repeat {
    char name[NAMES_SHOWN];
    bool is_trial, is_average;
};

/* Reads a heading such as "speed 2", "v2", "speed trial 2", "trial 2" or "average speed". */
static struct repeat repeat_read(const char *folded)
{
    struct repeat r = {.name = ""};
    for (const char *word = folded; *word;) {
        const size_t all = strcspn(word, " ");
        size_t length = all;
        while (length > 0 && (isdigit((unsigned char)word[length - 1]) || word[length - 1] == '#'))
            length--;
        char copy[NAMES_SHOWN];
        snprintf(copy, sizeof copy, "%.*s", (int)length, word);
        const bool trial = names_index(trial_words, ',', copy) >= 0,
                   average = names_index(average_words, ',', copy) >= 0;
        r.is_trial = r.is_trial || trial || length < all;
        r.is_average =
            r.is_average || average || strncmp(copy, "durchschnitts", strlen("durchschnitts")) == 0;
        if (*copy && !trial && !average)
            text_add(r.name, sizeof r.name, "%s%s", *r.name ? " " : "", copy);
        word += all + (word[all] == ' ');
    }
    return r;
}

/* Returns true if a heading is that of one of several columns of a measurement. A heading without a name,
 * such as "trial 2 (s)", fits if its unit is one of those of the column. */
static bool repeat_fits(const struct csv_column *column, const char *name, const char *unit)
{
    char copy[CSV_UNIT];
    const struct repeat r = repeat_read(name);
    if (!(column->traits & CSV_REPEATED) || !(r.is_trial || r.is_average))
        return false;
    return *r.name ? column_has(column, r.name)
                   : csv_unit_copy(unit, copy) &&
                         quantity_alike(expression_unit(copy), expression_unit(column->unit));
}

int csv_column_find(const struct csv_kind *kind, const char *name, const char *unit)
{
    int k = 0;
    while (k < kind->columns && !column_has(&kind->column[k], name))
        k++;
    for (int i = 0; i < kind->columns && k == kind->columns; i++)
        k = repeat_fits(&kind->column[i], name, unit) ? i : k;
    return k;
}

bool csv_is_average(const char *name)
{
    return repeat_read(name).is_average;
}

const char *csv_single_advice(const struct csv_kind *kind, char text[CSV_ADVICE])
{
    while (kind && (!kind->example || strchr(kind->example, ',')))
        kind = kind->otherwise;
    *text = '\0';
    if (kind)
        snprintf(text, CSV_ADVICE, "if it lists %.20s, write '%.24s' above it; otherwise ", kind->items,
                 kind->example);
    return text;
}
