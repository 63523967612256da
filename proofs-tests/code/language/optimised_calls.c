double dot(int n, const double *a, const double *b);
double horner(int n, const double *a, double x);
double largest(int n, const double *a);
void scale(int n, double *restrict a, double x);
double product(int n, const double *a);
float product_of_floats(int n, const float *a);
float sum_of_floats(int n, const float *a);
int relations(double x, double y);
struct three { double x[3]; };
void assign(struct three *to, const struct three *from);
double every(double x, double y, int n, unsigned m);
/* = F(1, 3) */
double o_dot(void) { double a[8], b[8]; for (int i = 0; i < 8; i++) a[i] = i < 4 ? 1.0 / 3 : -1.0 / 5, b[i] = i == 2; scale(8, b, 1); return dot(8, a, b); }
/* = 1 + F(10, 9) + F(100, 81) */
double o_horner(void) { double a[3] = {1.0, 10.0 / 3, 100.0 / 9}; return horner(2, a, 1.0 / 3); }
/* = F(5, 7) */
double o_largest(void) { double a[5] = {1.0 / 3, 5.0 / 7, 2.0 / 3, -1, 0}; return largest(5, a); }
/* = F(1, 3) */
double o_assigned(void) { struct three a = {{1.0 / 3, 1, 2}}, b; assign(&b, &a); assign(&b, &b); return b.x[0]; }
/* ! which overlap */
double o_assigned_over_itself(void) { double a[4] = {1, 2, 3, 4}; assign((struct three *)a, (struct three *)(a + 1)); return a[0]; }
/* = F(15, 4) + 3 + 2 + 5 + 7 + F(7, 6) */
double o_every(void) { return every(7.0 / 2, 2, 5, 7); }
int is_no_number(double), is_infinite(double), is_infinite_float(float), is_below_a_third(double), is_below_a_third_float(float), is_a_third(double), is_zero(double), exponent(double), is_no_power(double);
/* = 111 */
double o_bits_of_what_is_no_number(void) { double x = 1.0 / 3, i = __builtin_inf(), n = __builtin_nan(""); return is_infinite_float(i) + 10 * is_infinite(-i) + 100 * is_no_number(n) + is_no_number(i) + is_infinite(x) + is_no_number(x) + is_infinite_float(x); }
/* ! bits of a number */
double o_bits_below_a_third(void) { return is_below_a_third(1.0 / 4); }
/* ! bits of a number */
double o_bits_of_a_float_below_a_third(void) { return is_below_a_third_float(1.0 / 4); }
/* ! bits of a number */
double o_bits_of_a_third(void) { return is_a_third(1.0 / 3); }
/* ! bits of a number */
double o_bits_of_zero(void) { double x = 1.0 / 3; return is_zero(x - x); }
/* ! bits of a number */
double o_bits_of_an_exponent(void) { return exponent(1.0 / 3); }
/* ! bits of a number */
double o_bits_less_one(void) { return is_no_power(1.0 / 3); }
/* = math.prod(F(k + 1, k + 3) for k in range(13)) */
double o_product(void) { double a[13]; for (int k = 0; k < 13; k++) a[k] = (k + 1.0) / (k + 3); return product(13, a); }
/* = math.prod(F(k + 1, k + 3) for k in range(17)) + sum(F(k + 1, k + 3) for k in range(17)) */
double o_floats(void) { float a[17]; for (int k = 0; k < 17; k++) a[k] = (k + 1.0f) / (k + 3); return product_of_floats(17, a) + sum_of_floats(17, a); }
/* = sum(F(k, 7) * F(k, 3) for k in range(19)) */
double o_long_dot(void) { double a[19], b[19]; for (int k = 0; k < 19; k++) a[k] = k / 7.0, b[k] = k / 3.0; return dot(19, a, b); }
/* = 1 + 2 + 32 + 256 + 512 + 2048 + 4096 */
double o_less(void) { return relations(1.0 / 3, 1.0 / 2); }
/* = 4 + 8 + 32 + 64 + 128 + 2048 + 4096 */
double o_greater(void) { return relations(1.0 / 2, 1.0 / 3); }
/* = 2 + 8 + 16 + 64 + 256 + 2048 + 8192 */
double o_equal(void) { return relations(2.0 / 6, 1.0 / 3); }
/* = 32 + 64 + 128 + 256 + 512 + 1024 + 8192 */
double o_unordered(void) { return relations(__builtin_nan(""), 1.0 / 3); }
