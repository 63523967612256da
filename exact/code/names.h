/* names.h -- the functions of the C library that exact numbers go through: rewrite.c turns a call of NAME into one of
 * cagd_code_lib_NAME, which functions.c, memory.c and print.c define.
 *
 * ONE(name): double name(double), with its forms for float and long double; TWO(name): double name(double, double); OTHER(name): a
 * function of another signature, by its full name. */
#ifndef CAGD_CODE_NAMES_H
#define CAGD_CODE_NAMES_H

#define CAGD_CODE_ONE(ONE)                                                                                             \
    ONE(fabs)                                                                                                          \
    ONE(floor)                                                                                                         \
    ONE(ceil)                                                                                                          \
    ONE(trunc)                                                                                                         \
    ONE(round)                                                                                                         \
    ONE(rint)                                                                                                          \
    ONE(nearbyint)                                                                                                     \
    ONE(roundeven)                                                                                                     \
    ONE(sqrt)                                                                                                          \
    ONE(cbrt)                                                                                                          \
    ONE(exp)                                                                                                           \
    ONE(exp2)                                                                                                          \
    ONE(expm1)                                                                                                         \
    ONE(log)                                                                                                           \
    ONE(log2)                                                                                                          \
    ONE(log10)                                                                                                         \
    ONE(log1p)                                                                                                         \
    ONE(sin)                                                                                                           \
    ONE(cos)                                                                                                           \
    ONE(tan)                                                                                                           \
    ONE(asin)                                                                                                          \
    ONE(acos)                                                                                                          \
    ONE(atan)                                                                                                          \
    ONE(sinh)                                                                                                          \
    ONE(cosh)                                                                                                          \
    ONE(tanh)                                                                                                          \
    ONE(logb)

#define CAGD_CODE_TWO(TWO)                                                                                             \
    TWO(fmin)                                                                                                          \
    TWO(fmax)                                                                                                          \
    TWO(fdim)                                                                                                          \
    TWO(copysign)                                                                                                      \
    TWO(fmod)                                                                                                          \
    TWO(remainder)                                                                                                     \
    TWO(pow)                                                                                                           \
    TWO(hypot)                                                                                                         \
    TWO(atan2)

#define CAGD_CODE_OTHER(OTHER)                                                                                         \
    OTHER(fma)                                                                                                         \
    OTHER(fmaf)                                                                                                        \
    OTHER(ldexp)                                                                                                       \
    OTHER(ldexpf)                                                                                                      \
    OTHER(scalbn)                                                                                                      \
    OTHER(scalbln)                                                                                                     \
    OTHER(frexp)                                                                                                       \
    OTHER(modf)                                                                                                        \
    OTHER(sincos)                                                                                                      \
    OTHER(lround)                                                                                                      \
    OTHER(llround)                                                                                                     \
    OTHER(lrint)                                                                                                       \
    OTHER(llrint)                                                                                                      \
    OTHER(isnan)                                                                                                       \
    OTHER(__isnan)                                                                                                     \
    OTHER(isinf)                                                                                                       \
    OTHER(__isinf)                                                                                                     \
    OTHER(finite)                                                                                                      \
    OTHER(__finite)                                                                                                    \
    OTHER(__signbit)                                                                                                   \
    OTHER(__muldc3)                                                                                                    \
    OTHER(__divdc3)                                                                                                    \
    OTHER(creal)                                                                                                       \
    OTHER(cimag)                                                                                                       \
    OTHER(conj)                                                                                                        \
    OTHER(ilogb)                                                                                                       \
    OTHER(cabs)                                                                                                        \
    OTHER(memcmp)                                                                                                      \
    OTHER(memcpy)                                                                                                      \
    OTHER(memmove)                                                                                                     \
    OTHER(memset)                                                                                                      \
    OTHER(malloc)                                                                                                      \
    OTHER(calloc)                                                                                                      \
    OTHER(realloc)                                                                                                     \
    OTHER(aligned_alloc)                                                                                               \
    OTHER(posix_memalign)                                                                                              \
    OTHER(free)                                                                                                        \
    OTHER(_Znwm)                                                                                                       \
    OTHER(_Znam)                                                                                                       \
    OTHER(_ZdlPv)                                                                                                      \
    OTHER(_ZdaPv)                                                                                                      \
    OTHER(_ZdlPvm)                                                                                                     \
    OTHER(_ZdaPvm)                                                                                                     \
    OTHER(printf)                                                                                                      \
    OTHER(fprintf)                                                                                                     \
    OTHER(sprintf)                                                                                                     \
    OTHER(snprintf)                                                                                                    \
    OTHER(vprintf)                                                                                                     \
    OTHER(vfprintf)                                                                                                    \
    OTHER(vsprintf)                                                                                                    \
    OTHER(vsnprintf)                                                                                                   \
    OTHER(crealf)                                                                                                      \
    OTHER(cimagf)                                                                                                      \
    OTHER(conjf)                                                                                                       \
    OTHER(cabsf)                                                                                                       \
    OTHER(csqrt)                                                                                                       \
    OTHER(__mulsc3)                                                                                                    \
    OTHER(__divsc3)                                                                                                    \
    OTHER(bcmp)                                                                                                        \
    OTHER(reallocarray)                                                                                                \
    OTHER(memalign)                                                                                                    \
    OTHER(valloc)                                                                                                      \
    OTHER(pvalloc)                                                                                                     \
    OTHER(_ZnwmSt11align_val_t)                                                                                        \
    OTHER(_ZnamSt11align_val_t)                                                                                        \
    OTHER(_ZnwmRKSt9nothrow_t)                                                                                         \
    OTHER(_ZnamRKSt9nothrow_t)                                                                                         \
    OTHER(_ZnwmSt11align_val_tRKSt9nothrow_t)                                                                          \
    OTHER(_ZnamSt11align_val_tRKSt9nothrow_t)                                                                          \
    OTHER(_ZdlPvSt11align_val_t)                                                                                       \
    OTHER(_ZdaPvSt11align_val_t)                                                                                       \
    OTHER(_ZdlPvmSt11align_val_t)                                                                                      \
    OTHER(_ZdaPvmSt11align_val_t)                                                                                      \
    OTHER(_ZdlPvRKSt9nothrow_t)                                                                                        \
    OTHER(_ZdaPvRKSt9nothrow_t)                                                                                        \
    OTHER(_ZSt11_Hash_bytesPKvmm)                                                                                      \
    OTHER(fesetround)                                                                                                  \
    OTHER(strtod)                                                                                                      \
    OTHER(strtof)                                                                                                      \
    OTHER(atof)                                                                                                        \
    OTHER(sscanf)                                                                                                      \
    OTHER(fscanf)                                                                                                      \
    OTHER(scanf)                                                                                                       \
    OTHER(__isoc99_sscanf)                                                                                             \
    OTHER(__isoc99_fscanf)                                                                                             \
    OTHER(__isoc99_scanf)                                                                                              \
    OTHER(_ZNSirsERd)                                                                                                  \
    OTHER(_ZNSirsERf)                                                                                                  \
    OTHER(_ZNSolsEf)                                                                                                   \
    OTHER(_ZNSolsEd)                                                                                                   \
    OTHER(_ZNSo9_M_insertIdEERSoT_)

/* Functions that only make numbers out of times, and never see one of ours: called as they are. */
#define CAGD_CODE_NATIVE(NATIVE) NATIVE(difftime)

/* Functions of the libraries that a run must not reach: there is one table of numbers, for one thread; and what is
 * longer than it was asked for. */
#define CAGD_CODE_REFUSED_NAMES(NAME)                                                                                  \
    NAME(pthread_create)                                                                                               \
    NAME(thrd_create)                                                                                                  \
    NAME(_ZNSt6thread15_M_start_threadESt10unique_ptrINS_6_StateESt14default_deleteIS1_EEPFvvE)                        \
    NAME(malloc_usable_size)
#endif
