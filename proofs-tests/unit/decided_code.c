/* decided_code.c -- code as it is once it is rewritten, by hand: what test_decide.c asks about.  The input `which` says which. */
#include "exact/code/machine.h"

#include <math.h>
#include <stdlib.h>

enum { SAME = 1, GREATER = 2, LESS = 4, MOST_NUMBERS = 16 };

static double input(const char *name)
{
    double x;
    cagd_code_input(name, 1, &x);
    return x;
}
/* x, of which the driver of a harness says that x <= most, or x < most. */
static double limited(int is_open)
{
    double x = input("x");
    cagd_code_given(1);
    cagd_code_where(cagd_code_compare(x, input("most"), is_open ? LESS : LESS | SAME));
    cagd_code_given(0);
    return x;
}
static void put(double got, double wanted) { cagd_code_expect("r", 1, &got, &wanted); }

/* r = x, on each side of 0 of so many numbers. */
static void many_ways(int many)
{
    double y[MOST_NUMBERS];
    cagd_code_input("y", many, y);
    for (int k = 0; k < many; k++)
        cagd_code_compare(y[k], 0, LESS);
    put(y[0], y[0]);
}

/* Whether (x - c)^2 = 0, which is not solved for x. */
static int is_near(double x, double c)
{
    double d = cagd_code_sub(x, c);
    return cagd_code_compare(cagd_code_mul(d, d), 0, SAME);
}

/* r = x, but c where (x - c)^2 = 0. */
static void equal_at_one_number(double c)
{
    double x = input("x");
    put(is_near(x, c) ? c : x, x);
}

static void patterns(void)
{
    double u[4];
    cagd_code_input("u", 4, u);
    cagd_code_output("r", 1, u);
}

/* x = 12345 alone is more than can be done, or refused, or undefined, or another number, or the end of the process. */
static void one_number(int which, double x)
{
    double r = x;
    if (cagd_code_compare(x, 12345, SAME)) {
        if (which == 0)
            cagd_code_power(3, 1 << 30);
        if (which == 1)
            cagd_code_refuse("something");
        if (which == 2)
            r = cagd_code_div(x, cagd_code_sub(x, x));
        if (which == 3)
            r = cagd_code_add(x, 1);
        if (which == 4)
            abort();
    }
    put(r, x);
}

/* r = x + 1 where x > 7, else x. */
static void wrong_above(double x) { put(cagd_code_compare(x, 7, GREATER) ? cagd_code_add(x, 1) : x, x); }

/* r = x + 1 where x^2 > 400, else x. */
static void wrong_beyond_a_square(double x)
{
    put(cagd_code_compare(cagd_code_mul(x, x), 400, GREATER) ? cagd_code_add(x, 1) : x, x);
}

/* What rounding costs in x is nothing, in x / 7 something: whichever comes first. */
static void two_results(double x)
{
    double seventh = cagd_code_div(x, 7);
    for (int k = 0; k < 2; k++) {
        cagd_code_output(k ? "seventh" : "same", 1, k ? &seventh : &x);
        cagd_code_output(k ? "same again" : "seventh again", 1, k ? &x : &seventh);
    }
}

/* r = x + 1 where x lies between the inputs least and most, else x. */
static void wrong_between(double x)
{
    int is_above = cagd_code_compare(x, input("least"), GREATER);
    put(is_above && cagd_code_compare(x, input("most"), LESS) ? cagd_code_add(x, 1) : x, x);
}

/* p[2] = 0 where it is not 0. */
static void third_of_three(void)
{
    double p[3], wanted[3];
    cagd_code_input("p", 3, p);
    for (int k = 0; k < 3; k++)
        wanted[k] = p[k];
    wanted[2] = 0;
    cagd_code_expect("r", 3, p, wanted);
}

/* Infinities, NaN and numbers as results and as what they should be. */
static void of_no_order(int kind)
{
    static const double list[] = {(double)INFINITY, -(double)INFINITY, (double)NAN, 1};
    put(list[kind / 4], list[kind % 4]);
}

double cagd_code_lib_sqrt(double x);
static void root(int of, double wanted) { put(cagd_code_lib_sqrt(of), wanted); }

static void precondition(int can_be_true)
{
    double x = input("x");
    cagd_code_given(1);
    cagd_code_where(cagd_code_compare(x, 3, GREATER) && (can_be_true || cagd_code_compare(x, 2, LESS)));
    cagd_code_given(0);
    put(cagd_code_compare(x, 2, LESS) ? 0 : x, x);
}

void never_ends(void);
void never_ends(void)
{
    for (volatile int k = 0;; k++)
        ;
}
void asks_for_more(void);
void asks_for_more(void)
{
    double x[2];
    cagd_code_input("x", 2, x);
}

void cagd_code_entry(void);
void cagd_code_entry(void)
{
    switch ((int)input("which")) {
    case 0:
        many_ways(9);
        break;
    case 1:
        equal_at_one_number(1);
        break;
    case 2:
        equal_at_one_number(12345);
        break;
    case 3:
        patterns();
        break;
    case 4:
    case 5:
    case 6:
    case 7:
        one_number((int)input("which") - 4, input("x"));
        break;
    case 8:
        wrong_above(limited(0));
        break;
    case 11:
    case 12:
        one_number(0, limited((int)input("which") == 12));
        break;
    case 13:
        many_ways(11);
        break;
    case 14:
        wrong_beyond_a_square(input("x"));
        break;
    case 15:
        two_results(input("x"));
        break;
    case 16:
        wrong_between(input("x"));
        break;
    case 17:
        third_of_three();
        break;
    case 18:
        of_no_order((int)input("kind"));
        break;
    case 19:
        root(2, cagd_code_lib_sqrt(2));
        break;
    case 20:
        root(2, 1.5);
        break;
    case 21:
        root(4, 2);
        break;
    case 22:
        one_number(4, input("x"));
        break;
    default:
        precondition(input("which") == 9);
        break;
    }
}
