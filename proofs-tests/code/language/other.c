/* A second file: what it defines, storage.c's neighbours do not see. */
static double hidden = 0.75;
double from_another_file(double x);
double from_another_file(double x) { return x * hidden; }
