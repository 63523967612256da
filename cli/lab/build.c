/* build.c -- other people's code before it runs: compiled, looked at, and in binary64 under the sanitizers; see lab.h. */
#include "cli/lab/lab.h"

#include "cli/lab/allowed.h"
#include "cli/output.h"
#include "cli/refuse.h"
#include "exact/code/names.h"
#include "exact/number/rational.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <unistd.h>

static const char NAMES[] = "names"; /* what cagd-compile-exactly has seen */
enum { EXPAND_SECONDS = 5, COMPILE_SECONDS = 20, NATIVE_SECONDS = 5, SHOWN_ERRORS = 3, MOST_WORDS = 32 };

static void put_file(const struct lab_place *place, const char *name, const char *text)
{
    char path[LAB_MOST_PATH + 128];
    snprintf(path, sizeof path, "%s/%s", place->folder, name);
    unlink(path); /* whatever code that ran there has made of it */
    int file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    FILE *out = file >= 0 ? fdopen(file, "w") : NULL;
    if (out == NULL || fputs(text, out) < 0 || fclose(out) != 0)
        refuse_line("%s: cannot be written: %s; %slet TMPDIR name another folder", path, strerror(errno),
                    output_advice(errno));
}

static char *copied(const char *text)
{
    char *copy = strdup(text);
    if (copy == NULL)
        abort();
    return copy;
}

/* A program of the folder of clang that cagd-compile-exactly uses. */
static const char *tool(const char *name, char path[LAB_MOST_PATH])
{
    static char folder[LAB_MOST_PATH - 64];
    if (folder[0] == 0) {
        char command[LAB_MOST_PATH + 32];
        ssize_t length = readlink("/proc/self/exe", command, LAB_MOST_PATH - 1);
        command[length > 0 ? length : 0] = 0;
        char *slash = strrchr(command, '/');
        if (slash == NULL)
            return NULL;
        strcpy(slash + 1, "cagd-compile-exactly --tools");
        FILE *said = popen(command, "r");
        if (said != NULL && fgets(folder, sizeof folder, said) != NULL)
            folder[strcspn(folder, "\n")] = 0;
        if (said != NULL)
            pclose(said);
    }
    snprintf(path, LAB_MOST_PATH, "%s/%s", folder, name);
    return path;
}

const char *lab_program(const char *name, char path[LAB_MOST_PATH])
{
    ssize_t length = readlink("/proc/self/exe", path, LAB_MOST_PATH - 32);
    path[length > 0 ? length : 0] = 0;
    char *slash = strrchr(path, '/');
    if (slash != NULL)
        strcpy(slash + 1, name);
    return path;
}

static const char *compiler(char path[LAB_MOST_PATH]) { return lab_program("cagd-compile-exactly", path); }

/* A file of one place, in another; what was there is no more. */
static int copy_file(const struct lab_place *from, const struct lab_place *to, const char *name)
{
    char path[LAB_MOST_PATH + 128], bytes[1 << 14];
    snprintf(path, sizeof path, "%s/%s", to->folder, name);
    unlink(path);
    int out = open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    snprintf(path, sizeof path, "%s/%s", from->folder, name);
    int in = open(path, O_RDONLY | O_NOFOLLOW | O_CLOEXEC), status = in < 0 || out < 0 ? -1 : 0;
    for (ssize_t size; status == 0 && (size = read(in, bytes, sizeof bytes)) != 0;)
        status = size > 0 && write(out, bytes, (size_t)size) == size ? 0 : -1;
    if (in >= 0)
        close(in);
    if (out >= 0 && close(out) != 0)
        status = -1;
    return status;
}

/* The first errors of clang, each "line 12: what", with the line of the source. */
static char *errors_of(const char *said, const char *source)
{
    char *text = NULL;
    size_t size;
    int shown = 0;
    FILE *out = open_memstream(&text, &size);
    for (const char *at = said; (at = strstr(at, " error: ")) != NULL && shown < SHOWN_ERRORS; at++) {
        const char *start = at, *end = at + strcspn(at, "\n");
        while (start > said && start[-1] != '\n')
            start--;
        const char *colon = strchr(start, ':');
        long line = colon != NULL ? strtol(colon + 1, NULL, 10) : 0;
        fprintf(out, "%sline %ld:%.*s", shown++ > 0 ? "\n" : "", line, (int)(end - at - 7), at + 7);
        const char *row = source;
        for (long k = 1; k < line && row != NULL; k++)
            row = strchr(row, '\n') != NULL ? strchr(row, '\n') + 1 : NULL;
        if (row != NULL && strncmp(start, "the assignment", 14) != 0)
            fprintf(out, "\n    %.*s", (int)strcspn(row, "\n"), row);
    }
    if (shown == 0)
        fprintf(out, "%.*s", (int)strcspn(said, "\n"), said);
    fclose(out);
    return text;
}

/* The source is expanded, and takes its own place: what is looked at and what is compiled are one text.  NULL, or the cause.  The day
 * and the hour are the same for all. */
static char *expand(const struct lab *lab, const struct lab_place *place, const char *source, enum lab_reason *reason)
{
    char clang[LAB_MOST_PATH], path[LAB_MOST_PATH + 128], *said = NULL, *cause = lab_wrong_directive(source);
    char *const word[] = {(char *)(uintptr_t)tool("clang", clang),
                          (char *)(uintptr_t) "-E",
                          (char *)(uintptr_t) "-w",
                          (char *)(uintptr_t) "-fno-color-diagnostics",
                          (char *)(uintptr_t) "-fno-caret-diagnostics",
                          (char *)(uintptr_t) "-D__DATE__=\"Jan  1 2000\"",
                          (char *)(uintptr_t) "-D__TIME__=\"00:00:00\"",
                          (char *)(uintptr_t) "-D__TIMESTAMP__=\"Sat Jan  1 00:00:00 2000\"",
                          (char *)(uintptr_t) "-Dmain=main_of_the_answer", /* its own tests stay out of the way */
                          (char *)(uintptr_t) "-o",
                          (char *)(uintptr_t) "expanded",
                          (char *)(uintptr_t)lab->file,
                          NULL};
    *reason = LAB_REFUSED;
    if (cause != NULL)
        return cause;
    put_file(place, "written", source); /* for messages */
    put_file(place, lab->file, source);
    if (lab_run(place, word, EXPAND_SECONDS, &said) != 0) {
        *reason = LAB_NOT_EXPANDED;
        cause = errors_of(said != NULL ? said : "", source);
        free(said);
        return cause;
    }
    free(said);
    snprintf(path, sizeof path, "%s/expanded", place->folder);
    char *expanded = lab_file(path);
    if (expanded == NULL)
        return copied("its macros make more than a megabyte of it");
    cause = lab_wrong_expansion(lab, expanded);
    if (cause == NULL) {
        *reason = LAB_NO_REASON;
        put_file(place, lab->file, expanded);
    }
    free(expanded);
    return cause;
}

/* Runs it in the place; NULL, or what was said as the cause. */
static char *compiled(const struct lab_place *place, char *const word[], const char *source)
{
    char *said = NULL;
    int code = lab_run(place, word, COMPILE_SECONDS, &said);
    char *cause = code == 0 ? NULL : errors_of(said != NULL ? said : "", source);
    free(said);
    return cause;
}

char *lab_build_driver(const struct lab *lab, const struct lab_place *place)
{
    char path[LAB_MOST_PATH + 128], program[LAB_MOST_PATH];
    snprintf(path, sizeof path, "%s/driver.c", place->folder);
    if (lab_write_driver(lab, path) != 0)
        return copied("the driver cannot be written");
    char *text = lab_file(path);
    int kept = text != NULL && lab_take_kept(place, "driver.bc", text);
    char *const word[] = {(char *)(uintptr_t)compiler(program),
                          (char *)(uintptr_t) "-o",
                          (char *)(uintptr_t) "driver.bc",
                          (char *)(uintptr_t) "driver.c",
                          (char *)(uintptr_t) "--",
                          (char *)(uintptr_t) "-w",
                          NULL};
    char *cause = kept ? NULL : compiled(place, word, "");
    if (cause == NULL && text != NULL && !kept)
        lab_keep(place, "driver.bc", text);
    free(text);
    return cause;
}

char *lab_with_driver(const struct lab_place *place, const char *source)
{
    char path[LAB_MOST_PATH + 32], *text = NULL;
    size_t size;
    snprintf(path, sizeof path, "%s/driver.c", place->folder);
    char *driver = lab_file(path);
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        abort();
    fprintf(out, "%s\n%s", driver != NULL ? driver : "", source);
    if (fclose(out) != 0)
        abort();
    free(driver);
    return text;
}

char *lab_build(const struct lab *lab, const struct lab_place *place, const struct lab_place *ready, const char *source,
                const char *object, enum lab_reason *reason)
{
    char program[LAB_MOST_PATH];
    if (lab_is_python(lab, object))
        return lab_build_python(lab, place, source, object);
    int is_numbers = lab_is_numbers(lab, object);
    const char *file = strcmp(object, "reference.so") == 0 ? "reference.c" : is_numbers ? "answer.c" : lab->file;
    if (is_numbers) {
        long digits;
        char *unread = NULL, *made = lab_numbers_as_c(source, &unread, &digits);
        put_file(place, lab->file, source);
        if (made == NULL)
            return unread;
        put_file(place, file, made);
        free(made);
    } else if (reason != NULL) {
        char *wrong = expand(lab, place, source, reason);
        if (wrong != NULL)
            return wrong;
    } else { /* of the lab itself */
        put_file(place, file, source);
    }
    if (ready != place && copy_file(ready, place, "driver.bc") != 0)
        return copied("there is no room for the driver");
    char *const word[] = {(char *)(uintptr_t)compiler(program),
                          (char *)(uintptr_t) "--names",
                          (char *)(uintptr_t)NAMES,
                          (char *)(uintptr_t) "-o",
                          (char *)(uintptr_t)object,
                          (char *)(uintptr_t) "driver.bc",
                          (char *)(uintptr_t)file,
                          (char *)(uintptr_t) "--",
                          (char *)(uintptr_t) "-w",
                          NULL};
    char *made_of = reason == NULL ? lab_with_driver(place, source) : NULL;
    int kept = made_of != NULL && lab_take_kept(place, object, made_of);
    char *cause = kept ? NULL : compiled(place, word, source);
    if (cause == NULL && made_of != NULL && !kept)
        lab_keep(place, object, made_of);
    free(made_of);
    return cause;
}

/* ---- what is seen in the source --------------------------------------------------------------------------- */

static int is_allowed(const char *name, size_t length)
{
#define NAME(name)    #name,
#define NUMBERS(name) #name, #name "f", #name "l",
    static const char *const names[] = {LAB_ALLOWED(NAME) CAGD_CODE_ONE(NUMBERS) CAGD_CODE_TWO(NUMBERS)
                                            CAGD_CODE_OTHER(NAME)};
    static const char *const texts[] = {LAB_TEXTS(NAME)}; /* of numbers, which would decide by digits */
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++)
        if (strlen(texts[k]) == length && strncmp(texts[k], name, length) == 0)
            return 0;
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (strlen(names[k]) == length && strncmp(names[k], name, length) == 0)
            return 1;
    return length > 10 && strncmp(name, "__builtin_", 10) == 0;
}

/* Where clang's tree is being read. */
struct tree {
    const struct lab *lab;
    json_t *notes;
    char refused[LAB_CAUSE], file[256];
    long line;
    int converted;   /* the depth of a conversion of an integer to a number, or -1 */
    char unset[100]; /* a variable that is used and never got a value, or "" */
    long unset_line;
};

static void note(struct tree *t, const char *text)
{
    size_t k;
    const json_t *old;
    json_array_foreach(t->notes, k, old) if (json_integer_value(json_object_get(old, "line")) == t->line &&
                                             strcmp(json_string_value(json_object_get(old, "text")), text) == 0) return;
    json_array_append_new(t->notes, json_pack("{s:I, s:s}", "line", (json_int_t)t->line, "text", text));
}

static void refuse(struct tree *t, const char *what)
{
    if (t->refused[0] == 0)
        snprintf(t->refused, sizeof t->refused, "line %ld: %s", t->line, what);
}

/* "file:3:4", "line:3:4" or "col:4": the place is known from then on. */
static void move(struct tree *t, const char *at, size_t length)
{
    char text[256];
    snprintf(text, sizeof text, "%.*s", (int)(length < 255 ? length : 255), at);
    if (strncmp(text, "line:", 5) == 0) {
        t->line = strtol(text + 5, NULL, 10);
        return;
    }
    char *last = strrchr(text, ':');
    if (strncmp(text, "col:", 4) == 0 || last == NULL || last == text)
        return;
    *last = 0;
    char *first = strrchr(text, ':');
    if (first == NULL || !isdigit((unsigned char)first[1]))
        return;
    *first = 0;
    t->line = strtol(first + 1, NULL, 10);
    snprintf(t->file, sizeof t->file, "%s", text);
}

static int contains(const char *line, size_t length, const char *what)
{
    return memmem(line, length, what, strlen(what)) != NULL;
}

/* What the node of this line means, where it stands in what was handed in. */
static void look(struct tree *t, const char *node, size_t length, int depth)
{
    static const char *const tricks[] = {"FileScopeAsmDecl", "GCCAsmStmt",  "MSAsmStmt",   "ConstructorAttr",
                                         "DestructorAttr",   "IFuncAttr",   "AliasAttr",   "SectionAttr",
                                         "AsmLabelAttr",     "WeakRefAttr", "CleanupAttr", "NakedAttr"};
    for (size_t k = 0; k < sizeof tricks / sizeof *tricks; k++)
        if (strncmp(node, tricks[k], strlen(tricks[k])) == 0)
            refuse(t, strstr(tricks[k], "Asm") != NULL ? "assembly is no part of an assignment"
                                                       : "an attribute that is no part of an assignment");
    if (contains(node, length, "<PointerToIntegral>"))
        refuse(t, "an address is no number in an assignment");
    if (t->converted >= 0 && depth <= t->converted)
        t->converted = -1;
    if (contains(node, length, "<IntegralToFloating>"))
        t->converted = depth;
    if (t->converted >= 0 && strncmp(node, "BinaryOperator", 14) == 0 && contains(node, length, " '/'"))
        note(t, "a division of integers drops the remainder: 1/2 is 0, 1.0/2 is a half");
    int declared = strncmp(node, "VarDecl", 7) == 0 || strncmp(node, "ParmVarDecl", 11) == 0 ||
                   strncmp(node, "CStyleCastExpr", 14) == 0 || strncmp(node, "FunctionDecl", 12) == 0;
    if (declared && contains(node, length, "'long double"))
        note(t, "long double is not double");
    else if (declared && contains(node, length, "'float"))
        note(t, "float keeps 24 bits, double 53");
    const char *called = memmem(node, length, " Function 0x", 12);
    if (strncmp(node, "DeclRefExpr", 11) == 0 && called != NULL) {
        const char *name = memchr(called, '\'', (size_t)(node + length - called));
        size_t size = name != NULL ? strcspn(name + 1, "'") : 0;
        if (size > 7 && (strncmp(name + 1, "cagd_", 5) == 0 || strncmp(name + 1, "lab_", 4) == 0))
            refuse(t, "a function of the grader is no part of an assignment");
    }
}

/* "FILE:3:4: warning: variable 'k' is uninitialized when used here" */
static void look_at_warning(struct tree *t, const char *row, size_t length)
{
    static const char words[] = "is uninitialized when used";
    const char *name = memchr(row, '\'', length), *line = memchr(row, ':', length);
    if (t->unset[0] != 0 || name == NULL || line == NULL || !contains(row, length, words) ||
        !contains(row, (size_t)(line - row), t->lab->file))
        return;
    t->unset_line = strtol(line + 1, NULL, 10);
    snprintf(t->unset, sizeof t->unset, "%.*s", (int)strcspn(name + 1, "'"), name + 1);
}

static void read_tree(struct tree *t, const char *said)
{
    for (const char *row = said; *row != 0;) {
        size_t length = strcspn(row, "\n"), indent = strspn(row, " |`-");
        if (contains(row, length, " warning: "))
            look_at_warning(t, row, length);
        const char *node = row + indent, *end = row + length, *open = memchr(node, '<', (size_t)(end - node));
        if (open != NULL && indent < length && isalpha((unsigned char)*node)) {
            long begun = -1;
            const char *at = open + 1;
            while (at < end && *at != '>') {
                size_t size = strcspn(at, ",>\n");
                move(t, at, size);
                if (begun < 0)
                    begun = t->line;
                at += size;
                at += strspn(at, ", ");
            }
            long ended = t->line;
            t->line = begun;
            if (strstr(t->file, t->lab->file) != NULL)
                look(t, node, (size_t)(end - node), (int)indent);
            t->line = ended;
            if (at < end) /* the place of a name stands behind its range */
                move(t, at + 2, strcspn(at + (at + 2 <= end ? 2 : 0), " \n"));
        }
        row = end + (*end == '\n');
    }
}

/* The line of the source in which a word stands, or 0. */
static long line_of(const char *source, const char *name, size_t length)
{
    long line = 1;
    for (const char *at = source; *at != 0; at++) {
        if (strncmp(at, name, length) == 0 && !isalnum((unsigned char)at[length]) && at[length] != '_' &&
            (at == source || (!isalnum((unsigned char)at[-1]) && at[-1] != '_')))
            return line;
        line += *at == '\n';
    }
    return 0;
}

/* What the code asks of others: names that are allowed, and none of ours. */
static void check_names(struct tree *t, const struct lab_place *place, const char *source)
{
    char path[LAB_MOST_PATH + 128];
    snprintf(path, sizeof path, "%s/%s", place->folder, NAMES);
    char *list = lab_file(path);
    for (const char *row = list != NULL ? list : ""; *row != 0;) {
        size_t length = strcspn(row, "\n");
        const char *name = row + 2;
        if (length > 2) {
            char text[200];
            int ours = strncmp(name, "cagd_", 5) == 0 || strncmp(name, "lab_", 4) == 0;
            t->line = line_of(source, name, length - 2);
            snprintf(text, sizeof text, "%.*s is no function for an assignment", (int)length - 2, name);
            if (ours || (*row == 'U' && !is_allowed(name, length - 2)))
                refuse(t, text);
        }
        row += length + (row[length] != 0);
    }
    if (list == NULL)
        refuse(t, "its names cannot be read");
    free(list);
}

/* What the assignment declares, and then the source: what is declared in another way is an error there. */
static void write_check(const struct lab *lab, const struct lab_place *place)
{
    char *text = NULL;
    size_t size, k;
    const json_t *value;
    FILE *out = open_memstream(&text, &size);
    fputs("#line 1 \"the assignment\"\n", out);
    json_array_foreach(json_object_get(lab->head, "declare"), k, value) fprintf(out, "%s\n", json_string_value(value));
    fprintf(out, "#include \"%s\"\n", lab->file);
    fclose(out);
    put_file(place, "check.c", text);
    free(text);
}

static json_t *inspect_numbers(const struct lab *lab, const struct lab_place *place)
{
    char path[LAB_MOST_PATH + 128];
    snprintf(path, sizeof path, "%s/%s", place->folder, lab->file);
    char *source = lab_file(path);
    json_t *seen = lab_inspect_numbers(source != NULL ? source : "");
    free(source);
    return seen;
}

json_t *lab_inspect(const struct lab *lab, const struct lab_place *place)
{
    if (lab_is_python(lab, "student.so"))
        return lab_inspect_python(place, "student.so");
    if (lab_is_numbers(lab, "student.so"))
        return inspect_numbers(lab, place);
    char clang[LAB_MOST_PATH], path[LAB_MOST_PATH + 128], *said;
    struct tree t = {.lab = lab, .notes = json_array(), .converted = -1};
    char *const dump[] = {(char *)(uintptr_t)tool("clang", clang),
                          (char *)(uintptr_t) "-fsyntax-only",
                          (char *)(uintptr_t) "-fno-caret-diagnostics",
                          (char *)(uintptr_t) "-fno-color-diagnostics",
                          (char *)(uintptr_t) "-Wno-everything",
                          (char *)(uintptr_t) "-Wuninitialized",
                          (char *)(uintptr_t) "-Wno-sometimes-uninitialized",
                          (char *)(uintptr_t) "-Xclang",
                          (char *)(uintptr_t) "-ast-dump",
                          (char *)(uintptr_t) "check.c",
                          NULL};
    char *const plain[] = {dump[0], dump[1], dump[2], dump[3], (char *)(uintptr_t) "-w", dump[9], NULL};
    json_t *result = json_object();
    snprintf(path, sizeof path, "%s/written", place->folder);
    char *source = lab_file(path);
    write_check(lab, place);
    int code = lab_run(place, dump, COMPILE_SECONDS, &said);
    if (code == 0) {
        read_tree(&t, said);
        check_names(&t, place, source != NULL ? source : "");
    } else {
        free(said);
        lab_run(place, plain, COMPILE_SECONDS, &said);
        char *cause = errors_of(said, source != NULL ? source : "");
        json_object_set_new(result, "compiler", json_string(cause));
        free(cause);
    }
    if (t.refused[0] != 0)
        json_object_set_new(result, "refused", json_string(t.refused));
    if (t.unset[0] != 0)
        json_object_set_new(result, "unset",
                            json_pack("{s:I, s:s}", "line", (json_int_t)t.unset_line, "name", t.unset));
    json_object_set_new(result, "notes", t.notes);
    free(said);
    free(source);
    return result;
}

/* ---- in binary64 --------------------------------------------------------------------------------------------- */

static void write_jobs(const struct lab_place *place, const json_t *jobs)
{
    char *text = NULL;
    size_t size, k, i, e;
    const json_t *job, *in, *value;
    FILE *out = open_memstream(&text, &size);
    cagd_region_mark mark = cagd_region_open();
    json_array_foreach(jobs, k, job)
    {
        const json_t *inputs = json_object_get(job, "inputs");
        fprintf(out, "%s %zu", strrchr(json_string_value(json_object_get(job, "entry")), '_') + 1,
                json_array_size(inputs));
        json_array_foreach(inputs, i, in)
        {
            fprintf(out, " %s %zu", json_string_value(json_object_get(in, "name")),
                    json_array_size(json_object_get(in, "value")));
            json_array_foreach(json_object_get(in, "value"), e, value)
                fprintf(out, " %a", cagd_to_double_q(cagd_from_string_q(json_string_value(value))));
        }
        fputc('\n', out);
    }
    cagd_region_drop(mark);
    fclose(out);
    put_file(place, "native.in", text);
    free(text);
}

/* What a report of the sanitizers says, in words. */
static json_t *report_of(const struct lab *lab, const char *said)
{
    static const struct {
        const char *there, *means;
    } kinds[] = {{"buffer-overflow", "reads or writes outside an array"},
                 {"buffer-underflow", "reads or writes outside an array"},
                 {"out of bounds", "reads or writes outside an array"},
                 {"use-after", "uses memory that was given back"},
                 {"double-free", "gives memory back twice"},
                 {"bad-free", "gives back what was not taken"},
                 {"stack-overflow", "calls itself without end"},
                 {"rss limit", "takes memory without end"},
                 {"allocation-size-too-big", "takes memory without end"},
                 {"SEGV", "uses memory that is not there"},
                 {"null pointer", "uses memory that is not there"},
                 {"division by zero", "divides an integer by zero"},
                 {"signed integer overflow", "an integer overflows"},
                 {"shift exponent", "shifts by too much"},
                 {"uninitialized-value", "decides by a value that was never computed"},
                 {"runtime error", "does what C does not define"}};
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        if (strstr(said, kinds[k].there) == NULL)
            continue;
        char name[100];
        snprintf(name, sizeof name, "%s:", lab->file);
        const char *at = strstr(said, name);
        return json_pack("{s:I, s:s}", "line", (json_int_t)(at != NULL ? strtol(at + strlen(name), NULL, 10) : 0),
                         "text", kinds[k].means);
    }
    return NULL;
}

/* What nobody knows before. */
static unsigned long long secret(void)
{
    unsigned long long value = 0;
    if (getrandom(&value, sizeof value, 0) != (ssize_t)sizeof value)
        abort();
    return value;
}

/* Memory that is there, and what C defines; and values that were computed, for which other code is made. */
struct sanitizer {
    const char *program, *flag, *driver, *answer, *object;
};
static const struct sanitizer of_memory = {"cagd-run-sanitized", "-fsanitize=address,undefined", "native-driver.o",
                                           "native-answer.o", "native.so"};
static const struct sanitizer of_values = {"cagd-run-initialised", "-fsanitize=memory", "values-driver.o",
                                           "values-answer.o", "values.so"};

/* A source as an object for the sanitizer; the exit code. */
static int compile_native(const struct lab_place *place, const struct sanitizer *s, const char *source,
                          const char *object, const char *define)
{
    char clang[LAB_MOST_PATH], *said;
    char *const word[] = {(char *)(uintptr_t)tool("clang", clang),
                          (char *)(uintptr_t) "-g",
                          (char *)(uintptr_t) "-O0",
                          (char *)(uintptr_t) "-w",
                          (char *)(uintptr_t) "-fPIC",
                          (char *)(uintptr_t)s->flag,
                          (char *)(uintptr_t) "-fno-sanitize-recover=all",
                          (char *)(uintptr_t) "-c",
                          (char *)(uintptr_t) "-o",
                          (char *)(uintptr_t)object,
                          (char *)(uintptr_t)source,
                          (char *)(uintptr_t)define,
                          NULL};
    int code = lab_run(place, word, COMPILE_SECONDS, &said);
    free(said);
    return code;
}

/* The driver for the sanitizer, made once in the place of the lab and copied. */
static int take_driver(const struct lab_place *place, const struct sanitizer *s, const struct lab_place *ready)
{
    char path[LAB_MOST_PATH + 32];
    snprintf(path, sizeof path, "%s/%s", ready->folder, s->driver);
    if (access(path, R_OK) != 0) {
        char *made_of = lab_with_driver(ready, "");
        int code = 0;
        if (!lab_take_kept(ready, s->driver, made_of)) {
            code = compile_native(ready, s, "driver.c", s->driver, "-DLAB_NATIVE");
            if (code == 0)
                lab_keep(ready, s->driver, made_of);
        }
        free(made_of);
        if (code != 0)
            return code;
    }
    return copy_file(ready, place, s->driver);
}

static json_t *told(const char *text) { return json_pack("{s:i, s:s}", "line", 0, "text", text); }

/* The object of the driver and the answer.  Nothing of it but the driver's table can be seen: it stands in for no function of the
 * library or of the sanitizers.  NULL, or a report. */
static json_t *build_native(const struct lab *lab, const struct lab_place *place, const struct sanitizer *s,
                            const struct lab_place *ready)
{
    char *said;
    char *const link[] = {(char *)(uintptr_t) "ld",
                          (char *)(uintptr_t) "-shared",
                          (char *)(uintptr_t) "-Bsymbolic",
                          (char *)(uintptr_t) "--version-script=shown",
                          (char *)(uintptr_t) "-o",
                          (char *)(uintptr_t)s->object,
                          (char *)(uintptr_t)s->driver,
                          (char *)(uintptr_t)s->answer,
                          NULL};
    if (compile_native(place, s, lab->file, s->answer, NULL) != 0)
        return told("cannot be compiled with the sanitizers");
    if (take_driver(place, s, ready) != 0)
        return told("there is no driver for the sanitizers");
    put_file(place, "shown", "{ global: lab_table; local: *; };\n");
    int code = lab_run(place, link, COMPILE_SECONDS, &said);
    free(said);
    return code == 0 ? NULL : told("cannot be linked with the sanitizers");
}

/* Whether there is such a program: what is no C has no arrays to read outside of, and there may be no sanitizers. */
static int has_sanitizer(const struct lab *lab, const struct sanitizer *s)
{
    char program[LAB_MOST_PATH];
    return strcmp(lab->language, "c") == 0 && access(lab_program(s->program, program), X_OK) == 0;
}

/* What is said while the jobs are run; the exit code. */
static int run_native(const struct lab_place *place, const struct sanitizer *s, const json_t *jobs, const char *end,
                      char **said)
{
    char program[LAB_MOST_PATH], object[LAB_MOST_PATH + 32];
    lab_program(s->program, program);
    snprintf(object, sizeof object, "%s/%s", place->folder, s->object);
    char *const run[] = {program, object, (char *)(uintptr_t) "native.in", (char *)(uintptr_t)end, NULL};
    write_jobs(place, jobs);
    return lab_run_sanitized(place, run, NATIVE_SECONDS, said);
}

static const char MISSING[] = "undefined symbol: "; /* in the words of the dynamic linker */

json_t *lab_sanitize(const struct lab *lab, const struct lab_place *place, const struct lab_place *ready,
                     const json_t *jobs)
{
    char end[40], *said;
    if (!has_sanitizer(lab, &of_memory))
        return NULL;
    snprintf(end, sizeof end, "end-%016llx", secret());
    json_t *report = build_native(lab, place, &of_memory, ready);
    if (report != NULL)
        return report;
    int code = run_native(place, &of_memory, jobs, end, &said);
    report = code != 0 ? report_of(lab, said) : NULL;
    if (report == NULL && strstr(said, end) == NULL && strstr(said, MISSING) != NULL) {
        char text[200];
        const char *name = strstr(said, MISSING) + strlen(MISSING);
        snprintf(text, sizeof text, "there is no function %.*s", (int)strcspn(name, ", \n"), name);
        report = told(text);
    }
    if (report == NULL && strstr(said, end) == NULL)
        report = told("ends the program, or does not come to an end, in binary64");
    free(said);
    return report;
}

json_t *lab_look_for_values(const struct lab *lab, const struct lab_place *place, const struct lab_place *ready,
                            const json_t *jobs)
{
    char *said;
    json_t *report = has_sanitizer(lab, &of_values) ? build_native(lab, place, &of_values, ready) : NULL;
    if (!has_sanitizer(lab, &of_values) || report != NULL) {
        json_decref(report); /* it was compiled with the others */
        return NULL;
    }
    int code = run_native(place, &of_values, jobs, "end", &said);
    if (code != 0 && strstr(said, "use-of-uninitialized-value") != NULL)
        report = report_of(lab, said);
    free(said);
    return report;
}

/* ---- wrong solutions -------------------------------------------------------------------------------------- */

char *lab_wrong_source(const struct lab *lab, const json_t *wrong, char cause[LAB_CAUSE])
{
    char path[LAB_MOST_PATH + 128];
    const char *of = lab_text(wrong, "of");
    const json_t *olds = json_object_get(wrong, "replace"), *news = json_object_get(wrong, "by");
    snprintf(path, sizeof path, "%s/%s", lab->folder, *of != 0 ? of : "reference.c");
    char *text = lab_file(path);
    if (text == NULL || json_array_size(olds) != json_array_size(news))
        snprintf(cause, LAB_CAUSE, "%s: %s", lab_text(wrong, "of"),
                 text == NULL ? "cannot be read" : ":replace: and :by: come in pairs");
    for (size_t k = 0; text != NULL && k < json_array_size(olds) && k < json_array_size(news); k++) {
        const char *old = json_string_value(json_array_get(olds, k)), *by = json_string_value(json_array_get(news, k));
        char *at = strstr(text, old), *made = NULL;
        if (at == NULL || strstr(at + 1, old) != NULL) {
            snprintf(cause, LAB_CAUSE, "%.200s: \"%.200s\" is there %s", of, old, at == NULL ? "not at all" : "twice");
            free(text);
            return NULL;
        }
        if (asprintf(&made, "%.*s%s%s", (int)(at - text), text, by, at + strlen(old)) < 0)
            abort();
        free(text);
        text = made;
    }
    return text;
}
