/* file.h -- the bytes of a fuzzer as a file with a name, in memory. */
#ifndef CAGD_FUZZ_FILE_H
#define CAGD_FUZZ_FILE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static int file_in_memory = -1;

/* The path of a file that holds just these bytes; the same file each time. */
static inline const char *file_of(const uint8_t *data, size_t size)
{
    static char path[40];
    if (file_in_memory < 0)
        file_in_memory = memfd_create("fuzz", 0);
    if (file_in_memory < 0 || ftruncate(file_in_memory, 0) != 0 || pwrite(file_in_memory, data, size, 0) != (ssize_t)size)
        abort();
    snprintf(path, sizeof path, "/proc/self/fd/%d", file_in_memory);
    return path;
}
#endif
