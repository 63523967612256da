/* Compiled with optimisation: plain operations, vectors, select and phi. */
double dot(int n, const double *a, const double *b)
{
    double s = 0;
    for (int i = 0; i < n; i++)
        s += a[i] * b[i];
    return s;
}
double horner(int n, const double *a, double x)
{
    double s = a[n];
    while (n-- > 0)
        s = s * x + a[n];
    return s;
}
double largest(int n, const double *a)
{
    double m = a[0];
    for (int i = 1; i < n; i++)
        m = a[i] > m ? a[i] : m;
    return m;
}
double product(int n, const double *a)
{
    double s = 1;
    for (int i = 0; i < n; i++)
        s *= a[i];
    return s;
}
float product_of_floats(int n, const float *a)
{
    float s = 1;
    for (int i = 0; i < n; i++)
        s *= a[i];
    return s;
}
float sum_of_floats(int n, const float *a)
{
    float s = 0;
    for (int i = 0; i < n; i++)
        s += a[i];
    return s;
}
/* What holds of x and y, a bit for each relation and for what is not so. */
int relations(double x, double y)
{
    return (x < y) + 2 * (x <= y) + 4 * (x > y) + 8 * (x >= y) + 16 * (x == y) + 32 * (x != y) + 64 * !(x < y) + 128 * !(x <= y) + 256 * !(x > y) +
           512 * !(x >= y) + 1024 * __builtin_isunordered(x, y) + 2048 * !__builtin_isunordered(x, y) + 4096 * __builtin_islessgreater(x, y) +
           8192 * !__builtin_islessgreater(x, y);
}
struct three { double x[3]; };
void assign(struct three *to, const struct three *from);
void assign(struct three *to, const struct three *from) { *to = *from; }
void scale(int n, double *restrict a, double x)
{
    for (int i = 0; i < n; i++)
        a[i] *= x;
}
/* Every operation that has an instruction of its own. */
double every(double x, double y, int n, unsigned m)
{
    return x + y - x / y + (int)x + (unsigned)y + n + m + (float)(x / 3);
}
/* What is asked of the bits of a number: whether it is one, which is the same for all numbers; and what is not. */
static unsigned long bits_of(double x) { unsigned long bits; __builtin_memcpy(&bits, &x, sizeof bits); return bits; }
static unsigned bits_of_float(float x) { unsigned bits; __builtin_memcpy(&bits, &x, sizeof bits); return bits; }
int is_no_number(double x) { return (bits_of(x) & 0x7FFFFFFFFFFFFFFF) > 0x7FF0000000000000; }
int is_infinite(double x) { return bits_of(x) << 1 == 0xFFE0000000000000; }
int is_infinite_float(float x) { return (bits_of_float(x) & 0x7FFFFFFF) == 0x7F800000; }
int is_below_a_third(double x) { return (bits_of(x) & 0x7FFFFFFFFFFFFFFF) < 0x3FD5555555555555; }
int is_below_a_third_float(float x) { return (bits_of_float(x) & 0x7FFFFFFF) < 0x3EAAAAAB; }
int is_a_third(double x) { return bits_of(x) << 1 == 0x7FAAAAAAAAAAAAAA; }
int is_zero(double x) { return bits_of(x) << 1 == 0; }
int exponent(double x) { return (int)((bits_of(x) & 0x7FFFFFFFFFFFFFFF) >> 52); }
int is_no_power(double x) { return ((bits_of(x) & 0x7FFFFFFFFFFFFFFF) - 1) >> 52 != 0; }
