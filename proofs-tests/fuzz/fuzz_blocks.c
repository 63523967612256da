/* fuzz_blocks.c -- the blocks of a section: weave complains, or writes a register that is JSON.  Weave frees nothing, so the fuzzer is
 * started again before the memory is full. */
#include "proofs-tests/fuzz/file.h"

#include "chapters/weave/book.h"

#include <jansson.h>
#include <string.h>
#include <sys/stat.h>

static char folder[64], section[96], json[96];

static void write_text(const char *path, const void *text, size_t size)
{
    FILE *out = fopen(path, "wb");
    if (out == NULL || fwrite(text, 1, size, out) != size || fclose(out) != 0)
        abort();
}

static void begin(void)
{
    char path[96];
    strcpy(folder, "/dev/shm/fuzzXXXXXX");
    if (mkdtemp(folder) == NULL)
        abort();
    strcat(folder, "/bezier");
    mkdir(folder, 0700);
    snprintf(path, sizeof path, "%s/index.md", folder);
    static const char index[] = "# A chapter\n\n```{toctree}\ns\n```\n";
    write_text(path, index, sizeof index - 1);
    snprintf(section, sizeof section, "%s/s.claims.h", folder);
    snprintf(json, sizeof json, "%s/register.json", folder);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (folder[0] == '\0')
        begin();
    file_of(section, data, size);
    struct book book = {.types = "field rational interval double"};
    complaints = 0;
    read_chapter(&book, folder);
    check_book(&book);
    if (complaints == 0 && memchr(data, '\0', size) == NULL) {
        if (write_register_c(&book, "/dev/null") != 0 || write_register_json(&book, json) != 0)
            abort();
        json_error_t error;
        json_t *read = json_load_file(json, 0, &error);
        /* a text that is no UTF-8 stays as it was written in the chapter */
        if (read == NULL && json_error_code(&error) != json_error_invalid_utf8)
            abort();
        json_decref(read);
    }
    return 0;
}
