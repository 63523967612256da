/* noise.h -- random numbers that are the same on every machine, for the tests of the fit: splitmix64, and Box and Muller. */
#include <math.h>
#include <stdint.h>

static uint64_t state; /* the seed */

/* In (0,1). */
static double uniform(void)
{
    uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return ((double)((z ^ (z >> 31)) >> 11) + 0.5) * 0x1p-53;
}

/* Of mean 0 and variance 1. */
static double normal(void)
{
    const double radius = sqrt(-2 * log(uniform())); /* before the angle, whatever the compiler */
    return radius * cos(6.283185307179586476925 * uniform());
}
