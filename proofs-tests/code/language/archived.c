double from_an_archive(double x);
double from_an_archive(double x) { return x * x; }
