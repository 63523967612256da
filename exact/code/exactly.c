/* exactly.c -- see exactly.h: a harness from its parts, and runs of it. */
#include "exact/code/exactly.h"

#include "exact/code/build.h"
#include "exact/code/points.h"
#include "exact/code/resident.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct cagd_exactly {
    struct cagd_code_harness *harness;
    struct cagd_code_program *program;
    struct cagd_code_point *point;
    struct cagd_code_resident *resident; /* runs in rationals; its outcome is its own */
    struct cagd_code_outcome *outcome, *own;
    int is_set[CAGD_CODE_MOST_IN_HARNESS];
    char message[1000], condition[5000];
};

/* The functions that only the loaded code calls: named here, so that who links a static library gets them. */
double cagd_code_lib_sqrt(double x);
int cagd_code_lib_printf(const char *format, ...);
void *cagd_code_lib_malloc(size_t n);
static void (*volatile const linked[])(void) = {
    (void (*)(void))cagd_code_lib_sqrt, (void (*)(void))cagd_code_lib_printf, (void (*)(void))cagd_code_lib_malloc};

/* ---- the harness ------------------------------------------------------------------------------------------- */

/* ":key: text", once, or once for each word. */
static void put_key(FILE *out, const char *key, const char *text, int is_list)
{
    while (text != NULL && *text != 0) {
        size_t length = is_list ? strcspn(text, " \t\n") : strlen(text);
        if (length > 0) {
            fprintf(out, ":%s: ", key);
            for (size_t k = 0; k < length; k++) /* a line goes on where the next begins with a blank */
                fprintf(out, text[k] == '\n' ? "\n   " : "%c", text[k]);
            fputc('\n', out);
        }
        text += length + (text[length] != 0);
    }
}

static struct cagd_code_harness *read_code(const struct cagd_exactly_code *code, size_t room, char message[])
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL) {
        snprintf(message, room, "no memory");
        return NULL;
    }
    fputs(":::{exactly} code\n", out);
    put_key(out, "source", code->source, 1);
    put_key(out, "flag", code->flags, 0);
    put_key(out, "include", code->include, 1);
    put_key(out, "declare", code->declare, 0);
    put_key(out, "input", code->input, 0);
    put_key(out, "where", code->where, 0);
    put_key(out, "call", code->call, 0);
    put_key(out, "output", code->output, 1);
    fputs(":::\n", out);
    struct cagd_code_harness_error error;
    struct cagd_code_harness *h = fclose(out) == 0 ? cagd_code_read_harness(text, &error) : NULL;
    if (h == NULL)
        snprintf(message, room, "%s", text != NULL ? error.cause : "no memory");
    free(text);
    return h;
}

/* As the header says; whether it was found. */
static int find_compiler(size_t room, char path[])
{
    static const char name[] = "cagd-compile-exactly";
    const char *named = getenv("CAGD_COMPILE_EXACTLY"), *folders = getenv("PATH");
    if (named != NULL && *named != 0)
        return (size_t)snprintf(path, room, "%s", named) < room;
    ssize_t length = readlink("/proc/self/exe", path, room - sizeof name - 1);
    while (length > 0 && path[length - 1] != '/')
        length--;
    strcpy(path + (length > 0 ? length : 0), name);
    if (length > 0 && access(path, X_OK) == 0)
        return 1;
    while (folders != NULL && *folders != 0) {
        size_t n = strcspn(folders, ":");
        if ((size_t)snprintf(path, room, "%.*s/%s", (int)n, folders, name) < room && access(path, X_OK) == 0)
            return 1;
        folders += n + (folders[n] == ':');
    }
    return 0;
}

struct cagd_exactly *cagd_exactly_load(const struct cagd_exactly_code *code, size_t room, char message[])
{
    char compiler[4096];
    struct cagd_exactly *x = calloc(1, sizeof *x);
    if (x == NULL || linked[0] == NULL) {
        snprintf(message, room, "no memory");
        return NULL;
    }
    if (!find_compiler(sizeof compiler, compiler))
        snprintf(message, room, "cagd-compile-exactly was not found beside this program or in PATH");
    else if ((x->harness = read_code(code, room, message)) != NULL)
        x->program = cagd_code_build(x->harness, "code", compiler, room, message);
    if (x->program == NULL) {
        cagd_exactly_free(x);
        return NULL;
    }
    x->point = cagd_code_point_new(x->harness, 0, 0);
    for (int k = 0; k < x->harness->inputs; k++)
        x->is_set[k] = x->harness->input[k].shape == CAGD_CODE_FIXED;
    return x;
}

void cagd_exactly_free(struct cagd_exactly *x)
{
    if (x == NULL)
        return;
    cagd_code_outcome_free(x->own);
    cagd_code_dismiss(x->resident);
    cagd_code_point_free(x->point);
    cagd_code_unload(x->program);
    cagd_code_harness_free(x->harness);
    free(x);
}

/* ---- runs ---------------------------------------------------------------------------------------------------- */

int cagd_exactly_set(struct cagd_exactly *x, const char *name, int count, const char *const value[])
{
    for (int k = 0; k < x->point->inputs; k++) {
        const struct cagd_code_input *in = &x->point->input[k];
        if (strcmp(in->name, name) != 0 || count != (in->count > 0 ? in->count : 1))
            continue;
        for (int j = 0; j < count; j++)
            if (!cagd_code_is_number(value[j]))
                return -1;
        for (int j = 0; j < count; j++)
            cagd_code_point_set(x->point, k, j, value[j]);
        x->is_set[k] = 1;
        for (int j = 0; j < count; j++)
            ((int *)(uintptr_t)in->like)[j] = j;
        return 0;
    }
    return -1;
}

enum cagd_exactly_end cagd_exactly_call(struct cagd_exactly *x, enum cagd_exactly_numbers numbers)
{
    cagd_code_outcome_free(x->own);
    x->outcome = x->own = NULL;
    for (int k = 0; k < x->point->inputs; k++)
        if (!x->is_set[k]) {
            snprintf(x->message, sizeof x->message, "the input %s was not set", x->point->input[k].name);
            return CAGD_EXACTLY_OUTSIDE;
        }
    struct cagd_code_job job = {.entry = "cagd_code_entry",
                                .numbers = (enum cagd_code_numbers)numbers,
                                .enclose = 1,
                                .inputs = x->point->inputs,
                                .input = x->point->input};
    struct cagd_code_outcome *o;
    if (numbers == CAGD_EXACTLY_RATIONAL)
        o = cagd_code_run_again(&x->resident, x->program, &job);
    else
        o = x->own = cagd_code_run(x->program, &job);
    x->message[0] = 0;
    if (o == NULL) {
        snprintf(x->message, sizeof x->message, "no memory");
        return CAGD_EXACTLY_BOUND;
    }
    x->outcome = o;
    if (o->end != CAGD_CODE_FINISHED)
        snprintf(x->message, sizeof x->message, o->line > 0 ? "%s, at %s:%d in %s" : "%s", o->message, o->file, o->line,
                 o->function);
    return (enum cagd_exactly_end)o->end;
}

static const struct cagd_code_result *result(const struct cagd_exactly *x, const char *name)
{
    const struct cagd_code_result *r = NULL;
    if (x->outcome != NULL && x->outcome->end == CAGD_CODE_FINISHED)
        for (r = x->outcome->results; r != NULL && strcmp(r->name, name) != 0;)
            r = r->next;
    return r;
}

const char *cagd_exactly_get(const struct cagd_exactly *x, const char *name)
{
    const struct cagd_code_result *r = result(x, name);
    return r != NULL ? r->got : NULL;
}

const char *cagd_exactly_function(const struct cagd_exactly *x, const char *name)
{
    const struct cagd_code_result *r = result(x, name);
    return r != NULL ? r->got_field : NULL;
}

double cagd_exactly_computed(const struct cagd_exactly *x, const char *name)
{
    const struct cagd_code_result *r = result(x, name);
    return r != NULL ? r->computed : (double)NAN;
}

double cagd_exactly_ulps(const struct cagd_exactly *x, const char *name)
{
    const struct cagd_code_result *r = result(x, name);
    return r != NULL ? r->ulps : (double)NAN;
}

const char *cagd_exactly_condition(const struct cagd_exactly *x, int k)
{
    const struct cagd_code_condition *c = x->outcome != NULL ? x->outcome->conditions : NULL;
    for (; c != NULL && (c->given || k-- > 0);)
        c = c->next;
    if (c == NULL)
        return NULL;
    struct cagd_exactly *mine = (struct cagd_exactly *)(uintptr_t)x;
    snprintf(mine->condition, sizeof mine->condition, "%s %s %s", c->left, c->relation, c->right);
    return mine->condition;
}

const char *cagd_exactly_message(const struct cagd_exactly *x) { return x->message; }
