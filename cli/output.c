/* output.c -- files that are written: whole or not at all, and in place of nothing that was not meant. */
#include "cli/output.h"
#include "chapters/judge/memory_text.h"
#include "cli/command.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void *must(void *p)
{
    if (p == NULL)
        abort();
    return p;
}

static int failed(const char *path, const char *format, ...) __attribute__((format(printf, 2, 3)));
static int failed(const char *path, const char *format, ...)
{
    char cause[PATH_MAX + 128];
    va_list list;
    va_start(list, format);
    vsnprintf(cause, sizeof cause, format, list);
    va_end(list);
    refuse_line("%s: %s", path, cause);
    return -1;
}

/* ---- where a name leads --------------------------------------------------------------------------- */

/* Where the bytes go: the path behind all symbolic links, and what is there. */
struct place {
    char path[PATH_MAX];
    struct stat is; /* of the file; where there is none, of its folder */
    int exists, in_place;
};

/* The folder of a path, "." where it names none. */
static void folder_of(const char *path, char folder[PATH_MAX])
{
    const char *slash = strrchr(path, '/');
    int length = slash == NULL ? 0 : slash == path ? 1 : (int)(slash - path);
    snprintf(folder, PATH_MAX, "%.*s", length == 0 ? 1 : length, length == 0 ? "." : path);
}

static const char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash == NULL ? path : slash + 1;
}

/* The link at p->path is replaced by what it says; 0 where there is no link. */
static int follow(struct place *p)
{
    char target[PATH_MAX], folder[PATH_MAX], whole[2 * PATH_MAX];
    ssize_t length = readlink(p->path, target, sizeof target - 1);
    if (length < 0)
        return 0;
    target[length] = '\0';
    folder_of(p->path, folder);
    snprintf(whole, sizeof whole, "%s%s%s", target[0] == '/' ? "" : folder, target[0] == '/' ? "" : "/", target);
    if (strlen(whole) >= sizeof p->path)
        return 0;
    memcpy(p->path, whole, strlen(whole) + 1);
    return 1;
}

/* A file that is there.  The path of a regular file, when its links are followed, leads to itself; that of one which is open
 * but has no name any more does not. */
static int find_existing(const char *path, struct place *p)
{
    char folder[PATH_MAX], *real = realpath(p->path, NULL);
    struct stat again;
    p->exists = 1;
    if (S_ISDIR(p->is.st_mode)) {
        free(real);
        return failed(path, "is a folder; name a file in it");
    }
    p->in_place = !S_ISREG(p->is.st_mode) || p->is.st_nlink != 1 || real == NULL || strlen(real) >= sizeof p->path ||
                  stat(real, &again) != 0 || again.st_ino != p->is.st_ino || again.st_dev != p->is.st_dev;
    if (!p->in_place)
        memcpy(p->path, real, strlen(real) + 1);
    free(real);
    if (access(p->path, W_OK) != 0)
        return failed(path, "cannot be written: %s; choose another name or change what it permits", strerror(errno));
    folder_of(p->path, folder);
    p->in_place = p->in_place || access(folder, W_OK | X_OK) != 0;
    return 0;
}

/* 0, or -1 and a line on stderr when nothing can be written there. */
static int find_place(const char *path, struct place *p)
{
    enum { MOST_LINKS = 40 };
    char folder[PATH_MAX];
    *p = (struct place){.exists = 0};
    if (path[0] == '\0')
        return failed("''", "is no name of a file; give one");
    if (strlen(path) >= sizeof p->path)
        return failed(path, "%s; choose another name", strerror(ENAMETOOLONG));
    strcpy(p->path, path);
    for (int links = 0; stat(p->path, &p->is) != 0;) {
        if (errno != ENOENT)
            return failed(path, "no file can be there: %s; choose another name", strerror(errno));
        if (links++ < MOST_LINKS && follow(p))
            continue;
        folder_of(p->path, folder);
        if (stat(folder, &p->is) != 0)
            return failed(path, "there is no folder '%s'; make it first", folder);
        if (name_of(p->path)[0] == '\0')
            return failed(path, "is a folder; name a file in it");
        if (access(folder, W_OK | X_OK) != 0)
            return failed(path, "nothing can be written in the folder '%s': %s; choose another", folder,
                          strerror(errno));
        return 0;
    }
    return find_existing(path, p);
}

/* ---- writing --------------------------------------------------------------------------------------- */

struct output {
    const char *path; /* as it was given */
    struct place place;
    char temporary[PATH_MAX]; /* empty: written in place */
    int file;
    FILE *stream; /* keeps the text until it is whole */
    char *text;
    size_t size;
};

/* The files that are being written, for whoever ends the program in between. */
enum { MOST_OPEN = 64 };
static _Atomic(struct output *) being_written[MOST_OPEN];

static void begin_writing(struct output *o)
{
    struct output *none = NULL;
    for (int k = 0; k < MOST_OPEN && !atomic_compare_exchange_strong(&being_written[k], &none, o); k++)
        none = NULL;
}

static void end_writing(const struct output *o)
{
    for (int k = 0; k < MOST_OPEN; k++)
        if (being_written[k] == o)
            being_written[k] = NULL;
}

void output_forget(void)
{
    for (int k = 0; k < MOST_OPEN; k++) {
        const struct output *o = being_written[k];
        if (o != NULL && o->temporary[0] != '\0')
            unlink(o->temporary);
    }
}

/* A file under a name that nobody uses, in the folder of the place, with the mode and the owner of what is there: its
 * descriptor, or -1. */
static int open_temporary(struct output *o)
{
    static atomic_uint last;
    char folder[PATH_MAX];
    int fd;
    folder_of(o->place.path, folder);
    do {
        int length = snprintf(o->temporary, sizeof o->temporary, "%s/.cagd-%ld-%u", folder, (long)getpid(), last++);
        if (length >= (int)sizeof o->temporary) {
            errno = ENAMETOOLONG;
            return -1;
        }
        fd = open(o->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (fd < 0 && errno == EEXIST);
    if (fd < 0 || !o->place.exists)
        return fd;
    const struct stat *is = &o->place.is;
    struct stat mine;
    if (fstat(fd, &mine) == 0 &&
        ((mine.st_uid == is->st_uid && mine.st_gid == is->st_gid) || fchown(fd, is->st_uid, is->st_gid) == 0) &&
        fchmod(fd, is->st_mode & 07777) == 0)
        return fd;
    close(fd);
    unlink(o->temporary);
    return -1;
}

struct output *output_open(const char *path)
{
    struct output *o = must(calloc(1, sizeof *o));
    o->path = path;
    o->file = -1;
    if (find_place(path, &o->place) != 0) {
        free(o);
        return NULL;
    }
    begin_writing(o);
    if (!o->place.in_place)
        o->file = open_temporary(o);
    if (o->file < 0 && o->place.exists) {
        o->temporary[0] = '\0';
        o->file = open(o->place.path, O_WRONLY | O_NOCTTY | O_CLOEXEC);
    }
    if (o->file < 0) {
        failed(path, "cannot be written: %s; choose another name", strerror(errno));
        end_writing(o);
        free(o);
        return NULL;
    }
    o->stream = text_open(&o->text, &o->size);
    return o;
}

FILE *output_stream(struct output *o) { return o->stream; }

/* Whether the file is a regular one that is written in place, and so loses what it has. */
static int is_overwritten(const struct output *o) { return o->temporary[0] == '\0' && S_ISREG(o->place.is.st_mode); }

/* Room for the whole text behind what the file has, before anything of that is lost; 0, or -1 and errno. */
static int find_room(const struct output *o)
{
    struct stat was;
    if (fstat(o->file, &was) != 0)
        return -1;
    int cause = (off_t)o->size > was.st_size ? posix_fallocate(o->file, 0, (off_t)o->size) : 0;
    if (cause != 0 && ftruncate(o->file, was.st_size) == 0)
        errno = cause;
    return cause == 0 ? 0 : -1;
}

/* The whole text into the file; 0, or -1 and errno. */
static int write_whole(const struct output *o)
{
    for (size_t done = 0; done < o->size;) {
        ssize_t more = write(o->file, o->text + done, o->size - done);
        if (more < 0 && errno != EINTR)
            return -1;
        done += more > 0 ? (size_t)more : 0;
    }
    return is_overwritten(o) ? ftruncate(o->file, (off_t)o->size) : 0;
}

const char *output_advice(int cause)
{
    return cause == 0 || cause == ENOSPC || cause == EDQUOT || cause == EFBIG ? "make room there, or " : "";
}

int output_close(struct output *o)
{
    text_close(o->stream, &o->text);
    int kept = is_overwritten(o) && find_room(o) != 0, bad = kept ? -1 : write_whole(o), cause = errno;
    if (close(o->file) != 0 && bad == 0)
        bad = -1, cause = errno;
    if (bad == 0 && o->temporary[0] != '\0' && rename(o->temporary, o->place.path) != 0)
        bad = -1, cause = errno;
    if (bad != 0) {
        failed(o->path, "%s%s; %schoose another name", strerror(cause),
               kept || (o->temporary[0] != '\0' && o->place.exists) ? "; what was there is unchanged"
               : o->temporary[0] != '\0'                            ? "; nothing was left there"
               : is_overwritten(o)                                  ? "; what was there is lost"
                                                                    : "",
               output_advice(cause));
        if (o->temporary[0] != '\0')
            unlink(o->temporary);
    }
    end_writing(o);
    free(o->text);
    free(o);
    return bad;
}

int write_text_file(const char *path, const char *text)
{
    struct output *o = output_open(path);
    if (o == NULL)
        return -1;
    fputs(text, output_stream(o));
    return output_close(o);
}

int write_text_in_turn(const char *path, const char *text, int *failed)
{
    static pthread_mutex_t turn = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&turn);
    *failed = *failed || write_text_file(path, text) != 0;
    int status = *failed ? -1 : 0;
    pthread_mutex_unlock(&turn);
    return status;
}

int make_folder(const char *path)
{
    char *copy = must(strdup(path));
    for (char *p = copy + 1; *copy != '\0' && *p != '\0'; p++)
        if (*p == '/') {
            *p = '\0';
            mkdir(copy, 0777);
            *p = '/';
        }
    int cause = mkdir(copy, 0777) != 0 ? errno : 0;
    struct stat s;
    int is_folder = stat(copy, &s) == 0 && S_ISDIR(s.st_mode);
    free(copy);
    if (is_folder)
        return 0;
    if (cause == EEXIST)
        return failed(path, "is no folder; choose another name");
    return failed(path, "no folder can be made there: %s; choose another name", strerror(cause));
}

/* ---- promises --------------------------------------------------------------------------------------- */

/* Files that are read or that options will write, by what tells them apart: a file by its own number, and one that is not
 * there by the number of its folder and its name. */
struct named {
    const char *option; /* NULL: it is read */
    dev_t device;
    ino_t number;
    char name[NAME_MAX + 1];
};
enum { MOST_NAMED = 64 };
static struct named named[MOST_NAMED];
static int names;

static struct named identity(const char *option, const struct stat *is, const char *name)
{
    struct named n = {.option = option, .device = is->st_dev, .number = is->st_ino};
    snprintf(n.name, sizeof n.name, "%.*s", NAME_MAX, name);
    return n;
}

static void note(struct named n)
{
    if (names < MOST_NAMED)
        named[names++] = n;
}

/* What is already noted of the same file; NULL: nothing. */
static const struct named *noted(const struct named *n)
{
    for (int k = 0; k < names; k++)
        if (named[k].device == n->device && named[k].number == n->number && strcmp(named[k].name, n->name) == 0)
            return &named[k];
    return NULL;
}

int output_spare(const char *path)
{
    struct stat is;
    if ((strcmp(path, "-") == 0 ? fstat(STDIN_FILENO, &is) : stat(path, &is)) != 0 || !S_ISREG(is.st_mode))
        return 0;
    const struct named n = identity(NULL, &is, "");
    const struct named *other = noted(&n);
    if (other != NULL && other->option != NULL) {
        refuse_line("%s: is read, and --%s would write over it; choose another name", path, other->option);
        return EXIT_USAGE;
    }
    if (other == NULL)
        note(n);
    return 0;
}

static int misused(const char *option, const char *path, const char *cause)
{
    refuse_line("--%s %s: %s", option, path, cause);
    return EXIT_USAGE;
}

static int given_already(const char *option, const char *path, const char *other)
{
    refuse_line("--%s %s: --%s writes that file; choose another name", option, path, other);
    return EXIT_USAGE;
}

int output_promise(const char *option, const char *path)
{
    struct place place;
    struct stat is;
    if (strcmp(path, "-") == 0)
        return misused(option, path, "takes the name of a file; standard output is /dev/stdout");
    if (path[0] == '\0')
        return misused(option, "''", "is no name of a file; give one");
    if (find_place(path, &place) != 0)
        return EXIT_USAGE;
    if (place.exists && !S_ISREG(place.is.st_mode))
        return 0;
    for (int stream = STDOUT_FILENO; stream <= STDERR_FILENO; stream++)
        if (place.exists && fstat(stream, &is) == 0 && is.st_dev == place.is.st_dev && is.st_ino == place.is.st_ino)
            return misused(option, path, "is where other output goes already; choose another name");
    const struct named n = identity(option, &place.is, place.exists ? "" : name_of(place.path));
    const struct named *other = noted(&n);
    if (other != NULL && other->option == NULL)
        return misused(option, path, "is read, and would be lost; choose another name");
    if (other != NULL)
        return given_already(option, path, other->option);
    note(n);
    return 0;
}

/* Where a folder that is not there yet begins: the first part of the path that is missing, and the folder that it is missing
 * from, whose name is a part of the path, too.  0 where nothing is missing; -1 where something else is in the way. */
static int first_missing(const char *path, char part[PATH_MAX], struct stat *parent)
{
    size_t length = 0;
    if (strlen(path) >= PATH_MAX)
        return errno = ENAMETOOLONG, -1;
    if (stat(path[0] == '/' ? "/" : ".", parent) != 0)
        return -1;
    while (path[length] != '\0') {
        struct stat is;
        length += strspn(path + length, "/");
        length += strcspn(path + length, "/");
        snprintf(part, PATH_MAX, "%.*s", (int)length, path);
        if (stat(part, &is) != 0) {
            if (errno != ENOENT)
                return -1;
            return lstat(part, &is) != 0 ? 1 : (errno = EEXIST, -1); /* a link to nothing */
        }
        if (!S_ISDIR(is.st_mode))
            return errno = path[length] == '\0' ? EEXIST : ENOTDIR, -1;
        *parent = is;
    }
    return 0;
}

int output_promise_folder(const char *option, const char *path)
{
    char part[PATH_MAX], parent[PATH_MAX];
    struct stat is;
    if (strcmp(path, "-") == 0)
        return misused(option, path, "takes the name of a folder; give one");
    if (path[0] == '\0')
        return misused(option, "''", "is no name of a folder; give one");
    int missing = first_missing(path, part, &is);
    if (missing < 0 && errno == EEXIST)
        return failed(path, "is no folder; choose another name"), EXIT_USAGE;
    if (missing < 0)
        return failed(path, "no folder can be made there: %s; choose another name", strerror(errno)), EXIT_USAGE;
    const struct named n = identity(option, &is, missing ? name_of(part) : "");
    const struct named *other = missing ? noted(&n) : NULL;
    if (other != NULL)
        return given_already(option, path, other->option);
    folder_of(part, parent);
    if (access(missing ? parent : path, W_OK | X_OK) != 0)
        return failed(path, "nothing can be written in the folder '%s': %s; choose another", missing ? parent : path,
                      strerror(errno)),
               EXIT_USAGE;
    return 0;
}
