#include "chapters/judge/memory_text.h"

#include <stdlib.h>

FILE *text_open(char **text, size_t *size)
{
    FILE *stream = open_memstream(text, size);
    if (stream == NULL)
        abort();
    return stream;
}

/* A stream that found no memory has an error; one that found none for its last byte has no text. */
void text_close(FILE *stream, char *const *text)
{
    int whole = fflush(stream) == 0 && !ferror(stream);
    if (fclose(stream) != 0 || !whole || *text == NULL)
        abort();
}
