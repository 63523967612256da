#include "parts.h"
namespace {
double hidden(double x) { return x / 2; }
struct Begin {
    double v;
    Begin() : v(weights[1]) { v /= 3; }
} begin;
} // namespace
Shape::~Shape() {}
double from_one(double x) { counted() += x; return hidden(x) + (Counter<double>::total += x) + shared; }
double throwing(double x) { std::vector<double> v(3, x / 3); if (x > 0) throw Failure(v.at(2)); return v.at(5); }
double begun_before(void) { return begin.v; }
