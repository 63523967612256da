/* scope.c -- for which degrees and values a claim was decided, in words. */
#include "chapters/judge/scope.h"

#include "exact/number/field.h"
#include "exact/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int is_word(const char *word, size_t n, const char *words)
{
    for (size_t m; *words != '\0'; words += m + (words[m] == ' ')) {
        m = strcspn(words, " ");
        if (m == n && strncmp(words, word, n) == 0)
            return 1;
    }
    return 0;
}

static int has_index(const char *letters, int index, const char *names)
{
    char name[FIELD_MAX_NAME + 16];
    int n = snprintf(name, sizeof name, "%s%d", letters, index);
    return is_word(name, (size_t)n, names);
}

/* "t w0 R0 w1 w3" -> "t, w0..w1, w3, R0": the variables by their letters. */
static char *put_variables(char *at, const char *names)
{
    const char *all = names;
    char letters[FIELD_MAX_VARIABLES][FIELD_MAX_NAME + 1];
    int low[FIELD_MAX_VARIABLES], high[FIELD_MAX_VARIABLES], count = 0;
    while (*names != '\0') {
        size_t n = strcspn(names, " "), stem = strcspn(names, "0123456789 ");
        int index = stem < n ? atoi(names + stem) : -1, k = 0;
        while (k < count &&
               ((low[k] < 0) != (index < 0) || strlen(letters[k]) != stem || strncmp(letters[k], names, stem) != 0))
            k++;
        if (k == count) {
            snprintf(letters[count], sizeof letters[0], "%.*s", (int)stem, names);
            low[count] = high[count] = index;
            count++;
        }
        low[k] = index < low[k] ? index : low[k];
        high[k] = index > high[k] ? index : high[k];
        names += n + (names[n] == ' ');
    }
    for (int k = 0; k < count; k++) {
        if (low[k] < 0)
            at += sprintf(at, "%s%s", k > 0 ? ", " : "", letters[k]);
        for (int first = low[k], last; first >= 0 && first <= high[k]; first = last + 1) {
            for (last = first; has_index(letters[k], last + 1, all);)
                last++;
            at += sprintf(at, "%s%s%d", k > 0 || first > low[k] ? ", " : "", letters[k], first);
            if (last > first)
                at += sprintf(at, "..%s%d", letters[k], last);
            while (last < high[k] && !has_index(letters[k], last + 1, all))
                last++;
        }
    }
    return at;
}

/* "every value of t, R0..R3 and every positive value of w0..w3": the variables of b, those apart that were
 * taken to be positive. */
static char *put_range(char *at, const type_result *b)
{
    char *free_ones = calloc(strlen(b->variables) + 2, 1), *end = free_ones;
    if (free_ones == NULL)
        abort();
    for (const char *name = b->variables; *name != '\0'; name += strspn(name, " ")) {
        size_t n = strcspn(name, " ");
        if (!is_word(name, n, b->positive))
            end += sprintf(end, "%s%.*s", end > free_ones ? " " : "", (int)n, name);
        name += n;
    }
    if (free_ones[0] != '\0')
        at = put_variables(at + sprintf(at, "every value of "), free_ones);
    if (b->positive[0] != '\0')
        at = put_variables(at + sprintf(at, "%severy positive value of ", free_ones[0] != '\0' ? " and " : ""),
                           b->positive);
    free(free_ones);
    return at;
}

char *scope_of(const claim_result *r)
{
    const claim *c = r->claim;
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        const type_result *b = &r->by[t];
        if (!b->ran || evidence_of(c, t) != r->evidence)
            continue;
        size_t room = 160 + strlen(c->scope) + (b->variables != NULL ? 3 * strlen(b->variables) : 0);
        char *s = malloc(room), *at = s;
        if (s == NULL)
            abort();
        *s = '\0';
        if (c->all_degrees)
            at += sprintf(at, "all n");
        else if (b->degree_high > 0)
            at +=
                sprintf(at, b->degree_low == b->degree_high ? "n = %d" : "n = %d to %d", b->degree_low, b->degree_high);
        if (c->scope[0] != '\0')
            at += sprintf(at, "%s%s", at > s ? "; " : "", c->scope);
        if (r->evidence == PROVED && b->variables != NULL && b->variables[0] != '\0')
            put_range(at + sprintf(at, "%s", at > s ? "; " : ""), b);
        else if (r->evidence == SAMPLED || r->evidence == MEASURED || r->evidence == ENCLOSED)
            sprintf(at, "%s%d instances", at > s ? "; " : "", b->cases);
        else if (at == s)
            sprintf(at, "the stated instance");
        return s;
    }
    return strdup("");
}
