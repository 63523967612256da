/* guard.h -- what AddressSanitizer is told of the region's pages: bytes that belong to no block are forbidden.  Without it, nothing. */
#ifndef CAGD_GUARD_H
#define CAGD_GUARD_H

#include <stddef.h>

#if defined(__SANITIZE_ADDRESS__)
#define CAGD_GUARDED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CAGD_GUARDED
#endif
#endif

#ifdef CAGD_GUARDED
#include <sanitizer/asan_interface.h>
enum { CAGD_GAP = 16 }; /* bytes behind each block that are no block's */
static inline void cagd_forbid(void *bytes, size_t n) { __asan_poison_memory_region(bytes, n); }
static inline void cagd_allow(void *bytes, size_t n) { __asan_unpoison_memory_region(bytes, n); }
#else
enum { CAGD_GAP = 0 };
static inline void cagd_forbid(void *bytes, size_t n) { (void)bytes, (void)n; }
static inline void cagd_allow(void *bytes, size_t n) { (void)bytes, (void)n; }
#endif
#endif
