/* make.c -- folders that are written: what a student begins with, and a lab of one's own; see lab.h. */
#include "cli/command.h"
#include "cli/lab/lab.h"
#include "cli/output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Whether files of these names can be made in the folder, which is made when they can: nothing is written before all of that is
 * known. */
static int is_free(const char *folder, const char *const *names)
{
    char path[LAB_MOST_PATH + 128];
    struct stat is;
    if (*folder == '\0' || strcmp(folder, "-") == 0) {
        refuse_line("'%s': is no name of a folder; give one", folder);
        return -1;
    }
    for (; *names != NULL; names++) {
        snprintf(path, sizeof path, "%s/%s", folder, *names);
        if (lstat(path, &is) == 0) {
            refuse_line("%s: is there already, and is not written over; name another folder", path);
            return -1;
        }
    }
    return make_folder(folder);
}

static int put(const char *folder, const char *name, const char *text)
{
    char path[LAB_MOST_PATH + 128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return write_text_file(path, text);
}

/* A file of the lab, under another name perhaps. */
static int copy(const struct lab *lab, const char *from, const char *folder, const char *to)
{
    char path[LAB_MOST_PATH + 128];
    snprintf(path, sizeof path, "%s/%s", lab->folder, from);
    char *text = lab_file(path);
    int status = -1;
    if (text == NULL)
        refuse_line("%s: %s", path, strerror(errno));
    else
        status = put(folder, to, text);
    free(text);
    return status;
}

/* How this program is called: by its name where that finds it, else by its path. */
static const char *called(char path[LAB_MOST_PATH])
{
    char other[LAB_MOST_PATH];
    struct stat self, there;
    ssize_t length = readlink("/proc/self/exe", path, LAB_MOST_PATH - 1);
    path[length > 0 ? length : 0] = 0;
    for (const char *at = getenv("PATH"); at != NULL && *at != 0; at += strcspn(at, ":"), at += *at == ':') {
        snprintf(other, sizeof other, "%.*s/cagd", (int)strcspn(at, ":"), at);
        if (stat(other, &there) == 0) /* the first one is called */
            return stat(path, &self) == 0 && self.st_ino == there.st_ino && self.st_dev == there.st_dev ? "cagd" : path;
    }
    return length > 0 ? path : "cagd";
}

/* What says which lab it is where that is none of the program's own: " --lab "FOLDER"", else nothing. */
static const char *option_of(const struct lab *lab, char option[LAB_MOST_PATH + 16])
{
    char own[LAB_MOST_PATH], here[LAB_MOST_PATH], place[LAB_MOST_PATH];
    option[0] = 0;
    if (realpath(lab->folder, here) == NULL)
        return option;
    int length = (int)(strrchr(here, '/') - here);
    if (lab_folder(own) != 0 || realpath(own, place) == NULL || (int)strlen(place) != length ||
        strncmp(place, here, (size_t)length) != 0)
        snprintf(option, LAB_MOST_PATH + 16, " --lab \"%s\"", here);
    return option;
}

int lab_begin(const struct lab *lab, const char *folder)
{
    char start[80], makefile[3 * LAB_MOST_PATH], path[LAB_MOST_PATH + 16], program[LAB_MOST_PATH],
        option[LAB_MOST_PATH + 16];
    snprintf(path, sizeof path, "%s/figure.svg", lab->folder);
    int has_figure = access(path, R_OK) == 0;
    const char *const names[] = {"README.md", lab->file, "Makefile", has_figure ? "figure.svg" : NULL, NULL};
    if (is_free(folder, names) != 0)
        return EXIT_USAGE;
    snprintf(start, sizeof start, "start%s", strrchr(lab->file, '.'));
    snprintf(makefile, sizeof makefile,
             "# make: does it compile?  make check: is it right?\n"
             "all:\n\t%s\n"
             "check:\n\t\"%s\" lab check .%s\n"
             ".PHONY: all check\n",
             strcmp(lab->language, "python") == 0 ? "python3 -c 'import ast, sys; [ast.parse(open(name).read(), name) "
                                                    "for name in sys.argv[1:]]' $(wildcard *.py)"
             : strcmp(lab->language, "c") == 0 ? "cc -Wall -Wextra -Wno-unused-parameter -fsyntax-only $(wildcard *.c)"
                                               : "@echo nothing to compile",
             called(program), option_of(lab, option));
    if (copy(lab, "README.md", folder, "README.md") != 0 || copy(lab, start, folder, lab->file) != 0 ||
        put(folder, "Makefile", makefile) != 0 || (has_figure && copy(lab, "figure.svg", folder, "figure.svg") != 0))
        return EXIT_INTERNAL;
    printf("%s/README.md is the assignment, %s/%s the place for the answer\n"
           "%s lab check %s%s judges it\n"
           "%s lab list %s tells what each requirement is worth\n",
           folder, folder, lab->file, called(program), folder, option, called(program),
           option[0] != 0 ? lab->folder : lab->name);
    return EXIT_AS_EXPECTED;
}

int lab_new(const char *name)
{
    static const char lab_md[] =
        "# %s: for the lecturer\n\nWhat it teaches, how long it takes, how it can be varied.\n\n"
        ":::{lab} %s\n:title: The sum of two numbers\n:zh: 两数之和\n:chapter: mine\n:learn: what a lab is made of\n"
        ":declare: double sum(double a, double b);\n:::\n\n"
        ":::{requirement} sum\n:title: a + b\n:zh: a + b\n:points: 4\n:input: a; b\n:call: double S = sum(a, b);\n"
        ":output: S\n:printed: S = a + b\n:::\n\n"
        ":::{requirement} manners\n:title: nothing outside arrays, nothing kept, nothing printed, arguments unchanged\n"
        ":zh: 不越界、不留状态、不打印、不改参数\n:points: 1\n:::\n\n"
        ":::{wrong} difference\n:of: right/plain.c\n:replace: a + b\n:by: a - b\n:fails: sum manners\n"
        ":hint: The second number is taken away.\n:zh: 减去了第二个数。\n:::\n\n"
        ":::{wrong} printing\n:of: right/plain.c\n:replace: return a + b;\n"
        ":by: puts(\"sum\"); return a + b;\n:fails: manners\n:::\n";
    static const char plain[] = "#include <stdio.h>\n\ndouble sum(double a, double b)\n{\n    return a + b;\n}\n";
    static const char reference[] = "double sum(double a, double b) { return b + a; }\n";
    static const char start[] = "double sum(double a, double b)\n{\n    return 0;\n}\n";
    const char *const names[] = {"lab.md", "README.md", "reference.c", "start.c", "right", NULL};
    char path[LAB_MOST_PATH], place[LAB_MOST_PATH], *text = NULL;
    if (*name == '\0' || strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789-") != strlen(name) || strlen(name) > 40) {
        refuse_line("'%s': a name of at most 40 small letters, digits and - was expected", name);
        return EXIT_USAGE;
    }
    snprintf(path, sizeof path, "%s/right", name);
    if (is_free(name, names) != 0)
        return EXIT_USAGE;
    if (make_folder(path) != 0 || asprintf(&text, lab_md, name, name) < 0)
        return EXIT_INTERNAL;
    int status = put(name, "lab.md", text);
    free(text);
    if (status != 0 || asprintf(&text,
                                "# %s\n\nWrite `double sum(double a, double b)` in `%s.c`: the sum of the two.\n\n"
                                "在 `%s.c` 中写出 `double sum(double a, double b)`：两数之和。\n",
                                name, name, name) < 0)
        return EXIT_INTERNAL;
    status = put(name, "README.md", text);
    free(text);
    status = status != 0 ? status : put(name, "reference.c", reference);
    status = status != 0 ? status : put(name, "start.c", start);
    status = status != 0 ? status : put(name, "right/plain.c", plain);
    if (status == 0)
        printf("%s is a lab: change its files, and cagd lab test %s says whether it is well made\n"
               "%s/README.md tells what the blocks of lab.md may have in them\n"
               "cagd lab start ./%s writes the assignment\n",
               name, name, lab_folder(path) == 0 && realpath(path, place) != NULL ? place : "chapters/labs", name);
    return status == 0 ? EXIT_AS_EXPECTED : EXIT_INTERNAL;
}
