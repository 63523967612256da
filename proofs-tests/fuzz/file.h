/* file.h -- the bytes of a fuzzer as a file with a name, in memory; and what makes a fuzzer fast. */
#ifndef CAGD_FUZZ_FILE_H
#define CAGD_FUZZ_FILE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* The readers complain to nobody: what is written to stderr costs more than what is read.  The fuzzer itself keeps the stream that
 * stderr was. */
int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc, (void)argv;
    stderr = fopen("/dev/null", "w");
    return stderr == NULL;
}

/* Whether the input is one of 64, by a hash of its bytes: what takes long and is no reading is done for these. */
static inline int is_one_of_64(const uint8_t *data, size_t size)
{
    uint32_t hash = 2166136261u; /* Fowler, Noll and Vo's */
    for (size_t k = 0; k < size; k++)
        hash = (hash ^ data[k]) * 16777619u;
    return hash >> 26 == 0;
}

static const char *file_name = "";
static const uint8_t *file_bytes;
static size_t file_size;

/* Whoever opens a file of that name from now on reads just these bytes.  There is no such file: the linker puts the fopen below in the
 * place of the C library's. */
static inline const char *file_of(const char *name, const uint8_t *data, size_t size)
{
    file_name = name, file_bytes = data, file_size = size;
    return name;
}

FILE *__real_fopen(const char *path, const char *mode);
FILE *__wrap_fopen(const char *path, const char *mode);
FILE *__wrap_fopen(const char *path, const char *mode)
{
    return strcmp(path, file_name) == 0 ? fmemopen((void *)(uintptr_t)file_bytes, file_size, "r")
                                        : __real_fopen(path, mode);
}
#endif
