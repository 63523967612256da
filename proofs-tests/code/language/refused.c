/* What cannot be carried.  "! TEXT": the message has it, and names the line that ends in "// here". */
#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ! inline assembly */
double r_assembly(void)
{
    double x = 1.0 / 3;
    __asm__("addsd %0, %0" : "+x"(x)); // here
    return x;
}
/* ! 16 bits */
double r_half(void)
{
    __fp16 x = 1.0f / 3; // here
    return x;
}
/* ! malloc_usable_size */
double r_how_much_memory_there_is(void)
{
    double *x = malloc(sizeof *x);
    size_t malloc_usable_size(void *);
    return (double)malloc_usable_size(x); // here
}
/* = F(1, 3) */
double r_a_barrier_is_no_assembly(void) { double x = 1.0 / 3; __asm__ volatile("" ::: "memory"); return x; }
/* ! a division by zero */
double r_infinity_by_zero(void)
{
    double x = INFINITY, y = 0;
    return x / y; // here
}
/* ! bits of a number */
double r_exponent(void)
{
    double x = 1.0 / 3;
    uint64_t u;
    memcpy(&u, &x, sizeof u);
    return (double)(u >> 52); // here
}
/* ! bits of a number */
double r_union(void)
{
    union { double x; uint64_t u; } v = {1.0 / 3};
    return (v.u & 1) ? 1 : 0; // here
}
/* ! bits of a number */
double r_high_word(void)
{
    union { double x; uint32_t u[2]; } v = {1.0 / 3};
    return v.u[1] >> 20; // here
}
/* ! bits of a number */
double r_low_word(void)
{
    union { double x; uint32_t u[2]; } v = {1.0 / 3};
    return v.u[0] & 1; // here
}
/* ! bits of a number */
double r_bytes(void)
{
    double x = 1.0 / 3;
    unsigned h = 0;
    const unsigned char *p = (const unsigned char *)&x;
    for (int i = 0; i < 8; i++)
        h = 31 * h + p[i]; // here
    return h;
}
/* ! bits of a number */
double r_float_bits(void)
{
    float x = 1.0f / 3;
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    return u >> 23; // here
}
/* ! bits of an integer */
double r_integer_as_number(void)
{
    uint64_t u = 5;
    double x;
    memcpy(&x, &u, sizeof x);
    return x + 1; // here
}
/* ! long double */
double r_long_double(void)
{
    long double x = 1.0 / 3; // here
    return x;
}
/* ! the function tgamma */
double r_unknown_function(void)
{
    return tgamma(5); // here
}
/* ! the function jn */
double r_pointer_to_an_unknown_function(void)
{
    double (*f)(int, double) = jn;
    return f(1, 2); // here
}
double n_pow(double x); /* a name that a library below ours has, too */
/* ! the function n_pow, which is not in the sources */
double r_undefined_function(void)
{
    return n_pow(5); // here
}
int fmpz_init(int *x);
/* ! which is not in the sources */
double r_undefined_function_without_numbers(void)
{
    int x = 1;
    return fmpz_init(&x); // here
}
static void *nothing(void *p) { return p; }
/* ! the function pthread_create */
double r_thread(void)
{
    pthread_t t;
    return pthread_create(&t, NULL, nothing, NULL); // here
}
/* ! division by zero */
double r_division_by_zero(void)
{
    double x = 1.0 / 3 - 2.0 / 6;
    return 1 / x; // here
}
/* ! square root of a negative */
double r_root_of_a_negative(void)
{
    return sqrt(-1.0 / 3); // here
}
/* ! not rational */
double r_root_of_two(void)
{
    return sqrt(2); // here
}
/* ! not rational */
double r_sine(void)
{
    return sin(1); // here
}
/* ! pow */
double r_pow(void)
{
    return pow(2, 1.0 / 3); // here
}
/* ! never computed */
double r_uninitialised(void)
{
    double x;
    return x + 1; // here
}
/* ! never computed */
double r_uninitialised_array(void)
{
    double x[4], s = 0;
    for (int i = 0; i < 3; i++)
        x[i] = i;
    for (int i = 0; i < 4; i++)
        s += x[i]; // here
    return s;
}
/* ! never computed */
double r_uninitialised_memory(void)
{
    double *x = malloc(4 * sizeof *x);
    return x[2] * 2; // here
}
/* ! never computed */
double r_uninitialised_float(void)
{
    float x;
    return x * 2; // here
}
/* ! outside an array */
double r_behind_an_array(void)
{
    double x[4] = {1, 2, 3, 4}, s = 0;
    for (int i = 0; i <= 4; i++)
        s += x[i]; // here
    return s;
}
/* ! outside an array */
double r_before_an_array(void)
{
    double x[4] = {1, 2, 3, 4}, s = 0;
    for (int i = 3; i >= -1; i--)
        s += x[i]; // here
    return s;
}
/* ! outside an array */
double r_behind_a_variable_array(void)
{
    volatile int n = 3;
    double x[n], s = 0;
    for (int i = 0; i < n; i++)
        x[i] = i;
    for (int i = 0; i <= n; i++)
        s += x[i]; // here
    return s;
}
/* ! outside an array */
double r_behind_memory(void)
{
    double *x = calloc(1, 1), *y = malloc(3 * sizeof *y);
    (void)x;
    y[0] = y[1] = y[2] = 1;
    return y[3] + 1; // here
}
static double table[3] = {1, 2, 3};
/* ! outside an array */
double r_behind_a_global_array(void)
{
    volatile int n = 3;
    return table[n] + 1; // here
}
/* ! range of a signed integer */
double r_integer_too_large(void)
{
    double x = 1e10 / 3;
    return (int)x; // here
}
/* ! range of an unsigned integer */
double r_integer_below_zero(void)
{
    double x = -4.0 / 3;
    return (unsigned)x; // here
}
/* ! infinity */
double r_integer_of_infinity(void)
{
    return (int)INFINITY; // here
}
/* ! bits */
double r_number_too_large(void)
{
    double x = 3;
    for (int i = 0; i < 40; i++)
        x *= x; // here
    return x;
}
/* ! memcmp */
double r_memcmp(void)
{
    double a[2] = {1.0 / 3, 1}, b[2] = {2.0 / 6, 1};
    return memcmp(a, b, sizeof a); // here
}
/* ! conversion */
double r_printf(void)
{
    int n;
    char b[20];
    sprintf(b, "%g%n", 1.0 / 3, &n); // here
    return n;
}
/* ! memory was used */
double r_null(void)
{
    double *p = NULL;
    double x = 1.0 / 3;
    x = x + 1;
    *p = x; // here
    return 0;
}
/* ! an integer was divided by zero */
double r_integer_by_zero(void)
{
    volatile int n = 0;
    double x = 1.0 / 3;
    x = x + 7 / n; // here
    return x;
}
/* ! aborted */
double r_abort(void)
{
    double x = 1.0 / 3;
    if (x < 1)
        abort(); // here
    return 0;
}
/* ! ended its process */
double r_exit(void) { exit(7); }
/* ! does not specify */
double r_frexp_of_an_infinity(void)
{
    int e;
    frexp(INFINITY, &e); // here
    return e;
}
/* ! complex numbers with an infinity */
double r_complex_product_with_an_infinity(void)
{
    double _Complex z = __builtin_complex((double)INFINITY, (double)NAN), w = z * __builtin_complex(1.0, 1.0); // here
    return __real__ w;
}
/* ! complex number with an infinity */
double r_complex_root_of_an_infinity(void)
{
    double _Complex csqrt(double _Complex);
    return __real__ csqrt(__builtin_complex(-(double)INFINITY, 1.0)); // here
}
/* ! beyond 2^100000 */
double r_scalbln(void)
{
    double x = 1.0 / 3;
    return scalbln(x, (-0x7FFFFFFFFFFFFFFF - 1)); // here
}
