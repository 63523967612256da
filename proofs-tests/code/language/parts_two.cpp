#include "parts.h"
namespace {
double hidden(double x) { return x / 3; }
}
extern const double weights[3] = {0.25, 0.5, 0.25};
Square::Square(double x) : a(x) {}
double Square::area() const { return a * a; }
Shape *any_square(double x) { return new Square(x); }
double from_two(double x) { shared *= 2; return hidden(x) + (Counter<double>::total += x) + shared + counted(); }
double caught(double x)
{
    try { return throwing(x); }
    catch (const Failure &f) { return plain_part(f.at); }
    catch (const std::out_of_range &) { return 7; }
}
