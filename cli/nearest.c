/* nearest.c -- names that are spelled nearly alike; see nearest.h. */
#include "cli/nearest.h"

#include <stdlib.h>
#include <string.h>

/* Levenshtein's distance; it is no less than the difference of the lengths, which is all that is told where that is above `most`. */
static int distance(const char *a, const char *b, int most)
{
    size_t m = strlen(b);
    int longer = (int)strlen(a) - (int)m;
    if (abs(longer) > most)
        return abs(longer);
    int *row = calloc(m + 1, sizeof *row);
    if (row == NULL)
        abort();
    for (size_t j = 0; j <= m; j++)
        row[j] = (int)j;
    for (size_t i = 1; a[i - 1] != '\0'; i++) {
        int diagonal = row[0];
        row[0] = (int)i;
        for (size_t j = 1; j <= m; j++) {
            int change = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            int smallest = row[j] + 1 < row[j - 1] + 1 ? row[j] + 1 : row[j - 1] + 1;
            row[j] = change < smallest ? change : smallest;
        }
    }
    int d = row[m];
    free(row);
    return d;
}

void consider_name(struct nearest *n, const char *name)
{
    enum { SHORTEST = 3, LONGEST = 255 };
    const char *place = strchr(name, ':') != NULL ? strchr(name, ':') + 1 : name;
    int length = (int)strlen(n->text), most = length / 4 + 1, alike = 0;
    int letters = distance(n->text, name, most), without = distance(n->text, place, most);
    if (without < letters)
        letters = without;
    if (length >= SHORTEST && strstr(name, n->text) != NULL)
        letters = 1;
    if (letters > most || letters >= length)
        return;
    while (alike < LONGEST && n->text[alike] != '\0' && n->text[alike] == name[alike])
        alike++;
    int d = letters * (LONGEST + 1) - alike;
    for (int k = 0; k < NEAREST_NAMES; k++)
        if (n->name[k] == NULL || d < n->distance[k]) {
            for (int j = NEAREST_NAMES - 1; j > k; j--)
                n->name[j] = n->name[j - 1], n->distance[j] = n->distance[j - 1];
            n->name[k] = name, n->distance[k] = d;
            return;
        }
}

void put_nearest(FILE *out, const struct nearest *n, const char *before)
{
    for (int k = 0; k < NEAREST_NAMES && n->name[k] != NULL; k++)
        fprintf(out, "%s %s%s", k > 0 ? "," : "the nearest:", before, n->name[k]);
}
