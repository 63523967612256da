/* output.c -- files that are either whole or not there. */
#include "cli/output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct output {
    char *path, *temporary;
    FILE *stream;
};

static int failed(const char *path)
{
    fprintf(stderr, "cagd: %s: %s\n", path, strerror(errno));
    return -1;
}

struct output *output_open(const char *path)
{
    struct output *o = calloc(1, sizeof *o);
    size_t room = strlen(path) + 8;
    if (o == NULL || (o->path = strdup(path)) == NULL || (o->temporary = malloc(room)) == NULL)
        abort();
    snprintf(o->temporary, room, "%s.XXXXXX", path);
    int fd = mkstemp(o->temporary);
    if (fd >= 0 && fchmod(fd, 0644) == 0)
        o->stream = fdopen(fd, "w");
    if (o->stream == NULL) {
        failed(path);
        free(o->path), free(o->temporary), free(o);
        return NULL;
    }
    return o;
}

FILE *output_stream(struct output *o) { return o->stream; }

int output_close(struct output *o)
{
    int bad = ferror(o->stream) != 0;
    bad |= fclose(o->stream) != 0;
    if (bad || rename(o->temporary, o->path) != 0) {
        bad = failed(o->path);
        unlink(o->temporary);
    }
    free(o->path), free(o->temporary), free(o);
    return bad ? -1 : 0;
}

int write_text_file(const char *path, const char *text)
{
    struct output *o = output_open(path);
    if (o == NULL)
        return -1;
    fputs(text, output_stream(o));
    return output_close(o);
}

int make_folder(const char *path)
{
    char *copy = strdup(path);
    if (copy == NULL)
        abort();
    for (char *p = copy + 1; *p != '\0'; p++)
        if (*p == '/') {
            *p = '\0';
            mkdir(copy, 0755);
            *p = '/';
        }
    int bad = mkdir(copy, 0755) != 0 && errno != EEXIST;
    struct stat s;
    bad |= stat(copy, &s) != 0 || !S_ISDIR(s.st_mode);
    free(copy);
    return bad ? failed(path) : 0;
}
