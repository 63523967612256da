double plain_part(double x);
double plain_part(double x) { double *restrict p = &x; return *p / 5; } /* no C++ */
double half_of(double x);
double half_of(double x) { return x / 2; }
