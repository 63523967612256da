/* What the parts of a program in C++ share: parts_*, and several.cc, whose programs use them. */
#ifndef PARTS_H
#define PARTS_H
#include <stdexcept>
#include <vector>

template <class T> struct Series {
    T ratio;
    T sum(int n) const;
};
template <class T> T Series<T>::sum(int n) const
{
    T s = 0, power = 1;
    for (int i = 0; i < n; i++, power *= ratio)
        s += power;
    return s;
}
extern template struct Series<double>; /* parts_instance.cpp has it */

template <class T> struct Counter { static T total; };
template <class T> T Counter<T>::total = T(1) / 4;

inline double &counted(void)
{
    static double n = 0;
    return n;
}
inline double shared = 0.125;

struct Shape {
    virtual ~Shape();
    virtual double area() const = 0;
};
struct Named {
    virtual ~Named() = default;
    double name = 0.5;
};
struct Square : Shape, virtual Named {
    double a;
    explicit Square(double x);
    double area() const override;
};
struct Halved {
    double a;
    explicit Halved(double x);
};
struct Failure : std::runtime_error {
    double at;
    explicit Failure(double x) : std::runtime_error("failure"), at(x) {}
};

double from_one(double x), from_two(double x), throwing(double x), caught(double x), begun_before(void);
Shape *any_square(double x);
extern const double weights[3];
extern "C" double plain_part(double x), half_of(double x);
#endif
