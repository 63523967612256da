double from_the_same_archive(double x);
double from_the_same_archive(double x) { return x; }
