/* Reads and writes outside of what an address belongs to.  "! TEXT": the message has it, and names the line that ends in "// here";
 * the last programs stay inside in ways that look as if they did not. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Numbers, whose address came from somewhere. */
static double at(const double *p, long k) { return p[k]; }
static double *memory(int n)
{
    double *p = malloc((size_t)n * sizeof *p);
    for (int i = 0; i < n; i++)
        p[i] = 1 + i / 3.0;
    return p;
}

/* ! 8 bytes before the beginning of the memory */
double o_before_memory(void)
{
    double *p = memory(4);
    return p[-1] + 1; // here
}
/* ! 8 bytes before the beginning of the memory */
double o_before_memory_that_is_not_used_further(void)
{
    double *p = memory(4);
    volatile int i = 3;
    while (i > -1 && p[--i] > 0) // here
        ;
    return 5;
}
/* ! 0 bytes behind the end of the memory */
double o_behind_memory(void)
{
    double *p = memory(4);
    return p[4] + 1; // here
}
/* ! outside an array */
double o_far_before_memory(void)
{
    double *p = memory(4), *q = memory(4);
    (void)q;
    return p[-9] + 1; // here
}
/* ! outside */
double o_into_other_memory(void)
{
    double *p = memory(4), *q = memory(4);
    long far = q - p;
    return p[far] + 1; // here
}
/* ! outside */
double o_into_other_memory_in_steps(void)
{
    double *p = memory(4), *q = memory(4), *walk = p;
    while (walk != q)
        walk++; // here
    return *walk;
}
/* ! before the beginning */
double o_before_memory_of_calloc(void)
{
    double *p = calloc(4, sizeof *p);
    return p[-1] + 1; // here
}
/* ! before the beginning */
double o_before_memory_of_realloc(void)
{
    double *p = realloc(memory(2), 8 * sizeof *p);
    return p[-2] + 1; // here
}
/* ! 16 bytes behind the end */
double o_behind_memory_that_was_made_smaller(void)
{
    double *p = realloc(memory(8), 2 * sizeof *p);
    return p[4] + 1; // here
}
/* ! before the beginning */
double o_before_aligned_memory(void)
{
    double *p = aligned_alloc(64, 64);
    memset(p, 0, 64);
    return p[-1] + 1; // here
}
/* ! 4 bytes before the beginning of the memory */
double o_integers_before_memory(void)
{
    int *p = malloc(3 * sizeof *p);
    p[0] = p[1] = p[2] = 7;
    return p[-1]; // here
}
/* ! given back */
double o_memory_that_was_given_back(void)
{
    double *p = memory(4);
    free(p);
    return p[1] + 1; // here
}
/* ! given back */
double o_memory_given_back_twice(void)
{
    double *p = memory(4);
    free(p);
    free(p); // here
    return 1;
}
/* ! does not begin there */
double o_memory_given_back_from_its_middle(void)
{
    double *p = memory(4);
    free(p + 1); // here
    return 1;
}
/* ! something is put outside an array: 0 bytes behind the end */
double o_put_behind_memory(void)
{
    double *p = memory(4);
    p[4] = 1; // here
    return p[0];
}
/* ! something is put outside an array: 8 bytes before */
double o_put_before_memory(void)
{
    double *p = memory(4);
    p[-1] = 1; // here
    return p[0];
}
/* ! before the beginning of row, which has 32 bytes */
double o_before_an_array(void)
{
    double row[4] = {1, 2, 3, 4};
    double *p = row;
    return p[-1] + 1; // here
}
/* ! element -1 of 4 */
double o_element_before_an_array(void)
{
    double row[4] = {1, 2, 3, 4};
    volatile int i = -1;
    return row[i]; // here
}
/* ! element 4 of 4 */
double o_element_behind_an_array(void)
{
    double row[4] = {1, 2, 3, 4};
    volatile int i = 4;
    return row[i]; // here
}
/* ! element 3 of 3 */
double o_behind_a_row_of_a_matrix(void)
{
    double m[2][3] = {{1, 2, 3}, {4, 5, 6}};
    volatile int j = 3;
    return m[0][j]; // here
}
/* ! element 2 of 2 */
double o_behind_an_array_in_a_structure(void)
{
    struct { double a[2], b[2]; } s = {{1, 2}, {3, 4}};
    volatile int j = 2;
    return s.a[j]; // here
}
/* ! 0 bytes behind the end of y, which has 8 bytes */
double o_behind_one_number(void)
{
    double x = 1.0 / 3, y = 2.0 / 3, *p = &y;
    return at(&x, 0) + p[1]; // here
}
static double values[3] = {1, 2, 3};
/* ! 8 bytes before the beginning of values */
double o_before_a_global_array(void)
{
    const double *p = values;
    return p[-1]; // here
}
/* ! outside an array */
double o_far_before_a_variable_array(void)
{
    volatile int n = 3;
    double row[n], other[n];
    for (int i = 0; i < n; i++)
        row[i] = other[i] = i;
    double *p = row;
    return p[-7] + 1; // here
}
static double *kept;
static void keep(void)
{
    double x[2] = {1, 2};
    kept = x;
}
/* ! a function that has returned */
double o_array_of_a_function_that_returned(void)
{
    keep();
    return kept[1] + 1; // here
}
/* ! outside an array */
double o_copied_from_behind(void)
{
    double *p = memory(4), q[5];
    memcpy(q, p, sizeof q); // here
    return q[0];
}
/* ! outside an array */
double o_copied_to_behind(void)
{
    double *p = memory(4), q[5] = {1, 2, 3, 4, 5};
    memmove(p, q, sizeof q); // here
    return p[0];
}
/* ! which overlap */
double o_copied_over_itself(void)
{
    double *p = memory(4);
    for (int i = 0; i < 4; i++)
        p[i] = 1.0 / (i + 1);
    memcpy(p, p + 1, 3 * sizeof *p); // here
    return p[0];
}
/* = F(1, 3) */
double o_copied_beside(void)
{
    double *p = memory(4);
    for (int i = 0; i < 4; i++)
        p[i] = 1.0 / (i + 1);
    memcpy(p, p + 2, 2 * sizeof *p);
    return p[0];
}
/* ! outside an array */
double o_filled_behind(void)
{
    double *p = memory(4);
    memset(p, 0, 5 * sizeof *p); // here
    return p[0];
}
struct pair { double x, y; };
/* ! outside an array */
double o_structure_copied_from_behind(void)
{
    struct pair *p = malloc(2 * sizeof *p), q;
    p[0].x = p[1].y = 1;
    q = p[2]; // here
    return q.x;
}
/* ! outside an array */
double o_member_of_a_structure_behind(void)
{
    struct pair *p = malloc(sizeof(double));
    p->x = 1;
    return p->y; // here
}

/* = 6 */
double i_counted_from_one(void)
{
    double row[3] = {1, 2, 3}, *p = row - 1, s = 0;
    for (int i = 1; i <= 3; i++)
        s += p[i];
    return s;
}
/* = 21 */
double i_matrix_counted_from_one(void)
{
    double *block = malloc(6 * sizeof *block), **row = malloc(2 * sizeof *row), s = 0;
    row -= 1;
    for (int i = 1; i <= 2; i++)
        row[i] = block + 3 * (i - 1) - 1;
    for (int i = 1; i <= 2; i++)
        for (int j = 1; j <= 3; j++)
            row[i][j] = 3 * (i - 1) + j;
    for (int i = 0; i < 6; i++)
        s += block[i];
    free(row + 1);
    free(block);
    return s;
}
/* = 6 */
double i_backwards_to_one_before(void)
{
    double *p = malloc(3 * sizeof *p), s = 0;
    for (int i = 0; i < 3; i++)
        p[i] = i + 1;
    for (double *q = p + 2; q >= p; q--)
        s += *q;
    return s;
}
/* = 12 */
double i_columns_by_strides(void)
{
    double *m = malloc(9 * sizeof *m), s = 0;
    for (int i = 0; i < 9; i++)
        m[i] = i;
    for (double *p = m + 1, *end = p + 9; p < end; p += 3)
        s += *p;
    return s;
}
/* = 3 */
double i_from_the_end(void)
{
    double row[3] = {1, 2, 3}, *end = row + 3;
    return end[-1];
}
/* = 5 */
double i_structure_that_goes_on(void)
{
    struct tail { int n; double x[1]; } *t = malloc(sizeof *t + 4 * sizeof(double));
    for (t->n = 0; t->n < 5; t->n++)
        t->x[t->n] = t->n + 1;
    return t->x[4];
}
/* = 10 */
double i_matrix_as_one_array(void)
{
    double m[2][2] = {{1, 2}, {3, 4}}, *p = m[0], s = 0;
    for (int i = 0; i < 4; i++)
        s += p[i];
    return s;
}
static double sum_of(const void *p, size_t n)
{
    const double *x = p;
    double s = 0;
    while (n-- > 0)
        s += *x++;
    return s;
}
/* = 6 */
double i_compound_literal(void) { return sum_of((double[]){1, 2, 3}, 3); }
static int order(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}
/* = F(1, 3) */
double i_sorted(void)
{
    double x[40];
    for (int i = 0; i < 40; i++)
        x[i] = (i * 17 % 40 + 1) / 3.0;
    qsort(x, 40, sizeof *x, order);
    return x[0];
}
static double recursive(int n)
{
    double x[3] = {n, 1, 0};
    if (n > 0)
        x[2] = recursive(n - 1);
    return sum_of(x, 3);
}
/* = 66 */
double i_arrays_of_a_recursion(void) { return recursive(10); }
/* = 45 */
double i_variable_arrays_in_a_loop(void)
{
    double s = 0;
    for (int n = 1; n < 10; n++) {
        double x[n];
        for (int i = 0; i < n; i++)
            x[i] = 1;
        s += sum_of(x, (size_t)n);
    }
    return s;
}
/* = 100000 */
double i_much_memory_one_after_another(void)
{
    double s = 0;
    for (int i = 0; i < 100000; i++) {
        double *p = malloc(sizeof *p);
        *p = 1;
        s += *p;
        free(p);
    }
    return s;
}
/* = 4 */
double i_text(void)
{
    char text[16], *copy;
    strcpy(text, "four");
    copy = strdup(text);
    double n = (double)strlen(copy);
    free(copy);
    return n;
}
/* = F(1, 3) + 3 */
double o_the_address_behind_the_last(void)
{
    double a[3] = {1.0 / 3, 1, 2}, s = 0;
    double *end = &a[3];
    for (double *p = a; p < end; p++)
        s += *p;
    return s;
}
void cagd_code_output(const char *name, long count, const double *x);
/* ! a value from outside an array */
double o_told_behind_an_array(void)
{
    double a[3] = {1.0 / 3, 1, 2};
    cagd_code_output("a", 4, a);
    return a[0];
}
/* ! a value from outside an array */
double o_told_behind_an_array_of_variable_length(void)
{
    int n = 3;
    double a[n];
    for (int k = 0; k < n; k++)
        a[k] = 1.0 / 3;
    cagd_code_output("a", 4, a);
    return a[0];
}
/* ! a value from outside an array */
double o_told_before_an_array_of_variable_length(void)
{
    int n = 3;
    double a[n];
    for (int k = 0; k < n; k++)
        a[k] = 1.0 / 3;
    cagd_code_output("a", 2, a - 1);
    return a[0];
}
