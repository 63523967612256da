/* scope.c -- for which cases something was decided, as a set and in words. */
#include "chapters/judge/scope.h"
#include "chapters/judge/memory_text.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- the parts of a scope ------------------------------------------------------------------------- */

static void *one_more(void *list, int count, size_t size)
{
    void *longer = realloc(list, (size_t)(count + 1) * size);
    if (longer == NULL)
        abort();
    return longer;
}

static char *copy_of(const char *s, size_t n)
{
    char *copy = strndup(s, n);
    if (copy == NULL)
        abort();
    return copy;
}

static void meet_range(scope *s, whole_range r)
{
    for (int k = 0; k < s->ranges; k++) {
        whole_range *mine = &s->range[k];
        if (strcmp(mine->letter, r.letter) == 0) {
            mine->low = r.low > mine->low ? r.low : mine->low;
            mine->high = r.high < mine->high ? r.high : mine->high;
            return;
        }
    }
    s->range = one_more(s->range, s->ranges, sizeof *s->range);
    s->range[s->ranges++] = r;
}

static void add_phrase(phrases *list, const char *text, size_t n)
{
    list->at = one_more(list->at, list->count, sizeof *list->at);
    list->at[list->count++] = copy_of(text, n);
}

/* "one; another": each a phrase of the list; NULL is none. */
static void add_phrases(phrases *list, const char *text)
{
    for (const char *at = text != NULL ? text : ""; *at != '\0'; at += strspn(at, "; ")) {
        size_t n = strcspn(at, ";");
        add_phrase(list, at, n);
        at += n;
    }
}

static void free_phrases(phrases *list)
{
    for (int k = 0; k < list->count; k++)
        free(list->at[k]);
    free(list->at);
}

/* Whether the next n characters are that text. */
static int is_text(const char *at, size_t n, const char *text)
{
    return strlen(text) == n && strncmp(at, text, n) == 0;
}

/* Whether all cases of a phrase are cases of another one: the same, or the table has the row "narrow | wide", or "* | wide" of
 * one that leaves nothing out. */
static int is_within(const char *table, const char *narrow, const char *wide)
{
    if (strcmp(narrow, wide) == 0)
        return 1;
    for (const char *row = table; row != NULL && *row != '\0'; row += *row == ';') {
        row += strspn(row, " ");
        size_t end = strcspn(row, ";"), n = strcspn(row, "|");
        int is_left = n > 1 && n < end && (is_text(row, n - 1, narrow) || is_text(row, n - 1, "*"));
        if (is_left && is_text(row + n + 2, end - n - 2, wide))
            return 1;
        row += end;
    }
    return 0;
}

/* Whether some phrase of s has no counterpart in the other scope, none that is the same, narrower or wider. */
static int has_phrase_alone(const scope *s, const scope *other, const char *table)
{
    for (int k = 0; k < s->said.count; k++) {
        const char *mine = s->said.at[k];
        int known = 0;
        for (int m = 0; m < other->said.count; m++)
            known |= is_within(table, mine, other->said.at[m]) || is_within(table, other->said.at[m], mine);
        if (!known)
            return 1;
    }
    return 0;
}

/* Whether it is that of something stated: a curve, some polygons, numbers. */
static int is_stated(const scope *s)
{
    static const char stated[] = "the stated ";
    for (int k = 0; k < s->said.count; k++)
        if (strncmp(s->said.at[k], stated, sizeof stated - 1) == 0)
            return 1;
    return 0;
}

/* Whether it has one case, of one degree where it has any. */
static int is_one_instance(const scope *s)
{
    for (int k = 0; k < s->ranges; k++)
        if (s->range[k].low < s->range[k].high)
            return 0;
    return s->kinds == 0;
}

/* Whether the one is about what is stated, and the other one about more. */
static int is_beside_more(const scope *s, const scope *other)
{
    return is_stated(s) && !is_stated(other) && (is_one_instance(s) || other->kinds > 0);
}

static int is_every_case(const scope *s) { return s->ranges == 0 && s->said.count == 0 && s->kinds == 0; }

static int are_apart(const scope *s, const scope *other, const char *table)
{
    if (is_every_case(s) || is_every_case(other))
        return 0;
    return (has_phrase_alone(s, other, table) && has_phrase_alone(other, s, table)) || is_beside_more(s, other) ||
           is_beside_more(other, s);
}

/* Of phrases that can be compared the narrower one is left. */
static void meet_phrases(phrases *mine, const phrases *other, const char *table)
{
    for (int m = 0; m < other->count; m++) {
        int asked = 0;
        for (int k = 0; k < mine->count && !asked; k++) {
            asked = is_within(table, mine->at[k], other->at[m]);
            if (!asked && is_within(table, other->at[m], mine->at[k])) {
                free(mine->at[k]);
                mine->at[k--] = mine->at[--mine->count];
            }
        }
        if (!asked)
            add_phrase(mine, other->at[m], strlen(other->at[m]));
    }
}

/* What one claim takes to be positive and another one takes as it comes is positive. */
static void meet_quantity(scope *s, const char *noun, size_t n, int many, int positive, int claims)
{
    for (int k = 0; k < s->kinds; k++) {
        quantity *q = &s->data[k];
        int same =
            noun == NULL || q->noun == NULL ? noun == q->noun : strlen(q->noun) == n && strncmp(q->noun, noun, n) == 0;
        if (same) {
            q->positive |= positive;
            q->claims += claims;
            return;
        }
    }
    s->data = one_more(s->data, s->kinds, sizeof *s->data);
    s->data[s->kinds++] = (quantity){noun != NULL ? copy_of(noun, n) : NULL, many, positive, claims};
}

static int is_same_noun(const quantity *a, const quantity *b)
{
    return a->noun == NULL || b->noun == NULL ? a->noun == b->noun : strcmp(a->noun, b->noun) == 0;
}

/* Whether s has data that the other scope, which has some, does not have. */
static int has_data_alone(const scope *s, const scope *other)
{
    for (int k = 0; k < s->kinds && other->kinds > 0; k++) {
        int known = 0;
        for (int m = 0; m < other->kinds; m++)
            known |= is_same_noun(&s->data[k], &other->data[m]);
        if (!known)
            return 1;
    }
    return 0;
}

void meet_scope(scope *s, const scope *other)
{
    if (s->within == NULL)
        s->within = other->within;
    s->apart |= other->apart || are_apart(s, other, s->within);
    s->mixed |= other->mixed || (has_data_alone(s, other) && has_data_alone(other, s));
    meet_phrases(&s->said, &other->said, s->within);
    meet_phrases(&s->where, &other->where, s->within);
    for (int k = 0; k < other->ranges; k++)
        meet_range(s, other->range[k]);
    for (int k = 0; k < other->kinds; k++) {
        const quantity *q = &other->data[k];
        meet_quantity(s, q->noun, q->noun != NULL ? strlen(q->noun) : 0, q->many, q->positive, q->claims);
    }
    if (other->instances > 0 && (s->instances == 0 || other->instances < s->instances))
        s->instances = other->instances;
}

/* The next word of a blank-separated list, of n characters; NULL at its end. */
static const char *next_word(const char *list, size_t *n)
{
    list += strspn(list, " ");
    *n = strcspn(list, " ");
    return *n > 0 ? list : NULL;
}

static int is_among(const char *word, size_t n, const char *words)
{
    size_t m;
    for (; (words = next_word(words, &m)) != NULL; words += m)
        if (m == n && strncmp(words, word, n) == 0)
            return 1;
    return 0;
}

/* The letters of the field, as TeX writes them, and those of a text. */
static const char *const greek[][2] = {{"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"},     {"lambda", "λ"},
                                       {"mu", "μ"},    {"tau", "τ"},   {"sigma", "σ"},     {"theta", "θ"},
                                       {"rho", "ρ"},   {"omega", "ω"}, {"delta", "δ"},     {"kappa", "κ"},
                                       {"chi", "χ"},   {"nu", "ν"},    {"varepsilon", "ε"}};
enum { GREEK = sizeof greek / sizeof *greek };

static const char *letter_in_print(const char *noun)
{
    for (int k = 0; k < GREEK; k++)
        if (strcmp(noun, greek[k][0]) == 0)
            return greek[k][1];
    return noun;
}

static int is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0; }

/* Whether the letter stands in the text by itself: no part of a word, without an index or an argument. */
static int has_letter(const char *text, const char *letter)
{
    size_t n = strlen(letter);
    for (const char *at = text; (at = strstr(at, letter)) != NULL; at += n) {
        int is_command = at > text && at[-1] == '\\' && n > 1;
        int is_begun = at > text && !is_command && (is_letter(at[-1]) || at[-1] == '\\');
        if (!is_begun && !is_letter(at[n]) && at[n] != '_' && at[n] != '(')
            return 1;
    }
    return 0;
}

/* The letter of the field, "beta" or "x'", is the one of a text, "β" or "x", and not a word such as "interval". */
static int is_greek(const char *noun, size_t n, int k)
{
    return is_text(noun, n, greek[k][0]) || is_text(noun, n, greek[k][1]);
}

static int is_called_by_letter(const quantity *q)
{
    if (q->noun == NULL || q->many)
        return 0;
    size_t n = strcspn(q->noun, "'/");
    int known = n == 1;
    for (int k = 0; k < GREEK; k++)
        known |= is_greek(q->noun, n, k);
    return known;
}

/* Whether the letter is among those, "t beta x"; a quotient of two letters is none. */
static int is_letter_of(const char *letters, const char *noun)
{
    size_t n = strcspn(noun, "'/");
    int known = noun[n] != '/' && is_among(noun, n, letters);
    for (int k = 0; k < GREEK; k++)
        known |= is_greek(noun, n, k) && is_among(greek[k][0], strlen(greek[k][0]), letters);
    return known;
}

void leave_letters(scope *s, const char *letters)
{
    int left = 0;
    for (int k = 0; k < s->kinds; k++)
        if (is_called_by_letter(&s->data[k]) && !s->data[k].positive && !is_letter_of(letters, s->data[k].noun))
            free(s->data[k].noun);
        else
            s->data[left++] = s->data[k];
    s->kinds = left;
}

void keep_degree(scope *s, int degree)
{
    for (int k = 0; k < s->ranges; k++)
        if (s->range[k].letter[0] == '\0') {
            meet_range(s, (whole_range){"", degree, degree});
            return;
        }
}

int is_empty_scope(const scope *s)
{
    for (int k = 0; k < s->ranges; k++)
        if (s->range[k].low > s->range[k].high)
            return 1;
    return 0;
}

void free_scope(scope *s)
{
    free_phrases(&s->said), free_phrases(&s->where);
    for (int k = 0; k < s->kinds; k++)
        free(s->data[k].noun);
    free(s->range), free(s->data);
    *s = (scope){0};
}

/* ---- what the variables of the field stand for ------------------------------------------------------ */

/* Whether a pattern means the variable: "w#" any w with an index, "beta" beta or beta0, "x1" itself. */
static int means(const char *pattern, size_t m, const char *name, size_t n)
{
    size_t stem = n;
    while (stem > 0 && isdigit((unsigned char)name[stem - 1]))
        stem--;
    if (pattern[m - 1] == '#')
        return stem < n && m - 1 == stem && strncmp(pattern, name, stem) == 0;
    if (m == n && strncmp(pattern, name, n) == 0)
        return 1;
    return n - stem == 1 && name[stem] == '0' && m == stem && strncmp(pattern, name, stem) == 0;
}

/* "x# y#: points; w#: weights; t": the entry of the list that means the variable. *noun: what it stands for, *many: whether
 * in the plural.  An entry without a noun means a letter that stands for itself. */
static int find_noun(const char *over, const char *name, size_t n, const char **noun, size_t *length, int *many)
{
    while (over != NULL && *over != '\0') {
        size_t entry = strcspn(over, ";"), colon = strcspn(over, ":;"), m;
        for (const char *p = over; (p = next_word(p, &m)) != NULL && p < over + colon; p += m) {
            size_t in_pattern = strcspn(p, ":; ");
            m = in_pattern > 0 ? in_pattern : 1;
            if (in_pattern > 0 && means(p, m, name, n)) {
                *many = p[m - 1] == '#';
                *noun = colon < entry ? over + colon + 1 + strspn(over + colon + 1, " ") : p;
                *length = colon < entry ? (size_t)(over + entry - *noun) : m - (size_t)*many;
                while (*length > 0 && (*noun)[*length - 1] == ' ')
                    --*length;
                return 1;
            }
        }
        over += entry + (over[entry] == ';');
    }
    return 0; /* in no entry */
}

static void add_variables(scope *s, const claim *c, const type_result *b)
{
    size_t n;
    for (const char *name = b->variables; (name = next_word(name, &n)) != NULL; name += n) {
        const char *noun = NULL;
        size_t length = 0;
        int many = 1, positive = is_among(name, n, b->positive);
        if (!find_noun(c->over, name, n, &noun, &length, &many))
            noun = NULL;
        if (noun == NULL || length != 1 || *noun != '-') /* "s: -": the phrases of the scope say it already */
            meet_quantity(s, noun, length, many, positive, 0);
    }
    for (int k = 0; k < s->kinds; k++)
        s->data[k].claims = 1;
}

/* ---- the scope of a claim --------------------------------------------------------------------------- */

/* The range of the letter of the claim's degrees; "k" is the order, one more than the degree. */
static whole_range range_of(const claim *c, int low, int high)
{
    whole_range r = {.low = low, .high = high};
    const char *letter = c->letter != NULL ? c->letter : "";
    if (strcmp(letter, "k") == 0) {
        r.low -= low > 0 || high < WITHOUT_END; /* k = 0 to 6, where k counts something else than the order */
        r.high -= high < WITHOUT_END;
    } else if (letter[0] != '\0' && strcmp(letter, "n") != 0 && strcmp(letter, "p") != 0) {
        snprintf(r.letter, sizeof r.letter, "%s", letter);
    }
    return r;
}

scope scope_of(const claim_result *r)
{
    const claim *c = r->claim;
    scope s = {.within = c->within};
    number_type t = 0; /* the types stand in the order of their strength */
    while (t < NUMBER_TYPES && !r->by[t].ran)
        t++;
    if (t == NUMBER_TYPES || r->evidence == NO_EVIDENCE)
        return s;
    const type_result *b = &r->by[t];
    evidence computed = evidence_of(c, t);
    if (c->all_degrees)
        meet_range(&s, range_of(c, c->degree_low, WITHOUT_END));
    else if (b->degree_high > 0)
        meet_range(&s, range_of(c, b->degree_low, b->degree_high));
    add_phrases(&s.said, c->scope);
    add_phrases(&s.where, c->where);
    if (computed == PROVED && b->variables != NULL)
        add_variables(&s, c, b);
    else if (computed == SAMPLED || computed == MEASURED || computed == ENCLOSED)
        s.instances = b->cases;
    else if (s.ranges == 0 && s.said.count == 0 && s.where.count == 0)
        add_phrase(&s.said, "the stated instance", strlen("the stated instance"));
    return s;
}

/* ---- in words --------------------------------------------------------------------------------------- */

static void put_range(FILE *out, const whole_range *r, const char *letter)
{
    int is_degree = r->letter[0] == '\0',
        is_order = is_degree && (strcmp(letter, "k") == 0 || strcmp(letter, "order") == 0);
    int endless = r->high == WITHOUT_END;
    int low = r->low + (is_order && !(endless && r->low == 0)), high = r->high + (is_order && !endless);
    const char *name = is_degree ? letter : r->letter;
    const char *is = is_degree && letter[1] != '\0' ? "" : "= "; /* "degree 3" */
    if (low > high)
        fprintf(out, "no %s", name);
    else if (low == high)
        fprintf(out, "%s %s%d", name, is, low);
    else if (!endless)
        fprintf(out, "%s %s%d to %d", name, is, low, high);
    else if (low > 0)
        fprintf(out, "every %s from %d on", name, low);
    else
        fprintf(out, "every %s", name);
}

/* Whether a phrase says for which values of a letter of the field: "0 < t < 1" does for t, "every β > 1" and "$\beta>1$" for
 * beta. */
static int has_relation_of(const phrases *list, const char *noun)
{
    static const char *const relations[] = {"<", ">", "≤", "≥", "\\le", "\\ge"};
    for (int k = 0; k < list->count; k++) {
        const char *phrase = list->at[k];
        int is_relation = strncmp(phrase, "every ", 6) == 0;
        for (size_t r = 0; r < sizeof relations / sizeof *relations; r++)
            is_relation |= strstr(phrase, relations[r]) != NULL;
        if (is_relation && (has_letter(phrase, noun) || has_letter(phrase, letter_in_print(noun))))
            return 1;
    }
    return 0;
}

/* Whether a phrase says which they are: "the distinct knots variables up to order 5, numbers above" does of the knots and of
 * their gaps, which are then not all of them. */
static int has_definite_phrase(const phrases *list, const char *noun)
{
    const char *last = strrchr(noun, ' ');
    last = last != NULL ? last + 1 : noun;
    for (int k = 0; k < list->count; k++)
        if (strncmp(list->at[k], "the ", 4) == 0 && is_among(last, strlen(last), list->at[k]))
            return 1;
    return 0;
}

/* Whether another claim has some of them only: "equal weights" of the weights. */
static int has_narrower_noun(const scope *s, const char *noun)
{
    static const char narrower[] = "equal ";
    for (int k = 0; k < s->kinds; k++) {
        const char *other = s->data[k].noun;
        if (other != NULL && strncmp(other, narrower, strlen(narrower)) == 0 &&
            strcmp(other + strlen(narrower), noun) == 0)
            return 1;
    }
    return 0;
}

/* Whether a phrase or another noun says already for which values of it. */
static int is_told(const scope *s, const quantity *q)
{
    if (q->noun == NULL)
        return 0;
    if (q->many)
        return has_definite_phrase(&s->said, q->noun) || has_narrower_noun(s, q->noun);
    return has_relation_of(&s->said, q->noun) || has_relation_of(&s->where, q->noun);
}

/* Whether the data, when they are positive, meet the condition: "the weights are positive" of weights, and what is within it. */
static int is_positivity_of(const scope *s, const char *condition, const quantity *q)
{
    char text[80] = "";
    if (q->many && q->noun != NULL)
        snprintf(text, sizeof text, "the %s are positive", q->noun);
    return text[0] != '\0' && is_within(s->within, text, condition);
}

/* Whether a condition says it, or what was run. */
static int is_positive(const scope *s, const quantity *q)
{
    for (int k = 0; k < s->where.count; k++)
        if (is_positivity_of(&(scope){0}, s->where.at[k], q))
            return 1;
    return q->positive;
}

/* Whether there are so many kinds of data, of which no claim has all, that no reader knows what a list is about. */
static int are_too_many(const scope *s)
{
    enum { READABLE = 4 };
    int count = 0;
    for (int k = 0; k < s->kinds; k++)
        count += !is_told(s, &s->data[k]);
    return s->mixed && count > READABLE;
}

/* Whether data are put among those that are many or single, positive or not: a letter is not of which a phrase speaks; and of
 * too many those are that several claims have. */
static int is_put_among(const scope *s, const quantity *q, int many, int positive)
{
    return q->noun != NULL && q->many == many && is_positive(s, q) == positive && !is_told(s, q) &&
           (!are_too_many(s) || q->claims > 1);
}

/* "all points and weights": the named data that are many or single, positive or not. */
static int put_nouns(FILE *out, const scope *s, int many, int positive, int first)
{
    int count = 0, put = 0;
    for (int k = 0; k < s->kinds; k++)
        count += is_put_among(s, &s->data[k], many, positive);
    for (int k = 0; k < s->kinds && count > 0; k++)
        if (is_put_among(s, &s->data[k], many, positive)) {
            if (put == 0)
                fprintf(out, "%s%s%s", first ? "" : ", ", many ? "all" : "every", positive ? " positive" : "");
            fprintf(out, "%s %s", put == 0 ? "" : put + 1 == count ? " and" : ",", letter_in_print(s->data[k].noun));
            put++;
        }
    return first && count == 0;
}

/* Returns whether there was anything to say. */
static int put_data(FILE *out, const scope *s)
{
    int first = put_nouns(out, s, 1, 0, 1);
    first = put_nouns(out, s, 1, 1, first);
    first = put_nouns(out, s, 0, 0, first);
    first = put_nouns(out, s, 0, 1, first);
    for (int k = 0; k < s->kinds; k++)
        if (s->data[k].noun == NULL && (!are_too_many(s) || s->data[k].claims > 1)) {
            fprintf(out, "%sall %s%sdata", first ? "" : ", ", first ? "" : "other ",
                    s->data[k].positive ? "positive " : "");
            first = 0;
        }
    if (are_too_many(s))
        fprintf(out, "%seach step for its own %sdata", first ? "" : "; ", first ? "" : "other ");
    return !first || are_too_many(s);
}

/* What follows is behind "; " unless it is the first. */
static void put_between(FILE *out) { fputs(ftell(out) > 0 ? "; " : "", out); }

/* Whether data are told to be positive, and so meet the condition. */
static int is_among_data(const scope *s, const char *condition)
{
    for (int k = 0; k < s->kinds; k++)
        if (is_positivity_of(s, condition, &s->data[k]) && is_put_among(s, &s->data[k], 1, 1))
            return 1;
    return 0;
}

/* The next sign of a phrase as it is read, whether in TeX or in the letters of a text: blanks, dollars and the marks of indices
 * are none.  0 at the end. */
static int next_sign(const char **at)
{
    static const char *const written[][2] = {{"\\le", "≤"}, {"\\ge", "≥"}, {"\\ne", "≠"}, {"₀", "0"}, {"₁", "1"}};
    *at += strspn(*at, " $_");
    for (size_t k = 0; k < sizeof written / sizeof *written; k++)
        for (int w = 0; w < 2; w++)
            if (strncmp(*at, written[k][w], strlen(written[k][w])) == 0) {
                *at += strlen(written[k][w]);
                return 256 + (int)k;
            }
    return **at != '\0' ? (unsigned char)*(*at)++ : 0;
}

/* Whether a phrase of the scope is narrower than the condition, or reads the same: "0 ≤ t ≤ 1" and "$0\le t\le1$". */
static int is_said(const scope *s, const char *condition)
{
    for (int k = 0; k < s->said.count; k++) {
        const char *a = condition, *b = s->said.at[k];
        int x, y;
        if (is_within(s->within, b, a))
            return 1;
        do
            x = next_sign(&a), y = next_sign(&b);
        while (x == y && x != 0);
        if (x == y)
            return 1;
    }
    return 0;
}

/* "all points and weights, where ω ≠ 0, and 0 < t < 1"; of cases that are not told, every condition. */
static void put_conditions(FILE *out, const scope *s, int behind_data)
{
    int put = 0;
    for (int k = 0; k < s->where.count; k++) {
        if (!s->apart && (is_among_data(s, s->where.at[k]) || is_said(s, s->where.at[k])))
            continue;
        if (put == 0 && !behind_data)
            put_between(out);
        fprintf(out, "%s%s", put > 0 ? ", and " : behind_data ? ", where " : "where ", s->where.at[k]);
        put++;
    }
}

/* "each step for its own cases (simple knots; 0 < t < 1)": what the steps ask of their cases, as far as that is few. */
static void put_cases_of_steps(FILE *out, const scope *s)
{
    enum { FEW = 3 };
    put_between(out);
    fputs("each step for its own cases", out);
    for (int k = 0; k < s->said.count && s->said.count <= FEW; k++)
        fprintf(out, "%s%s", k == 0 ? " (" : "; ", s->said.at[k]);
    if (s->said.count > 0 && s->said.count <= FEW)
        fputs(")", out);
}

void add_condition(scope *s, const char *condition)
{
    const phrases one = {(char *[]){(char *)condition}, 1};
    if (condition != NULL && condition[0] != '\0')
        meet_phrases(&s->where, &one, s->within);
}

char *scope_words(const scope *s, const char *letter)
{
    char *text = NULL, *data = NULL;
    size_t room = 0, of_data = 0;
    FILE *out = text_open(&text, &room), *all = text_open(&data, &of_data);
    int any_data = put_data(all, s);
    text_close(all, &data);
    for (int k = 0; k < s->ranges; k++) {
        if (s->apart && s->range[k].letter[0] != '\0')
            continue;
        put_between(out);
        put_range(out, &s->range[k], letter);
    }
    for (int k = 0; k < s->said.count && !s->apart; k++) {
        put_between(out);
        fputs(s->said.at[k], out);
    }
    if (any_data && !s->apart) {
        put_between(out);
        fputs(data, out);
    }
    if (s->apart)
        put_cases_of_steps(out, s);
    put_conditions(out, s, any_data || s->apart);
    if (s->instances > 0) {
        put_between(out);
        fprintf(out, "%d random instances", s->instances);
    }
    text_close(out, &text);
    free(data);
    return text;
}
