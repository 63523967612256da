/* What others miss of it has its name from an alias alone. */
static double cubed(double x) { return x * x * x; }
double from_an_alias(double x) __attribute__((alias("cubed")));
