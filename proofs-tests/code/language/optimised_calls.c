double dot(int n, const double *a, const double *b);
double horner(int n, const double *a, double x);
double largest(int n, const double *a);
void scale(int n, double *restrict a, double x);
double every(double x, double y, int n, unsigned m);
/* = F(1, 3) */
double o_dot(void) { double a[8], b[8]; for (int i = 0; i < 8; i++) a[i] = i < 4 ? 1.0 / 3 : -1.0 / 5, b[i] = i == 2; scale(8, b, 1); return dot(8, a, b); }
/* = 1 + F(10, 9) + F(100, 81) */
double o_horner(void) { double a[3] = {1.0, 10.0 / 3, 100.0 / 9}; return horner(2, a, 1.0 / 3); }
/* = F(5, 7) */
double o_largest(void) { double a[5] = {1.0 / 3, 5.0 / 7, 2.0 / 3, -1, 0}; return largest(5, a); }
/* = F(15, 4) + 3 + 2 + 5 + 7 + F(7, 6) */
double o_every(void) { return every(7.0 / 2, 2, 5, 7); }
