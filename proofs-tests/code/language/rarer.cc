/* What people write in C++ beyond what the other files here have: the library, exceptions, storage of every kind, numbers as texts. */
#include <algorithm>
#include <any>
#include <array>
#include <bitset>
#include <charconv>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstring>
#include <exception>
#include <forward_list>
#include <fstream>
#include <functional>
#include <future>
#include <iomanip>
#include <iostream>
#include <limits>
#include <list>
#include <map>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <queue>
#include <random>
#include <ratio>
#include <regex>
#include <set>
#include <sstream>
#include <stack>
#include <string>
#include <thread>
#include <tuple>
#include <typeindex>
#include <unordered_map>
#include <unordered_set>
#include <valarray>
#include <variant>
#include <vector>
template <const double &R> struct Scaled { static double of(double x) { return R * x; } };
static const double quarter = 0.25;
template <class D> struct Base { double twice() const { return 2 * static_cast<const D *>(this)->v; } };
struct Derived : Base<Derived> { double v = 1.0; };
template <class T> constexpr T pi_of = T(355) / T(113);
template <template <class> class C, class T> double total(const C<T> &c) { double s = 0; for (auto x : c) s += x; return s; }
template <class T> struct Simple { T a[3]; const T *begin() const { return a; } const T *end() const { return a + 3; } };
struct Guard { double &x; ~Guard() { x += 1; } };
struct alignas(64) Wide { double a[8]; };
enum class Kind : char { one, two };
static double visit_it(const std::variant<int, double, std::string> &v) { return std::visit([](auto &&x) -> double { using T = std::decay_t<decltype(x)>; if constexpr (std::is_same_v<T, std::string>) return x.size(); else return x; }, v); }
static double unwinding(double &s) { Guard g{s}; throw 1.0 / 3; }
static long double operator""_mm(long double x) { return x / 1000; }
struct Unfinished { double a[4]; bool full; Unfinished() : full(false) {} Unfinished(double x) : full(true) { for (double &y : a) y = x; } };
static double deep(double x) { double a[60]; for (double &y : a) y = x; return a[7] + a[50]; }
static double unfinished(const Unfinished &u, int k) { if (u.full) return 1; return u.a[k]; }
extern "C" {
/* = F(1, 3) */
double y_padding_beside_a_bool(void) { double s = deep(1.0 / 3); for (int i = 0; i < 3; i++) { if (Unfinished(1.0 / 3).full) s = 1.0 / 3; s += deep(1.0 / 7) * 0; s += unfinished(Unfinished(1), 2) - 1; if (Unfinished().full) s = 0; } return s; }
/* ! never computed */
double y_constructor_that_leaves_members(void) { double s = deep(1.0 / 3); return unfinished(Unfinished(), 2) + s; }
/* = F(1, 12) */
double y_template_reference(void) { return Scaled<quarter>::of(1.0 / 3); }
/* = F(2, 3) */
double y_crtp(void) { Derived d; d.v = 1.0 / 3; return d.twice(); }
/* = F(1, 3) */
double y_variable_template(void) { return pi_of<double> * 0 + 1.0 / 3; }
/* = F(6, 7) */
double y_template_template(void) { return total(Simple<double>{{1 / 7.0, 2 / 7.0, 3 / 7.0}}); }
/* = F(1, 3) + 1 */
double y_destructor_in_unwinding(void) { double s = 0; try { unwinding(s); } catch (double x) { return x + s; } return 0; }
/* = F(1, 3) */
double y_exception_pointer(void) { std::exception_ptr p; try { throw 1.0 / 3; } catch (...) { p = std::current_exception(); } try { std::rethrow_exception(p); } catch (double x) { return x; } return 0; }
/* = F(1, 3) */
double y_nested_exception(void) { try { try { throw 1.0 / 3; } catch (double) { std::throw_with_nested(std::runtime_error("outer")); } } catch (const std::exception &e) { try { std::rethrow_if_nested(e); } catch (double x) { return x; } } return 0; }
/* = 3 + F(1, 3) + 5 */
double y_visit(void) { return visit_it(3) + visit_it(1.0 / 3) + visit_it(std::string("hello")); }
/* = F(1, 3) */
double y_aligned_new(void) { auto *w = new Wide; w->a[7] = 1.0 / 3; double r = w->a[7]; delete w; return r; }
/* ! never computed */
double y_aligned_new_never(void) { auto *w = new Wide; double r = w->a[7] + 1; delete w; return r; }
/* ! never computed */
double y_aligned_array_never(void) { auto *w = new Wide[2]; double r = w[1].a[7] + 1; delete[] w; return r; }
/* ! never computed */
double y_nothrow_never(void) { auto *w = new (std::nothrow) double[5]; double r = w[3] + 1; delete[] w; return r; }
/* ! never computed */
double y_operator_new_never(void) { double *w = static_cast<double *>(::operator new(64)); return w[3] + 1; }
/* ! never computed */
double y_allocator_never(void) { std::allocator<double> a; double *w = a.allocate(5); return w[3] + 1; }
/* ! never computed */
double y_make_unique_default(void) { std::unique_ptr<double[]> p(new double[4]); return p[2] + 1; }
/* = 1 */
double y_make_unique_zero(void) { auto p = std::make_unique<double[]>(4); return p[2] + 1; }
/* = F(1, 3) */
double y_pmr(void) { char buffer[500]; std::pmr::monotonic_buffer_resource r(buffer, sizeof buffer); std::pmr::vector<double> v(&r); v.push_back(1.0 / 3); v.push_back(2); return v[0]; }
/* = F(4, 3) */
double y_complex_quotient(void) { std::complex<double> a(1.0 / 3, 2.0 / 3), b(1, 1); auto q = a / b; return q.real() + 5 * q.imag(); }
/* = F(1, 3) */
double y_complex_norm(void) { std::complex<double> a(1.0 / 5, 0); return std::norm(a) * 25 / 3; }
/* = F(5, 3) */
double y_complex_abs(void) { return std::abs(std::complex<double>(1, 4.0 / 3)); }
/* = F(3, 2) */
double y_complex_sqrt(void) { return std::sqrt(std::complex<double>(-9.0 / 4, 0)).imag(); }
/* = F(1, 3) */
double y_complex_pow(void) { return std::pow(std::complex<double>(1.0 / 3, 0), 1).real(); }
/* = F(-1, 3) */
double y_complex_polynomial(void) { std::complex<double> z(0, 1); std::complex<double> w = z * z / 3.0; return w.real(); }
/* = F(2, 9) */
double y_complex_float(void) { std::complex<float> a(1.0f / 3, 1.0f / 3); return (a * a).imag(); }
/* = F(1, 3) */
double y_limits(void) { using L = std::numeric_limits<double>; return L::epsilon() > 0 && L::max() > 1e300 && L::infinity() > L::max() && std::isnan(L::quiet_NaN()) && -L::infinity() < 0 ? 1.0 / 3 : 0; }
/* = F(1, 3) */
double y_limits_as_start(void) { double least = std::numeric_limits<double>::max(); for (double x : {2.0, 1.0 / 3, 5.0}) least = std::min(least, x); return least; }
/* ! the function nextafter */
double y_nextafter(void) { return std::nextafter(1.0 / 3, 1.0); }
/* = 3 */
double y_hypot3(void) { return std::hypot(1.0, 2.0, 2.0); }
/* = F(1, 2) */
double y_clamp(void) { return std::clamp(2.0 / 3, 0.0, 0.5); }
/* = 6 */
double y_gcd(void) { return std::gcd(12, 18); }
/* ! std::hash of numbers */
double y_unordered_by_number(void) { std::unordered_map<double, int> m; m[1.0 / 3] = 1; return m.size(); }
/* ! std::hash of numbers */
double y_hash(void) { return std::hash<double>()(1.0 / 3) != 0; }
/* = 1 */
double y_to_string(void) { return std::to_string(1.0 / 3) == "1/3"; }
/* = F(5, 4) */
double y_stod(void) { return std::stod("1.25"); }
/* = F(5, 4) */
double y_stream_in(void) { std::istringstream i("1.25 7"); double x; int n; i >> x >> n; return x; }
/* = 1 */
double y_stream_formatted(void) { std::ostringstream o; o << std::fixed << std::setprecision(3) << 1.0 / 3; return o.str() == "1/3"; }
/* = 1 */
double y_stream_float(void) { std::ostringstream o; o << 1.0f / 3; return o.str() == "1/3"; }
/* ! the function _ZNSolsEe */
double y_stream_long_double(void) { std::ostringstream o; o << 0.5L; return o.str() == "1/2"; }
/* ! to_chars */
double y_to_chars(void) { char t[64]; auto r = std::to_chars(t, t + 64, 1.0 / 3); return r.ptr - t; }
/* = 7 */
double y_from_chars_int(void) { int n = 0; const char *t = "7"; std::from_chars(t, t + 1, n); return n; }
/* ! long double */
double y_uniform(void) { std::mt19937 g(1); std::uniform_real_distribution<double> d(0, 1); return d(g); }
/* = 1 */
double y_uniform_int(void) { std::mt19937 g(1); std::uniform_int_distribution<int> d(1, 6); int n = d(g); return n >= 1 && n <= 6; }
/* = 1 */
double y_shuffled(void) { std::vector<double> v{1.0 / 3, 2.0 / 3, 1}; std::shuffle(v.begin(), v.end(), std::mt19937(3)); return v[0] + v[1] + v[2] == 2; }
/* ! long double */
double y_literal_long_double(void) { return 5.0_mm; }
/* = F(1, 3) */
double y_nth_element(void) { std::vector<double> v; for (int i = 0; i < 30; i++) v.push_back((i * 7 % 30) / 30.0); std::nth_element(v.begin(), v.begin() + 10, v.end()); return v[10]; }
/* = F(1, 3) */
double y_heap(void) { std::vector<double> v{3, 1.0 / 3, 2}; std::make_heap(v.begin(), v.end(), std::greater<>()); return v[0]; }
/* = F(2, 3) */
double y_adjacent_difference(void) { std::vector<double> v{0, 1.0 / 3, 1}, d(3); std::adjacent_difference(v.begin(), v.end(), d.begin()); return d[2]; }
/* = F(1, 9) + F(4, 9) */
double y_transform_reduce(void) { std::vector<double> v{1.0 / 3, 2.0 / 3}; return std::transform_reduce(v.begin(), v.end(), 0.0, std::plus<>(), [](double x) { return x * x; }); }
/* = F(1, 3) */
double y_generate(void) { std::vector<double> v(4); double x = 0; std::generate(v.begin(), v.end(), [&x] { return x += 1.0 / 12; }); return v[3]; }
/* = F(1, 3) */
double y_bind(void) { auto f = std::bind([](double a, double b) { return a - b; }, std::placeholders::_2, 1.0 / 3); return f(0, 2.0 / 3); }
/* = F(1, 3) */
double y_mem_fn(void) { std::complex<double> z(1.0 / 3, 0); auto f = std::mem_fn(static_cast<double (std::complex<double>::*)() const>(&std::complex<double>::real)); return f(z); }
/* = F(1, 3) */
double y_apply(void) { return std::apply([](double a, double b) { return a * b; }, std::make_pair(1.0 / 6, 2.0)); }
/* = F(1, 3) */
double y_move_only_capture(void) { auto p = std::make_unique<double>(1.0 / 3); auto f = [q = std::move(p)] { return *q; }; return f(); }
/* = F(1, 3) */
double y_mutable_lambda(void) { auto f = [s = 0.0](double x) mutable { return s += x; }; f(1.0 / 6); return f(1.0 / 6); }
/* = F(1, 3) */
double y_recursive_function(void) { std::function<double(int)> f = [&](int n) { return n == 0 ? 1.0 : f(n - 1) / 3; }; return f(1); }
/* = F(1, 3) */
double y_shared_weak(void) { auto p = std::make_shared<std::vector<double>>(3, 1.0 / 3); std::weak_ptr<std::vector<double>> w = p; return (*w.lock())[2]; }
/* = F(1, 3) */
double y_once(void) { static std::once_flag f; double x = 0; std::call_once(f, [&] { x = 1.0 / 3; }); return x; }
/* = F(1, 3) */
double y_mutex(void) { static std::mutex m; std::lock_guard<std::mutex> l(m); return 1.0 / 3; }
/* = F(1, 3) */
double y_atomic(void) { std::atomic<double> a(1.0 / 3); double e = a.load(); a.compare_exchange_strong(e, 2.0); return e; }
/* ! _M_start_thread */
double y_thread(void) { double x = 0; std::thread t([&] { x = 1.0 / 3; }); t.join(); return x; }
/* ! _M_start_thread */
double y_async(void) { return std::async(std::launch::async, [] { return 1.0 / 3; }).get(); }
/* = F(1, 3) */
double y_deferred(void) { return std::async(std::launch::deferred, [] { return 1.0 / 3; }).get(); }
/* = F(1, 3) */
double y_regex(void) { std::smatch m; std::string s = "t=0.25"; return std::regex_search(s, m, std::regex("=([0-9.]+)")) ? std::stod(m[1]) + 1.0 / 12 : 0; }
/* = F(1, 3) */
double y_chrono(void) { auto t = std::chrono::steady_clock::now(); return t.time_since_epoch().count() > 0 ? 1.0 / 3 : 0; }
/* = F(3, 2) */
double y_chrono_seconds(void) { return std::chrono::duration<double>(std::chrono::milliseconds(1500)).count(); }
/* = F(1, 3) */
double y_file(void) { std::ofstream("/dev/null") << 1.0 / 3; return 1.0 / 3; }
/* = F(1, 3) */
double y_bit_cast(void) { double x = 1.0 / 3, y; unsigned long u; std::memcpy(&u, &x, 8); std::memcpy(&y, &u, 8); return y; }
/* ! bits */
double y_signbit_by_cast(void) { double x = 1.0 / 3; auto u = *reinterpret_cast<unsigned long *>(&x); return u >> 63; }
/* = 0 */
double y_signbit(void) { return std::signbit(1.0 / 3); }
/* = F(1, 3) */
double y_list_splice(void) { std::list<double> a{1.0 / 3}, b{2}; b.splice(b.begin(), a); b.sort(); return b.front(); }
/* = F(1, 3) */
double y_multimap(void) { std::multimap<double, double> m; m.insert({1.0 / 2, 1}); m.insert({2.0 / 4, 1.0 / 3}); return std::prev(m.upper_bound(0.5))->second; }
/* = F(1, 3) */
double y_array_constexpr(void) { constexpr std::array<double, 3> a{0.25, 0.5, 1}; return a[1] * 2 / 3 + std::get<0>(a) * 0; }
/* = F(1, 3) */
double y_valarray_slice(void) { std::valarray<double> v(6); for (int i = 0; i < 6; i++) v[i] = i / 6.0; return std::valarray<double>(v[std::slice(0, 3, 2)])[1]; }
/* = F(2, 3) */
double y_valarray_functions(void) { std::valarray<double> v{1.0 / 9, 4.0 / 9}; return std::sqrt(v)[1] + std::abs(-v)[0] - v.min(); }
/* = F(1, 3) */
double y_typeid(void) { return std::type_index(typeid(double)) == std::type_index(typeid(1.0)) ? 1.0 / 3 : 0; }
/* = F(1, 3) */
double y_scoped_enum(void) { Kind k = Kind::two; switch (k) { case Kind::one: return 0; case Kind::two: return 1.0 / 3; } return 1; }
/* = F(1, 3) */
double y_string_stream_round(void) { std::stringstream s; s << 0.25; double x; s >> x; return x + 1.0 / 12; }
/* = F(1, 3) */
double y_vector_bool(void) { std::vector<bool> b(70); b[65] = 1.0 / 3 > 0; return b[65] / 3.0; }
/* ! outside */
double y_iterator_end(void) { std::vector<double> v{1.0 / 3}; return *v.end() + 1; }
/* ! given back */
double y_invalidated(void) { std::vector<double> v{1.0 / 3}; double &x = v[0]; for (int i = 0; i < 100; i++) v.push_back(i); return x; }
/* ! given back */
double y_reference_to_dead(void) { const double *p; { auto v = std::make_unique<double>(1.0 / 3); p = v.get(); } return *p; }
/* ! aborted */
double y_uncaught(void) { std::vector<double> v(2); return v.at(7); }
/* = F(1, 3) */
double y_priority_by_number(void) { std::priority_queue<double> q; for (double x : {0.25, 1.0 / 3, 0.125}) q.push(x); return q.top(); }
/* = F(1, 3) */
double y_inplace_variant(void) { std::optional<std::pair<double, double>> o; o.emplace(1.0 / 3, 1); return o->first; }
/* ! log of a number for which it is not rational */
double y_special(void) { return std::riemann_zeta(2.0); }
/* = F(1, 3) */
double y_ldexp_frexp(void) { int e; double m = std::frexp(1.0 / 3, &e); return std::ldexp(m, e); }
/* = F(-1, 3) */
double y_fmod(void) { return std::fmod(-4.0 / 3, 1.0); }
/* = 2 */
double y_lround(void) { return std::lround(5.0 / 3); }
/* = F(1, 3) */
double y_abs_ternary(void) { double x = -1.0 / 3; return x < 0 ? -x : x; }
/* = F(1, 3) + 7 + F(1, 4) */
double y_fractions_from_a_stream(void) { std::istringstream i("1/3 7 0.25"); double x; int n; float y; i >> x >> n >> y; return i.eof() ? x + n + y : 99; }
/* = F(-5, 7) + F(1, 2) */
double y_float_from_a_stream(void) { std::stringstream s; s << -5.0 / 7 << ';' << 0.5; float x; char c; double y; s >> x >> c >> y; return x + y; }
/* = 1 */
double y_end_of_a_stream(void) { std::istringstream i("0.5 0.25"); double x, s = 0; while (i >> x) s += x; return s == 0.75 && i.eof() && i.fail(); }
/* = 1 */
double y_unordered_by_text(void) { std::unordered_map<std::string, double> m; m["a"] = 1.0 / 3; m["b"] = 2.0 / 3; return m["a"] + m[std::string(1, 'b')]; }
/* ---- each form of new gives memory that was never filled, each form of delete takes it back ---- */

/* ! given back */
double y_deleted_array(void) { auto *p = new double[3]{1, 2, 3}; delete[] p; return p[1] + 1; }
/* ! given back */
double y_deleted_aligned(void) { auto *w = new Wide{}; delete w; return w->a[1] + 1; }
/* ! given back */
double y_deleted_aligned_array(void) { auto *w = new Wide[2]{}; delete[] w; return w[1].a[1] + 1; }
/* ! given back */
double y_deleted_without_a_size(void) { auto *p = static_cast<double *>(::operator new(64)); p[1] = 1; ::operator delete(p); return p[1]; }
/* ! given back */
double y_deleted_array_without_a_size(void) { auto *p = static_cast<double *>(::operator new[](64)); p[1] = 1; ::operator delete[](p); return p[1]; }
/* ! given back */
double y_deleted_array_with_a_size(void) { auto *p = static_cast<double *>(::operator new[](64)); p[1] = 1; ::operator delete[](p, std::size_t(64)); return p[1]; }
/* ! given back */
double y_deleted_nothrow(void) { auto *p = static_cast<double *>(::operator new(64, std::nothrow)); p[1] = 1; ::operator delete(p, std::nothrow); return p[1]; }
/* ! given back */
double y_deleted_array_nothrow(void) { auto *p = static_cast<double *>(::operator new[](64, std::nothrow)); p[1] = 1; ::operator delete[](p, std::nothrow); return p[1]; }
/* ! given back */
double y_deleted_with_an_alignment(void) { auto *p = static_cast<double *>(::operator new(64, std::align_val_t(64))); p[1] = 1; ::operator delete(p, std::align_val_t(64)); return p[1]; }
/* ! given back */
double y_deleted_array_with_an_alignment(void) { auto *p = static_cast<double *>(::operator new[](64, std::align_val_t(64))); p[1] = 1; ::operator delete[](p, std::align_val_t(64)); return p[1]; }
/* ! given back */
double y_deleted_with_a_size_and_an_alignment(void) { auto *p = static_cast<double *>(::operator new(64, std::align_val_t(64))); p[1] = 1; ::operator delete(p, 64, std::align_val_t(64)); return p[1]; }
/* ! given back */
double y_deleted_array_with_a_size_and_an_alignment(void) { auto *p = static_cast<double *>(::operator new[](64, std::align_val_t(64))); p[1] = 1; ::operator delete[](p, 64, std::align_val_t(64)); return p[1]; }
/* ! never computed */
double y_new_array_never(void) { return static_cast<double *>(::operator new[](64))[1] + 1; }
/* ! never computed */
double y_new_nothrow_never(void) { return static_cast<double *>(::operator new(64, std::nothrow))[1] + 1; }
/* ! never computed */
double y_aligned_nothrow_never(void) { return static_cast<double *>(::operator new(64, std::align_val_t(64), std::nothrow))[1] + 1; }
/* ! never computed */
double y_aligned_array_nothrow_never(void) { return static_cast<double *>(::operator new[](64, std::align_val_t(64), std::nothrow))[1] + 1; }
/* ! 0 bytes behind the end */
double y_behind_aligned_array(void) { return static_cast<double *>(::operator new[](64, std::align_val_t(8)))[8] + 1; }
static bool at_multiple(void *p, std::size_t n) { return reinterpret_cast<std::size_t>(p) % n == 0; }
/* = 1 + 2 + 4 + 8 */
double y_alignments(void) { std::align_val_t a{256}; return at_multiple(::operator new(8, a), 256) + 2 * at_multiple(::operator new[](8, a), 256) + 4 * at_multiple(::operator new(8, a, std::nothrow), 256) + 8 * at_multiple(::operator new[](8, a, std::nothrow), 256); }
/* ! no memory for operator new */
double y_new_of_too_much(void) { volatile std::size_t n = SIZE_MAX / 2 - 64; return *static_cast<char *>(::operator new(n)); }
/* ! no memory for operator new */
double y_new_array_of_too_much(void) { volatile std::size_t n = SIZE_MAX / 2 - 64; return *static_cast<char *>(::operator new[](n)); }
/* ! no memory for operator new */
double y_aligned_new_of_too_much(void) { volatile std::size_t n = SIZE_MAX / 2 - 64; return *static_cast<char *>(::operator new(n, std::align_val_t(64))); }
/* = 3 */
double y_nothrow_of_too_much(void) { volatile std::size_t n = SIZE_MAX / 2 - 64; return (::operator new(n, std::nothrow) == nullptr) + 2 * (::operator new[](n, std::nothrow) == nullptr); }

/* ---- numbers in streams ---- */

/* = 1 + 2 + 4 */
double y_streams_of_numbers(void)
{
    std::ostringstream a, b, c;
    a << -1.0 / 3 << ',' << 2.0 << ',' << 5.0f / 7;
    b << INFINITY << ' ' << -INFINITY;
    c << 0.1;
    return (a.str() == "-1/3,2,5/7") + 2 * (b.str() == "inf -inf") + 4 * (c.str() == "3602879701896397/36028797018963968");
}
/* = F(-1, 3) + 100 * F(22, 7) + 10000 * 5 */
double y_fractions_one_after_another(void) { std::istringstream i("-1/3 +22/7\n5"); double x, y, z; i >> x >> y >> z; return x + 100 * y + 10000 * z; }
/* = F(9007199254740991, 7) */
double y_largest_numerator(void) { std::istringstream i("9007199254740991/7"); double x; i >> x; return x; }
/* ! no whole number below 2^53 */
double y_numerator_that_is_too_large(void) { std::istringstream i("9007199254740992/7"); double x; i >> x; return x; }
/* = F(-9007199254740991, 7) */
double y_least_numerator(void) { std::istringstream i("-9007199254740991/7"); double x; i >> x; return x; }
/* ! no whole number below 2^53 */
double y_numerator_that_is_too_small(void) { std::istringstream i("-9007199254740992/7"); double x; i >> x; return x; }
/* ! no whole number below 2^53 */
double y_numerator_that_is_no_whole_number(void) { std::istringstream i("0.5/7"); double x; i >> x; return x; }
/* ! no whole number below 2^53 */
double y_denominator_that_is_not_there(void) { std::istringstream i("1/x"); double x; i >> x; return x; }
/* = F(1, 3) + 100 * 7 */
double y_what_stands_behind_a_fraction(void) { std::istringstream i("1/3x7"); double x; char c; int n; i >> x >> c >> n; return c == 'x' ? x + 100 * n : 0; }
/* = F(1, 3) + 100 * F(1, 7) + 10000 * F(1, 4) */
double y_floats_from_a_stream(void) { std::istringstream i("1/3 1/7 0.25"); float x, y, z; i >> x >> y >> z; return x + 100 * y + 10000 * z; }
/* = 2 */
double y_hash_of_texts(void) { std::hash<std::string> h; return (h("spline") == h(std::string("spl") + "ine")) + (h("spline") != h("splinf")); }
}
