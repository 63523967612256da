/* build.c -- see build.h. */
#include "exact/code/build.h"

#include "exact/code/driver.h"
#include "exact/code/scratch.h"

#include <errno.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

enum { MOST_WORDS = 3 * CAGD_CODE_MOST_IN_HARNESS + 16, MOST_PATH = 4096 };

/* `name` from the folder of the file `path`, unless it begins at the root; the caller frees it. */
static char *beside(const char *path, const char *name)
{
    const char *slash = strrchr(path, '/');
    size_t folder = *name != '/' && slash != NULL ? (size_t)(slash - path) + 1 : 0;
    char *full = malloc(folder + strlen(name) + 1);
    if (full == NULL)
        abort();
    memcpy(full, path, folder);
    strcpy(full + folder, name);
    return full;
}

/* Its exit code, or -1 and errno when it could not be started. */
static int run(char *const word[])
{
    pid_t child;
    int status;
    errno = posix_spawn(&child, word[0], NULL, NULL, word, environ);
    if (errno != 0)
        return -1;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* What is left when the program ends while it builds; nothing that is not allowed in a handler of a signal. */
static char unfinished[3][IN_SCRATCH];
void cagd_code_build_forget(void)
{
    for (int k = 0; k < 2 && unfinished[0][0] != '\0'; k++)
        unlink(unfinished[k + 1]);
    if (unfinished[0][0] != '\0')
        rmdir(unfinished[0]);
}

struct cagd_code_program *cagd_code_build(const struct cagd_code_harness *h, const char *path, const char *compiler,
                                          size_t room, char message[])
{
    char folder[SCRATCH], driver[IN_SCRATCH], object[IN_SCRATCH], *word[MOST_WORDS], *made[MOST_WORDS];
    struct cagd_code_program *p = NULL;
    int words = 0, count = 0, status = -1, cause = 0;
    if (make_scratch(folder, "cagd-exactly") != 0) {
        snprintf(message, room, "no temporary folder: %s", strerror(errno));
        return NULL;
    }
    snprintf(driver, sizeof driver, "%s/driver%s", folder, cagd_code_is_cpp(h) ? ".cc" : ".c");
    snprintf(object, sizeof object, "%s/object.so", folder);
    memcpy(unfinished[1], driver, sizeof driver), memcpy(unfinished[2], object, sizeof object);
    memcpy(unfinished[0], folder, strlen(folder) + 1);
    FILE *out = fopen(driver, "w");
    if (out != NULL) {
        cagd_code_write_driver(h, path, out);
        status = fclose(out);
    }
    if (status != 0)
        cause = errno;
    word[words++] = (char *)(uintptr_t)compiler;
    if (h->notes_stores)
        word[words++] = "--stores";
    word[words++] = "-o";
    word[words++] = object;
    word[words++] = driver;
    for (int k = 0; k < h->source.count; k++)
        word[words++] = made[count++] = beside(path, h->source.text[k]);
    word[words++] = "--";
    word[words++] = "-I";
    word[words++] = made[count++] = beside(path, ".");
    for (int k = 0; k < h->flag.count; k++) /* -Ifolder is one from the folder of the file */
        if (strncmp(h->flag.text[k], "-I", 2) == 0 && h->flag.text[k][2] != 0) {
            word[words++] = "-I";
            word[words++] = made[count++] = beside(path, h->flag.text[k] + 2);
        } else {
            word[words++] = h->flag.text[k];
        }
    word[words] = NULL;
    if (status == 0) {
        status = run(word);
        cause = errno;
    }
    if (status == 0)
        p = cagd_code_load(object, room, message);
    else if (status < 0)
        snprintf(message, room,
                 "%s cannot be started: %s; it is built where LLVM 14 or newer and its clang are installed", compiler,
                 strerror(cause));
    else
        snprintf(message, room, "the sources were not compiled");
    for (int k = 0; k < count; k++)
        free(made[k]);
    cagd_code_build_forget();
    unfinished[0][0] = '\0';
    return p;
}
