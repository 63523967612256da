#include "cli/input.h"
#include "cli/refuse.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

int input_refuse(struct input_error *error, const char *place, const char *format, va_list list)
{
    snprintf(error->place, sizeof error->place, "%s", place);
    vsnprintf(error->cause, sizeof error->cause, format, list);
    return -1;
}

const char *name_of_input(const char *path)
{
    return strcmp(path, "-") == 0 ? "standard input" : path[0] == '\0' ? "''" : path;
}

FILE *open_input(const char *path, const char *what, struct input_error *error)
{
    FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "rb");
    struct stat is;
    *error = (struct input_error){"", ""};
    if (file == NULL)
        snprintf(error->cause, sizeof error->cause, "%s; expected the file of %s", strerror(errno), what);
    if (file == NULL || fstat(fileno(file), &is) != 0 || !S_ISDIR(is.st_mode))
        return file;
    if (file != stdin)
        fclose(file);
    snprintf(error->cause, sizeof error->cause, "is a folder; expected the file of %s", what);
    return NULL;
}

void report_input_error(const char *path, const struct input_error *error)
{
    refuse_line("%s: %s%s%s", name_of_input(path), error->place, error->place[0] != '\0' ? ": " : "", error->cause);
}
