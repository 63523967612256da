/* table.c -- points in a table: a line each. */
#include "cli/fit/reader.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { MOST_FIELDS = 256, MOST_SHOWN = 40, MOST_LEADING = 16 };
enum role { X, Y, Z, SIGMA, ROLES };
static const char *const role_name[ROLES] = {"x", "y", "z", "sigma"};

/* What maps, surveyors and schools call x and y; first those in degrees, last the words for x and y themselves. */
static const char *const pair_name[][2] = {
    {"longitude", "latitude"},  {"lon", "lat"},      {"long", "lat"}, {"lng", "lat"},  {"经度", "纬度"},
    {"easting", "northing"},    {"east", "north"},   {"e", "n"},      {"ost", "nord"}, {"est", "nord"},
    {"rechtswert", "hochwert"}, {"rechts", "hoch"},  {"rw", "hw"},    {"东", "北"},    {"abscissa", "ordinate"},
    {"abszisse", "ordinate"},   {"横坐标", "纵坐标"}};
enum { PAIRS = sizeof pair_name / sizeof *pair_name, IN_DEGREES = 5, PLAIN = 3 };

/* What heights are called, which are z if three coordinates are asked for. */
static const char *const height_name[] = {"h",        "height", "hoehe", "höhe",      "HÖHE", "alt",
                                          "altitude", "ele",    "elev",  "elevation", "高程", "竖坐标"};

/* A piece of the file, without the quotes around it. */
struct field {
    char *at;
    size_t length;
    int quoted;
};

struct table {
    struct reader in;
    char separator;    /* ';', '\t', ',', ' '; 0: not known yet  */
    int comma, point;  /* lines of the first decimal comma and of the first decimal point; 0: none     */
    int column[ROLES]; /* where each is, from 0; -1: nowhere                                          */
    int pair;          /* which one the columns are called by, from 1; 0: they are called x and y, or not at all  */
    int is_number[MOST_FIELDS]; /* whether a column is called a number or name of the point                       */
    int counts;                 /* the columns have no names, and the first one begins with a whole number         */
    int two;                    /* the only two columns that can be coordinates are taken as x and y           */
    int fields;                 /* of every line                                                               */
    int dim;
    char unit[8]; /* that stands behind numbers; "": none                                 */
    int leading;  /* lines before the first row: titles, names, counts                        */
    struct lead {
        char *text, *start;
        int line;
    } lead[MOST_LEADING];
};

static int is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }

/* The next line that says something, without blanks around it and ended by a zero byte; NULL at the end. */
static char *next_line(struct table *r)
{
    while (r->in.next < r->in.end) {
        char *line = r->in.next, *stop = line;
        while (stop < r->in.end && *stop != '\n' && *stop != '\r')
            stop++;
        r->in.start = line;
        r->in.next = stop + (stop + 1 < r->in.end && stop[0] == '\r' && stop[1] == '\n') + 1;
        r->in.line++;
        while (stop > line && is_blank(stop[-1]))
            stop--;
        *stop = '\0';
        while (line < stop && is_blank(*line))
            line++;
        if (line < stop && *line != '#')
            return line;
    }
    return NULL;
}

/* ---- fields -------------------------------------------------------------------------------------- */

/* The field that begins at s; returns where it ends, or NULL when a quote is not closed. */
static char *one_field(char *s, const char *separators, struct field *f)
{
    f->quoted = *s == '"';
    if (!f->quoted) {
        f->at = s;
        s += strcspn(s, separators);
        for (f->length = (size_t)(s - f->at); f->length > 0 && is_blank(f->at[f->length - 1]);)
            f->length--;
        return s;
    }
    char *to = f->at = ++s; /* a doubled quote is one quote */
    for (; *s != '\0' && !(*s == '"' && s[1] != '"'); s++)
        *to++ = *(s += *s == '"');
    f->length = (size_t)(to - f->at);
    while (f->length > 0 && is_blank(*f->at))
        f->at++, f->length--;
    while (f->length > 0 && is_blank(f->at[f->length - 1]))
        f->length--;
    return *s == '"' ? s + 1 : NULL;
}

/* The fields of a line; -1 and the error when a quote is not closed or something follows it. */
static int fields_of(const struct table *r, char *line, struct field *field)
{
    const char one[] = {r->separator, '\0'};
    int runs = r->separator == ' ' || r->separator == '\t', count = 0;
    const char *separators = runs ? r->separator == ' ' ? " \t\f\v" : "\t" : one;
    for (char *s = line; *s != '\0'; count++) {
        struct field f;
        while (is_blank(*s) && strchr(separators, *s) == NULL)
            s++;
        if ((s = one_field(s, separators, &f)) == NULL)
            return refuse(&r->in, NULL, "a quote is opened and not closed");
        while (is_blank(*s) && strchr(separators, *s) == NULL)
            s++;
        if (*s != '\0' && strchr(separators, *s) == NULL)
            return refuse(&r->in, s, "expected a separator after the closing quote, not '%.*s'", MOST_SHOWN, s);
        s += *s != '\0';
        while (runs && *s != '\0' && strchr(separators, *s) != NULL)
            s++;
        if (count < MOST_FIELDS)
            field[count] = f;
    }
    if (count > MOST_FIELDS)
        return refuse(&r->in, NULL, "%d fields, expected at most %d", count, MOST_FIELDS);
    return count;
}

/* How many bytes the unit of a length or an angle at s has that ends there; 0: none does. */
static size_t unit_length(const char *s)
{
    static const char *const units[] = {"mm", "cm",   "dm", "m",  "km", "µm",  "μm",  "um", "nm",
                                        "in", "inch", "ft", "\"", "°",  "deg", "rad", "%"};
    for (size_t k = 0; k < sizeof units / sizeof *units; k++) {
        size_t n = strlen(units[k]);
        if (strncmp(s, units[k], n) == 0 && (s[n] == '\0' || strchr(" \t;,\"", s[n]) != NULL))
            return n;
    }
    return 0;
}

/* Whether it is a unit, perhaps in brackets, or empty, as in a line of units below the names. */
static int is_unit(const struct field *f)
{
    const char *s = f->at, *stop = f->at + f->length;
    s += s < stop && strchr("[(", *s) != NULL;
    stop -= stop > s && strchr("])", stop[-1]) != NULL;
    char text[8] = "";
    if ((size_t)(stop - s) < sizeof text)
        memcpy(text, s, (size_t)(stop - s));
    return s == stop || (*text != '\0' && unit_length(text) == strlen(text));
}

/* What the line is separated by: 0 when it has one field only.  A blank before a unit that ends a field is none. */
static char separator_of(const char *line)
{
    int quoted = 0, semicolon = 0, tab = 0, comma = 0, blank = 0;
    for (const char *s = line; *s != '\0'; s++) {
        quoted ^= *s == '"';
        if (quoted)
            continue;
        semicolon |= *s == ';';
        tab |= *s == '\t';
        comma |= *s == ',';
        if (*s == ' ' && s > line && s[-1] != ',' && s[-1] != ' ') {
            const char *behind = s + strspn(s, " "), *unit = behind + unit_length(behind);
            int ends =
                unit > behind && isdigit((unsigned char)s[-1]) && strchr(";,\t", unit[strspn(unit, " ")]) != NULL;
            blank |= *behind != ',' && !ends;
        }
    }
    return semicolon ? ';' : tab ? '\t' : blank ? ' ' : comma ? ',' : '\0';
}

enum number { NUMBER, NO_NUMBER, TWO_MARKS, NOT_FINITE, TOO_LARGE, OTHER_UNIT };

/* The number that the field is.  The program keeps the C locale for numbers, in which strtod takes the decimal point and
 * rounds correctly. */
static enum number number_of(struct table *r, const struct field *f, double *value)
{
    char *stop = f->at + f->length, *end;
    if (f->length == 0)
        return NO_NUMBER;
    char *comma = r->separator != ',' || f->quoted ? memchr(f->at, ',', f->length) : NULL;
    char *point = memchr(f->at, '.', f->length);
    if (comma != NULL &&
        (point != NULL || comma == f->at || !isdigit((unsigned char)comma[-1]) || !isdigit((unsigned char)comma[1])))
        return NO_NUMBER;
    char after = *stop;
    const char *unit = NULL;
    *stop = '\0';
    if (comma != NULL)
        *comma = '.';
    errno = 0;
    *value = strtod(f->at, &end);
    if (comma != NULL)
        *comma = ',';
    if (end > f->at && end < stop) {
        unit = end + strspn(end, " \t");
        end = *unit != '\0' && unit_length(unit) == strlen(unit) ? stop : end;
    }
    *stop = after;
    if (end != stop)
        return NO_NUMBER;
    if (!isfinite(*value))
        return errno == ERANGE ? TOO_LARGE : NOT_FINITE;
    if (unit != NULL && r->unit[0] == '\0')
        memcpy(r->unit, unit, (size_t)(stop - unit));
    else if (unit != NULL && (strlen(r->unit) != (size_t)(stop - unit) || strncmp(unit, r->unit, strlen(r->unit)) != 0))
        return OTHER_UNIT;
    int *mark = comma != NULL ? &r->comma : point != NULL ? &r->point : NULL;
    if (mark != NULL && *mark == 0)
        *mark = r->in.line;
    return r->comma != 0 && r->point != 0 ? TWO_MARKS : NUMBER;
}

/* How many bytes a mark that people put between thousands has; 0: none is there. */
static size_t thousands_mark(const char *s)
{
    static const char *const marks[] = {",", ".", "'", " ", "_", "\u2019", "\u00a0", "\u202f"};
    for (size_t k = 0; k < sizeof marks / sizeof *marks; k++)
        if (strncmp(s, marks[k], strlen(marks[k])) == 0)
            return strlen(marks[k]);
    return 0;
}

/* Whether the field is a number with its thousands apart: 1,234.5 or 12 345 or 1.234.567,8. */
static int has_thousands(const struct field *f)
{
    const char *s = f->at, *stop = f->at + f->length;
    s += *s == '-' || *s == '+';
    size_t digits = strspn(s, "0123456789"), groups = 0, mark;
    const char *first = s + digits;
    if (digits < 1 || digits > 3 || (mark = thousands_mark(first)) == 0)
        return 0;
    for (s = first; s < stop && strncmp(s, first, mark) == 0 && strspn(s + mark, "0123456789") == 3; groups++)
        s += mark + 3;
    if (s < stop && (*s == '.' || *s == ',') && *s != *first)
        s += 1 + strspn(s + 1, "0123456789");
    return groups > 0 && s == stop;
}

/* Whether the fields are numbers whose thousands are apart by the comma that separates fields: 1 234.5 2 345.5 for
 * 1,234.5,2,345.5. */
static int are_cut_at_thousands(const struct table *r, const struct field *field, int fields)
{
    int cut = r->separator == ',' && fields % 2 == 0;
    for (int k = 0; cut && k < fields; k += 2) {
        const char *a = field[k].at, *b = field[k + 1].at;
        size_t sign = *a == '-', whole = strspn(b, "0123456789");
        cut = !field[k].quoted && field[k].length >= sign + 1 && field[k].length <= sign + 3 &&
              strspn(a + sign, "0123456789") >= field[k].length - sign && whole == 3 &&
              (field[k + 1].length == 3 || b[3] == '.');
    }
    return cut;
}

/* Whether commas between digits and commas before blanks take turns, as in 1,5, 2,25. */
static int are_decimal_commas_beside_blanks(const struct table *r, const struct field *field, int fields)
{
    int so = r->separator == ',' && fields >= 4 && fields % 2 == 0;
    for (int k = 0; k + 1 < fields && so; k++) {
        const char *stop = field[k].at + field[k].length;
        so = !field[k].quoted && *stop == ',' && (k % 2 == 0) == (field[k + 1].at == stop + 1);
    }
    return so;
}

/* Whether some piece of the line is a number, however its fields are separated, or several are and all have units. */
static int has_number(const char *line)
{
    int with_unit = 0, others = 0;
    for (const char *s = line; *(s += strspn(s, " \t,;\"\f\v")) != '\0';) {
        size_t length = strcspn(s, " \t,;\"\f\v");
        char *end;
        strtod(s, &end);
        if (end > s && end == s + length)
            return 1;
        with_unit += end > s && unit_length(end) > 0;
        others += !(end > s && unit_length(end) > 0);
        s += length;
    }
    return with_unit > 1 && others == 0;
}

/* ---- columns ------------------------------------------------------------------------------------- */

/* Whether the field is this name, perhaps with a unit or the word coordinate after it. */
static int is_called(const struct field *f, const char *name)
{
    static const char *const after[] = {" ", "\t", "[", "(", "/", "（", "［", "【", "坐标", "-coord", "-koord"};
    size_t n = strlen(name);
    if (f->length < n || strncasecmp(f->at, name, n) != 0)
        return 0;
    int ends = f->length == n;
    for (size_t k = 0; k < sizeof after / sizeof *after && !ends; k++)
        ends = f->length >= n + strlen(after[k]) && strncasecmp(f->at + n, after[k], strlen(after[k])) == 0;
    return ends;
}

/* Whether the field is a name of numbers that count the points, or of names of them: Nr., id, Punkt-Nr, 序号. */
static int is_called_number(const struct field *f)
{
    static const char *const words[] = {"number", "nummer", "num",   "nr",    "no",   "n°",   "index", "idx",
                                        "id",     "i",      "point", "punkt", "pkt",  "pt",   "lfd",   "name",
                                        "row",    "line",   "zeile", "序号",  "编号", "点号", "点名"};
    size_t at = 0, any = 0;
    while (at < f->length) {
        size_t longest = 0;
        for (size_t k = 0; k < sizeof words / sizeof *words; k++) {
            size_t n = strlen(words[k]);
            if (n > longest && n <= f->length - at && strncasecmp(f->at + at, words[k], n) == 0)
                longest = n;
        }
        any += longest;
        if (longest == 0 && strchr(" \t._-/:", f->at[at]) == NULL)
            return 0;
        at += longest > 0 ? longest : 1;
    }
    return any > 0;
}

static int role_of(const struct field *f)
{
    static const char *const sigmas[] = {"sigma", "s", "sd", "std", "stddev", "σ"};
    for (int k = X; k <= Z; k++)
        if (is_called(f, role_name[k]))
            return k;
    for (size_t k = 0; k < sizeof sigmas / sizeof *sigmas; k++)
        if (is_called(f, sigmas[k]))
            return SIGMA;
    return ROLES;
}

static int is_whole(const struct field *f, const char *name)
{
    return strlen(name) == f->length && strncasecmp(f->at, name, f->length) == 0;
}

/* The column that --sigma-column means, from 0. */
static int asked_sigma(const struct table *r, const char *asked, const struct field *names, int *column)
{
    char *end;
    long number = strtol(asked, &end, 10);
    if (*asked != '\0' && *end == '\0') {
        if (number < 1 || number > r->fields)
            return refuse(&r->in, NULL, "--sigma-column %s: there are %d columns", asked, r->fields);
        *column = (int)number - 1;
        return 0;
    }
    for (int k = 0; names != NULL && k < r->fields; k++)
        if (is_whole(&names[k], asked) || is_called(&names[k], asked)) {
            *column = k;
            return 0;
        }
    return refuse(&r->in, NULL, "--sigma-column %s: no column is called so%s", asked,
                  names == NULL ? "; there are no names, expected a number from 1" : "");
}

/* The columns of the first pair that stands among the names. */
static void find_pair(struct table *r, const struct field *names)
{
    for (int pair = 0; pair < PAIRS && r->pair == 0; pair++) {
        int at[2] = {-1, -1};
        for (int c = 0; c < 2; c++)
            for (int k = r->fields - 1; k >= 0; k--)
                at[c] = is_called(&names[k], pair_name[pair][c]) ? k : at[c];
        if (at[X] >= 0 && at[Y] >= 0)
            r->column[X] = at[X], r->column[Y] = at[Y], r->pair = pair + 1;
    }
}

static int is_height(const struct field *f)
{
    int height = 0;
    for (size_t k = 0; k < sizeof height_name / sizeof *height_name; k++)
        height |= is_called(f, height_name[k]);
    return height;
}

/* Whether the name is one of a pair of which the other is not there. */
static int is_half(const struct field *f)
{
    int half = 0;
    for (int pair = 0; pair < PAIRS; pair++)
        half |= is_called(f, pair_name[pair][X]) || is_called(f, pair_name[pair][Y]);
    return half;
}

/* Columns that are neither a standard deviation nor numbers of the points: how many, and the first of them. */
static int others_of(const struct table *r, int column[3])
{
    int others = 0;
    for (int k = 0; k < r->fields; k++)
        if (k != r->column[SIGMA] && !r->is_number[k]) {
            if (others < 3)
                column[others] = k;
            others++;
        }
    return others;
}

/* Where exactly two columns can be coordinates, as in x z, t x, and id alpha beta, they are: in their order, but x y z in
 * theirs.  1 if it is so. */
static int find_two(struct table *r, const struct field *names)
{
    int at[3];
    if (others_of(r, at) != 2 || (r->fields > 2 && (is_half(&names[at[0]]) || is_half(&names[at[1]]))))
        return 0;
    int first = role_of(&names[at[0]]), second = role_of(&names[at[1]]), turned = first <= Z && second < first;
    r->column[X] = at[turned], r->column[Y] = at[!turned], r->column[Z] = -1;
    r->two = r->fields > 2 || first <= Z || second <= Z;
    return 1;
}

/* Which columns count the points, unless too few are left for coordinates. */
static void set_numbers_aside(struct table *r, const struct field *names)
{
    int at[3];
    for (int k = 0; k < r->fields; k++)
        r->is_number[k] = is_called_number(&names[k]);
    if (others_of(r, at) < 2)
        memset(r->is_number, 0, sizeof r->is_number);
}

/* Columns by their names.  1 when the names say nothing of coordinates. */
static int columns_by_name(struct table *r, const struct columns *asked, const struct field *names)
{
    int at[3];
    for (int k = 0; k < r->fields; k++) {
        int role = role_of(&names[k]);
        if (role == ROLES || (role == SIGMA && asked->sigma != NULL))
            continue;
        if (r->column[role] >= 0)
            return refuse(&r->in, NULL, "two columns are called %s", role_name[role]);
        r->column[role] = k;
    }
    if (r->column[X] < 0 && r->column[Y] < 0)
        find_pair(r, names);
    if (r->column[X] < 0 && r->column[Y] < 0 && r->column[Z] < 0 && r->fields == 2 && asked->sigma == NULL)
        r->column[SIGMA] = -1; /* t s */
    set_numbers_aside(r, names);
    if (asked->dim != 3 && (r->column[X] < 0 || r->column[Y] < 0) && find_two(r, names))
        return 0;
    if (r->column[X] < 0 && r->column[Y] < 0) {
        for (int k = 0; k < r->fields && r->fields > 2 && r->separator != ' '; k++)
            if (is_half(&names[k]))
                return refuse(&r->in, NULL, "no column is the other coordinate beside %.*s", (int)names[k].length,
                              names[k].at);
        if (r->column[Z] >= 0 && others_of(r, at) > 2)
            return refuse(&r->in, NULL, "a column is called z, none x and y");
        r->column[Z] = -1;
        return 1;
    }
    for (int k = X; k <= Y; k++)
        if (r->column[k] < 0)
            return refuse(&r->in, NULL, "no column is called %s", role_name[k]);
    for (int k = 0; k < r->fields && asked->dim == 3 && r->column[Z] < 0; k++)
        if (is_height(&names[k]))
            r->column[Z] = k;
    if (asked->dim == 3 && r->column[Z] < 0)
        return refuse(&r->in, NULL, "--dim 3: no column is called z");
    if (asked->dim == 2)
        r->column[Z] = -1;
    return 0;
}

/* Columns in their order: coordinates, then the standard deviation, which may have been named already. */
static int columns_by_order(struct table *r, const struct columns *asked, const struct field *names)
{
    int known = r->column[SIGMA] >= 0, column[3], others = others_of(r, column);
    int dim = asked->dim != 0 ? asked->dim : known ? others : others == 3 ? 0 : others == 4 ? 3 : others;
    if (dim == 0 && names == NULL)
        return refuse(
            &r->in, NULL, "three columns without names can be x y z or x y sigma; say which by --dim 3 or --dim 2%s",
            r->counts ? ", or, if the first one numbers the points, by a line above them such as nr x y" : "");
    if (dim == 0)
        return refuse(
            &r->in, NULL,
            "three columns can be x y z or x y sigma, and their names do not say which; say it by names x and "
            "y, or by --dim 3 or --dim 2, in this order");
    if (dim < 2 || dim > 3 || others < dim || others > dim + !known)
        return refuse(&r->in, NULL,
                      asked->dim != 0 ? "%d column%s, expected %d coordinates and perhaps a standard deviation"
                                      : "%d column%s without names x and y, expected 2 or 3 coordinates and perhaps a "
                                        "standard deviation",
                      r->fields, r->fields == 1 ? "" : "s", dim);
    int at = 0;
    for (int k = 0; k < r->fields; k++)
        if (k != r->column[SIGMA] && !r->is_number[k] && at <= dim)
            r->column[at == dim ? SIGMA : at] = k, at++;
    return 0;
}

/* From the first line, or from names.  0, or -1 and the error. */
static int find_columns(struct table *r, const struct columns *asked, const struct field *names, int fields)
{
    r->fields = fields;
    for (int k = 0; k < ROLES; k++)
        r->column[k] = -1;
    memset(r->is_number, 0, sizeof r->is_number);
    if (asked->sigma != NULL && asked_sigma(r, asked->sigma, names, &r->column[SIGMA]) != 0)
        return -1;
    int by_name = names == NULL ? 1 : columns_by_name(r, asked, names);
    if (by_name < 0)
        return -1;
    for (int k = X; k <= Z; k++)
        if (r->column[SIGMA] >= 0 && r->column[k] == r->column[SIGMA])
            return refuse(&r->in, NULL, "--sigma-column %s: that is the column of %s", asked->sigma, role_name[k]);
    if (by_name == 1 && columns_by_order(r, asked, names) != 0)
        return -1;
    r->dim = r->column[Z] >= 0 ? 3 : 2;
    return 0;
}

/* ---- the points ---------------------------------------------------------------------------------- */

static int read_value(struct table *r, const struct field *f, enum role role, double *value)
{
    int shown = f->length < MOST_SHOWN ? (int)f->length : MOST_SHOWN;
    switch (number_of(r, f, value)) {
    case NO_NUMBER:
        if (f->length == 0)
            return refuse(&r->in, f->at, "%s is missing, expected a number", role_name[role]);
        return refuse(&r->in, f->at, "%s: '%.*s' is not a number%s", role_name[role], shown, f->at,
                      has_thousands(f) ? ": expected digits with nothing between the thousands" : "");
    case NOT_FINITE:
        return refuse(&r->in, f->at, "%s is %.*s, expected a finite number", role_name[role], shown, f->at);
    case TOO_LARGE:
        return refuse(&r->in, f->at, "%s: '%.*s' is larger than any binary64 number", role_name[role], shown, f->at);
    case TWO_MARKS:
        return refuse(&r->in, f->at,
                      "%s: '%.*s' has a decimal %s, line %d a decimal %s; expected one of them throughout",
                      role_name[role], shown, f->at, r->comma == r->in.line ? "comma" : "point",
                      r->comma < r->point ? r->comma : r->point, r->comma == r->in.line ? "point" : "comma");
    case OTHER_UNIT:
        return refuse(&r->in, f->at, "%s: '%.*s' has another unit than %s, which stands behind other numbers",
                      role_name[role], shown, f->at, r->unit);
    case NUMBER:
        break;
    }
    if (role == SIGMA && *value <= 0)
        return refuse(&r->in, f->at, "sigma is %.*s, expected a standard deviation > 0", shown, f->at);
    return 0;
}

static int refuse_thousands(const struct table *r)
{
    return refuse(&r->in, NULL,
                  "the numbers seem to have commas between the thousands, and commas part the fields; expected digits "
                  "with nothing between the thousands");
}

static int read_row(struct table *r, const struct field *field, int fields, struct points *p)
{
    double at[3] = {0}, sigma = 0;
    if (fields == 2 * r->fields && are_cut_at_thousands(r, field, fields))
        return refuse_thousands(r);
    if (fields != r->fields)
        return refuse(&r->in, NULL, "%d field%s, expected %d", fields, fields == 1 ? "" : "s", r->fields);
    for (int k = X; k <= Z; k++)
        if (r->column[k] >= 0 && read_value(r, &field[r->column[k]], (enum role)k, &at[k]) != 0)
            return -1;
    if (r->column[SIGMA] >= 0 && read_value(r, &field[r->column[SIGMA]], SIGMA, &sigma) != 0)
        return -1;
    p->dim = r->dim;
    p->has_sigma = r->column[SIGMA] >= 0;
    return add_point(p, at, sigma, r->in.line) == 0 ? 0 : refuse(&r->in, NULL, "memory is short");
}

/* ---- before the first row ------------------------------------------------------------------------ */

/* Whether the line begins with a number whose thousands are apart. */
static int begins_with_thousands(char *line)
{
    struct field first = {line, strcspn(line, " \t;"), 0};
    return has_thousands(&first);
}

/* Whether a line before all rows that has a number in it may be no row: a number alone, as a count is, or a line that
 * begins with a letter, as titles do ("NACA 2412").  The next line decides. */
static int may_be_heading(const struct table *r, const char *line)
{
    return separator_of(line) == 0 ||
           (r->leading == 0 && (isalpha((unsigned char)*line) || (unsigned char)*line >= 0x80));
}

/* The fields of a heading, separated so, in a copy of it that the caller frees.  Units apart from their names belong to
 * them: x [mm] is one field.  `gap` separates at two blanks or more. */
static int heading_fields(const struct table *r, const struct lead *lead, char separator, struct field *field,
                          char **copy)
{
    enum { GAP = '2' };
    struct table here = *r;
    struct input_error ignored;
    here.in.error = &ignored;
    here.separator = separator == GAP ? '\t' : separator;
    *copy = strdup(lead->text);
    if (*copy == NULL)
        abort();
    for (char *s = *copy; separator == GAP && *s != '\0'; s++)
        if (is_blank(s[0]) && is_blank(s[1]))
            s[0] = s[1] = '\t';
    int fields = fields_of(&here, *copy, field), kept = 0;
    for (int k = 0; k < fields; k++)
        if (kept == 0 || field[k].length == 0 || strchr("[(", *field[k].at) == NULL)
            field[kept++] = field[k];
    return fields < 0 ? fields : kept;
}

/* Tells which columns are not used, and which are without being called x and y. */
static void note_columns(const struct table *r, const struct columns *asked, const struct field *names,
                         struct points *p)
{
    char text[400] = "";
    const struct field *height = NULL;
    if (r->two)
        note_of(p, "%.*s and %.*s are taken as coordinates x and y of a plane", (int)names[r->column[X]].length,
                names[r->column[X]].at, (int)names[r->column[Y]].length, names[r->column[Y]].at);
    for (int k = 0, role; k < r->fields; k++) {
        for (role = 0; role < ROLES && r->column[role] != k; role++)
            continue;
        size_t at = strlen(text);
        if (role < ROLES)
            continue;
        if (names[k].length > 0)
            snprintf(text + at, sizeof text - at, "%s%.*s", at > 0 ? ", " : "", (int)names[k].length, names[k].at);
        else
            snprintf(text + at, sizeof text - at, "%scolumn %d", at > 0 ? ", " : "", k + 1);
        height = is_height(&names[k]) && height == NULL ? &names[k] : height;
    }
    if (*text == '\0')
        return;
    if (height != NULL && asked->dim == 0 && !r->two && (r->pair == 0 || r->pair > IN_DEGREES))
        note_of(p, "not used: %s (--dim 3 takes %.*s as z)", text, (int)height->length, height->at);
    else
        note_of(p, "not used: %s", text);
}

/* Columns from line k before the rows, if it names so many.  1 if it does, 0 if not, -1 and the error.  In blanks a name
 * x or y without the other is a word of a title, as in Clark Y. */
static int columns_from(struct table *r, int k, const struct columns *asked, int fields, int only_coordinates,
                        struct points *p)
{
    const char separators[] = {r->separator, r->separator == ' ' ? '2' : '\0', '\t', ';', ',', '\0'};
    struct field field[MOST_FIELDS];
    const struct lead *lead = &r->lead[k];
    int found = 0;
    for (const char *separator = separators; found == 0 && separator < separators + sizeof separators; separator++) {
        char *copy;
        if (*separator == '\0' || (separator > separators && r->separator != ' '))
            continue;
        int coordinates[2] = {0}, units = 1, count = heading_fields(r, lead, *separator, field, &copy);
        for (int j = 0; j < count; j++) {
            if (role_of(&field[j]) <= Y)
                coordinates[role_of(&field[j])] = 1;
            units &= is_unit(&field[j]);
        }
        int both = coordinates[X] && coordinates[Y], one = coordinates[X] || coordinates[Y];
        if (count == fields && !units && (both || (!only_coordinates && !(one && r->separator == ' ')))) {
            struct reader here = r->in;
            r->in.line = lead->line, r->in.start = lead->start;
            found = find_columns(r, asked, field, fields) == 0 ? 1 : -1;
            r->in = here;
            if (found > 0)
                note_columns(r, asked, field, p);
        }
        free(copy);
    }
    return found;
}

/* The error that line k before the rows is as a row. */
static int refuse_heading(struct table *r, int k, const struct columns *asked, struct points *p)
{
    struct field field[MOST_FIELDS];
    r->in.line = r->lead[k].line, r->in.start = r->lead[k].start;
    r->separator = separator_of(r->lead[k].text);
    r->separator = r->separator != '\0' ? r->separator : ' ';
    int fields = fields_of(r, r->lead[k].text, field);
    if (fields < 0 || find_columns(r, asked, NULL, fields) != 0 || read_row(r, field, fields, p) != 0)
        return -1;
    return refuse(&r->in, NULL, "this line is not like the others");
}

/* Whether all fields are numbers. */
static int is_row_of_numbers(const struct table *r, const struct field *field, int fields)
{
    int good = fields >= 2;
    for (int k = 0; good && k < fields; k++) {
        struct table here = *r;
        double value;
        good = number_of(&here, &field[k], &value) == NUMBER;
    }
    return good;
}

/* What the lines before the first row say: its columns, or nothing. */
static int read_headings(struct table *r, const struct columns *asked, const struct field *field, int fields,
                         struct points *p)
{
    int names = -1;
    for (int k = 0; k < r->leading; k++) {
        char own = separator_of(r->lead[k].text);
        struct field its[MOST_FIELDS];
        char *copy;
        if (!has_number(r->lead[k].text))
            continue;
        int like_a_row = own != ' ' && own != '\0' && own == r->separator &&
                         heading_fields(r, &r->lead[k], own, its, &copy) == fields;
        if (own != ' ' && own != '\0' && own == r->separator)
            free(copy);
        if (like_a_row || !is_row_of_numbers(r, field, fields))
            return refuse_heading(r, k, asked, p);
    }
    for (int only = 1; only >= 0 && names < 0; only--)
        for (int k = r->leading - 1; k >= 0 && names < 0; k--) {
            int found = has_number(r->lead[k].text) ? 0 : columns_from(r, k, asked, fields, only, p);
            if (found < 0)
                return -1;
            names = found ? k : names;
        }
    for (int k = 0; k < r->leading; k++)
        if (k != names)
            note_of(p, "line %d, \"%.*s\", is passed over", r->lead[k].line, MOST_SHOWN, r->lead[k].text);
    if (r->pair > 0 && r->pair <= PAIRS - PLAIN)
        note_of(p, "%s and %s are taken as they are, as coordinates x and y of a plane", pair_name[r->pair - 1][X],
                pair_name[r->pair - 1][Y]);
    if (names >= 0)
        return 0;
    if (asked->dim == 0 && are_cut_at_thousands(r, field, fields))
        return refuse_thousands(r);
    if (are_decimal_commas_beside_blanks(r, field, fields))
        return refuse(&r->in, NULL,
                      "some commas have a blank behind them and others stand between digits; if these are decimal "
                      "commas, expected "
                      "semicolons or blanks alone between the fields");
    struct table here = *r;
    double first;
    r->counts = fields > 2 && number_of(&here, &field[0], &first) == NUMBER && first == floor(first);
    return find_columns(r, asked, NULL, fields);
}

/* Tells when the first of several columns without names, which is taken as x, counts 1, 2, 3, ... */
static void note_counting(const struct table *r, struct points *p)
{
    int counting = r->counts && p->count > 2 && (p->at[0] == 0 || p->at[0] == 1);
    for (int i = 1; i < p->count && counting; i++)
        counting = p->at[i * p->dim] == p->at[0] + i;
    if (counting)
        note_of(
            p,
            "the first column, %g, %g, %g, ..., is taken as x%s; if it numbers the points, a line such as nr x y above "
            "them says so",
            p->at[0], p->at[p->dim], p->at[2 * p->dim],
            p->has_sigma ? " and the last one as the standard deviation" : "");
}

static int read_rows(struct table *r, const struct columns *asked, struct points *p)
{
    struct field field[MOST_FIELDS];
    for (char *line; (line = next_line(r)) != NULL;) {
        if (r->fields == 0 && r->leading < MOST_LEADING &&
            ((!has_number(line) && !begins_with_thousands(line)) || may_be_heading(r, line))) {
            r->lead[r->leading++] = (struct lead){line, r->in.start, r->in.line};
            continue;
        }
        if (r->separator == 0 && (r->separator = separator_of(line)) == 0)
            r->separator = ' ';
        int fields = fields_of(r, line, field);
        if (fields < 0 || (r->fields == 0 && read_headings(r, asked, field, fields, p) != 0))
            return -1;
        if (read_row(r, field, fields, p) != 0)
            return -1;
    }
    for (int k = 0; k < r->leading && p->count == 0; k++)
        if (has_number(r->lead[k].text))
            return refuse_heading(r, k, asked, p);
    if (p->count == 0) {
        r->in.line = 0;
        return refuse(&r->in, NULL, "there are no points in it; expected a line for each, such as 1.5, 2.25");
    }
    return 0;
}

/* ---- Lednicer's airfoils -------------------------------------------------------------------------- */

static int is_count(double x) { return x >= 2 && x < 1e6 && x == floor(x); }

/* Points first, ..., last from the nose backwards: x grows from the first to the last one. */
static int goes_back(const struct points *p, int first, int last) { return p->at[2 * first] < p->at[2 * last]; }

static void swap_points(struct points *p, int i, int j)
{
    for (int c = 0; c < 2; c++) {
        double x = p->at[2 * i + c];
        p->at[2 * i + c] = p->at[2 * j + c], p->at[2 * j + c] = x;
    }
    int line = p->line[i];
    p->line[i] = p->line[j], p->line[j] = line;
}

/* Two counts m, n in place of a first point, and then the m points of the upper side and the n of the lower one, each
 * from the nose: they become one line, from the trailing edge over the nose, which stands there once. */
static void join_sides(struct points *p)
{
    if (p->dim != 2 || p->has_sigma || p->count < 5 || !is_count(p->at[0]) || !is_count(p->at[1]) ||
        p->at[0] + p->at[1] != p->count - 1)
        return;
    int m = (int)p->at[0], n = (int)p->at[1];
    if (!goes_back(p, 1, m) || !goes_back(p, m + 1, m + n))
        return;
    for (int i = 1, j = m; i < j; i++, j--)
        swap_points(p, i, j);
    int same = is_same_point(p, m, m + 1); /* the nose */
    for (int from = 1, to = 0; from <= m + n; from++)
        if (from != m + 1 || !same) {
            memmove(p->at + 2 * to, p->at + 2 * from, 2 * sizeof *p->at);
            p->line[to++] = p->line[from];
            p->count = to;
        }
    note_of(
        p,
        "Lednicer's order, %d points of the upper and %d of the lower side from the nose: read as one line, from the "
        "trailing edge over the upper side and back",
        m, n);
}

int read_table(struct reader *in, const struct columns *asked, struct points *p)
{
    struct table r = {.in = *in};
    if (read_rows(&r, asked, p) != 0)
        return -1;
    if (r.unit[0] != '\0')
        note_of(p, "the unit %s stands behind the numbers, which are taken as they are", r.unit);
    join_sides(p);
    note_counting(&r, p);
    return 0;
}
