/* reader.h -- what the parts of the reader share; only for read*.c. */
#ifndef CAGD_READER_H
#define CAGD_READER_H

#include "exact/expression/read.h"
#include "exact/expression/token.h"

/* A letter that is bound where the reader stands: by a sum, by the left side of a definition. */
struct cagd_bound {
    const char *head;
    const struct cagd_bound *next;
    int arity; /* of an argument that is a function: how many it has itself */
};

typedef struct cagd_reader {
    const cagd_scope *scope;
    const char *text;
    const cagd_token *token; /* the next one */
    const struct cagd_bound *bound;
    cagd_reading_error *error;
    int depth;
    int declaring; /* on the left of a definition: names need not be known   */
    int supposing; /* in a condition: letters of indices need not be known   */
    int in_index;
    int integrals;              /* around what is read: d and a letter end the integrand  */
    int norms;                  /* likewise: \| ends the norm and begins none             */
    int amounts;                /* and | that of a number                                  */
    int ends;                   /* where a range is read: dots stand between its ends      */
    int premises;               /* in what is supposed                                     */
    int lists;                  /* likewise i = 0, 1, 2 is a condition                     */
    const char *defines;        /* behind the definition of that name: another one may follow a comma */
    const char *defines_one_of; /* the head of w_0, where w_1 = ... may follow with a value of its own, or NULL */
    int nodes;
    int defining;               /* the right side of a definition */
    int looking;                /* ahead, where nothing is asked for that would be read once more */
    const cagd_token *left_out; /* the last dots that leave steps of a chain out */
    const cagd_token *broken;   /* the last factor that begins a line, or stands behind a space, and how deep it is */
    int broken_depth, broken_by_sign; /* it was a sign that begins the line */
    int squares;                      /* brackets [ that are open: in them spaces divide the components of a row */
    const cagd_token *ranged;         /* the last quantifier over real numbers */
    int comma; /* where the last comma between the conditions that were read begins; -1 without one */
} cagd_reader;

enum { CAGD_MOST_NODES = 20000 };

/* Starts at text[from..to); 0 and the error where there are no tokens. */
int cagd_reader_open(cagd_reader *r, const cagd_scope *scope, const char *text, int from, int to,
                     cagd_reading_error *error);

/* Formulas below one another, with which the tokens begin, stand side by side with commas between. */
void cagd_open_rows(cagd_token list[]);

/* Whether the next token is that word; whether it was, and then it is passed; and the same or an error. */
int cagd_next_is(const cagd_reader *r, const char *word);
int cagd_pass(cagd_reader *r, const char *word);
int cagd_expect(cagd_reader *r, const char *word, const char *after);
/* An error at the next token, or at a tree: NULL. */
cagd_tree *cagd_refuse_token(cagd_reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));
cagd_tree *cagd_refuse_tree(cagd_reader *r, const cagd_tree *t, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* What messages call the next token. */
const char *cagd_name_of_next(const cagd_reader *r);

/* A tree of the reader: like cagd_tree_new, counted. */
cagd_tree *cagd_new(cagd_reader *r, cagd_tree_kind kind, int from, int count);
/* The same with these children; NULL if one of them is. */
cagd_tree *cagd_new_of(cagd_reader *r, cagd_tree_kind kind, int from, int count, const cagd_tree *const child[]);

/* Sets the dimension of t by that of its parts, if they fit; otherwise an error, and NULL. */
cagd_tree *cagd_with_dimension(cagd_reader *r, cagd_tree *t);
/* What messages call what has that dimension: "a vector of 3 components". */
const char *cagd_called(int dimension);
/* The component number k of a vector or matrix, from 0. */
const cagd_tree *cagd_component_of(cagd_reader *r, const cagd_tree *t, int k);
/* a b for matrices and vectors, if they fit; a product of several factors, some of them matrices, from the left. */
const cagd_tree *cagd_matrix_product(cagd_reader *r, const cagd_tree *a, const cagd_tree *b);
const cagd_tree *cagd_chain_of_matrices(cagd_reader *r, const cagd_tree *t);
/* The matrix whose columns are these vectors, which have to be of one dimension. */
const cagd_tree *cagd_columns_of(cagd_reader *r, int count, const cagd_tree *const list[], int from);
/* The determinant of a square matrix; a matrix to a whole power, perhaps below 0; transposed. */
const cagd_tree *cagd_determinant_of(cagd_reader *r, const cagd_tree *t, int from);
const cagd_tree *cagd_matrix_power(cagd_reader *r, const cagd_tree *t, const cagd_tree *exponent);
const cagd_tree *cagd_transposed(cagd_reader *r, const cagd_tree *t);
/* Whether the sign of transposition comes next, behind ^; then it is passed. */
int cagd_pass_transposed(cagd_reader *r);
/* The environment of a matrix, if its name in braces comes next: then it is passed.  The entries behind it, up to its end. */
const char *cagd_pass_matrix(cagd_reader *r);
/* The columns, {ccc}, behind \begin{array}. */
int cagd_pass_columns(cagd_reader *r);
const cagd_tree *cagd_read_matrix(cagd_reader *r, const char *name, int from);
/* Whether the name of an environment comes next, in braces; then it is passed. */
int cagd_environment(cagd_reader *r, const char *name);
/* The factor b behind a with "*" or "\times" between, one of them a vector; of two vectors a product of vectors. */
const cagd_tree *cagd_vector_product(cagd_reader *r, const char *sign, const cagd_tree *a, const cagd_tree *b);
/* Behind the first of several values with commas between: a point, or the mixed product of three vectors. */
const cagd_tree *cagd_read_point(cagd_reader *r, const cagd_tree *first, const char *close, int from);
/* What stands in square brackets: [x \; y] is a point, [a b c] of three vectors their mixed product; else t itself. */
const cagd_tree *cagd_in_square_brackets(cagd_reader *r, const cagd_tree *t);
/* Dots between before[0..count) and the last term, factor or member: the sum, product, greatest or smallest over an index that stands for the terms from
 * before[*start] to the last; where the signs before and behind the dots differ, the terms alternate.  An error at the dots, and NULL, where what they leave out is not evident. */
const cagd_tree *cagd_fill_dots(cagd_reader *r, cagd_tree_kind kind, const cagd_token *dots,
                                const cagd_tree *const before[], int count, const cagd_tree *last, int signs_differ,
                                int *start);
/* Dots between members of a chain, with one relation between all of before[0..count) and the last one: that it is between any two neighbours from
 * before[*start] on, if the ends say which; NULL and no error where they do not. */
const cagd_tree *cagd_fill_chain(cagd_reader *r, const cagd_tree *const before[], int count, const cagd_tree *last,
                                 cagd_relation relation, int *start);
/* Whole numbers: low, low + step, ..., high, or without an end where high is NULL; or those that are listed, one by one. */
typedef struct cagd_list {
    const cagd_tree *low, *high;
    long step;
    const cagd_tree *const *listed;
    int count, is_list; /* is_list: what is wrong with it is wrong as a list */
} cagd_list;
enum { CAGD_MOST_SHOWN = 8 };
/* The list that comes next, of the numbers of that letter: 0, 1, \dots, n; 2, 4, \dots, 8; 0(2)8; 0, 2, 4.  1; 0 where there is one number alone, which is
 * read as its low end; -1 and an error. */
int cagd_read_list(cagd_reader *r, const char *letter, cagd_list *list);
/* Whether these words may stand before a range, or before what a definition is given for: "for all", "where", "even"; none, too. */
int cagd_are_words_of_range(const char *words);
/* That the words that come next are none of these: NULL. */
cagd_tree *cagd_refuse_words(cagd_reader *r, const char *words);
/* Behind a list of ranges, before which the scope was `before`: bounds and values are those of the indices of which the list speaks.  0 and the error
 * where bounds for some indices do not go together with others. */
int cagd_restrict_to_ranges(cagd_reader *r, cagd_scope *scope, const cagd_scope *before);
/* The condition that the name is a whole number. */
const cagd_tree *cagd_is_whole(cagd_reader *r, const cagd_tree *name);
/* Whether it is a whole number that fits. */
int cagd_is_whole_in_long(const cagd_tree *t, long *value);
/* That the name is one of them, as a condition; an error where that depends on what the letters in the ends are. */
const cagd_tree *cagd_is_in_list(cagd_reader *r, const cagd_tree *name, const cagd_list *list);
/* What is said of each number of the list in the place of the letter, or of one of them, as the kind of a quantifier has it. */
const cagd_tree *cagd_over_list(cagd_reader *r, cagd_tree_kind kind, int from, const char *letter,
                                const cagd_list *list, const cagd_tree *body);
/* i = 0, 1, \dots, n as a condition, if it comes next; NULL and no error where it does not. */
const cagd_tree *cagd_read_list_condition(cagd_reader *r);
/* Behind one value of the letter: whether others that are no whole numbers follow, t = 0, 1/2, 1: then an error. */
int cagd_refuse_values(cagd_reader *r, const char *letter);
/* The condition that a whole number is even, or odd, if it comes next, n \text{ even}: NULL and no error where it does not.  And whether it does. */
const cagd_tree *cagd_read_parity(cagd_reader *r);
int cagd_next_is_parity(const cagd_reader *r);
/* Whether these words end with "even" or "odd": -1, 1; 0 where they do not; and the condition that the letter that comes next, which is not passed, is so. */
int cagd_parity_of_words(const char *words);
const cagd_tree *cagd_is_of_parity(cagd_reader *r, int parity);
/* Whether b - a is a whole number whatever the names in it are. */
int cagd_difference_is_number(const cagd_tree *a, const cagd_tree *b, long *number);
/* Whether b - a is a multiple of that number for all whole numbers in the place of its names. */
int cagd_difference_is_multiple(const cagd_tree *a, const cagd_tree *b, long number);
/* A chain of relations; between vectors, of each component. */
const cagd_tree *cagd_relate(cagd_reader *r, int from, int count, const cagd_tree *const list[],
                             const cagd_relation relation[]);

/* A sum of products; a product; the argument of a command or a script, in braces or a single token. */
const cagd_tree *cagd_read_sum(cagd_reader *r);
const cagd_tree *cagd_read_product(cagd_reader *r);
/* The number \pi, which was not declared, up to the last token. */
const cagd_tree *cagd_read_argument(cagd_reader *r, int is_script);
/* One factor; a product, or, behind the sign of one over that index, what it goes over. */
const cagd_tree *cagd_read_factor(cagd_reader *r);
const cagd_tree *cagd_read_product_in(cagd_reader *r, cagd_tree_kind inside, const char *index);
/* Behind \frac, \sqrt, \sum or \prod, \int, which began at `from`. */
const cagd_tree *cagd_read_fraction(cagd_reader *r, int from);
const cagd_tree *cagd_read_root(cagd_reader *r, int from);
const cagd_tree *cagd_read_over(cagd_reader *r, cagd_tree_kind kind, int from);
const cagd_tree *cagd_read_integral(cagd_reader *r, int from);
/* How many tokens a differential sign has that begins at t: d, \partial, \mathrm{d}; 0 where there is none. */
int cagd_differential(const cagd_reader *r, const cagd_token *t);
/* A chain of relations, and conditions with "," or "and" between; a truth. */
const cagd_tree *cagd_read_relations(cagd_reader *r);
const cagd_tree *cagd_read_conditions(cagd_reader *r);
/* Conditions, and perhaps others behind \lor or "or". */
const cagd_tree *cagd_read_alternatives(cagd_reader *r);
/* What is true or false: conditions, with implications, "or", "not" and quantifiers between. */
const cagd_tree *cagd_read_truth(cagd_reader *r);
/* A truth, perhaps behind \forall and names that stand for all numbers anyway. */
const cagd_tree *cagd_read_for_all_numbers(cagd_reader *r);
int cagd_forall_of_names(const cagd_reader *r);
/* Whether names and \in come next, with no relation before it: what follows is said of them. */
int cagd_next_is_member(const cagd_reader *r);
const cagd_tree *cagd_read_members(cagd_reader *r);
/* The list that comes next, 0 \le u, v \le 1 or x, y > 0, becomes a relation for each name; what is no such list stays.  0 and an error where both
 * can be meant. */
int cagd_share_bounds(cagd_reader *r);
/* And names with the same value, \omega_0 = \omega_2 = 1, which become an equality for each. */
void cagd_share_value(cagd_reader *r);
/* One condition: a chain of relations, or a truth in brackets. */
const cagd_tree *cagd_read_condition(cagd_reader *r);
/* Whether a letter and "=", or \in \{, begin there; and, if it is a range of whole numbers with an end, i = 0, 1, \dots, n, i = 0, 1, 2, i \in \{0, \dots, n\}:
 * then it is passed.  Otherwise nothing is, and that is no error. */
int cagd_begins_range(const cagd_token *t);
int cagd_read_index_range(cagd_reader *r, cagd_list *list);
int cagd_relation_next(const cagd_reader *r, cagd_relation *relation);
/* Whether \quad or another wide space stands before the next token: it divides formulas as a comma does. */
int cagd_is_behind_wide_space(const cagd_reader *r);
/* Whether a chain has relations of both directions. */
int cagd_changes_direction(const cagd_relation relation[], int count);
/* The words of \text{...} if they come next, passed; "" for an empty one, and NULL if none comes next. */
const char *cagd_read_words(cagd_reader *r);

/* A name with indices and arguments, and perhaps a power, if the next token begins one. */
int cagd_begins_name(const cagd_reader *r);
const cagd_tree *cagd_read_name(cagd_reader *r);
/* {B_i^n}'(t): a name in brackets, and primes and arguments behind them. */
const cagd_tree *cagd_read_primed_group(cagd_reader *r, const cagd_tree *t);
/* Whether the square bracket that comes next has functions or vectors in it, so that it is a factor. */
int cagd_bracket_has_function(const cagd_reader *r);
/* Whether the round bracket that comes next has a relation in it, so that it is no factor: (x > 0). */
int cagd_is_truth_in_brackets(const cagd_reader *r);
/* t to a power, t a number or a matrix; with halves, 3/2, a power of the square root. */
const cagd_tree *cagd_power_of(cagd_reader *r, const cagd_tree *t, const cagd_tree *power, int from);
/* Whether t is a function without its arguments; whether such a one is in it, and a bracket comes next, which can be its arguments or a
 * factor, or primes: then an error.  A bracket with functions is a factor. */
int cagd_is_bare_function(const cagd_reader *r, const cagd_tree *t);
int cagd_refuse_argument(cagd_reader *r, const cagd_tree *t);
/* On the left of a definition, of which the right side comes next: how many arguments that letter has there, being a function, K(f) = f(0) + f(1); 0 of a
 * number. */
int cagd_arity_of_argument(const cagd_reader *r, const char *letter);
/* What the value t of d, which is of functions, stands for: the right side with what is given. */
const cagd_tree *cagd_put_in_functional(cagd_reader *r, const cagd_definition *d, const cagd_tree *t);
/* The letter with its faces: "t", "\hat{\omega}". */
const char *cagd_read_head(cagd_reader *r);
/* Whether another definition comes next, behind the condition of one: of the same name, or of one that is not known. */
int cagd_next_is_other_definition(const cagd_reader *r);
/* What messages call a head: "t_i" for "t_". */
const char *cagd_spelled(const char *head);
int cagd_is_known(const cagd_reader *r, const char *head);
/* That a letter alone is not defined, with what gives it a meaning: NULL. */
cagd_tree *cagd_complain_of_letter(cagd_reader *r, int from, int to, const char *letter);
/* Whether it is made of whole numbers and names that stand for such, and which of both are in it: n, n-1, 3. */
int cagd_is_of_whole_numbers(const cagd_reader *r, const cagd_tree *t, int *has_name);
/* Whether a letter may stand here that is not known. */
int cagd_may_be_unknown(const cagd_reader *r);
int cagd_is_bound(const cagd_reader *r, const char *head);
/* ---- read_rows.c ----------------------------------------------------------------------------------------- */

/* Whether some row has an arrow, "for" and the like: these reach over that row alone; and rows, each of them read as if it stood alone. */
int cagd_are_read_apart(const cagd_reader *r);
const cagd_tree *cagd_read_rows_apart(cagd_reader *r);
/* Whether nothing but a full stop comes next: then that is passed; otherwise what stands there is refused. */
int cagd_at_the_end(cagd_reader *r);

/* ---- read_own_ranges.c ----------------------------------------------------------------------------------- */

/* Ranges of indices in what is supposed, "if a_j = 0 for j = 1, 2": it is supposed for all of them. */
typedef struct cagd_own_ranges {
    struct cagd_bound letter[CAGD_MOST_INDICES];
    cagd_list list[CAGD_MOST_INDICES];
    int count;
} cagd_own_ranges;
/* Takes the ranges out of what is supposed and comes next; their letters are known from here on.  With `known`, also those of whole numbers that were declared. */
int cagd_take_ranges(cagd_reader *r, int known, cagd_own_ranges *own);
/* What was supposed, for all of its own ranges. */
const cagd_tree *cagd_for_own_ranges(cagd_reader *r, const cagd_tree *t, const cagd_own_ranges *own);
/* The token that ends what is supposed and begins at r->token. */
const cagd_token *cagd_end_of_supposed(const cagd_reader *r);
/* A row, and the ranges behind it of letters that mean nothing else, a_i = 1, \quad 0 \le i \le n, up to the last token: it is said for all of these.  Whether there
 * are some. */
const cagd_tree *cagd_read_row(cagd_reader *r);
int cagd_row_has_range(const cagd_reader *r);
/* Whether a text says this and nothing else; commas around it, and how it begins, do not count. */
int cagd_is_said(const char *text, const char *words);

/* ---- read_declaration.c, read_range.c -------------------------------------------------------------------- */

/* Tries that fail leave no trace: cagd_back goes to where the reader was, and is 0. */
typedef struct cagd_place {
    const cagd_token *token;
    int depth;
} cagd_place;
cagd_place cagd_here(const cagd_reader *r);
int cagd_back(cagd_reader *r, cagd_place p);
/* A name as it is declared: its indices are letters or numbers. */
const cagd_tree *cagd_read_declared_name(cagd_reader *r);
/* Ranges with commas between, up to the end; `before` is what was declared before this line. */
int cagd_read_list_of_ranges(cagd_reader *r, cagd_scope *scope, const cagd_scope *before);
/* Whether the name can be the left side of a definition; with the condition *given that its indices are, which are numbers. */
int cagd_is_left_side(cagd_reader *r, const cagd_tree *left, int may_repeat);
const cagd_tree *cagd_with_given_indices(cagd_reader *r, const cagd_scope *scope, const cagd_tree *left,
                                         const cagd_tree **given);
/* Whether a letter is called as last indices are, and is one, a whole number. */
int cagd_is_last_index(const cagd_scope *scope, const char *letter);
/* Of what has a last index that is not known it is asked whether all are meant; `value`: NULL for bounds. */
int cagd_refuse_degree(cagd_reader *r, const cagd_scope *scope, const cagd_tree *name, const cagd_tree *value);

#endif
