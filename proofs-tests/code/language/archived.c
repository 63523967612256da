double from_an_archive(double x);
double from_the_same_archive(double x);
double from_an_archive(double x) { return from_the_same_archive(x) * x; }
