/* machine.h -- what rewritten code calls: exact numbers behind the 64 bits of a double.
 *
 * A plain binary64 is the rational that it denotes; a quiet NaN with our tag names a value in a table.  What a value is depends on
 * the run (run.h): a rational, an element of the field with its value at a point, an interval, or a binary64 with the exact number.
 * cagd_code_at is set before each call.  Whatever has no answer ends the run, with a message and that place. */
#ifndef CAGD_CODE_MACHINE_H
#define CAGD_CODE_MACHINE_H

#include <stdint.h>

/* A place in the source; line 0: unknown. */
struct cagd_code_place {
    const char *file, *function;
    int32_t line;
};
extern const struct cagd_code_place *cagd_code_at;

double cagd_code_add(double a, double b);
double cagd_code_sub(double a, double b);
double cagd_code_mul(double a, double b);
double cagd_code_div(double a, double b);
double cagd_code_neg(double a);
double cagd_code_power(double a, int32_t n);
/* LLVM's llvm.minimum and llvm.maximum: a NaN is passed on, and of two zeros the negative one is the smaller. */
double cagd_code_minimum(double a, double b);
double cagd_code_maximum(double a, double b);

/* Whether one of the relations holds that the predicate is the sum of: 1 equal, 2 greater, 4 less, 8 unordered. */
int32_t cagd_code_compare(double a, double b, int32_t predicate);
int32_t cagd_code_class(double a, int32_t classes);  /* LLVM's classes of llvm.is.fpclass       */
int64_t cagd_code_size_bits(double a, int32_t bits); /* those of a number, infinity or NaN, as a is one */
int64_t cagd_code_sign_bits(double a);               /* -1 if a < 0, else 0                      */

double cagd_code_from_signed(int64_t n);
double cagd_code_from_unsigned(uint64_t n);
int64_t cagd_code_to_integer(double a, int32_t bits, int32_t is_signed); /* towards 0; refused outside the range */
double cagd_code_widen(float a);
float cagd_code_narrow(double a);

/* x was put into a variable; only in code that was compiled so that its stores are noted. */
void cagd_code_stored(double x, const char *name);

void cagd_code_refuse(const char *what); /* does not return; no attribute, as the rewritten code does not know it */

/* `size` bytes at p are about to be taken for an integer: refused when they are part of a number.  object: they are a variable. */
void cagd_code_look(const char *p, int32_t size, int32_t object);

/* Addresses and objects (objects.h).  A variable of a function, or of all, that begins at p and has a margin on both sides. */
void cagd_code_local(const char *p, int64_t size, int64_t margin, const char *name);
void cagd_code_global(const char *p, int64_t size, int64_t margin, const char *name);
/* `to` is computed from `from`; so many bytes at p are about to be read or written; element `index` of `count` is used, or (0) only
 * its address is taken, which may be that of the one behind the last. */
void cagd_code_step(const char *from, const char *to);
void cagd_code_reach(const char *p, int64_t bytes, int32_t writes);
/* memcpy of so many bytes: refused where the two pieces overlap, unless the job lets them. */
void cagd_code_apart(const char *to, const char *from, int64_t bytes);
/* Two addresses are about to be ordered, or one taken from the other: refused where they are of different objects, if the job asks for that. */
void cagd_code_together(const char *a, const char *b);
void cagd_code_index(int64_t index, int64_t count, int32_t is_used);

/* ---- what the driver of a harness calls ---------------------------------------------------------------- */

/* The inputs of that name, x[0..count), as the run has them; elsewhere a run is refused. */
void cagd_code_input(const char *name, long count, double *x);
/* Comparisons from here on are those of preconditions (1), or of the code (0). */
void cagd_code_given(int on);
/* The run ends here unless the precondition is true. */
void cagd_code_where(int truth);
void cagd_code_output(const char *name, long count, const double *x);
void cagd_code_expect(const char *name, long count, const double *got, const double *wanted);
/* The formulas of a driver (formula.h): they begin; what a name of theirs is, count = 0: a number alone; a line that says what
 * others mean; one that is to hold, in each case of its whole numbers. */
void cagd_code_formulas(void);
void cagd_code_name(const char *name, long count, const double *x);
void cagd_code_let(const char *line);
void cagd_code_printed(const char *formula, const char *ranges, const char *file, int line);
/* Numbers that are stored from here on are those of the calls (1), of what is expected (2), or not noted (0). */
void cagd_code_side(int which);
/* The first `count` numbers that the calls stored at a line, "curves.c:12", should be these. */
void cagd_code_known(const char *place, long count, const double *wanted);
#endif
