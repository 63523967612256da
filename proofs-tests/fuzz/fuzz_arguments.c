/* fuzz_arguments.c -- command lines of `cagd fit`, which has most options: words in lines.  What the parser would end the program
 * for ends the run; what it accepts is inside the limits that the fit asks for. */
#include "proofs-tests/fuzz/file.h"

#include "cli/fit/fit.h"

#include <setjmp.h>
#include <stdarg.h>
#include <string.h>

static jmp_buf refused;
error_t __real_argp_parse(const struct argp *, int, char **, unsigned, int *, void *);
error_t __wrap_argp_parse(const struct argp *argp, int argc, char **argv, unsigned flags, int *end, void *input)
{
    if (__real_argp_parse(argp, argc, argv, flags | ARGP_NO_EXIT | ARGP_NO_HELP | ARGP_SILENT, end, input) != 0)
        longjmp(refused, 1);
    return 0;
}
_Noreturn void __wrap_refuse_call(const char *name, const char *format, ...) __attribute__((format(printf, 2, 3)));
void __wrap_refuse_call(const char *name, const char *format, ...)
{
    char text[512];
    va_list list;
    (void)name;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    longjmp(refused, 1);
}
_Noreturn void __wrap_argp_failure(const struct argp_state *state, int status, int number, const char *format, ...);
void __wrap_argp_failure(const struct argp_state *state, int status, int number, const char *format, ...)
{
    (void)state, (void)status, (void)number, (void)format;
    longjmp(refused, 1);
}

/* Files that are named are left alone. */
int output_spare(const char *path) { return path == NULL; }
int make_folder(const char *path) { return path == NULL; }
const char *output_advice(int cause) { return cause == 0 ? "" : " "; }
int output_promise(const char *option, const char *path)
{
    (void)option, (void)path;
    return 0;
}
int output_promise_folder(const char *option, const char *path)
{
    (void)option, (void)path;
    return 0;
}

int run_fit(const struct call *c)
{
    (void)c;
    return 0;
}

extern const struct command command_fit;

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > 1024)
        return -1;
    static char text[1025], *words[66];
    static char name[] = "cagd fit";
    memcpy(text, data, size);
    text[size] = '\0';
    int count = 1;
    words[0] = name;
    for (char *word = strtok(text, "\n"); word != NULL && count < 64; word = strtok(NULL, "\n"))
        words[count++] = word;
    words[count] = NULL;
    const struct call call = {.command = &command_fit, .argc = count, .argv = words};
    region_faults = 0;
    region_mark mark = region_open();
    if (setjmp(refused) == 0) {
        struct fit_arguments a = read_fit_arguments(&call);
        if (a.asked.path == NULL || a.asked.jobs < 0 || a.sigma < 0 || a.inner_knots < 0)
            abort();
        free(a.inner);
    }
    region_drop(mark);
    return 0;
}
