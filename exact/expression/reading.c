#include "exact/expression/reading.h"

#include "exact/words.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

int cagd_refuse_reading(cagd_reading_error *error, int from, int to, const char *format, ...)
{
    if (error->message[0] != '\0')
        return 0;
    error->from = from, error->to = to;
    va_list list;
    va_start(list, format);
    vsnprintf(error->message, sizeof error->message, format, list);
    va_end(list);
    return 0;
}

const char *cagd_text_of(const char *s, int n)
{
    char *text = region_bytes((size_t)n + 1);
    if (text == NULL)
        return NULL;
    memcpy(text, s, (size_t)n);
    text[n] = '\0';
    return text;
}
