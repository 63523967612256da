/* keep.c -- what was compiled of a lab itself, kept for the next check of it in the user's folder for such things; see lab.h.
 *
 * A file there is a line, the digest of what it was made of and that of its content, and the content: one that is old, or was damaged,
 * is made again.  Only `cagd lab check` keeps anything: where submissions are graded nothing is taken from a file that somebody else
 * might have written. */
#include "cli/digest.h"
#include "cli/lab/lab.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { HEAD = 2 * DIGEST, MOST_KEPT = 1 << 23 };

/* Each folder of the path is made that is not there; whether the last is one of this user, in which nobody else writes. */
static int is_folder(char *path)
{
    for (char *slash = strchr(path + 1, '/'); slash != NULL; slash = strchr(slash + 1, '/')) {
        *slash = 0;
        mkdir(path, 0700);
        *slash = '/';
    }
    struct stat is;
    return (mkdir(path, 0700) == 0 || errno == EEXIST) && stat(path, &is) == 0 && S_ISDIR(is.st_mode) &&
           is.st_uid == geteuid() && (is.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

void lab_keep_for(struct lab_place *p, const struct lab *lab)
{
    const char *cache = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
    int absolute = cache != NULL && *cache == '/', length = -1;
    if (absolute || (home != NULL && *home == '/'))
        length = snprintf(p->store, sizeof p->store, "%s%s/cagd/labs/%s", absolute ? cache : home,
                          absolute ? "" : "/.cache", lab->name);
    if (length < 0 || length >= (int)sizeof p->store || !is_folder(p->store))
        p->store[0] = 0;
}

/* What it is made of and what made it: the text, and the programs by their times and sizes. */
static void key_of(const char *name, const char *text, char key[DIGEST])
{
    static const char *const programs[] = {"cagd", "cagd-compile-exactly"};
    char *all = NULL, path[LAB_MOST_PATH];
    size_t size;
    FILE *out = open_memstream(&all, &size);
    if (out == NULL)
        abort();
    for (size_t k = 0; k < sizeof programs / sizeof *programs; k++) {
        struct stat is;
        if (stat(lab_program(programs[k], path), &is) == 0)
            fprintf(out, "%s %lld %lld.%09ld\n", path, (long long)is.st_size, (long long)is.st_mtim.tv_sec,
                    is.st_mtim.tv_nsec);
    }
    fprintf(out, "%s\n%s", name, text);
    if (fclose(out) != 0)
        abort();
    digest_of_text(all, key);
    free(all);
}

/* The bytes of a file; NULL when there are none, or too many.  The caller frees. */
static char *bytes_of(const char *path, size_t *size)
{
    struct stat is;
    int file = open(path, O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    char *bytes = NULL;
    if (file >= 0 && fstat(file, &is) == 0 && S_ISREG(is.st_mode) && is.st_size > 0 && is.st_size <= MOST_KEPT) {
        *size = (size_t)is.st_size;
        bytes = malloc(*size);
        if (bytes == NULL || read(file, bytes, *size) != is.st_size) {
            free(bytes);
            bytes = NULL;
        }
    }
    if (file >= 0)
        close(file);
    return bytes;
}

static int put_bytes(const char *path, const char *head, const char *bytes, size_t size)
{
    unlink(path);
    int file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    size_t length = strlen(head);
    int status = file >= 0 && write(file, head, length) == (ssize_t)length && write(file, bytes, size) == (ssize_t)size;
    if (file >= 0 && close(file) != 0)
        status = 0;
    return status ? 0 : -1;
}

int lab_take_kept(const struct lab_place *p, const char *name, const char *text)
{
    char path[LAB_MOST_PATH + 128], key[DIGEST], digest[DIGEST];
    size_t size;
    if (p->store[0] == 0)
        return 0;
    snprintf(path, sizeof path, "%s/%s", p->store, name);
    char *bytes = bytes_of(path, &size);
    int taken = 0;
    if (bytes != NULL && size > HEAD) {
        key_of(name, text, key);
        digest_of_bytes(bytes + HEAD, size - HEAD, digest);
        snprintf(path, sizeof path, "%s/%s", p->folder, name);
        taken = memcmp(bytes, key, DIGEST - 1) == 0 && memcmp(bytes + DIGEST, digest, DIGEST - 1) == 0 &&
                put_bytes(path, "", bytes + HEAD, size - HEAD) == 0;
    }
    free(bytes);
    return taken;
}

void lab_keep(const struct lab_place *p, const char *name, const char *text)
{
    char path[LAB_MOST_PATH + 128], beside[LAB_MOST_PATH + 160], key[DIGEST], digest[DIGEST], head[HEAD + 1];
    size_t size;
    if (p->store[0] == 0)
        return;
    snprintf(path, sizeof path, "%s/%s", p->folder, name);
    char *bytes = bytes_of(path, &size);
    if (bytes == NULL)
        return;
    key_of(name, text, key);
    digest_of_bytes(bytes, size, digest);
    snprintf(head, sizeof head, "%s %s\n", key, digest);
    snprintf(path, sizeof path, "%s/%s", p->store, name);
    snprintf(beside, sizeof beside, "%s.%ld", path, (long)getpid());
    if (put_bytes(beside, head, bytes, size) != 0 || rename(beside, path) != 0)
        unlink(beside);
    free(bytes);
}
