#include "exact/expression/scope.h"

#include "exact/words.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

const cagd_definition *cagd_defined(const cagd_scope *scope, const char *head)
{
    const cagd_definition *d = scope->definitions;
    while (d != NULL && strcmp(d->left->head, head) != 0)
        d = d->next;
    return d;
}

const cagd_variable *cagd_declared(const cagd_scope *scope, const char *head)
{
    const cagd_variable *v = scope->variables;
    while (v != NULL && strcmp(v->head, head) != 0)
        v = v->next;
    return v;
}

int cagd_put_key(char key[], int room, const cagd_tree *t, const long index[])
{
    int used = snprintf(key, (size_t)room, "%s", t->head);
    for (int k = 0; k < t->lower + t->upper && used < room; k++) {
        int group = k < t->lower ? t->lower : t->upper, first = k == 0 || k == t->lower,
            last = k + 1 == t->lower || k + 1 == t->lower + t->upper;
        int braces = group > 1 || index[k] < 0 || index[k] > 9;
        used += snprintf(key + used, (size_t)(room - used), "%s%s%ld%s",
                         !first         ? ","
                         : k < t->lower ? ""
                                        : "^",
                         first && braces ? "{" : "", index[k], last && braces ? "}" : "");
    }
    return used;
}

const cagd_variable *cagd_declared_for(const cagd_scope *scope, const cagd_tree *t, const char *key, const long index[],
                                       int (*is_for)(void *data, const cagd_variable *v, const long index[]),
                                       void *data)
{
    const cagd_variable *v = scope->variables;
    while (v != NULL && strcmp(v->head, key) != 0 && (strcmp(v->head, t->head) != 0 || !is_for(data, v, index)))
        v = v->next;
    if (v == NULL || v->left == NULL || strcmp(v->head, key) == 0)
        return v;
    cagd_variable *one = region_bytes(sizeof *one);
    if (one == NULL)
        return NULL;
    *one = *v;
    for (int k = 0; k < v->left->lower + v->left->upper && k < t->lower + t->upper; k++)
        if (v->left->at[k]->kind == CAGD_NAME && v->left->at[k]->count == 0) {
            const char *letter = v->left->at[k]->head;
            one->low = cagd_tree_with(one->low, letter, cagd_tree_number(index[k], t->from, t->to));
            one->high = cagd_tree_with(one->high, letter, cagd_tree_number(index[k], t->from, t->to));
        }
    return one;
}

int cagd_dimension_of(const cagd_scope *scope, const char *head)
{
    const cagd_variable *v = cagd_declared(scope, head);
    int dimension = v != NULL ? v->dimension : 0;
    for (const cagd_definition *d = scope->definitions; d != NULL && dimension == 0; d = d->next)
        if (strcmp(d->left->head, head) == 0)
            dimension = d->dimension;
    return dimension;
}

int cagd_is_label(const cagd_scope *scope, const char *head)
{
    for (int k = 0; k < scope->label_count; k++)
        if (strcmp(scope->labels[k]->head, head) == 0)
            return 1;
    return 0;
}

int cagd_is_parameter(const cagd_scope *scope, const char *head)
{
    for (const cagd_definition *d = scope->definitions; d != NULL; d = d->next)
        for (int k = d->left->lower + d->left->upper; k < d->left->count; k++)
            if (!(k < 32 && (d->functions >> k & 1)) && strcmp(d->left->at[k]->head, head) == 0)
                return 1;
    return 0;
}

/* Levenshtein's distance of two short words; long ones are far from one another. */
static int distance(const char *a, const char *b)
{
    enum { LONGEST = 30 };
    int m = (int)strlen(a), n = (int)strlen(b), row[LONGEST + 1];
    if (m > LONGEST || n > LONGEST)
        return LONGEST;
    for (int j = 0; j <= n; j++)
        row[j] = j;
    for (int i = 1; i <= m; i++) {
        int corner = row[0];
        row[0] = i;
        for (int j = 1; j <= n; j++) {
            int best = corner + (a[i - 1] != b[j - 1]);
            best = row[j] + 1 < best ? row[j] + 1 : best;
            best = row[j - 1] + 1 < best ? row[j - 1] + 1 : best;
            corner = row[j];
            row[j] = best;
        }
    }
    return row[n];
}

/* The letters of a name without its faces, star and indices: "P" of "\\mathbf{P}^*_", "\\omega" of "\\hat{\\omega}_". */
static int letters_of(const char *head, int room, char letters[])
{
    int count = 0;
    for (const char *c = head; *c != '\0' && *c != '_' && *c != '^' && *c != '\'' && count + 1 < room;) {
        int n = 1;
        while (*c == '\\' && ((c[n] >= 'a' && c[n] <= 'z') || (c[n] >= 'A' && c[n] <= 'Z')))
            n++;
        int is_face = *c == '\\' && c[n] == '{';
        for (int k = 0; k < n && !is_face && *c != '{' && *c != '}' && count + 1 < room; k++)
            letters[count++] = c[k];
        c += n;
    }
    letters[count] = '\0';
    return count;
}

enum { FAR_AWAY = 10000, WHOLE = 100 };

/* How far a name that is known is from one that is not: the same letters with other faces or indices are near, then those of which less than
 * half is different; of equal ones the whole names count. */
static int far_from(const char *known, const char *head)
{
    enum { LONGEST = 64 };
    char a[LONGEST], b[LONGEST];
    int m = letters_of(known, LONGEST, a), n = letters_of(head, LONGEST, b);
    int far = distance(a, b),
        is_case = m == 1 && n == 1 && tolower((unsigned char)a[0]) == tolower((unsigned char)b[0]);
    return m > 0 && n > 0 && (2 * far < n || is_case) ? WHOLE * far + distance(known, head) : FAR_AWAY;
}

const char *cagd_nearest(const cagd_scope *scope, const char *head)
{
    const char *nearest = NULL;
    int best = FAR_AWAY;
    for (const cagd_definition *d = scope->definitions; d != NULL; d = d->next) {
        int far = far_from(d->left->head, head);
        if (far < best)
            best = far, nearest = d->left->head;
    }
    for (const cagd_variable *v = scope->variables; v != NULL; v = v->next) {
        int far = far_from(v->head, head);
        if (far < best)
            best = far, nearest = v->head;
    }
    return nearest;
}

cagd_definition *cagd_define(cagd_scope *scope, const cagd_tree *left)
{
    cagd_definition *first = NULL, **end = &first, *copy;
    for (const cagd_definition *d = scope->definitions;; d = d->next) {
        copy = region_bytes(sizeof *copy);
        if (copy == NULL)
            return NULL;
        *copy = d != NULL ? *d : (cagd_definition){.left = left};
        copy->next = NULL;
        *end = copy;
        end = &copy->next;
        if (d == NULL)
            break;
    }
    scope->definitions = first;
    return copy;
}

int cagd_declare(cagd_scope *scope, cagd_variable v)
{
    cagd_variable *kept = region_bytes(sizeof *kept);
    if (kept == NULL)
        return 0;
    *kept = v;
    kept->next = scope->variables;
    scope->variables = kept;
    return 1;
}

static int is_less(cagd_relation r) { return r == CAGD_LESS || r == CAGD_LESS_OR_EQUAL; }
static int is_greater(cagd_relation r) { return r == CAGD_GREATER || r == CAGD_GREATER_OR_EQUAL; }
static int is_strict(cagd_relation r) { return r == CAGD_LESS || r == CAGD_GREATER; }

/* The bounds that a condition low <= v <= high, or high >= v >= low, tells, where the variable has none. */
static void take_bounds(const cagd_scope *scope, cagd_variable *v)
{
    for (int k = 0; k < scope->condition_count && v->low == NULL && v->high == NULL; k++) {
        const cagd_tree *t = scope->conditions[k];
        if (t->kind != CAGD_RELATION || t->count != 3 || t->at[1]->kind != CAGD_NAME || t->at[1]->count > 0 ||
            strcmp(t->at[1]->head, v->head) != 0)
            continue;
        const int up = is_less(t->relation[0]) && is_less(t->relation[1]),
                  down = is_greater(t->relation[0]) && is_greater(t->relation[1]), first = up ? 0 : 1;
        if (!up && !down)
            continue;
        v->low = t->at[2 * first], v->low_open = is_strict(t->relation[first]);
        v->high = t->at[2 - 2 * first], v->high_open = is_strict(t->relation[1 - first]);
    }
}

/* Whether the child number k of t is a whole number always: below in a binomial coefficient, the end of a sum, an index of what is no function. */
static int is_counted(const cagd_scope *scope, const cagd_tree *t, int k)
{
    return (t->kind == CAGD_NAME && k < t->lower + t->upper && cagd_defined(scope, t->head) == NULL) ||
           (t->kind == CAGD_BINOMIAL && k == 1) ||
           ((t->kind == CAGD_SUM_OVER || t->kind == CAGD_PRODUCT_OVER) && k < 2);
}
static int is_index(const cagd_tree *t, int k) { return t->kind == CAGD_NAME && k < t->lower + t->upper; }

/* A number as it stands, 1/2 or -3. */
int cagd_is_plain_number(const cagd_tree *t, cagd_num_q *value)
{
    cagd_num_q a, b;
    if (t->kind == CAGD_NUMBER)
        return *value = t->number, 1;
    if (t->kind == CAGD_NEGATIVE && cagd_is_plain_number(t->at[0], &a))
        return *value = cagd_neg_q(a), 1;
    if (t->kind != CAGD_QUOTIENT || !cagd_is_plain_number(t->at[0], &a) || !cagd_is_plain_number(t->at[1], &b) ||
        cagd_sign_q(b) == 0)
        return 0;
    return *value = cagd_div_q(a, b), 1;
}

static int is_one_of(const char *head, const char *const list[])
{
    for (int k = 0; list[k] != NULL; k++)
        if (strcmp(list[k], head) == 0)
            return 1;
    return 0;
}

int cagd_is_usual_index(const char *head)
{
    static const char *const letters[] = {"i", "j", "k", "l", "m", "n", "r", "\\ell",
                                          "I", "J", "K", "L", "M", "N", "R", NULL};
    return is_one_of(head, letters);
}

int cagd_is_called_as_last(const char *letter) { return letter[1] == '\0' && strchr("nmNM", letter[0]) != NULL; }

/* Whether a name in it is a variable that is no whole number. */
static int has_real(const cagd_scope *scope, const cagd_tree *t)
{
    const cagd_variable *v = t->kind == CAGD_NAME ? cagd_declared(scope, t->head) : NULL;
    int has = v != NULL && !v->whole && (v->real || !cagd_is_usual_index(v->head));
    for (int k = 0; k < t->count && !has; k++)
        has = has_real(scope, t->at[k]);
    return has;
}

enum kind_of_number { IS_REAL, IS_WHOLE, IS_EITHER };

/* What a variable with these bounds is, which is an index of a function.  Between 0 < q < 1 and 0 < q <= 1 there are not two whole numbers; 1/2 is no
 * end of an index.  0 <= i <= 1 are two by the letter; of 0 <= alpha <= 1, and of 0 <= s <= 2 or 0 < s < 3, it is not known. */
static enum kind_of_number kind_of(const cagd_scope *scope, const cagd_variable *v)
{
    static const char *const often_whole[] = {"p", "s", "d", "e", "P", "Q", "S", "D", NULL};
    cagd_num_q low, high;
    int has_low = cagd_is_plain_number(v->low, &low),
        has_high = v->high != NULL && cagd_is_plain_number(v->high, &high);
    int is_usual = cagd_is_usual_index(v->head);
    if ((has_low && !cagd_is_whole_q(low)) || (has_high && !cagd_is_whole_q(high)))
        return IS_REAL;
    if (has_low && has_high && cagd_sign_q(cagd_sub_q(high, low)) > 0) {
        int more = cagd_compare_q(cagd_sub_q(high, low), from_int_q(v->low_open + v->high_open));
        if (more < 0 || (more == 0 && !is_usual)) /* none, or one */
            return IS_REAL;
    }
    if (is_usual)
        return IS_WHOLE;
    if ((!has_low && has_real(scope, v->low)) || (v->high != NULL && !has_high && has_real(scope, v->high)))
        return IS_REAL;
    return (v->low_open || v->high_open) && !is_one_of(v->head, often_whole) ? IS_REAL : IS_EITHER;
}

/* A condition that tells both bounds of v is no other condition any more. */
static int leave_out_bounds(cagd_scope *scope, const cagd_variable *v)
{
    const cagd_tree **rest = cagd_region_array(scope->condition_count + 1, 1, sizeof *rest);
    int count = 0;
    if (rest == NULL)
        return 0;
    for (int k = 0; k < scope->condition_count; k++) {
        cagd_variable told = {.head = v->head};
        cagd_scope one = {.conditions = &scope->conditions[k], .condition_count = 1};
        take_bounds(&one, &told);
        if (told.low == NULL || told.low != v->low || told.high != v->high)
            rest[count++] = scope->conditions[k];
    }
    scope->conditions = rest, scope->condition_count = count;
    return 1;
}

static int become_whole(cagd_scope *scope, const cagd_variable *v)
{
    cagd_variable whole = *v;
    whole.whole = 1;
    if (!leave_out_bounds(scope, v))
        return 0;
    return cagd_declare(scope, whole);
}

/* What was declared of a letter that is not a whole number and was not said to be real, with its bounds; 0 where it is no such thing. */
static int may_become_whole(const cagd_scope *scope, const cagd_tree *t, cagd_variable *v)
{
    const cagd_variable *found = t->kind == CAGD_NAME && t->count == 0 ? cagd_declared(scope, t->head) : NULL;
    if (found == NULL || found->whole || found->real || found->lower + found->upper > 0)
        return 0;
    *v = *found;
    take_bounds(scope, v);
    return v->low != NULL;
}

/* Those that are counted. */
static int make_counted_whole(cagd_scope *scope, const cagd_tree *t, int counted)
{
    cagd_variable v;
    cagd_num_q q;
    if (counted && may_become_whole(scope, t, &v) && (!cagd_is_plain_number(v.low, &q) || cagd_is_whole_q(q)) &&
        (v.high == NULL || !cagd_is_plain_number(v.high, &q) || cagd_is_whole_q(q)))
        return become_whole(scope, &v);
    for (int k = 0; k < t->count; k++)
        if (!make_counted_whole(scope, t->at[k], (counted && t->kind != CAGD_NAME) || is_counted(scope, t, k)))
            return 0;
    return 1;
}

/* And those that are indices of functions. */
static int make_whole(cagd_scope *scope, const cagd_tree *t, int in_index, cagd_reading_error *error)
{
    cagd_variable v;
    if (in_index && may_become_whole(scope, t, &v)) {
        enum kind_of_number kind = kind_of(scope, &v);
        if (kind == IS_EITHER)
            return cagd_refuse_reading(
                error, t->from, t->to,
                "the index %s has bounds and may be a whole number or a real one: write %s = 0, 1, "
                "\\dots for the first, %s \\in [a, %s for the second",
                v.head, v.head, v.head, v.high != NULL ? "b]" : "\\infty)");
        return kind == IS_REAL || become_whole(scope, &v);
    }
    for (int k = 0; k < t->count; k++)
        if (!make_whole(scope, t->at[k], in_index || is_index(t, k), error))
            return 0;
    return 1;
}

/* Whether t is such a letter without bounds, called as last indices are: in 0 <= k <= n it begins where k does. */
static int begins_with(const cagd_scope *scope, const cagd_tree *t, const cagd_variable *k, cagd_variable *v)
{
    const cagd_variable *found = t->kind == CAGD_NAME && t->count == 0 ? cagd_declared(scope, t->head) : NULL;
    cagd_num_q q;
    if (found == NULL || found->whole || found->real || found->low != NULL || found->high != NULL ||
        !cagd_is_called_as_last(t->head) || k->low == NULL || !cagd_is_plain_number(k->low, &q) || !cagd_is_whole_q(q))
        return 0;
    *v = *found, v->low = k->low, v->low_open = k->low_open;
    return 1;
}

/* The first name of t, an end of the range of k, that may become whole, and is called as indices are. */
static int has_end(const cagd_scope *scope, const cagd_tree *t, const cagd_variable *k, cagd_variable *v)
{
    if (t == NULL)
        return 0;
    if (begins_with(scope, t, k, v) || (may_become_whole(scope, t, v) && kind_of(scope, v) == IS_WHOLE))
        return 1;
    for (int i = 0; i < t->count; i++)
        if (has_end(scope, t->at[i], k, v))
            return 1;
    return 0;
}

/* And n, where 0 <= k <= n is the range of a whole number k. */
static int make_ends_whole(cagd_scope *scope)
{
    cagd_variable end;
    for (const cagd_variable *v = scope->variables; v != NULL; v = v->next) {
        if (!v->whole || cagd_declared(scope, v->head) != v ||
            !(has_end(scope, v->low, v, &end) || has_end(scope, v->high, v, &end)))
            continue;
        if (!become_whole(scope, &end))
            return 0;
        v = scope->variables; /* its own ends, too */
    }
    return 1;
}

int cagd_make_indices_whole(cagd_scope *scope, const cagd_tree *t, cagd_reading_error *error)
{
    return make_counted_whole(scope, t, 0) && make_whole(scope, t, 0, error) && make_ends_whole(scope);
}

/* One more behind a list, of which there may be copies. */
static int append(const cagd_tree ***list, int *count, const cagd_tree *t)
{
    const cagd_tree **longer = cagd_region_array(*count + 1, 1, sizeof *longer);
    if (longer == NULL)
        return 0;
    for (int k = 0; k < *count; k++)
        longer[k] = (*list)[k];
    longer[(*count)++] = t;
    *list = longer;
    return 1;
}

int cagd_suppose(cagd_scope *scope, const cagd_tree *condition)
{
    return append(&scope->conditions, &scope->condition_count, condition);
}

int cagd_label(cagd_scope *scope, const cagd_tree *letter)
{
    return append(&scope->labels, &scope->label_count, letter);
}
