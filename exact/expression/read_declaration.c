/* read_declaration.c -- lines that say what names mean. */
#include "exact/expression/depends.h"
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

/* A name as it is declared: its indices are letters or numbers. */
const cagd_tree *cagd_read_declared_name(cagd_reader *r)
{
    if (!cagd_begins_name(r))
        return NULL;
    r->declaring = 1;
    const cagd_tree *t = cagd_read_name(r);
    r->declaring = 0;
    return t != NULL && t->kind == CAGD_NAME ? t : NULL;
}

/* ---- definitions --------------------------------------------------------------------------------------- */

/* Whether it fits whatever is given, so that nothing behind it is ever taken. */
static int fits_always(const cagd_definition *d)
{
    for (int k = 0; k < d->left->count; k++)
        if (d->left->at[k]->kind == CAGD_NUMBER || cagd_same_index(d->left, k) >= 0)
            return 0;
    return d->when == NULL;
}

/* Whether it fits wherever a definition of `left` would, which is then never taken: Q_0(t) and Q_0(s). */
static int takes_all_of(const cagd_definition *d, const cagd_tree *left)
{
    if (d->when != NULL || d->left->count != left->count || d->left->lower != left->lower)
        return 0;
    for (int k = 0; k < left->count; k++) {
        const cagd_tree *a = d->left->at[k], *b = left->at[k];
        if (cagd_same_index(d->left, k) >= 0 || (a->kind == CAGD_NUMBER && !cagd_tree_equal(a, b)))
            return 0;
    }
    return 1;
}

/* Letters and numbers; a letter stands there twice where indices are equal, as in b_{n,n}(t), if `may_repeat`, and else once.  Arguments are
 * letters.  As often as the same name was defined with. */
int cagd_is_left_side(cagd_reader *r, const cagd_tree *left, int may_repeat)
{
    for (int k = 0; k < left->count; k++) {
        const cagd_tree *t = left->at[k];
        int letter = t->kind == CAGD_NAME && t->count == 0, index = k < left->lower + left->upper;
        if (!letter && !(index && t->kind == CAGD_NUMBER))
            return cagd_refuse_tree(r, t, "on the left of a definition %s",
                                    index ? "an index is a letter or a number" : "an argument is a letter") != NULL;
        for (int m = 0; letter && !(index && may_repeat) && m < k; m++)
            if (left->at[m]->kind == CAGD_NAME && strcmp(left->at[m]->head, t->head) == 0)
                return cagd_refuse_tree(r, t,
                                        "the letter %s stands there twice: take another one, and say where they are "
                                        "equal behind \\quad",
                                        t->head) != NULL;
    }
    if (left->upper > 0 && left->lower + left->arguments == 0)
        return cagd_refuse_tree(r, left, "a power is no name: define %s", cagd_spelled(left->head)) != NULL;
    for (const cagd_definition *d = r->scope->definitions; d != NULL; d = d->next)
        if (strcmp(d->left->head, left->head) == 0 && fits_always(d))
            return cagd_refuse_tree(r, left, "%s was defined already, for all indices and arguments",
                                    cagd_spelled(left->head)) != NULL;
        else if (strcmp(d->left->head, left->head) == 0 && takes_all_of(d, left))
            return cagd_refuse_tree(r, left, "it was defined already, so that this line would mean nothing") != NULL;
    const cagd_definition *d = cagd_defined(r->scope, left->head);
    if (d != NULL &&
        (d->left->lower != left->lower || d->left->upper != left->upper || d->left->arguments != left->arguments))
        return cagd_refuse_tree(r, left, "%s was defined with %d lower, %d upper indices and %d arguments",
                                cagd_spelled(left->head), d->left->lower, d->left->upper, d->left->arguments) != NULL;
    return 1;
}

/* "=", or ":=". */
static int is_equal_sign(const cagd_token *t) { return strcmp(t->word, "=") == 0 || strcmp(t->word, ":=") == 0; }

/* Whether a function with its arguments and "=" come next: another definition. */
static int next_definition(const cagd_reader *r)
{
    const cagd_token *t = r->token;
    int depth = 0, has_arguments = 0;
    if (!cagd_begins_name(r))
        return 0;
    for (; t->kind != CAGD_TOKEN_END && (depth > 0 || strchr("=<>,:", t->word[0]) == NULL); t++) {
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        has_arguments |= strcmp(t->word, "(") == 0;
    }
    return has_arguments && is_equal_sign(t) && strcmp(t[-1].word, ")") == 0;
}

/* Whether the name is one of many, without arguments, w_0. */
static int is_one_of_those(const cagd_tree *name)
{
    int is = name->kind == CAGD_NAME && name->lower > 0 && name->arguments + name->upper == 0;
    for (int k = 0; k < name->count && is; k++)
        is = name->at[k]->kind == CAGD_NUMBER;
    return is;
}

/* Whether another one of those that are called so and "=" come next, w_1 = \frac12 behind w_0 = 1: it has its own value. */
static int next_of_those(const cagd_reader *r, const char *head)
{
    cagd_reader at = *r;
    cagd_reading_error none = {0};
    if (head == NULL || !cagd_begins_name(r))
        return 0;
    at.error = &none;
    const cagd_tree *name = cagd_read_declared_name(&at);
    return name != NULL && strcmp(name->head, head) == 0 && is_one_of_those(name) && is_equal_sign(at.token);
}

int cagd_next_is_other_definition(const cagd_reader *r)
{
    cagd_reader at = *r;
    cagd_reading_error none = {0};
    if (r->defines != NULL && next_of_those(r, r->defines_one_of))
        return 1;
    if (r->defines == NULL || !next_definition(r))
        return 0;
    at.error = &none;
    const cagd_tree *name = cagd_read_declared_name(&at);
    return name != NULL && (strcmp(name->head, r->defines) == 0 || !cagd_is_known(r, name->head));
}

/* What stands behind the comma of a definition: conditions, ranges of indices and intervals, with commas between; another definition may follow it. */
static const cagd_tree *condition(cagd_reader *r)
{
    r->lists++, r->premises++;
    const cagd_tree *first = cagd_next_is_member(r) ? cagd_read_members(r) : cagd_read_alternatives(r);
    r->lists--, r->premises--;
    if (first == NULL)
        return NULL;
    int more = cagd_next_is_member(r) || ((cagd_pass(r, ",") || cagd_pass(r, ";")) &&
                                          r->token->kind != CAGD_TOKEN_END && !cagd_next_is_other_definition(r));
    return more ? cagd_new_of(r, CAGD_ALL, first->from, 2, (const cagd_tree *[]){first, condition(r)}) : first;
}

static int definition(cagd_reader *r, cagd_scope *scope);

/* Whether all names of t are letters that are indices of the left side by themselves. */
static int is_of_indices(const cagd_tree *left, const cagd_tree *t)
{
    int is = t->kind != CAGD_NAME;
    for (int k = 0; !is && t->count == 0 && k < left->lower + left->upper; k++)
        is = left->at[k]->kind == CAGD_NAME && strcmp(left->at[k]->head, t->head) == 0;
    for (int k = 0; is && k < t->count; k++)
        is = is_of_indices(left, t->at[k]);
    return is;
}

int cagd_is_last_index(const cagd_scope *scope, const char *letter)
{
    const cagd_variable *v = cagd_declared(scope, letter);
    return v != NULL && v->whole && cagd_is_called_as_last(letter);
}

/* \omega_n, where n = 3 or n = 1, 2, 3: one of them. */
static int is_certain_index(const cagd_scope *scope, const cagd_tree *t)
{
    return t->kind == CAGD_NAME && t->count == 0 &&
           (cagd_has_value(scope, t->head) || cagd_is_last_index(scope, t->head));
}

/* Whether an index is a letter with a value: n = 2, a_n = 0. */
static int has_known_index(const cagd_scope *scope, const cagd_tree *name)
{
    int has = 0;
    for (int k = 0; k < name->lower + name->upper; k++)
        has |= name->at[k]->kind == CAGD_NAME && name->at[k]->count == 0 && cagd_has_value(scope, name->at[k]->head);
    return has;
}

/* D_{\lfloor n/2 \rfloor}^n: an index that the others give becomes a letter that no text has, and *given the condition that it is that.  So does n in \omega_n, where
 * it is a certain index in `scope`, which may be NULL. */
const cagd_tree *cagd_with_given_indices(cagd_reader *r, const cagd_scope *scope, const cagd_tree *left,
                                         const cagd_tree **given)
{
    static const char *const letters[2 * CAGD_MOST_INDICES] = {"index 1", "index 2", "index 3", "index 4",
                                                               "index 5", "index 6", "index 7", "index 8"};
    static const cagd_relation equal[] = {CAGD_EQUAL};
    const cagd_tree *condition[2 * CAGD_MOST_INDICES];
    int count = 0;
    cagd_tree *copy = cagd_new(r, CAGD_NAME, left->from, left->count);
    if (copy == NULL)
        return NULL;
    const cagd_tree **at = copy->at;
    *copy = *left, copy->at = at;
    for (int k = 0; k < left->count; k++) {
        const cagd_tree *t = at[k] = left->at[k];
        int is_certain = scope != NULL && is_certain_index(scope, t);
        if (k >= left->lower + left->upper ||
            (!is_certain && (t->kind == CAGD_NAME || t->kind == CAGD_NUMBER || !is_of_indices(left, t))))
            continue;
        cagd_tree *letter = cagd_new(r, CAGD_NAME, t->from, 0);
        if (letter == NULL)
            return NULL;
        letter->head = letters[count], letter->to = t->to, at[k] = letter;
        condition[count++] = cagd_relate(r, t->from, 2, (const cagd_tree *[]){letter, t}, equal);
    }
    *given = count == 0 ? NULL : count == 1 ? condition[0] : cagd_new_of(r, CAGD_ALL, left->from, count, condition);
    return count == 0 ? left : *given != NULL ? copy : NULL;
}

/* Whether an index is a number, or the same letter as another one. */
static int has_index_of_its_own(const cagd_tree *left)
{
    for (int k = 0; k < left->count; k++)
        if (left->at[k]->kind == CAGD_NUMBER || cagd_same_index(left, k) >= 0)
            return 1;
    return 0;
}

/* f_i(t) = ..., \quad 0 \le i \le 1: i, by its letter, is a whole number there, too, where the index is not. */
static const cagd_tree *with_whole_indices(cagd_reader *r, const cagd_tree *left, const cagd_tree *when)
{
    const cagd_tree *list[2 * CAGD_MOST_INDICES + 1] = {when};
    int count = 1;
    for (int k = 0; k < left->lower + left->upper; k++)
        if (left->at[k]->kind == CAGD_NAME && cagd_is_usual_index(left->at[k]->head) &&
            cagd_tree_has(when, left->at[k]->head) && (list[count++] = cagd_is_whole(r, left->at[k])) == NULL)
            return NULL;
    return count == 1 ? when : cagd_new_of(r, CAGD_ALL, when->from, count, list);
}

/* Whether the letter stands in t by itself, and is not that of a sum or an integral there. */
static int has_free(const cagd_tree *t, const char *letter)
{
    int is_letter = t->head != NULL && strcmp(t->head, letter) == 0;
    if (t->kind == CAGD_NAME ? is_letter && t->count == 0 : is_letter && t->kind != CAGD_DERIVATIVE)
        return t->kind == CAGD_NAME;
    for (int k = 0; k < t->count; k++)
        if (has_free(t->at[k], letter))
            return 1;
    return 0;
}

/* The first name in t whose definition has the letter, which is none of its own: G in t G, where G = t^2 is; NULL where there is none. */
static const cagd_tree *hides(const cagd_scope *scope, const cagd_tree *t, const char *letter)
{
    for (const cagd_definition *d = t->kind == CAGD_NAME ? scope->definitions : NULL; d != NULL; d = d->next) {
        int own = 0;
        for (int k = 0; k < d->left->count; k++)
            own |= d->left->at[k]->kind == CAGD_NAME && strcmp(d->left->at[k]->head, letter) == 0;
        if (strcmp(d->left->head, t->head) == 0 && !own && d->body != NULL && has_free(d->body, letter))
            return t;
    }
    const cagd_tree *found = NULL;
    for (int k = 0; k < t->count && found == NULL; k++)
        found = hides(scope, t->at[k], letter);
    return found;
}

/* An argument of the left side is asked for where it stands in another definition, too, that is no function of it. */
static int hides_no_argument(cagd_reader *r, const cagd_tree *left, const cagd_tree *body)
{
    for (int k = left->lower + left->upper; k < left->count; k++) {
        const cagd_tree *name = hides(r->scope, body, left->at[k]->head);
        if (name != NULL)
            return cagd_refuse_tree(r, name,
                                    "%s was defined with %s, and not as its function: is that the argument on the left "
                                    "here? write %s(%s), or take another "
                                    "letter",
                                    cagd_spelled(name->head), left->at[k]->head, cagd_spelled(name->head),
                                    left->at[k]->head) != NULL;
    }
    return 1;
}

/* The right side of a definition, in which the arguments of the left side are known, and what stands behind it; `given`: NULL, or a
 * condition of the left side; `one_of`: how those are called of which it is one, or NULL. */
static int right_side(cagd_reader *r, cagd_scope *scope, const cagd_tree *left, const cagd_tree *given,
                      const char *one_of)
{
    struct cagd_bound bound[CAGD_MOST_CHILDREN];
    const struct cagd_bound *outside = r->bound;
    for (int k = 0; k < left->count; k++)
        if (left->at[k]->kind == CAGD_NAME) {
            bound[k] = (struct cagd_bound){left->at[k]->head, r->bound, 0};
            r->bound = &bound[k];
        }
    int is_first = cagd_defined(scope, left->head) == NULL;
    cagd_definition *d = cagd_define(scope, left);
    for (int k = left->lower + left->upper; d != NULL && k < left->count; k++) {
        int arity = cagd_arity_of_argument(r, left->at[k]->head);
        if (arity == 0)
            continue;
        if (!is_first || k >= 32 || has_index_of_its_own(left) || (d->functions != 0 && d->arity != arity))
            return cagd_refuse_tree(
                       r, left->at[k],
                       "%s is a function there: such a definition stands alone, and its indices are letters",
                       left->at[k]->head) != NULL;
        d->functions |= 1u << k, d->arity = bound[k].arity = arity;
    }
    r->defining++;
    const cagd_tree *body = d != NULL ? cagd_read_sum(r) : NULL;
    int read = body != NULL;
    if (read) {
        d->body = body, d->dimension = body->dimension;
        int bracket = cagd_is_truth_in_brackets(r); /* f(t) = t^2 \quad (0 \le t \le 1) */
        if (cagd_pass(r, ",") || cagd_next_is(r, "\\text") || bracket) {
            const cagd_token *here = r->token;
            const char *words = cagd_read_words(r);
            if (words != NULL && !cagd_are_words_of_range(words) && r->token->kind != CAGD_TOKEN_END) {
                r->token = here;
                return cagd_refuse_words(r, words) != NULL;
            }
            if (words != NULL && cagd_parity_of_words(words) != 0) { /* for even i \ge 2 */
                if ((d->when = cagd_is_of_parity(r, cagd_parity_of_words(words))) == NULL)
                    return 0;
                r->token += r->token[1].kind == CAGD_TOKEN_END;
            }
            bracket = cagd_is_truth_in_brackets(r) && cagd_pass(r, "(");
            r->defines = left->head, r->defines_one_of = one_of;
            if (r->token->kind != CAGD_TOKEN_END && !next_definition(r) && !next_of_those(r, one_of)) {
                const cagd_tree *both[2] = {d->when, condition(r)};
                d->when = both[0] == NULL   ? both[1]
                          : both[1] == NULL ? NULL
                                            : cagd_new_of(r, CAGD_ALL, both[0]->from, 2, both);
                read = d->when != NULL && (!bracket || cagd_expect(r, ")", "the condition"));
            }
            r->defines = r->defines_one_of = NULL;
        }
    }
    read = read && hides_no_argument(r, left, body);
    if (read && d->when != NULL)
        read = (d->when = with_whole_indices(r, left, d->when)) != NULL;
    if (read && given != NULL)
        d->when =
            d->when == NULL ? given : cagd_new_of(r, CAGD_ALL, left->from, 2, (const cagd_tree *[]){given, d->when});
    r->defining--;
    r->bound = outside;
    return read && (given == NULL || d->when != NULL);
}

static int definition(cagd_reader *r, cagd_scope *scope)
{
    r->declaring = 1;
    const cagd_tree *left = cagd_read_name(r);
    r->declaring = 0;
    if (left == NULL)
        return 0;
    if (left->kind != CAGD_NAME)
        return cagd_refuse_tree(r, left, "the left side of a definition is a name with its indices and arguments") !=
               NULL;
    const cagd_tree *given = NULL;
    int is_value = left->arguments == 0 && (cagd_declared(scope, left->head) != NULL || has_known_index(scope, left));
    const cagd_tree *as_written = left;
    left = cagd_with_given_indices(r, is_value ? scope : NULL, left, &given);
    if (left == NULL || !cagd_is_left_side(r, left, 1) ||
        (!cagd_pass(r, ":=") && !cagd_expect(r, "=", "the left side")))
        return 0;
    const char *one_of = is_one_of_those(as_written) ? as_written->head : NULL;
    if (!right_side(r, scope, left, given, one_of))
        return 0;
    const cagd_definition *last = cagd_defined(scope, left->head);
    while (last != NULL && last->next != NULL)
        last = last->next;
    if (is_value && last != NULL && last->when == given && cagd_refuse_degree(r, scope, as_written, last->body))
        return 0;
    return !(next_definition(r) || next_of_those(r, one_of)) || definition(r, scope);
}

static int is_zero_over_zero(const cagd_token *t)
{
    static const char *const written[][8] = {
        {"0", "/", "0", NULL}, {"\\frac", "{", "0", "}", "{", "0", "}", NULL}, {"\\frac", "00", NULL}};
    for (int k = 0; k < 3; k++) {
        int m = 0;
        while (written[k][m] != NULL && strcmp(t[m].word, written[k][m]) == 0)
            m++;
        if (written[k][m] == NULL && is_equal_sign(t + m) && strcmp(t[m + 1].word, "0") == 0) /* words may follow */
            return t[m + 2].kind == CAGD_TOKEN_END || strchr(".,;", t[m + 2].word[0]) != NULL ||
                   strcmp(t[m + 2].word, "\\text") == 0;
    }
    return 0;
}

/* Whether the line is "name = ...", and no range: the first relation that stands in no bracket. */
static int is_definition(const cagd_token *t)
{
    const cagd_token *first = t;
    int depth = 0;
    for (; t->kind != CAGD_TOKEN_END; t++) {
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        if (depth == 0 &&
            (strcmp(t->word, "\\in") == 0 || strchr("<>", t->word[0]) != NULL || strcmp(t->word, "\\le") == 0 ||
             strcmp(t->word, "\\ge") == 0 || strcmp(t->word, "\\ne") == 0))
            return 0;
        if (depth == 0 && is_equal_sign(t))
            break;
    }
    if (t > first + 1 || strcmp(t->word, ":=") == 0) /* the name of a range is a letter */
        return 1;
    for (int inner = 0; t->kind != CAGD_TOKEN_END; t++) {
        inner += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        if (inner == 0 && strcmp(t->word, "\\dots") == 0)
            return strchr("+-*", t[-1].word[0]) != NULL; /* or what is left out of a sum or product */
    }
    return 1;
}

/* Whether a \quad ends before the token. */
static int is_behind_quad(const cagd_reader *r, const cagd_token *t)
{
    int at = t->from;
    while (at > 0 && r->text[at - 1] == ' ')
        at--;
    return at >= 4 && memcmp(r->text + at - 4, "quad", 4) == 0;
}

/* \quad (n \ge 3) at the end of a definition is read as \quad, n \ge 3. */
static void open_last_bracket(const cagd_reader *r)
{
    int depth = 0, relations = 0;
    cagd_token *first = (cagd_token *)r->token, *last = first, *t; /* they are this reader's own */
    while (last->kind != CAGD_TOKEN_END)
        last++;
    if (last == first || strcmp((--last)->word, ")") != 0)
        return;
    for (t = last; t > first; t--) {
        depth += (strchr(")}]", t->word[0]) != NULL) - (strchr("({[", t->word[0]) != NULL);
        if (depth == 0)
            break;
        cagd_reader here = *r;
        cagd_relation relation;
        here.token = t;
        relations += depth == 1 && (cagd_relation_next(&here, &relation) || cagd_next_is(&here, "\\in"));
    }
    if (t == first || relations == 0 || !is_behind_quad(r, t))
        return;
    t->word = ",", last->kind = CAGD_TOKEN_END;
}

/* Where the first definition of the line ends, "," or \text{where}, and the second one begins; 0 where there is one alone. */
static int second_definition(cagd_reader *r, int *end)
{
    int depth = 0;
    for (; r->token->kind != CAGD_TOKEN_END; r->token++) {
        const cagd_token *at = r->token;
        depth += (strchr("({[", at->word[0]) != NULL) - (strchr(")}]", at->word[0]) != NULL);
        if (depth != 0 || (!cagd_next_is(r, ",") && !cagd_next_is(r, "\\text")))
            continue;
        *end = at->from;
        cagd_pass(r, ",");
        const char *words = cagd_read_words(r);
        if (next_definition(r) && (words == NULL || cagd_are_words_of_range(words)))
            return r->token->from;
        r->token = at;
    }
    return 0;
}

/* Two definitions, K_n(f;x) = \sum p_{n,k}(x) ..., \quad p_{n,k}(x) = ..., of which the first has the second in it: that is read before it. */
static int in_other_order(cagd_scope *scope, const char *text, int from, int to)
{
    cagd_reader r;
    cagd_reading_error error;
    int end, begin = cagd_reader_open(&r, scope, text, from, to, &error) && is_definition(r.token)
                         ? second_definition(&r, &end)
                         : 0;
    return begin > 0 && cagd_read_definition(scope, text, begin, to, &error) &&
           cagd_read_definition(scope, text, from, end, &error);
}

int cagd_read_definition(cagd_scope *scope, const char *text, int from, int to, cagd_reading_error *error)
{
    cagd_reader r;
    cagd_scope before = *scope;
    if (!cagd_reader_open(&r, scope, text, from, to, error))
        return 0;
    r.defining = 1;
    if (is_zero_over_zero(r.token)) {
        scope->zero_over_zero = 1;
        return 1;
    }
    if (is_definition(r.token) && cagd_next_is(&r, "["))
        return cagd_refuse_token(&r, "[n]_q and [n]_{p,q} are known: what begins so is no definition") != NULL;
    if (is_definition(r.token))
        open_last_bracket(&r);
    int good = is_definition(r.token) ? definition(&r, scope) : cagd_read_list_of_ranges(&r, scope, &before);
    if (good && (cagd_pass(&r, "."), r.token->kind != CAGD_TOKEN_END))
        good = cagd_refuse_token(&r, "expected the end of the line, not %s", cagd_name_of_next(&r)) != NULL;
    if (!good) {
        *scope = before;
        good = strstr(error->message, " is not defined") != NULL && in_other_order(scope, text, from, to);
    }
    if (!good)
        *scope = before;
    return good;
}

/* The names that a line defines, one for each of its rows and definitions behind one another; their number. */
enum { MOST_DEFINED = CAGD_MOST_CHILDREN };
static int defined_names(const cagd_scope *scope, const char *text, int from, int to, const char *head[MOST_DEFINED])
{
    cagd_reader r;
    cagd_reading_error none;
    int count = 0, depth = 0, begins = 1;
    if (!cagd_reader_open(&r, scope, text, from, to, &none) || !is_definition(r.token))
        return 0;
    for (const cagd_token *t = r.token; t->kind != CAGD_TOKEN_END && count < MOST_DEFINED; t++) {
        r.token = t;
        none = (cagd_reading_error){0};
        const cagd_tree *name = begins && depth == 0 ? cagd_read_declared_name(&r) : NULL;
        if (name != NULL && is_equal_sign(r.token) && (count == 0 || name->arguments > 0))
            head[count++] = name->head;
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        begins = strcmp(t->word, ",") == 0 || strcmp(t->word, ";") == 0 || strcmp(t->word, "}") == 0;
    }
    return count;
}

int cagd_define_same(const cagd_scope *scope, const char *text, int from, int to, int other, int other_to)
{
    const char *head[MOST_DEFINED], *others[MOST_DEFINED];
    int count = defined_names(scope, text, from, to, head), more = defined_names(scope, text, other, other_to, others);
    for (int k = 0; k < count; k++)
        for (int m = 0; m < more; m++)
            if (strcmp(head[k], others[m]) == 0)
                return 1;
    return 0;
}

/* Whether the bound has no names but \pi and those of the indices. */
static int is_of_numbers(const cagd_tree *t, const cagd_tree *left)
{
    if (t == NULL)
        return 1;
    for (int k = 0; t->kind == CAGD_NAME && left != NULL && k < left->count; k++)
        if (left->at[k]->kind == CAGD_NAME && strcmp(left->at[k]->head, t->head) == 0)
            return 1;
    for (int k = 0; k < t->count; k++)
        if (!is_of_numbers(t->at[k], left))
            return 0;
    return t->kind != CAGD_NAME || strcmp(t->head, "\\pi") == 0;
}

int cagd_read_declaration(cagd_scope *scope, const char *text, int from, int to)
{
    cagd_reader r;
    cagd_reading_error error;
    cagd_scope before = *scope;
    if (!cagd_reader_open(&r, scope, text, from, to, &error))
        return 0;
    int good = !is_definition(r.token) && cagd_read_list_of_ranges(&r, scope, &before) &&
               scope->condition_count == before.condition_count && scope->definitions == before.definitions &&
               scope->label_count == before.label_count;
    for (const cagd_variable *v = scope->variables; good && v != before.variables; v = v->next)
        good = !v->whole && is_of_numbers(v->low, v->left) && is_of_numbers(v->high, v->left);
    if (!good)
        *scope = before;
    return good;
}
