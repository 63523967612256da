/* Parts in several files of C++ and one of C, as sources, as bitcode, or in archives of it (test_language.py). */
#include "parts.h"
#include <memory>
#include <typeinfo>
extern "C" {
/* = (F(1, 6) + F(1, 4) + F(1, 3) + F(1, 8)) + (F(1, 21) + F(1, 4) + F(1, 3) + F(1, 7) + F(1, 4) + F(1, 3)) */
double k_state_of_several_files(void) { double a = from_one(1.0 / 3); return a + from_two(1.0 / 7); }
/* = F(1, 6) */
double k_constructor_of_another_file(void) { return begun_before(); }
/* = F(1, 45) */
double k_thrown_there_and_caught_elsewhere(void) { return caught(1.0 / 3); }
/* = 7 */
double k_thrown_by_the_library(void) { return caught(-1.0 / 3); }
/* = F(1, 9) */
double k_caught_here(void) { try { return throwing(1.0 / 3); } catch (const std::exception &e) { return dynamic_cast<const Failure &>(e).at; } }
/* = 1 + F(1, 3) + F(1, 9) */
double k_instantiated_elsewhere(void) { return Series<double>{1.0 / 3}.sum(3); }
/* = F(1, 9) + F(1, 2) */
double k_virtual_base(void) { std::unique_ptr<Shape> s(any_square(1.0 / 3)); return s->area() + dynamic_cast<Named &>(*s).name; }
/* = F(4, 49) */
double k_constructed_here(void) { Square s(2.0 / 7); return s.area(); }
/* = 1 */
double k_types_are_the_same(void) { std::unique_ptr<Shape> s(any_square(1)); return typeid(*s) == typeid(Square); }
/* = F(1, 4) */
double k_constants_of_another_file(void) { return weights[2]; }
/* = F(1, 6) */
double k_constructor_alone_in_its_file(void) { return Halved(1.0 / 3).a; }
}
