/* read_name.c -- names: a letter with its faces, stars, primes, indices and arguments. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* What changes the letter behind it into another one. */
static const char *const faces[] = {
    "\\hat",        "\\bar",      "\\tilde",   "\\dot",      "\\ddot",      "\\dddot",        "\\vec",
    "\\check",      "\\breve",    "\\mathbf",  "\\mathrm",   "\\mathit",    "\\mathcal",      "\\bm",
    "\\boldsymbol", "\\mathsf",   "\\mathbb",  "\\mathfrak", "\\underline", "\\operatorname", "\\acute",
    "\\grave",      "\\mathring", "\\mathscr", "\\mathtt",   "\\pmb",       "\\textbf"};
enum { FACES = sizeof faces / sizeof *faces, MOST_ARGUMENTS = 8, MOST_HEAD = 60 };

static int is_face(const char *word)
{
    for (int k = 0; k < FACES; k++)
        if (strcmp(faces[k], word) == 0)
            return 1;
    return 0;
}

int cagd_begins_name(const cagd_reader *r)
{
    return r->token->kind == CAGD_TOKEN_LETTER || (r->token->kind == CAGD_TOKEN_WORD && is_face(r->token->word));
}

int cagd_is_bound(const cagd_reader *r, const char *head)
{
    for (const struct cagd_bound *b = r->bound; b != NULL; b = b->next)
        if (strcmp(b->head, head) == 0)
            return 1;
    return 0;
}

int cagd_is_known(const cagd_reader *r, const char *head)
{
    return cagd_is_bound(r, head) || cagd_defined(r->scope, head) != NULL || cagd_declared(r->scope, head) != NULL ||
           cagd_is_parameter(r->scope, head);
}

int cagd_may_be_unknown(const cagd_reader *r) { return r->declaring || (r->supposing > 0 && r->in_index > 0); }

struct parts {
    const char *head;
    int lower, upper, arguments, before_semicolon, primes, transposed;
    const cagd_tree *of_lower[CAGD_MOST_INDICES], *of_upper[CAGD_MOST_INDICES], *argument[MOST_ARGUMENTS];
    const cagd_tree *power, *times;
};

/* before head after, as one head. */
static const char *joined(cagd_reader *r, const char *before, const char *head, const char *after)
{
    char text[MOST_HEAD + 40];
    int n = snprintf(text, sizeof text, "%s%s%s", before, head, after);
    if (n > MOST_HEAD) {
        cagd_refuse_token(r, "a name of more than %d letters", MOST_HEAD);
        return NULL;
    }
    return cagd_text_of(text, n);
}

static int indices(cagd_reader *r, struct parts *p);
static int labelled(cagd_reader *r, struct parts *p);

static int letter(cagd_reader *r, struct parts *p);

static int begins_known_name(const cagd_scope *scope, const char *beginning)
{
    size_t n = strlen(beginning);
    for (const cagd_definition *d = scope->definitions; d != NULL; d = d->next)
        if (strncmp(d->left->head, beginning, n) == 0)
            return 1;
    for (const cagd_variable *v = scope->variables; v != NULL; v = v->next)
        if (strncmp(v->head, beginning, n) == 0)
            return 1;
    return 0;
}

/* \Delta P, \Delta^2 P, \Delta^r P: differences that are known, of which the order is an upper index; the head goes to p->head, or nothing
 * was passed. */
static int difference(cagd_reader *r, struct parts *p)
{
    const cagd_token *start = r->token;
    int depth = r->depth;
    struct parts of = {0};
    r->token++;
    const cagd_tree *order = cagd_pass(r, "^") ? cagd_read_argument(r, 1) : cagd_tree_number(1, start->from, start->to);
    if (order != NULL && cagd_begins_name(r) && letter(r, &of) && of.lower + of.upper == 0) {
        const char *head = joined(r, "\\Delta{", of.head, "}");
        if (head == NULL)
            return 0;
        if (r->declaring || begins_known_name(r->scope, head)) {
            p->head = head;
            p->of_upper[p->upper++] = order;
            return 1;
        }
    }
    r->token = start, r->depth = depth;
    *r->error = (cagd_reading_error){0};
    return 1;
}

/* A letter, or a face with a letter, or with a name that has its indices inside: \hat{B_i}. */
static int letter(cagd_reader *r, struct parts *p)
{
    if (cagd_next_is(r, "\\Delta") && (!difference(r, p) || p->head != NULL))
        return p->head != NULL;
    if (r->token->kind == CAGD_TOKEN_LETTER) {
        p->head = (r->token++)->word;
        return 1;
    }
    if (r->token->kind != CAGD_TOKEN_WORD || !is_face(r->token->word))
        return cagd_refuse_token(r, "expected a letter, not %s", cagd_name_of_next(r)) != NULL;
    if (++r->depth > CAGD_MOST_DEPTH)
        return cagd_refuse_token(r, "more than %d levels of brackets", CAGD_MOST_DEPTH) != NULL;
    const char *face = (r->token++)->word;
    int braces = cagd_pass(r, "{");
    if (!letter(r, p))
        return 0;
    while (braces && p->head != NULL && r->token->kind == CAGD_TOKEN_LETTER) /* \mathrm{SA} */
        p->head = joined(r, p->head, (r->token++)->word, "");
    if (p->head == NULL || (braces && (!labelled(r, p) || !indices(r, p) || !cagd_expect(r, "}", face))))
        return 0;
    char before[24];
    snprintf(before, sizeof before, "%s{", face);
    p->head = joined(r, before, p->head, p->lower > 0 ? "}_" : "}");
    r->depth--;
    return p->head != NULL;
}

/* A label behind the letter is part of the name: R_s, P_{\mathrm{I}}. */
static int labelled(cagd_reader *r, struct parts *p)
{
    const cagd_token *start = r->token;
    int depth = r->depth;
    struct parts label = {0};
    if (r->scope->label_count == 0 || !cagd_pass(r, "_"))
        return 1;
    int braces = cagd_pass(r, "{");
    if (cagd_begins_name(r) && letter(r, &label) && label.lower + label.upper == 0 && (!braces || cagd_pass(r, "}")) &&
        cagd_is_label(r->scope, label.head) && !cagd_is_bound(r, label.head)) {
        char behind[MOST_HEAD + 4];
        snprintf(behind, sizeof behind, "_{%s}", label.head);
        p->head = joined(r, "", p->head, behind);
        return p->head != NULL;
    }
    r->token = start, r->depth = depth;
    *r->error = (cagd_reading_error){0};
    return 1;
}

const char *cagd_read_head(cagd_reader *r)
{
    struct parts p = {0};
    return letter(r, &p) && p.lower + p.upper == 0 ? p.head : NULL;
}

/* What stands behind a letter or group. */
static const cagd_token *behind(const cagd_token *t)
{
    int depth = 0;
    do {
        depth += (strcmp(t->word, "{") == 0) - (strcmp(t->word, "}") == 0);
        t += t->kind != CAGD_TOKEN_END;
    } while (depth > 0 && t->kind != CAGD_TOKEN_END);
    return t;
}

/* Whether a lower index follows, perhaps behind a star, primes or what stands above: t and t_i are different names. */
static int lower_follows(const cagd_token *t)
{
    for (;;) {
        if (strcmp(t->word, "'") == 0) {
            t++;
        } else if (strcmp(t->word, "^") == 0) {
            t = behind(t + 1);
        } else {
            return strcmp(t->word, "_") == 0;
        }
    }
}

const char *cagd_spelled(const char *head)
{
    char text[MOST_HEAD + 8];
    size_t n = strlen(head);
    int length = snprintf(text, sizeof text, "%s%s", head, n > 0 && head[n - 1] == '_' ? "i" : "");
    const char *kept = cagd_text_of(text, length < (int)sizeof text ? length : (int)sizeof text - 1);
    return kept != NULL ? kept : "";
}

/* How many upper indices the name was given where it was made known; -1 where it is not known. */
static int known_upper(const cagd_reader *r, const char *head)
{
    const cagd_definition *d = cagd_defined(r->scope, head);
    const cagd_variable *v = cagd_declared(r->scope, head);
    return cagd_is_bound(r, head) ? 0 : d != NULL ? d->left->upper : v != NULL ? v->upper : -1;
}

static int known_arguments(const cagd_reader *r, const char *head)
{
    for (const struct cagd_bound *b = r->bound; b != NULL; b = b->next)
        if (strcmp(b->head, head) == 0)
            return b->arity;
    const cagd_definition *d = cagd_defined(r->scope, head);
    return d != NULL ? d->left->arguments : 0;
}

/* {12} for a name with two indices: one digit each.  0 where it is nothing of the kind, and nothing was passed. */
static int digits(cagd_reader *r, int *count, const cagd_tree *out[], int wanted)
{
    const cagd_token *t = r->token;
    if (wanted < 2 || t->kind != CAGD_TOKEN_NUMBER || (int)strlen(t->word) != wanted || strcmp(t[1].word, "}") != 0 ||
        strchr(t->word, '.') != NULL)
        return 0;
    for (int k = 0; k < wanted; k++)
        out[(*count)++] = cagd_tree_number(t->word[k] - '0', t->from + k, t->from + k + 1);
    r->token += 2;
    return out[wanted - 1] != NULL;
}

/* Indices with commas between, up to the closing brace if there are braces; side by side on the left of a definition: P_{ij}. */
static int list_inside(cagd_reader *r, int *count, const cagd_tree *out[], int wanted, int *primes)
{
    if (!cagd_next_is(r, "{")) {
        out[(*count)++] = cagd_read_argument(r, 1);
        return out[0] != NULL;
    }
    r->token++;
    if (digits(r, count, out, wanted))
        return 1;
    const char *close = cagd_pass(r, "[") ? "]" : cagd_pass(r, "(") ? ")" : NULL;
    do {
        if (*count == CAGD_MOST_INDICES)
            return cagd_refuse_token(r, "more than %d indices", CAGD_MOST_INDICES) != NULL;
        const cagd_tree *t = cagd_read_sum(r);
        if (t == NULL)
            return 0;
        int many = t->kind == CAGD_PRODUCT && t->juxtaposed && (wanted < 0 || wanted > 1) &&
                   t->count + *count <= CAGD_MOST_INDICES;
        for (int k = 0; many && k < t->count; k++)
            out[(*count)++] = t->at[k];
        if (!many)
            out[(*count)++] = t;
    } while (cagd_pass(r, ","));
    while (primes != NULL && (cagd_pass(r, "\\prime") || cagd_pass(r, "'")))
        ++*primes;
    return (close == NULL || cagd_expect(r, close, "the index")) && cagd_expect(r, "}", "the index");
}

static int list(cagd_reader *r, int *count, const cagd_tree *out[], int wanted, int *primes)
{
    r->in_index++;
    int good = list_inside(r, count, out, wanted, primes);
    r->in_index--;
    return good;
}

/* w_i and w_i^{[r]}, w_i^{(r)}, or w_i^r(t), are different names where w_i was made known without an upper index. */
static int with_upper(cagd_reader *r, struct parts *p, const char *upper)
{
    const char *with = known_upper(r, p->head) == 0 ? joined(r, "", p->head, upper) : p->head;
    if (with != NULL && with != p->head && (r->declaring || cagd_is_known(r, with)))
        p->head = with;
    return with != NULL;
}

/* The star t, which is part of the name; in braces a power may stand behind it: w^{*2}. */
static int star(cagd_reader *r, struct parts *p, const cagd_token *t, int braces)
{
    int lowered = p->head[strlen(p->head) - 1] == '_';
    const char *without = cagd_text_of(p->head, (int)strlen(p->head) - lowered);
    p->head = without != NULL ? joined(r, "", without, lowered ? "^*_" : "^*") : NULL;
    r->token = t + 1;
    if (braces && !cagd_next_is(r, "}") && p->head != NULL && (p->power = cagd_read_sum(r)) == NULL)
        return 0;
    return p->head != NULL && (!braces || cagd_expect(r, "}", "the star"));
}

/* What follows ^: a star, primes, an index, the order of a derivative, or a power. */
static int superscript(cagd_reader *r, struct parts *p)
{
    const cagd_token *t = r->token;
    int braces = strcmp(t->word, "{") == 0;
    t += braces;
    if (strcmp(t->word, "*") == 0)
        return star(r, p, t, braces);
    int primes = 0;
    while (strcmp(t[primes].word, "'") == 0 || strcmp(t[primes].word, "\\prime") == 0)
        primes++;
    if (primes > 0 && (!braces || strcmp(t[primes].word, "}") == 0)) {
        r->token = t + primes + braces;
        p->primes += primes;
        return 1;
    }
    if (braces && strcmp(t->word, "[") == 0 && p->upper == 0 && !with_upper(r, p, "^[]"))
        return 0;
    if (braces && strcmp(t->word, "(") == 0 && p->upper == 0 && known_arguments(r, p->head) == 0 &&
        !with_upper(r, p, "^{()}"))
        return 0;
    if (p->upper == 0 && strcmp(behind(r->token)->word, "(") == 0 && !with_upper(r, p, "^()"))
        return 0;
    int upper = known_upper(r, p->head), arguments = known_arguments(r, p->head);
    if (p->upper == 0 && (upper > 0 || (r->declaring && upper < 0)))
        return list(r, &p->upper, p->of_upper, upper, &p->primes);
    if (braces && arguments > 0 && strcmp(t->word, "(") == 0) {
        r->token++;
        const cagd_tree *order = (r->token++, cagd_read_sum(r));
        p->times = order;
        return order != NULL && cagd_expect(r, ")", "the order of the derivative") && cagd_expect(r, "}", "the order");
    }
    if (p->power != NULL)
        return cagd_refuse_token(r, "two powers of one name") != NULL;
    if (braces && (strcmp(t->word, "[") == 0 || strcmp(t->word, "(") == 0))
        return cagd_refuse_token(r, "%s was not defined with an upper index, and a power has no brackets",
                                 cagd_spelled(p->head)) != NULL;
    if (!cagd_is_bound(r, p->head) && cagd_dimension_of(r->scope, p->head) > 0 && cagd_pass_transposed(r)) {
        p->transposed = 1;
        return 1;
    }
    p->power = cagd_read_argument(r, 1);
    return p->power != NULL;
}

static int indices(cagd_reader *r, struct parts *p)
{
    for (;;) {
        if (cagd_next_is(r, "_")) {
            if (p->lower > 0)
                return cagd_refuse_token(r, "two lower indices of one name") != NULL;
            const cagd_definition *d = cagd_defined(r->scope, p->head);
            const cagd_variable *v = cagd_declared(r->scope, p->head);
            r->token++;
            if (!list(r, &p->lower, p->of_lower, d != NULL ? d->left->lower : v != NULL ? v->lower : -1, NULL))
                return 0;
        } else if (cagd_next_is(r, "^")) {
            r->token++;
            if (!superscript(r, p))
                return 0;
        } else if (cagd_pass(r, "'")) {
            p->primes++;
        } else if (cagd_next_is(r, "{") && strcmp(r->token[1].word, "}") == 0) {
            r->token += 2;
        } else {
            return 1;
        }
    }
}

static int arguments(cagd_reader *r, struct parts *p, int most)
{
    if (p->power != NULL && p->power->kind == CAGD_NEGATIVE)
        return cagd_refuse_tree(r, p->power, "the inverse of %s, or 1 over it? write \\frac{1}{...}",
                                cagd_spelled(p->head)) != NULL;
    const cagd_token *first = r->token++;
    p->before_semicolon = 0;
    do {
        if (p->arguments == MOST_ARGUMENTS || p->arguments == most)
            return cagd_refuse_token(r,
                                     most >= 0 ? "%s was defined with %d argument%s" : "%s has more than 8 arguments",
                                     cagd_spelled(p->head), most, most == 1 ? "" : "s") != NULL;
        p->argument[p->arguments] = cagd_read_sum(r);
        if (p->argument[p->arguments++] == NULL)
            return 0;
        if (cagd_next_is(r, ";") && p->before_semicolon == 0)
            p->before_semicolon = p->arguments;
    } while (cagd_pass(r, ",") || cagd_pass(r, ";"));
    if (p->before_semicolon == 0)
        p->before_semicolon = p->arguments;
    if (!cagd_expect(r, ")", "the arguments"))
        return 0;
    const cagd_definition *d = most > 0 && !cagd_is_bound(r, p->head) ? cagd_defined(r->scope, p->head) : NULL;
    if (d == NULL && most > 0 && p->arguments < most)
        return cagd_refuse_token(r, "%s has %d arguments", cagd_spelled(p->head), most) != NULL;
    if (d == NULL || p->arguments >= d->left->before_semicolon)
        return 1;
    r->token = first;
    return cagd_refuse_token(
               r,
               "%s was defined with %d arguments, of which %d stand here: write all of them, or \\cdot "
               "before a factor; parameters that may be left out stand behind a semicolon where it is defined",
               cagd_spelled(p->head), d->left->arguments, p->arguments) != NULL;
}

/* Primes belong to the name where it is known with them; of a function they are derivatives. */
static int primed(cagd_reader *r, struct parts *p)
{
    if (p->primes == 0)
        return 1;
    char primes[] = "''''''''";
    if (p->primes < (int)sizeof primes) {
        primes[p->primes] = '\0';
        const char *with = joined(r, "", p->head, primes);
        if (with == NULL)
            return 0;
        if (r->declaring || cagd_is_known(r, with)) {
            p->head = with, p->primes = 0;
            return 1;
        }
    }
    if (known_arguments(r, p->head) > 0)
        return 1;
    return cagd_refuse_token(r, "%s is no function with arguments, so it has no derivative; %s' was not defined either",
                             cagd_spelled(p->head), cagd_spelled(p->head)) != NULL;
}

/* The letters side by side around a byte, without a backslash before them; NULL where there are fewer than two. */
static const char *word_at(const cagd_reader *r, int at)
{
    int from = at, to = at;
    while (from > 0 && at - from < MOST_HEAD && isalpha((unsigned char)r->text[from - 1]))
        from--;
    while (to - at < MOST_HEAD && isalpha((unsigned char)r->text[to]))
        to++;
    return to - from < 2 || (from > 0 && r->text[from - 1] == '\\') ? NULL : cagd_text_of(r->text + from, to - from);
}

static const char *const said_words[] = {"for", "if", "and", "or", "where", "with", "then", "when", "otherwise", NULL};
static const char *const commands[] = {"sin",  "cos",  "tan",   "max",  "min", "det", "sum",
                                       "prod", "frac", "binom", "sqrt", "int", NULL};

static int is_one_of_words(const char *word, const char *const list[])
{
    for (int k = 0; list[k] != NULL; k++)
        if (strcmp(word, list[k]) == 0)
            return 1;
    return 0;
}

cagd_tree *cagd_complain_of_letter(cagd_reader *r, int from, int to, const char *letter)
{
    if (!cagd_is_usual_index(letter))
        cagd_refuse_reading(r->error, from, to, "%s is not defined", letter);
    else if (r->defining)
        cagd_refuse_reading(r->error, from, to,
                            "%s is not defined; a line '%s \\in \\mathbb{N}' in a let block makes it a whole number",
                            letter, letter);
    else
        cagd_refuse_reading(r->error, from, to,
                            "%s is not defined; ':for: %s = 1..4' says for which numbers it is meant", letter, letter);
    return NULL;
}

/* The name with its indices, letters in the places of numbers: p_{i,k} for p_{3,k}. */
static const char *spelled_with_indices(const struct parts *p)
{
    static const char *const letters[] = {"i", "j", "k", "l"};
    char text[MOST_HEAD + 40];
    size_t n = strlen(p->head);
    int used = snprintf(text, sizeof text, "%s%s", p->head, p->lower > 1 ? "{" : "");
    if (n == 0 || p->head[n - 1] != '_')
        return cagd_spelled(p->head);
    for (int k = 0; k < p->lower && used < (int)sizeof text; k++) {
        const cagd_tree *t = p->of_lower[k];
        int is_letter = t->kind == CAGD_NAME && t->count == 0;
        used += snprintf(text + used, sizeof text - (size_t)used, "%s%s", k > 0 ? "," : "",
                         is_letter ? t->head : letters[k]);
    }
    if (used < (int)sizeof text)
        used += snprintf(text + used, sizeof text - (size_t)used, "%s", p->lower > 1 ? "}" : "");
    const char *kept = used < (int)sizeof text ? cagd_text_of(text, used) : NULL;
    return kept != NULL ? kept : cagd_spelled(p->head);
}

static const cagd_tree *complain_of_unknown(cagd_reader *r, int from, const struct parts *p)
{
    const char *near = cagd_nearest(r->scope, p->head), *name = spelled_with_indices(p), *word = word_at(r, from);
    if (strcmp(p->head, "\\delta_") == 0 && p->lower + p->upper + (p->lower == 1 && p->power != NULL) == 2)
        return cagd_refuse_reading(
                   r->error, from, r->token[-1].to,
                   "\\delta_{ij} is not defined; in a let block ':use: kronecker \\delta_{ij}' makes it 1 for "
                   "i = j and else 0"),
               NULL;
    if (word != NULL && is_one_of_words(word, said_words))
        return cagd_refuse_reading(r->error, from, r->token[-1].to, "%s is not defined; words stand in \\text{%s}",
                                   name, word),
               NULL;
    if (word != NULL && is_one_of_words(word, commands))
        return cagd_refuse_reading(r->error, from, r->token[-1].to, "%s is not defined; or is it \\%s?", name, word),
               NULL;
    if (near == NULL && cagd_is_usual_index(p->head))
        return cagd_complain_of_letter(r, from, r->token[-1].to, p->head);
    cagd_refuse_reading(r->error, from, r->token[-1].to,
                        "%s is not defined%s%s%s; a line '%s \\in \\mathbb{R}' in a let "
                        "block makes it a variable",
                        name, near != NULL ? ", but " : "", near != NULL ? cagd_spelled(near) : "",
                        near != NULL ? " is" : "", name);
    return NULL;
}

/* The numbers of indices and arguments are those with which it was made known. */
static int fits(cagd_reader *r, const struct parts *p, int from)
{
    const cagd_definition *d = cagd_is_bound(r, p->head) ? NULL : cagd_defined(r->scope, p->head);
    const cagd_variable *v = cagd_is_bound(r, p->head) || d != NULL ? NULL : cagd_declared(r->scope, p->head);
    int lower = d != NULL ? d->left->lower : v != NULL ? v->lower : 0;
    int upper = d != NULL ? d->left->upper : v != NULL ? v->upper : 0;
    if (lower != p->lower)
        return cagd_refuse_reading(r->error, from, r->token[-1].to, "%s has %d lower ind%s, not %d",
                                   cagd_spelled(p->head), lower, lower == 1 ? "ex" : "ices", p->lower);
    if (upper != p->upper)
        return cagd_refuse_reading(r->error, from, r->token[-1].to, "%s has %d upper ind%s, not %d",
                                   cagd_spelled(p->head), upper, upper == 1 ? "ex" : "ices", p->upper);
    return 1;
}

/* The number, which has its place in angles. */
static const cagd_tree *pi(cagd_reader *r, int from, const cagd_tree *power)
{
    cagd_tree *t = cagd_new(r, CAGD_NAME, from, 0);
    if (t == NULL)
        return NULL;
    t->head = "\\pi";
    return power == NULL ? t : cagd_new_of(r, CAGD_POWER, from, 2, (const cagd_tree *[]){t, power});
}

int cagd_is_of_whole_numbers(const cagd_reader *r, const cagd_tree *t, int *has_name)
{
    if (t->kind == CAGD_NUMBER)
        return cagd_is_whole_q(t->number);
    if (t->kind == CAGD_NAME) {
        const cagd_variable *v = cagd_is_bound(r, t->head) ? NULL : cagd_declared(r->scope, t->head);
        *has_name = 1;
        return t->count == 0 && (v != NULL ? v->whole : cagd_is_bound(r, t->head) && cagd_is_usual_index(t->head));
    }
    if (t->kind != CAGD_SUM && t->kind != CAGD_NEGATIVE && t->kind != CAGD_PRODUCT)
        return 0;
    for (int k = 0; k < t->count; k++)
        if (!cagd_is_of_whole_numbers(r, t->at[k], has_name))
            return 0;
    return 1;
}

/* Whether TeX makes a space before the next token, as between factors. */
static int is_spaced(const cagd_reader *r)
{
    for (int k = r->token[-1].to; k < r->token->from; k++)
        if (r->text[k] == '~' || (r->text[k] == '\\' && strchr(",;: q", r->text[k + 1]) != NULL))
            return 1;
    return 0;
}

/* Whether the bracket that comes next has in it what no product needs a bracket for, a name, a number, a fraction, or a list: f(t), f(0), f(s,t).  Behind
 * a name with an index, or that of a matrix, a list is a point: \omega_i (x_i, y_i). */
static int bracket_is_of_arguments(const cagd_reader *r, int may_be_point)
{
    cagd_reader at = *r;
    cagd_reading_error none = {0};
    int depth = 0;
    for (const cagd_token *t = r->token; t->kind != CAGD_TOKEN_END; t++) {
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        if (depth == 1 && (t->word[0] == ',' || t->word[0] == ';'))
            return !may_be_point || t->word[0] == ';';
        if (depth == 0)
            break;
    }
    at.error = &none, at.looking = 1, at.token++;
    int minus = cagd_pass(&at, "-");
    const cagd_tree *t = cagd_read_factor(&at);
    if (t == NULL || !cagd_next_is(&at, ")"))
        return 0;
    int has_power = strcmp(at.token[1].word, "^") == 0; /* (-1)^n, (\frac{a}{b})^2 */
    const cagd_tree *name = t->kind == CAGD_POWER ? t->at[0] : t;
    return (name->kind == CAGD_NAME || t->kind == CAGD_NUMBER || t->kind == CAGD_QUOTIENT) &&
           !(has_power && (minus || t->kind == CAGD_QUOTIENT));
}

/* Dots above a function that was defined, \dot{f}(t), are primes where nothing is called so itself. */
static void read_dots_as_primes(const cagd_reader *r, struct parts *p)
{
    static const char *const dots[] = {"\\dot{", "\\ddot{", "\\dddot{"};
    const char *close = strrchr(p->head, '}');
    if (close == NULL || r->declaring || cagd_is_known(r, p->head))
        return;
    for (int k = 0; k < (int)(sizeof dots / sizeof *dots); k++) {
        const size_t n = strlen(dots[k]);
        if (strncmp(p->head, dots[k], n) != 0)
            continue;
        char inside[MOST_HEAD];
        const int length =
            snprintf(inside, sizeof inside, "%.*s%s", (int)(close - p->head - (long)n), p->head + n, close + 1);
        const char *head = length < MOST_HEAD ? cagd_text_of(inside, length) : NULL;
        const cagd_definition *d = head != NULL && !cagd_is_bound(r, head) ? cagd_defined(r->scope, head) : NULL;
        if (d != NULL && (d->left->arguments == 1 || d->left->before_semicolon == 1))
            p->head = head, p->primes += k + 1;
        return;
    }
}

/* Whether what is read is the right side of a definition of that name. */
static int is_being_defined(const cagd_reader *r, const char *head)
{
    for (const cagd_definition *d = r->scope->definitions; d != NULL && head != NULL; d = d->next)
        if (strcmp(d->left->head, head) == 0 && d->body == NULL)
            return 1;
    return 0;
}

const cagd_tree *cagd_read_name(cagd_reader *r)
{
    struct parts p = {0};
    int from = r->token->from;
    if (!letter(r, &p))
        return NULL;
    if (!labelled(r, &p))
        return NULL;
    if (p.lower == 0 && lower_follows(r->token))
        p.head = joined(r, "", p.head, "_");
    if (p.head == NULL || !indices(r, &p) || !primed(r, &p))
        return NULL;
    read_dots_as_primes(r, &p);
    int is_known = r->declaring || cagd_is_known(r, p.head);
    if (!is_known && strcmp(p.head, "\\pi") == 0 && p.lower + p.upper + p.primes == 0)
        return pi(r, from, p.power);
    if (!is_known && (!cagd_may_be_unknown(r) || p.lower + p.upper > 0))
        return complain_of_unknown(r, from, &p);
    int most = !is_known ? 0 : r->declaring ? -1 : known_arguments(r, p.head);
    if (!r->declaring && is_known && !fits(r, &p, from))
        return NULL;
    int braces = most != 0 && cagd_next_is(r, "{") && strcmp(r->token[1].word, "(") == 0; /* f{(t)}, printed as f(t) */
    r->token += braces;
    if (cagd_next_is(r, "(") && most != 0 && !arguments(r, &p, most))
        return NULL;
    if (braces && !cagd_expect(r, "}", "the arguments"))
        return NULL;
    cagd_reader behind_brace = *r;
    behind_brace.token += cagd_next_is(r, "{") && strcmp(r->token[1].word, "(") == 0; /* f{(0)}, printed as f(0) */
    if (most == 0 && is_known && !r->declaring && !r->looking && cagd_next_is(&behind_brace, "(") && !is_spaced(r) &&
        bracket_is_of_arguments(&behind_brace,
                                p.lower + p.upper > 0 || cagd_is_matrix(cagd_dimension_of(r->scope, p.head))))
        return cagd_refuse_token(
            r,
            "a value of %s, which was not defined with arguments, or a product? define %s, or write "
            "\\cdot before the bracket",
            cagd_spelled(p.head), cagd_spelled(p.head));
    cagd_tree *t = cagd_new(r, CAGD_NAME, from, p.lower + p.upper + p.arguments);
    if (t == NULL)
        return NULL;
    t->head = p.head, t->lower = p.lower, t->upper = p.upper, t->arguments = p.arguments,
    t->before_semicolon = p.before_semicolon;
    t->order = p.primes, t->times = p.times;
    t->dimension = r->declaring || cagd_is_bound(r, p.head) ? 0 : cagd_dimension_of(r->scope, p.head);
    for (int k = 0; k < p.lower; k++)
        t->at[k] = p.of_lower[k];
    for (int k = 0; k < p.upper; k++)
        t->at[p.lower + k] = p.of_upper[k];
    for (int k = 0; k < p.arguments; k++)
        t->at[p.lower + p.upper + k] = p.argument[k];
    for (int k = 0; k < t->count; k++)
        if (t->at[k]->dimension > 0)
            return cagd_refuse_tree(r, t->at[k], "a vector is no index and no argument");
    if (p.transposed)
        return cagd_transposed(r, t);
    const cagd_definition *d = r->declaring || cagd_is_bound(r, p.head) ? NULL : cagd_defined(r->scope, p.head);
    const cagd_tree *value = d != NULL && d->functions != 0 ? cagd_put_in_functional(r, d, t) : t;
    if (p.power == NULL || value == NULL)
        return value;
    if (!r->declaring && p.arguments == 0 && is_being_defined(r, joined(r, "", p.head, "^()")))
        return cagd_refuse_reading(r->error, from, r->token[-1].to,
                                   "a power, or the function with that upper index without its argument? write "
                                   "brackets around %s, or the argument",
                                   cagd_spelled(p.head)),
               NULL;
    return cagd_power_of(r, value, p.power, from);
}

const cagd_tree *cagd_read_primed_group(cagd_reader *r, const cagd_tree *t)
{
    if (t->kind != CAGD_NAME || t->arguments > 0 || known_arguments(r, t->head) == 0 ||
        !(cagd_next_is(r, "'") || cagd_next_is(r, "(")))
        return t;
    struct parts p = {.head = t->head};
    cagd_tree *whole = cagd_new(r, CAGD_NAME, t->from, t->count + MOST_ARGUMENTS);
    while (cagd_pass(r, "'"))
        p.primes++;
    if (whole == NULL || (cagd_next_is(r, "(") && !arguments(r, &p, known_arguments(r, t->head))))
        return NULL;
    const cagd_tree **at = whole->at;
    *whole = *t;
    whole->at = at, whole->to = r->token[-1].to;
    whole->order += p.primes, whole->arguments = p.arguments, whole->before_semicolon = p.before_semicolon;
    whole->count += p.arguments;
    for (int k = 0; k < t->count; k++)
        at[k] = t->at[k];
    for (int k = 0; k < p.arguments; k++)
        at[t->count + k] = p.argument[k];
    return whole;
}

int cagd_is_bare_function(const cagd_reader *r, const cagd_tree *t)
{
    return t->kind == CAGD_NAME && t->arguments == 0 && known_arguments(r, t->head) > 0;
}

static int has_bare_function(const cagd_reader *r, const cagd_tree *t)
{
    if (cagd_is_bare_function(r, t))
        return 1;
    for (int k = 0; k < t->count; k++)
        if (has_bare_function(r, t->at[k]))
            return 1;
    return 0;
}

int cagd_bracket_has_function(const cagd_reader *r)
{
    int depth = 0;
    for (const cagd_token *t = r->token; t->kind != CAGD_TOKEN_END; t++) {
        char head[MOST_HEAD];
        if (t->kind == CAGD_TOKEN_WORD && is_face(t->word))
            return 1;
        if (t->kind == CAGD_TOKEN_LETTER && snprintf(head, sizeof head, "%s_", t->word) < MOST_HEAD &&
            (known_arguments(r, t->word) > 0 || known_arguments(r, head) > 0 ||
             cagd_dimension_of(r->scope, t->word) > 0 || cagd_dimension_of(r->scope, head) > 0))
            return 1;
        depth += (strcmp(t->word, "[") == 0) - (strcmp(t->word, "]") == 0);
        if (depth == 0)
            return 0;
    }
    return 0;
}

int cagd_is_truth_in_brackets(const cagd_reader *r)
{
    int depth = 0;
    cagd_relation relation;
    for (cagd_reader at = *r; at.token->kind != CAGD_TOKEN_END; at.token++) {
        const char *word = at.token->word;
        if (depth == 1 && (cagd_relation_next(&at, &relation) || strcmp(word, "\\in") == 0))
            return 1;
        depth += (strchr("({[", word[0]) != NULL) - (strchr(")}]", word[0]) != NULL);
        depth += (strcmp(word, "\\begin") == 0) - (strcmp(word, "\\end") == 0); /* cases have conditions of their own */
        if (depth == 0)
            return 0;
    }
    return 0;
}

/* What is in the bracket that comes next: 1 where it has functions without arguments, which makes it a factor; -1 where it does not end. */
static int bracket_has_function(const cagd_reader *r)
{
    int depth = 0, deepest = 0, has = 0;
    for (const cagd_token *t = r->token; t->kind != CAGD_TOKEN_END; t++) {
        char head[MOST_HEAD];
        if (t->kind == CAGD_TOKEN_LETTER && snprintf(head, sizeof head, "%s_", t->word) < MOST_HEAD)
            has |= known_arguments(r, t->word) > 0 || known_arguments(r, head) > 0;
        depth += (strcmp(t->word, "(") == 0) - (strcmp(t->word, ")") == 0);
        deepest = depth > deepest ? depth : deepest;
        if (depth == 0)
            return has && deepest == 1;
    }
    return -1;
}

int cagd_refuse_argument(cagd_reader *r, const cagd_tree *t)
{
    if (t->kind != CAGD_NAME && cagd_next_is(r, "'") && has_bare_function(r, t)) {
        cagd_refuse_token(r, "a prime stands behind one function: write it behind each, or \\frac{d}{dt} before");
        return 1;
    }
    if (!cagd_next_is(r, "(") || !has_bare_function(r, t) || bracket_has_function(r) != 0)
        return 0;
    cagd_refuse_token(r, "arguments of what stands before, or a factor? write them behind the name, or \\cdot between");
    return 1;
}
