// C++17 by way of clang++.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace {
template <class T> T lerp_of(T a, T b, T t) { return (1 - t) * a + t * b; }
struct Point {
    double x, y;
    Point operator+(const Point &o) const { return {x + o.x, y + o.y}; }
    friend Point operator*(double s, const Point &p) { return {s * p.x, s * p.y}; }
};
struct Shape {
    virtual ~Shape() = default;
    virtual double area() const = 0;
};
struct Square : Shape {
    double s;
    explicit Square(double side) : s(side) {}
    double area() const override { return s * s; }
};
struct Triangle : Shape {
    double b, h;
    Triangle(double base, double height) : b(base), h(height) {}
    double area() const override { return b * h / 2; }
};
template <int N> double power(double x) { if constexpr (N == 0) return 1; else return x * power<N - 1>(x); }
double failing(double x) { if (x < 0.5) throw std::runtime_error("small"); return x; }
template <class... T> double sum_of(T... x) { return (x + ...); }
double held = 1.0 / 4;
struct Global { double v; Global() : v(held) { v /= 3; } } made;
}
extern "C" {
/* = F(1, 3) * F(2, 5) + F(2, 3) * F(1, 7) */
double p_template(void) { return lerp_of<double>(2.0 / 5, 1.0 / 7, 2.0 / 3); }
/* = F(1, 3) */
double p_template_of_float(void) { return lerp_of<float>(0, 1, 1.0f / 3); }
/* = F(10, 7) */
double p_vector(void) { std::vector<double> v; for (int i = 1; i < 5; i++) v.push_back(i / 7.0); double s = 0; for (double x : v) s += x; return s; }
/* = F(1, 3) + F(1, 5) + F(1, 7) */
double p_accumulate(void) { std::array<double, 3> a{1.0 / 3, 1.0 / 5, 1.0 / 7}; return std::accumulate(a.begin(), a.end(), 0.0); }
/* = F(1, 7) + 10 * F(1, 5) + 100 * F(1, 3) */
double p_sort(void) { std::vector<double> v{1.0 / 3, 1.0 / 7, 1.0 / 5}; std::sort(v.begin(), v.end()); return v[0] + 10 * v[1] + 100 * v[2]; }
/* = F(1, 3) + F(2, 7) */
double p_operators(void) { Point p{1.0 / 3, 0}, q{0, 1.0 / 7}; Point r = p + 2 * q; return r.x + r.y; }
/* = F(1, 9) + F(1, 30) */
double p_virtual(void) { std::vector<std::unique_ptr<Shape>> v; v.push_back(std::make_unique<Square>(1.0 / 3)); v.push_back(std::make_unique<Triangle>(1.0 / 3, 1.0 / 5)); double s = 0; for (auto &p : v) s += p->area(); return s; }
/* = F(1, 3) ** 5 */
double p_constexpr_if(void) { return power<5>(1.0 / 3); }
/* = F(1, 3) + 7 */
double p_exception(void) { try { return failing(1.0 / 3); } catch (const std::runtime_error &e) { return 7 + 1.0 / 3; } }
/* = F(1, 3) */
double p_thrown_number(void) { try { throw 1.0 / 3; } catch (double x) { return x; } }
/* = F(2, 21) */
double p_lambda(void) { double a = 1.0 / 3; auto f = [a](double x) { return a * x; }; return f(2.0 / 7); }
/* = F(2, 21) */
double p_function(void) { double a = 1.0 / 3; std::function<double(double)> f = [&](double x) { return a * x; }; return f(2.0 / 7); }
/* = F(1, 2) + F(1, 3) + F(1, 4) */
double p_fold(void) { return sum_of(1.0 / 2, 1.0 / 3, 1.0 / 4); }
/* = F(1, 3) + F(2, 3) ** 2 */
double p_map(void) { std::map<int, double> m; m[1] = 1.0 / 3; m[2] = 2.0 / 3; return m[1] + m[2] * m[2]; }
/* = F(1, 3) */
double p_map_by_number(void) { std::map<double, int> m; m[1.0 / 3] = 1; m[2.0 / 6] = 2; return m.size() == 1 ? m.begin()->first : 0; }
/* = F(1, 3) * F(1, 7) - F(1, 5) * F(1, 11) */
double p_complex(void) { std::complex<double> a(1.0 / 3, 1.0 / 5), b(1.0 / 7, 1.0 / 11); return (a * b).real(); }
/* = F(1, 3) + F(1, 7) */
double p_tuple(void) { auto [a, b] = std::make_tuple(1.0 / 3, 1.0 / 7); return a + b; }
/* = F(1, 3) */
double p_optional(void) { std::optional<double> o = 1.0 / 3; return o.value_or(0); }
/* = F(1, 3) */
double p_variant(void) { std::variant<int, double> v = 1.0 / 3; return std::get<double>(v); }
/* = F(3, 7) */
double p_std_sqrt(void) { return std::sqrt(9.0 / 49) + std::abs(0.0); }
/* = F(1, 3) */
double p_std_abs(void) { return std::abs(-1.0 / 3); }
/* = F(1, 2) */
double p_max_min(void) { return std::max(1.0 / 3, std::min(1.0 / 2, 2.0 / 3)); }
/* = F(1, 3) + F(1, 12) */
double p_global_constructor(void) { return made.v + 1.0 / 3; }
/* = F(5, 3) */
double p_new_array(void) { double *p = new double[3]; for (int i = 0; i < 3; i++) p[i] = (i + 4) / 9.0; double s = p[0] + p[1] + p[2]; delete[] p; return s; }
/* = 1 */
double p_stream(void) { std::ostringstream o; o << 1.0 / 3 << " " << 5; return o.str() == "1/3 5"; }
/* = F(1, 3) */
double p_shared(void) { auto p = std::make_shared<double>(1.0 / 3); auto q = p; return *q; }
/* = F(1, 3) - F(1, 5) */
double p_swap(void) { double a = 1.0 / 5, b = 1.0 / 3; std::swap(a, b); return a - b; }
/* = F(11, 15) */
double p_inner_product(void) { std::vector<double> a{1.0 / 3, 2.0 / 3}, b{1.0 / 5, 1}; return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }
/* = 2 */
double p_lower_bound(void) { std::vector<double> k{0, 1.0 / 3, 2.0 / 3, 1}; return std::lower_bound(k.begin(), k.end(), 1.0 / 2) - k.begin(); }
/* ! never computed */
double p_uninitialised(void) { double *p = new double[3]; return p[1] + 1; }
/* ! outside an array */
double p_outside(void) { std::vector<double> v(3, 1.0 / 3); return v[3] + 1; }
/* ! 8 bytes before the beginning of the memory */
double p_before(void)
{
    double *p = new double[3]{1, 2, 3};
    return p[-1]; // here
}
/* ! outside an array */
double p_before_a_vector(void) { std::vector<double> v(3, 1.0 / 3), w(3, 1); return *(v.begin() - 1) + w[0]; }
/* ! given back */
double p_deleted(void)
{
    auto *p = new double(1.0 / 3);
    delete p;
    return *p; // here
}
/* = F(5, 3) */
double p_many_of_the_library(void)
{
    std::map<std::string, std::vector<double>> m;
    for (int i = 0; i < 5; i++)
        m["key " + std::to_string(i % 2) + std::string(40, 'x')].push_back(1.0 / 3);
    double s = 0;
    for (auto &[name, values] : m)
        for (double x : values)
            s += x;
    return s;
}
/* ! the function tgamma */
double p_unknown(void) { std::istringstream i("1.5"); double x = 0; i >> x; return std::tgamma(x) + x; }
}
