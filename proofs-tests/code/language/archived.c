double from_an_archive(double x);
double from_the_same_archive(double x);
double from_an_archive(double x) { return from_the_same_archive(x) * x; }
double never_computed(int k)
{
    double x[3];
    x[0] = 1.0 / 3;
    return x[k];
}
struct with_array {
    int n;
    double x[2];
};
double never_computed_in_a_struct(int k)
{
    struct with_array a;
    a.x[0] = 1.0 / 3;
    return a.x[k];
}
