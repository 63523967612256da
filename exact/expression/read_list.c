/* read_list.c -- lists of whole numbers, as papers print them.
 *
 *     0, 1, \dots, n      0..n      0(1)n          every number from 0 to n
 *     2, 4, \dots, 2n     0(2)8     n, n-1, \dots, 0
 *     0, 2, 4             0, n
 *
 * With dots it is the arithmetic progression that is shown: all numbers before the dots and behind them are in it.  Where they are in none, as
 * 1, 2, 4, \dots, 64 is not, it is refused. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* What ends a number of a list. */
static int ends_number(const cagd_token *t)
{
    static const char *const ends[] = {"}",      ",",     ";",        "\\}",          ")",
                                       ":",      ".",     "\\\\",     "\\end",        "\\text",
                                       "\\land", "\\lor", "\\forall", "\\Rightarrow", "&"};
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++)
        if (strcmp(t->word, ends[k]) == 0)
            return 1;
    return t->kind == CAGD_TOKEN_END;
}

/* Whether the letter stands for a whole number: one that runs, one that is bound, or one with a value. */
static int is_whole_letter(const cagd_reader *r, const char *letter)
{
    const cagd_variable *v = cagd_declared(r->scope, letter);
    const cagd_definition *d = cagd_defined(r->scope, letter);
    return cagd_is_bound(r, letter) || (d != NULL && d->left->count == 0) || (v != NULL && v->whole);
}

/* Whether names with commas between, of which this is one, are said to be in a set, or to have bounds: n = 3, i, j \in \{0, 1\}. */
static int is_before_set(const cagd_token *t)
{
    while (t->kind == CAGD_TOKEN_LETTER && strcmp(t[1].word, ",") == 0)
        t += 2;
    if (t->kind != CAGD_TOKEN_LETTER)
        return 0;
    const char *word = t[1].word;
    if (strcmp(word, "\\le") == 0 || strcmp(word, "\\ge") == 0 || strchr("<>", word[0]) != NULL)
        return word[0] != '\0';
    return strcmp(word, "\\in") == 0 &&
           (strcmp(t[2].word, "\\{") == 0 || strcmp(t[2].word, "\\N") == 0 || strcmp(t[2].word, "\\mathbb") == 0);
}

/* Whether a whole number of a list comes next: made of numbers and letters of whole numbers, with a comma or the like behind it. */
static int is_number_next(const cagd_reader *r)
{
    const cagd_token *t = r->token;
    if (ends_number(t) || is_before_set(t))
        return 0;
    for (; !ends_number(t); t++) {
        if (t->kind == CAGD_TOKEN_LETTER
                ? !is_whole_letter(r, t->word)
                : t->kind != CAGD_TOKEN_NUMBER && strcmp(t->word, "+") != 0 && strcmp(t->word, "-") != 0)
            return 0;
        if (t->kind == CAGD_TOKEN_NUMBER && strchr(t->word, '.') != NULL)
            return 0;
    }
    return 1;
}

static const cagd_tree *read_end(cagd_reader *r)
{
    r->ends++;
    const cagd_tree *t = cagd_read_sum(r);
    r->ends--;
    return t;
}

static void refuse_geometric(cagd_reader *r, const cagd_tree *first, const cagd_tree *last)
{
    cagd_refuse_reading(r->error, first->from, last->to,
                        "the numbers that are shown do not grow by the same step: write all of them, without dots");
}

/* The step from one to the next of these, if there is one; 0 where some difference is no number, and -1 and the error where they are numbers, but different ones. */
static int common_step(cagd_reader *r, const cagd_tree *const at[], int count, long *step)
{
    long next;
    for (int k = 0; k + 1 < count; k++) {
        if (!cagd_difference_is_number(at[k], at[k + 1], &next))
            return 0;
        if (k > 0 && next != *step)
            return refuse_geometric(r, at[0], at[count - 1]), -1;
        *step = next;
    }
    return 1;
}

/* A letter that is not known, for a proposal. */
static const char *free_letter(const cagd_reader *r)
{
    static const char *const letters[] = {"m", "k", "j", "l", "r", "s"};
    for (size_t k = 0; k < sizeof letters / sizeof *letters; k++)
        if (!cagd_is_known(r, letters[k]))
            return letters[k];
    return "m";
}

static int refuse_equal(cagd_reader *r, const cagd_tree *first)
{
    return cagd_refuse_tree(r, first, "the numbers of the list are all the same") != NULL;
}

/* Without an end, by another step than 1: refused with the numbers in the words of those one behind another. */
static int refuse_steps_without_end(cagd_reader *r, const char *letter, const cagd_tree *low, long step)
{
    const char *m = free_letter(r);
    long first = low->kind == CAGD_NUMBER && mpz_fits_sshort_p(mpq_numref(low->number.at))
                     ? mpz_get_si(mpq_numref(low->number.at))
                     : 0;
    if (step == 0)
        return refuse_equal(r, low);
    if (step < 0)
        return cagd_refuse_tree(r, low, "a list that goes down without end") != NULL;
    if (first % step == 0)
        return cagd_refuse_tree(r, low,
                                "a list by steps of %ld without an end: write %s = %ld, %ld, \\dots, \\quad %s = %ld%s",
                                step, m, first / step, first / step + 1, letter, step, m) != NULL;
    return cagd_refuse_tree(r, low,
                            "a list by steps of %ld without an end: write %s = 0, 1, \\dots, \\quad %s = %ld%s + %ld",
                            step, m, letter, step, m, first) != NULL;
}

/* low, ..., high by the step, whose ends are numbers or not: 1; 0 and the error where the end is none of them. */
static int progression(cagd_reader *r, cagd_list *list, const cagd_tree *first, const cagd_tree *shown,
                       const cagd_tree *last, long step)
{
    long all, behind;
    if (cagd_difference_is_number(first, last, &all) && cagd_difference_is_number(shown, last, &behind)) {
        if (step == 0)
            return refuse_equal(r, first);
        if (all % step != 0)
            return cagd_refuse_tree(r, last,
                                    "the last number is none of those that the first ones go to by steps of %ld",
                                    labs(step)) != NULL;
        if (first != shown && (step > 0 ? behind < 0 : behind > 0))
            return cagd_refuse_tree(r, last, "the last number of the list stands before one that is shown") != NULL;
    }
    if (step == 0)
        return refuse_equal(r, first);
    list->low = step > 0 ? first : last, list->high = step > 0 ? last : first;
    list->step = labs(step);
    return 1;
}

/* Behind dots, which are passed: the last number, and perhaps others that go on from it. */
static int read_last(cagd_reader *r, cagd_list *list, const char *letter, const cagd_tree *const at[], int count)
{
    long step = 1, next;
    cagd_relation relation;
    list->is_list = 1;
    const cagd_token *behind = r->token;
    int depth = r->depth, comma = cagd_pass(r, ","), has_step = common_step(r, at, count, &step);
    if (has_step < 0)
        return -1;
    list->low = at[0], list->step = 1;
    if (cagd_pass(r, "\\infty") || r->token->kind == CAGD_TOKEN_END) {
        r->token = r->token->kind == CAGD_TOKEN_END && r->token[-1].word[0] == ',' ? behind : r->token;
        return step == 1 || refuse_steps_without_end(r, letter, at[0], step) ? 1 : -1;
    }
    const cagd_tree *last = read_end(r);
    const cagd_token *next_one = behind + comma;
    if (last == NULL && (!comma || (next_one->kind == CAGD_TOKEN_LETTER && ends_number(next_one + 1) &&
                                    strcmp(next_one[1].word, ",") != 0)))
        return -1;
    if (last == NULL || cagd_relation_next(r, &relation) || cagd_next_is(r, "\\in")) {
        r->token = behind, r->depth = depth;
        *r->error = (cagd_reading_error){0};
        return step == 1 || refuse_steps_without_end(r, letter, at[0], step) ? 1 : -1;
    }
    if (!has_step) {
        cagd_refuse_tree(r, at[1],
                         "what is left out? the numbers before the dots do not say by which steps it goes on");
        return -1;
    }
    const cagd_tree *end = last;
    while (cagd_next_is(r, ",")) { /* 0, 1, \dots, n-1, n */
        const cagd_token *here = r->token++;
        const cagd_tree *more = is_number_next(r) ? read_end(r) : NULL;
        if (more == NULL || !cagd_difference_is_number(end, more, &next) || (count > 1 && next != step) ||
            (count == 1 && labs(next) != 1)) {
            r->token = here;
            break;
        }
        step = next, end = more;
    }
    if (count == 1 && end == last && last->kind == CAGD_NUMBER && cagd_is_zero_q(last->number) &&
        at[0]->kind != CAGD_NUMBER) {
        cagd_refuse_tree(r, last, "does the list go down? write 0 first, and the greatest number last");
        return -1;
    }
    return progression(r, list, at[0], at[count - 1], end, step) ? 1 : -1;
}

/* The step of a(s)b, behind a. */
static long step_in_brackets(const cagd_token *t)
{
    if (strcmp(t->word, "(") != 0 || t[1].kind != CAGD_TOKEN_NUMBER || strlen(t[1].word) > 3 ||
        strchr(t[1].word, '.') != NULL || strcmp(t[2].word, ")") != 0)
        return 0;
    return t[3].kind == CAGD_TOKEN_NUMBER || t[3].kind == CAGD_TOKEN_LETTER ? atol(t[1].word) : 0;
}

/* Whether each of them is a number more or less than the one before it. */
static int differ_by_numbers(const cagd_tree *const at[], int count)
{
    long unused;
    for (int k = 0; k + 1 < count; k++)
        if (!cagd_difference_is_number(at[k], at[k + 1], &unused))
            return 0;
    return 1;
}

static int read_list(cagd_reader *r, const char *letter, cagd_list *list)
{
    const cagd_tree *at[CAGD_MOST_CHILDREN];
    enum { STEP = 3 };
    int count = 0;
    *list = (cagd_list){.step = 1};
    long step =
        r->token->kind == CAGD_TOKEN_NUMBER || r->token->kind == CAGD_TOKEN_LETTER ? step_in_brackets(r->token + 1) : 0;
    if (step > 0) { /* 0(1)n */
        list->is_list = 1;
        list->low = cagd_read_argument(r, 1);
        r->token += list->low != NULL ? STEP : 0;
        const cagd_tree *high = list->low != NULL ? read_end(r) : NULL;
        return high != NULL && progression(r, list, list->low, list->low, high, step) ? 1 : -1;
    }
    int is_number = is_number_next(r);
    list->low = at[count++] = read_end(r);
    if (list->low == NULL)
        return -1;
    const cagd_token *behind = r->token;
    int depth = r->depth, comma = cagd_pass(r, ",");
    if (cagd_pass(r, "\\dots"))
        return read_last(r, list, letter, at, 1);
    while (comma && count < CAGD_MOST_SHOWN) { /* numbers, and dots behind them */
        at[count] = read_end(r);
        if (at[count] == NULL || (count++, !cagd_pass(r, ",")))
            break;
        if (cagd_pass(r, "\\dots")) {
            if (differ_by_numbers(at, count))
                return read_last(r, list, letter, at, count);
            break;
        }
    }
    r->token = behind, r->depth = depth, count = 1;
    *r->error = (cagd_reading_error){0};
    while (is_number && cagd_next_is(r, ",") && count < CAGD_MOST_CHILDREN) {
        const cagd_token *here = r->token++;
        if (!is_number_next(r)) {
            r->token = here;
            break;
        }
        if ((at[count++] = read_end(r)) == NULL)
            return -1;
    }
    if (count == 1)
        return 0;
    long next, ascending = 1;
    for (int k = 0; k + 1 < count; k++)
        ascending &= at[k]->kind == CAGD_NUMBER && at[k + 1]->kind == CAGD_NUMBER &&
                     cagd_difference_is_number(at[k], at[k + 1], &next) && next == 1;
    list->high = at[count - 1];
    if (ascending)
        return 1;
    const cagd_tree **kept = cagd_region_array(count, 1, sizeof *kept);
    if (kept == NULL)
        return cagd_refuse_token(r, "there is no memory for the formula"), -1;
    memcpy(kept, at, (size_t)count * sizeof *kept);
    list->listed = kept, list->count = count;
    return 1;
}

int cagd_is_whole_in_long(const cagd_tree *t, long *value)
{
    if (t->kind != CAGD_NUMBER || !cagd_is_whole_q(t->number) || !mpz_fits_slong_p(mpq_numref(t->number.at)))
        return 0;
    *value = mpz_get_si(mpq_numref(t->number.at));
    return 1;
}

int cagd_read_list(cagd_reader *r, const char *letter, cagd_list *list)
{
    int is_clear = r->error->message[0] == '\0', read = read_list(r, letter, list);
    r->error->of_list = read < 0 && is_clear && list->is_list;
    return read;
}

int cagd_refuse_values(cagd_reader *r, const char *letter)
{
    cagd_reader at = *r;
    cagd_reading_error none = {0};
    at.error = &none;
    const cagd_tree *next = cagd_pass(&at, ",") ? read_end(&at) : NULL;
    if (next == NULL || !ends_number(at.token) || next->kind == CAGD_NAME)
        return 0;
    cagd_refuse_tree(r, next,
                     "a list of values that are not whole numbers: write one statement for each, or as what is "
                     "supposed, \\text{if } %s = ... \\text{ or } %s = ...",
                     letter, letter);
    return r->error->of_list = 1;
}

/* That t, which is made of the name, is a whole number: its floor is t. */
static const cagd_tree *is_whole(cagd_reader *r, const cagd_tree *name, const cagd_tree *t)
{
    static const cagd_relation equal[] = {CAGD_EQUAL};
    const cagd_tree *floor = t != NULL ? cagd_new_of(r, CAGD_FLOOR, name->from, 1, &t) : NULL;
    return floor != NULL ? cagd_relate(r, name->from, 2, (const cagd_tree *[]){floor, t}, equal) : NULL;
}

const cagd_tree *cagd_is_whole(cagd_reader *r, const cagd_tree *name) { return is_whole(r, name, name); }

const cagd_tree *cagd_is_in_list(cagd_reader *r, const cagd_tree *name, const cagd_list *list)
{
    static const cagd_relation equal[] = {CAGD_EQUAL}, from_low[] = {CAGD_GREATER_OR_EQUAL},
                               between[] = {CAGD_LESS_OR_EQUAL, CAGD_LESS_OR_EQUAL};
    const cagd_tree *one[CAGD_MOST_CHILDREN];
    for (int k = 0; k < list->count; k++)
        one[k] = cagd_relate(r, name->from, 2, (const cagd_tree *[]){name, list->listed[k]}, equal);
    if (list->count > 0)
        return cagd_new_of(r, CAGD_ANY, name->from, list->count, one);
    if (list->high == NULL)
        return cagd_relate(r, name->from, 2, (const cagd_tree *[]){name, list->low}, from_low);
    one[0] = cagd_relate(r, name->from, 3, (const cagd_tree *[]){list->low, name, list->high}, between);
    if (list->step == 1)
        return one[0];
    if (!cagd_difference_is_multiple(list->low, list->high, list->step))
        return cagd_refuse_tree(
            r, list->high,
            "is this one of the numbers that the first ones go to by steps of %ld? that depends on the letters in it",
            list->step);
    const cagd_tree *minus = cagd_new_of(r, CAGD_NEGATIVE, name->from, 1, &list->low);
    const cagd_tree *above = cagd_new_of(r, CAGD_SUM, name->from, 2, (const cagd_tree *[]){name, minus});
    const cagd_tree *steps =
        cagd_new_of(r, CAGD_QUOTIENT, name->from, 2,
                    (const cagd_tree *[]){above, cagd_tree_number(list->step, name->from, name->to)});
    one[1] = is_whole(r, name, steps);
    return cagd_new_of(r, CAGD_ALL, name->from, 2, one);
}

const cagd_tree *cagd_read_list_condition(cagd_reader *r)
{
    cagd_list list;
    cagd_reading_error none = {0};
    cagd_reader at = *r;
    at.error = &none;
    if (r->token->kind != CAGD_TOKEN_LETTER || strcmp(r->token[1].word, "=") != 0)
        return NULL;
    at.token += 2;
    int is_list = cagd_read_list(&at, r->token->word, &list);
    if (is_list < 0 && (none.of_list || list.is_list))
        *r->error = none;
    if (is_list <= 0)
        return NULL;
    const cagd_tree *name = cagd_read_name(r);
    r->token = at.token, r->nodes = at.nodes;
    const cagd_tree *is = name != NULL ? cagd_is_in_list(r, name, &list) : NULL;
    const cagd_variable *v = name != NULL ? cagd_declared(r->scope, name->head) : NULL;
    if (is == NULL || list.count > 0 || list.step > 1 || (v != NULL && v->whole && !cagd_is_bound(r, name->head)))
        return is;
    return cagd_new_of(r, CAGD_ALL, name->from, 2, (const cagd_tree *[]){is, is_whole(r, name, name)});
}

/* ---- even and odd -------------------------------------------------------------------------------------- */

int cagd_parity_of_words(const char *words)
{
    static const char *const kinds[] = {"even", "odd"};
    int n = (int)strlen(words);
    while (n > 0 && strchr(" ,.;~", words[n - 1]) != NULL)
        n--;
    for (int k = 0; k < 2; k++) {
        int m = (int)strlen(kinds[k]);
        if (n >= m && memcmp(words + n - m, kinds[k], (size_t)m) == 0 && (n == m || words[n - m - 1] == ' '))
            return k == 0 ? -1 : 1;
    }
    return 0;
}

int cagd_are_words_of_range(const char *words)
{
    static const char *const known[] = {"and",           "for",      "all",  "every", "each",     "any",
                                        "where",         "with",     "if",   "when",  "whenever", "as long as",
                                        "provided that", "provided", "even", "odd"};
    for (;;) {
        size_t k = 0, n = 0;
        words += strspn(words, " ,.;:~\\\n");
        if (*words == '\0')
            return 1;
        for (; k < sizeof known / sizeof *known; k++) {
            n = strlen(known[k]);
            if (tolower((unsigned char)words[0]) == known[k][0] && strncmp(words + 1, known[k] + 1, n - 1) == 0 &&
                !isalpha((unsigned char)words[n]))
                break;
        }
        if (k == sizeof known / sizeof *known)
            return 0;
        words += n;
    }
}

cagd_tree *cagd_refuse_words(cagd_reader *r, const char *words)
{
    cagd_refuse_token(
        r,
        "'%s' is not understood before a range; expected 'for', 'for all', 'where', 'with', 'if', 'when', "
        "'provided that', 'and', 'even' or 'odd'",
        words);
    r->error->of_words = 1;
    return NULL;
}

/* The floor of half of it, twice, and one more where it is odd, is the number itself. */
const cagd_tree *cagd_is_of_parity(cagd_reader *r, int parity)
{
    static const cagd_relation equal[] = {CAGD_EQUAL};
    const cagd_token *letter = r->token;
    if (letter->kind != CAGD_TOKEN_LETTER)
        return cagd_refuse_token(r, "expected the letter of a whole number, not %s", cagd_name_of_next(r));
    if (!is_whole_letter(r, letter->word))
        return cagd_refuse_token(r, "%s is no whole number: say its range, such as :for: %s = 1..8", letter->word,
                                 letter->word);
    int from = letter->from, to = letter->to;
    r->token++; /* trees are made behind a token */
    cagd_tree *name = cagd_new(r, CAGD_NAME, from, 0);
    if (name == NULL)
        return NULL;
    name->head = letter->word;
    const cagd_tree *half =
        cagd_new_of(r, CAGD_QUOTIENT, from, 2, (const cagd_tree *[]){name, cagd_tree_number(2, from, to)});
    const cagd_tree *whole = cagd_new_of(r, CAGD_FLOOR, from, 1, &half);
    const cagd_tree *twice =
        cagd_new_of(r, CAGD_PRODUCT, from, 2, (const cagd_tree *[]){cagd_tree_number(2, from, to), whole});
    const cagd_tree *all =
        parity < 0 ? twice
                   : cagd_new_of(r, CAGD_SUM, from, 2, (const cagd_tree *[]){twice, cagd_tree_number(1, from, to)});
    const cagd_tree *t = all != NULL ? cagd_relate(r, from, 2, (const cagd_tree *[]){name, all}, equal) : NULL;
    r->token = letter;
    return t;
}

/* The kind of the letter that comes next, and what is behind its words. */
static int parity_behind(const cagd_reader *r, const cagd_token **behind)
{
    static const char *const forms[] = {"even", "is even", "odd", "is odd", "be even", "be odd", "are even", "are odd"};
    cagd_reading_error none = {0};
    cagd_reader at = *r;
    at.error = &none;
    if (at.token->kind != CAGD_TOKEN_LETTER)
        return 0;
    at.token++;
    const char *words = cagd_read_words(&at);
    *behind = at.token;
    for (size_t k = 0; words != NULL && k < sizeof forms / sizeof *forms; k++) {
        size_t n = strlen(forms[k]);
        if (strncmp(words, forms[k], n) == 0 && strspn(words + n, " ,.;~") == strlen(words + n))
            return cagd_parity_of_words(words);
    }
    return 0;
}

int cagd_next_is_parity(const cagd_reader *r)
{
    const cagd_token *unused;
    return parity_behind(r, &unused) != 0;
}

const cagd_tree *cagd_read_parity(cagd_reader *r)
{
    const cagd_token *behind;
    int parity = parity_behind(r, &behind);
    const cagd_tree *t = parity != 0 ? cagd_is_of_parity(r, parity) : NULL;
    if (t != NULL) {
        ((cagd_tree *)t)->to = behind[-1].to;
        r->token = behind;
    }
    return t;
}
