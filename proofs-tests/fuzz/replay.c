/* replay.c -- runs what libFuzzer would run once for each of the files that are named: for counting which lines the corpora reach. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void run(const char *path)
{
    enum { LARGEST = 1 << 16 };
    static uint8_t bytes[LARGEST];
    FILE *in = fopen(path, "rb");
    if (in == NULL)
        abort();
    size_t size = fread(bytes, 1, LARGEST, in);
    fclose(in);
    uint8_t *data = malloc(size + 1); /* of its own size, so that whoever reads beyond it is seen */
    if (data == NULL)
        abort();
    for (size_t k = 0; k < size; k++)
        data[k] = bytes[k];
    LLVMFuzzerTestOneInput(data, size);
    free(data);
}

int main(int argc, char **argv)
{
    LLVMFuzzerInitialize(&argc, &argv);
    for (int k = 1; k < argc; k++)
        run(argv[k]);
    return 0;
}
