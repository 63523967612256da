// What C++17 has that cpp.cc does not use.
#include <algorithm>
#include <any>
#include <cmath>
#include <deque>
#include <exception>
#include <forward_list>
#include <initializer_list>
#include <iterator>
#include <list>
#include <memory>
#include <new>
#include <numeric>
#include <queue>
#include <set>
#include <stdexcept>
#include <string_view>
#include <typeinfo>
#include <unordered_map>
#include <utility>
#include <valarray>
#include <vector>

namespace {
struct Counted {
    static inline int alive = 0;
    double x;
    explicit Counted(double v) : x(v) { alive++; }
    Counted(const Counted &o) : x(o.x) { alive++; }
    Counted(Counted &&o) noexcept : x(std::exchange(o.x, 0)) { alive++; }
    ~Counted() { alive--; }
};
struct Failure : std::runtime_error {
    double amount;
    explicit Failure(double a) : std::runtime_error("failure"), amount(a) {}
};
double fails(int n, double x) { Counted here(x); if (n == 0) throw Failure(here.x); return fails(n - 1, x / 2) + here.x; }
struct A { double a = 1.0 / 3; virtual ~A() = default; virtual double value() const { return a; } };
struct B : virtual A { double b = 1.0 / 5; };
struct C : virtual A { double c = 1.0 / 7; };
struct D : B, C { double value() const override { return a + b + c; } };
template <class... T> double sum_of(T... x) { return (0.0 + ... + x); }
template <class T> struct Pair { T a, b; Pair(T x, T y) : a(x), b(y) {} };
template <class T, class = void> struct has_size : std::false_type {};
template <class T> struct has_size<T, std::void_t<decltype(std::declval<T>().size())>> : std::true_type {};
constexpr double cube(double x) { return x * x * x; }
double guarded(double x) { static const double once = x / 3; return once; }
double tried(double x) try { if (x > 0) throw x; return 0; } catch (double y) { return y / 2; }
double of_list(std::initializer_list<double> l) { double s = 0; for (double x : l) s += x; return s; }
namespace inner { inline namespace v1 { template <class T> T third(T x) { return x / 3; } } }
template <> double inner::v1::third<double>(double x) { return x / 3 + 1; }
double operator""_thirds(unsigned long long n) { return static_cast<double>(n) / 3; }
}
extern "C" {
/* = F(1, 8) * F(1, 3) */
double q_exception_through_frames(void) { try { return fails(3, 1.0 / 3); } catch (const Failure &f) { return Counted::alive == 0 ? f.amount : -1; } }
/* = F(2, 3) */
double q_rethrown(void) { try { try { throw 1.0 / 3; } catch (double x) { try { throw; } catch (...) { throw x * 2; } } } catch (double y) { return y; } }
/* = F(1, 6) */
double q_function_try_block(void) { return tried(1.0 / 3); }
/* = F(71, 105) */
double q_virtual_bases(void) { D d; const A &a = d; return a.value(); }
/* = F(1, 7) */
double q_dynamic_cast(void) { D d; A *a = &d; C *c = dynamic_cast<C *>(a); return c != nullptr && typeid(*a) == typeid(D) ? c->c : 0; }
/* = F(1, 3) + F(1, 5) + 2 */
double q_variadic(void) { return sum_of(1.0 / 3, 1.0 / 5, 2); }
/* = F(2, 21) */
double q_deduced_arguments(void) { Pair p(1.0 / 3, 2.0 / 7); return p.a * p.b; }
/* = F(1, 3) */
double q_selected_by_substitution(void) { return has_size<std::vector<double>>::value && !has_size<double>::value ? 1.0 / 3 : 0; }
/* = F(1, 27) + F(1, 8) */
double q_constant_expression(void) { constexpr double e = cube(0.5); return cube(1.0 / 3) + e; }
/* = F(2, 3) */
double q_guarded_static(void) { return guarded(1) + guarded(2); }
/* = F(float(F(1, 3))) */
double q_constants_are_the_compilers(void) { static const double third = 1.0 / 3; return third; }
/* = F(1, 3) + F(1, 4) + F(1, 5) */
double q_initializer_list(void) { return of_list({1.0 / 3, 1.0 / 4, 1.0 / 5}); }
/* = F(1, 9) + 1 */
double q_specialised_in_inline_namespace(void) { return inner::third(1.0 / 3); }
/* = F(7, 3) */
double q_literal_of_ones_own(void) { return 7_thirds; }
/* = F(1, 3) */
double q_moved(void) { Counted a(1.0 / 3); Counted b(std::move(a)); return a.x == 0 ? b.x : -1; }
/* = F(1, 3) */
double q_unique(void) { auto p = std::make_unique<Counted>(1.0 / 3); auto q = std::move(p); return p == nullptr ? q->x : -1; }
/* = F(2, 3) */
double q_placement(void) { alignas(Counted) unsigned char room[sizeof(Counted)]; auto *c = new (room) Counted(2.0 / 3); double x = c->x; c->~Counted(); return x; }
/* = F(1, 3) */
double q_nothrow(void) { double *p = new (std::nothrow) double(1.0 / 3); double x = p != nullptr ? *p : 0; delete p; return x; }
/* = F(8, 15) */
double q_structured_binding(void) { auto [a, b] = std::pair(1.0 / 3, 1.0 / 5); return a + b; }
/* = F(1, 4) */
double q_condition_with_initialiser(void) { if (double x = 1.0 / 2; x > 0) return x * x; else return x; }
/* = F(1, 5) */
double q_pointer_to_member(void) { double B::*m = &B::b; B b; return b.*m; }
/* = F(1, 3) */
double q_pointer_to_member_function(void) { double (A::*f)() const = &A::value; A a; return (a.*f)(); }
/* = F(1, 3) * 4 */
double q_generic_lambda(void) { auto twice = [](auto x) { return x + x; }; double y = 1.0 / 3; auto add = [y](auto f) mutable { y = f(y); return f(y); }; return add(twice); }
/* = F(1, 3) */
double q_any(void) { std::any a = 1.0 / 3; return std::any_cast<double>(a); }
/* = F(2, 3) + 2 */
double q_valarray(void) { std::valarray<double> a{1.0 / 3, 1.0}, b = a * 2.0; return b.sum(); }
/* = F(10, 3) */
double q_deque_and_list(void) { std::deque<double> d; for (int i = 0; i < 5; i++) d.push_front(i / 3.0); std::list<double> l(d.begin(), d.end()); l.sort(); return std::accumulate(l.begin(), l.end(), 0.0); }
/* = F(4, 3) */
double q_priority(void) { std::priority_queue<double> q; for (int i = 0; i < 5; i++) q.push(i / 3.0); return q.top(); }
/* = F(1, 3) */
double q_set(void) { std::set<double> s{1.0, 2.0 / 3, 1.0 / 3, 1.0 / 3}; return s.size() == 3 ? *s.begin() : -1; }
/* = F(1, 3) */
double q_unordered_by_integer(void) { std::unordered_map<int, double> m; m[7] = 1.0 / 3; return m.at(7); }
/* = F(5, 3) */
double q_partial_sums(void) { std::vector<double> v{1.0 / 3, 2.0 / 3, 2.0 / 3}; std::partial_sum(v.begin(), v.end(), v.begin()); return *std::max_element(v.begin(), v.end()); }
/* = F(14, 9) */
double q_transformed(void) { std::vector<double> v{1.0 / 3, 2.0 / 3, 1.0}; std::transform(v.begin(), v.end(), v.begin(), [](double x) { return x * x; }); return std::accumulate(v.begin(), v.end(), 0.0); }
/* = 1 */
double q_stable_sort_and_unique(void) { std::vector<double> v{1, 1.0 / 3, 1, 2.0 / 3}; std::stable_sort(v.begin(), v.end(), [](double a, double b) { return a < b; }); v.erase(std::unique(v.begin(), v.end()), v.end()); return v.size() == 3 ? v[2] : -1; }
/* = F(3, 2) */
double q_clamp_and_lerp(void) { return std::clamp(7.0 / 3, 0.0, 3.0 / 2); }
/* = 5 */
double q_string_view(void) { std::string_view s = "spline curve"; return static_cast<double>(s.substr(7).size()); }
}
