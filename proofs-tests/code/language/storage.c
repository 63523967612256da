/* Arrays, structs, unions, pointers, calls, memory: a double is 64 bits that are carried. */
#include <stdarg.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <setjmp.h>
#include <complex.h>

struct point { double x, y; };
struct segment { struct point a, b; int n; };
struct small { float a, b; };
struct odd { char c; double x; short s; float f; };
struct large { double x[9]; };
union either { double x; struct point p; double a[2]; };

/* = F(1, 3) + F(2, 3) ** 2 */
double s_array(void) { double x[3]; for (int i = 0; i < 3; i++) x[i] = i / 3.0; return x[1] + x[2] * x[2]; }
/* = sum(F(i, 7) * F(j, 3) for i in range(3) for j in range(4)) */
double s_matrix(void) { double m[3][4], s = 0; for (int i = 0; i < 3; i++) for (int j = 0; j < 4; j++) m[i][j] = i / 7.0 * (j / 3.0);
    for (int i = 0; i < 12; i++) s += (&m[0][0])[i]; return s; }
/* = F(25, 3) */
double s_variable_length(void) { volatile int n = 5; double x[n], s = 0; for (int i = 0; i < n; i++) x[i] = (2 * i + 1) / 3.0; for (int i = 0; i < n; i++) s += x[i]; return s; }
/* = F(5, 21) */
double s_struct(void) { struct point p = {1.0 / 3, 5.0 / 7}, q = p; return q.x * q.y; }
/* = F(1, 3) + F(1, 5) + F(1, 7) + F(1, 9) */
double s_nested(void) { struct segment s = {{1.0 / 3, 1.0 / 5}, {1.0 / 7, 1.0 / 9}, 2}, t; t = s; return t.a.x + t.a.y + t.b.x + t.b.y; }
static struct point middle(struct point a, struct point b) { return (struct point){(a.x + b.x) / 2, (a.y + b.y) / 2}; }
/* = F(1, 6) + F(5, 14) */
double s_struct_by_value(void) { struct point m = middle((struct point){0, 0}, (struct point){1.0 / 3, 5.0 / 7}); return m.x + m.y; }
static struct small swapped(struct small s) { return (struct small){s.b, s.a}; }
/* = F(1, 7) - F(1, 3) */
double s_struct_of_floats(void) { struct small s = swapped((struct small){1.0f / 3, 1.0f / 7}); return s.a - s.b; }
static struct odd moved(struct odd o) { o.x += 1; o.f += o.s; return o; }
/* = F(4, 3) + F(22, 7) + 65 */
double s_mixed_struct(void) { struct odd o = {'A', 1.0 / 3, 3, 1.0f / 7}; o = moved(o); return o.x + o.f + o.c; }
static double total(struct large l) { double s = 0; for (int i = 0; i < 9; i++) s += l.x[i]; return s; }
/* = F(36, 11) */
double s_large_by_value(void) { struct large l; for (int i = 0; i < 9; i++) l.x[i] = i / 11.0; return total(l); }
static struct large filled(double x) { struct large l; for (int i = 0; i < 9; i++) l.x[i] = x; return l; }
/* = 9 * F(2, 7) */
double s_large_returned(void) { return total(filled(2.0 / 7)); }
/* = F(1, 3) */
double s_union(void) { union either u; u.x = 1.0 / 3; return u.p.x; }
/* = F(2, 3) */
double s_union_of_array(void) { union either u = {.p = {1.0 / 3, 2.0 / 3}}; return u.a[1]; }
/* = F(8, 5) */
double s_memcpy(void) { double a[4] = {1.0 / 5, 2.0 / 5, 3.0 / 5, 2.0 / 5}, b[4], s = 0; memcpy(b, a, sizeof b); for (int i = 0; i < 4; i++) s += b[i]; return s; }
/* = F(1, 9) */
double s_memmove(void) { double a[4] = {1.0 / 9, 2, 3, 4}; memmove(a + 1, a, 3 * sizeof *a); return a[1]; }
/* = 0 */
double s_memset(void) { double a[4] = {1, 2, 3, 4}, s = 0; memset(a, 0, sizeof a); for (int i = 0; i < 4; i++) s += a[i]; return s; }
/* = F(10, 3) */
double s_malloc(void) { double *a = malloc(4 * sizeof *a), s = 0; for (int i = 0; i < 4; i++) a[i] = (i + 1) / 3.0; for (int i = 0; i < 4; i++) s += a[i]; free(a); return s; }
/* = F(3, 7) */
double s_calloc(void) { double *a = calloc(4, sizeof *a); a[1] = 3.0 / 7; double s = a[0] + a[1] + a[2]; free(a); return s; }
/* = F(5, 9) */
double s_realloc(void) { double *a = malloc(sizeof *a); a[0] = 5.0 / 9; a = realloc(a, 1000 * sizeof *a); a[999] = 1; double s = a[0]; free(a); return s; }
/* = F(3, 11) */
double s_bytes_copied_by_hand(void) { double x = 3.0 / 11, y; const char *a = (const char *)&x; char *b = (char *)&y; for (unsigned i = 0; i < sizeof x; i++) b[i] = a[i]; return y; }
/* = F(3, 13) */
double s_bits_carried_as_integers(void) { double x = 3.0 / 13, y; uint64_t u; memcpy(&u, &x, sizeof u); memcpy(&y, &u, sizeof y); return y; }
/* = F(1, 7) */
double s_pointer_to_pointer(void) { double x = 1.0 / 7, *p = &x, **q = &p; return **q; }
static void swap(double *a, double *b) { double t = *a; *a = *b; *b = t; }
/* = F(1, 3) - F(1, 5) */
double s_swap(void) { double a = 1.0 / 5, b = 1.0 / 3; swap(&a, &b); return a - b; }
static double global = 0.25, table[5] = {1, 0.5, 0.25};
/* = F(3, 4) + F(1, 3) */
double s_global(void) { double s = global + table[1]; global = 1.0 / 3; return s + global; }
static double counted(void) { static double n = 0.5; n += 1.0 / 3; return n; }
/* = F(5, 6) + F(7, 6) */
double s_static(void) { return counted() + counted(); }
static _Thread_local double own = 0.5;
/* = F(1, 2) + F(1, 7) */
double s_thread_local(void) { own += 1.0 / 7; return own; }
static double power(double x, int n) { return n == 0 ? 1 : x * power(x, n - 1); }
/* = F(2, 3) ** 9 */
double s_recursion(void) { return power(2.0 / 3, 9); }
static double square(double x) { return x * x; }
static double cube(double x) { return x * x * x; }
/* = F(1, 9) + F(1, 27) */
double s_function_pointer(void) { double (*f[2])(double) = {square, cube}, s = 0; for (int i = 0; i < 2; i++) s += f[i](1.0 / 3); return s; }
static double apply(double (*f)(double), double x) { return f(f(x)); }
/* = F(1, 3) ** 4 */
double s_callback(void) { return apply(square, 1.0 / 3); }
static double add_all(int n, ...) { va_list l; double s = 0; va_start(l, n); for (int i = 0; i < n; i++) s += va_arg(l, double); va_end(l); return s; }
/* = sum(F(1, k) for k in range(2, 14)) */
double s_variable_arguments(void) { return add_all(12, 1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5, 1.0 / 6, 1.0 / 7, 1.0 / 8, 1.0 / 9, 1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13); }
static double mixed(const char *f, ...) { va_list l; double s = 0; va_start(l, f); for (; *f; f++) s += *f == 'i' ? va_arg(l, int) : va_arg(l, double); va_end(l); return s; }
/* = 5 + F(1, 3) + F(1, 7) */
double s_mixed_arguments(void) { return mixed("idid", 2, 1.0 / 3, 3, 1.0 / 7); }
static double many(double a, double b, double c, double d, double e, double f, double g, double h, double i, double j) { return a - b + c - d + e - f + g - h + i - j; }
/* = sum((-1) ** k * F(1, k + 1) for k in range(10)) */
double s_arguments_on_the_stack(void) { return many(1, 1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5, 1.0 / 6, 1.0 / 7, 1.0 / 8, 1.0 / 9, 1.0 / 10); }
static int rising(const void *a, const void *b) { double x = *(const double *)a, y = *(const double *)b; return (x > y) - (x < y); }
/* = F(1, 7) + 100 * F(1, 5) + 10000 * F(1, 3) */
double s_qsort(void) { double a[3] = {1.0 / 3, 1.0 / 7, 1.0 / 5}; qsort(a, 3, sizeof *a, rising); return a[0] + 100 * a[1] + 10000 * a[2]; }
/* = F(1, 5) */
double s_bsearch(void) { double a[3] = {1.0 / 7, 1.0 / 5, 1.0 / 3}, key = 2.0 / 10, *p = bsearch(&key, a, 3, sizeof *a, rising); return *p; }
static _Atomic double atom = 0.5;
/* = F(5, 6) */
double s_atomic(void) { atom += 1.0 / 3; return atom; }
/* = F(1, 3) */
double s_atomic_exchange(void) { _Atomic double a = 1.0 / 3; return atomic_exchange(&a, 2.0); }
typedef double pair __attribute__((vector_size(16)));
/* = (F(1, 3) + F(1, 5)) * (F(1, 7) - 2) */
double s_vector(void) { pair a = {1.0 / 3, 1.0 / 7}, b = {1.0 / 5, -2}, c = a + b; return c[0] * c[1]; }
/* = F(1, 15) - F(1, 3) / F(1, 7) */
double s_vector_operations(void) { pair a = {1.0 / 3, 1.0 / 3}, b = {1.0 / 5, 1.0 / 7}, p = a * b, q = -(a / b); return p[0] + q[1]; }
/* = -1 */
double s_vector_comparison(void) { pair a = {1.0 / 3, 1.0 / 3}, b = {1.0 / 5, 1.0 / 2}; typedef long longs __attribute__((vector_size(16))); longs c = a < b; return c[0] + c[1]; }
typedef float four __attribute__((vector_size(16)));
/* = F(10, 7) */
double s_vector_of_floats(void) { four a = {1, 2, 3, 4}; a /= 7; return a[0] + a[1] + a[2] + a[3]; }
/* = F(1, 3) * F(1, 7) - F(1, 5) * F(1, 11) */
double s_complex_product(void) { double complex a = __builtin_complex(1.0 / 3, 1.0 / 5), b = __builtin_complex(1.0 / 7, 1.0 / 11); return creal(a * b); }
/* = (F(1, 5) * F(1, 7) - F(1, 3) * F(1, 11)) / (F(1, 49) + F(1, 121)) */
double s_complex_quotient(void) { double complex a = __builtin_complex(1.0 / 3, 1.0 / 5), b = __builtin_complex(1.0 / 7, 1.0 / 11); return cimag(a / b); }
/* = F(5, 12) */
double s_cabs(void) { return cabs(__builtin_complex(1.0 / 4, 1.0 / 3)); }
static jmp_buf back;
static void jump(double *x) { *x = 1.0 / 3; longjmp(back, 1); }
/* = F(1, 3) */
double s_longjmp(void) { static double x; if (setjmp(back) == 0) jump(&x); return x; }
/* = F(7, 3) */
double s_compound_literal(void) { return *(double[]){7.0 / 3, 1}; }
/* = 4 + F(2, 3) */
double s_designated(void) { double a[6] = {[4] = 4, [2] = 2.0 / 3}; double s = 0; for (int i = 0; i < 6; i++) s += a[i]; return s; }
/* = F(11, 7) */
double s_generic(void) { double x = 11.0 / 7; return _Generic(x, double: x, float: 0); }
struct node { double x; struct node *next; };
/* = F(1, 2) + F(1, 3) + F(1, 4) */
double s_linked_list(void) { struct node *first = NULL; double s = 0; for (int i = 2; i < 5; i++) { struct node *n = malloc(sizeof *n); n->x = 1.0 / i; n->next = first; first = n; }
    for (; first != NULL;) { struct node *n = first; s += n->x; first = n->next; free(n); } return s; }
struct flexible { int n; double x[]; };
/* = F(6, 5) */
double s_flexible_member(void) { struct flexible *f = malloc(sizeof *f + 3 * sizeof(double)); f->n = 3; double s = 0; for (int i = 0; i < 3; i++) f->x[i] = (i + 1) / 5.0; for (int i = 0; i < f->n; i++) s += f->x[i]; free(f); return s; }
struct __attribute__((packed)) tight { char c; double x; };
/* = F(1, 3) */
double s_packed(void) { struct tight t = {1, 1.0 / 3}, u = t; return u.x; }
struct bits { unsigned a : 3, b : 5; double x; };
/* = 9 + F(1, 3) */
double s_bit_fields(void) { struct bits b = {5, 4, 1.0 / 3}; return b.a + b.b + b.x; }
/* = F(2, 3) */
double s_volatile(void) { volatile double x = 1.0 / 3; x = x + x; return x; }
/* = F(4, 3) */
double s_restrict(void) { double a[2] = {1.0 / 3, 1}; double *restrict p = a; return p[0] + p[1]; }
/* = F(1, 17) */
double s_alloca(void) { double *p = __builtin_alloca(8 * sizeof *p); p[7] = 1.0 / 17; return p[7]; }
