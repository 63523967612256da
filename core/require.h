/* require.h -- how functions that give a status leave at the first thing that is wrong. */
#ifndef CAGD_REQUIRE_H
#define CAGD_REQUIRE_H

/* Returns `status` unless the condition is true. */
#define REQUIRE(condition, status)                                                                                     \
    do {                                                                                                               \
        if (!(condition))                                                                                              \
            return status;                                                                                             \
    } while (0)
#endif
