#include "cli/input.h"

#include <stdio.h>
#include <string.h>

int input_refuse(struct input_error *error, const char *place, const char *format, va_list list)
{
    snprintf(error->place, sizeof error->place, "%s", place);
    vsnprintf(error->cause, sizeof error->cause, format, list);
    return -1;
}

const char *name_of_input(const char *path) { return strcmp(path, "-") == 0 ? "standard input" : path; }

void report_input_error(const char *path, const struct input_error *error)
{
    fprintf(stderr, "cagd: %s: %s%s%s\n", name_of_input(path), error->place, error->place[0] != '\0' ? ": " : "",
            error->cause);
}
