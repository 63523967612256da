/* compile.c -- the program cagd-compile-exactly: sources in C, C++ or bitcode become a shared object in which numbers are ours.
 *
 *     cagd-compile-exactly [--stores] [--names LIST] -o OUT.so FILE... [-- FLAG...]
 *     cagd-compile-exactly -o OUT.bc FILE... [-- FLAG...]    bitcode, in which nothing is ours yet, to be given as a FILE
 *     cagd-compile-exactly --tools                           the folder of the clang that it uses
 *
 * With --stores the program can tell which numbers each line puts into variables.  LIST becomes the names that the sources define, "T name", and
 * those that they ask of others, "U name", a line each.  FILE ends in .c, in .cc, .cpp, .cxx or .C, in .a, an archive of bitcode, or is
 * bitcode (.bc, or .o of clang -flto).
 * The flags are clang's, for the sources.
 * Messages are clang's own, or one line; the exit code is 0, 1 when a source does not compile, 2 for wrong usage. */
#include "exact/code/archive.h"
#include "exact/code/rewrite.h"
#include "exact/code/scratch.h"

#include <llvm-c/Analysis.h>
#include <llvm-c/BitWriter.h>
#include <llvm-c/Linker.h>
#include <llvm-c/Target.h>
#include <llvm-c/TargetMachine.h>

#include <dlfcn.h>
#include <errno.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

enum { MOST_WORDS = 4096 };

static char scratch[SCRATCH];
static LLVMModuleRef everything;

_Noreturn void cagd_code_give_up(int code, const char *what, const char *about)
{
    fprintf(stderr, "cagd-compile-exactly: %s%s%s\n", what, about ? ": " : "", about ? about : "");
    exit(code);
}

static void remove_scratch(void)
{
    static const char *const names[] = {"source.bc", "all.o"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        char path[IN_SCRATCH];
        snprintf(path, sizeof path, "%s/%s", scratch, names[k]);
        unlink(path);
    }
    rmdir(scratch);
}

static int ends_in(const char *name, const char *end)
{
    size_t n = strlen(name), m = strlen(end);
    return n > m && strcmp(name + n - m, end) == 0;
}

static int is_cpp(const char *name)
{
    return ends_in(name, ".cc") || ends_in(name, ".cpp") || ends_in(name, ".cxx") || ends_in(name, ".C");
}

/* Runs a compiler of CAGD_LLVM_BIN; gives up where it does. */
static void run(char *const word[])
{
    pid_t child;
    int status;
    if (posix_spawnp(&child, word[0], NULL, NULL, word, environ) != 0)
        cagd_code_give_up(1, "there is no compiler", word[0]);
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            cagd_code_give_up(1, "the compiler was lost", word[0]);
    if (status != 0)
        exit(1);
}

/* The module, which `name` names, joins the others. */
static void take(LLVMModuleRef module, const char *name)
{
    if (everything == NULL)
        everything = module;
    else if (LLVMLinkModules2(everything, module))
        cagd_code_give_up(1, "it cannot be linked with the others", name);
}

/* For C++ the linker needs its library; who misses a name of C++ is C++, whatever the file was called. */
static int needs_cpp(LLVMModuleRef module)
{
    size_t length;
    for (LLVMValueRef v = LLVMGetFirstFunction(module); v != NULL; v = LLVMGetNextFunction(v)) {
        const char *name = LLVMGetValueName2(v, &length);
        if (LLVMIsDeclaration(v) && (strncmp(name, "_Z", 2) == 0 || strncmp(name, "__cxa_", 6) == 0 ||
                                     strcmp(name, "__gxx_personality_v0") == 0))
            return 1;
    }
    return 0;
}

/* "-std=c++20" says nothing of the files in C among the sources, nor "-std=c99" of those in C++. */
static int is_for_the_other_language(const char *flag, int cpp)
{
    return strncmp(flag, "-std=", 5) == 0 && (strstr(flag, "++") != NULL) != cpp;
}

/* Whether the libraries of C and C++ have it: other names of the process that runs the object are not meant. */
static int is_in_a_library(const char *name)
{
    static const char *const names[] = {"libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1"};
    static void *library[sizeof names / sizeof *names];
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        if (library[k] == NULL)
            library[k] = dlopen(names[k], RTLD_LAZY | RTLD_LOCAL);
        if (library[k] != NULL && dlsym(library[k], name) != NULL)
            return 1;
    }
    return 0;
}

/* ---- names --------------------------------------------------------------------------------------------- */

static void put_names(FILE *out, LLVMValueRef first, LLVMValueRef (*next)(LLVMValueRef))
{
    size_t length;
    for (LLVMValueRef v = first; v != NULL; v = next(v)) {
        const char *name = LLVMGetValueName2(v, &length);
        if (length > 0 && strncmp(name, "llvm.", 5) != 0)
            fprintf(out, "%c %s\n", LLVMIsDeclaration(v) ? 'U' : 'T', name);
    }
}

static void list_names(FILE *out, LLVMModuleRef module)
{
    put_names(out, LLVMGetFirstFunction(module), LLVMGetNextFunction);
    put_names(out, LLVMGetFirstGlobal(module), LLVMGetNextGlobal);
    put_names(out, LLVMGetFirstGlobalAlias(module), LLVMGetNextGlobalAlias);
    put_names(out, LLVMGetFirstGlobalIFunc(module), LLVMGetNextGlobalIFunc);
}

/* ---- code of the machine --------------------------------------------------------------------------------- */

static void write_object(const char *path)
{
    LLVMTargetRef target;
    char *message = NULL, *name = (char *)(uintptr_t)path;
    LLVMInitializeNativeTarget();
    LLVMInitializeNativeAsmPrinter();
    LLVMInitializeNativeAsmParser(); /* what is refused only when it is reached is assembled */
    const char *triple = LLVMGetTarget(everything);
    if (LLVMGetTargetFromTriple(triple, &target, &message))
        cagd_code_give_up(1, message, triple);
    LLVMTargetMachineRef machine =
        LLVMCreateTargetMachine(target, triple, "", "", LLVMCodeGenLevelNone, LLVMRelocPIC, LLVMCodeModelDefault);
    if (LLVMTargetMachineEmitToFile(machine, everything, name, LLVMObjectFile, &message))
        cagd_code_give_up(1, message, path);
    LLVMDisposeTargetMachine(machine);
}

/* The file of a library of the system. */
static char *file_of(const char *library, const char *function)
{
    Dl_info info;
    void *opened = dlopen(library, RTLD_LAZY | RTLD_LOCAL), *symbol = opened != NULL ? dlsym(opened, function) : NULL;
    if (symbol == NULL || dladdr(symbol, &info) == 0)
        cagd_code_give_up(1, "the file of a library is not known", library);
    return (char *)(uintptr_t)info.dli_fname;
}

/* What the sources define is meant (-Bsymbolic), whoever else has that name.  For C the linker is called at once, with the libraries that
 * clang would name. */
static void link_object(const char *object, const char *out, int cpp)
{
    char *const by_linker[] = {"ld",
                               "-shared",
                               "-Bsymbolic",
                               "--eh-frame-hdr",
                               "-o",
                               (char *)(uintptr_t)out,
                               (char *)(uintptr_t)object,
                               CAGD_LIBGCC,
                               file_of("libm.so.6", "sqrt"),
                               file_of("libc.so.6", "puts"),
                               NULL};
    char *const by_clang[] = {cpp ? CAGD_LLVM_BIN "/clang++" : CAGD_LLVM_BIN "/clang",
                              "-shared",
                              "-Wl,-Bsymbolic",
                              "-o",
                              (char *)(uintptr_t)out,
                              (char *)(uintptr_t)object,
                              NULL};
    run(!cpp && access(CAGD_LIBGCC, R_OK) == 0 ? by_linker : by_clang);
}

/* The folder in which core/kernels is: of the installation that this program is in, else that of the sources. */
static const char *folder_of_kernels(void)
{
    static const char installed[] = "/../share/cagd/include";
    static char path[4096];
    ssize_t length = readlink("/proc/self/exe", path, sizeof path - sizeof installed);
    while (length > 0 && path[length - 1] != '/')
        length--;
    if (length <= 0)
        return CAGD_SOURCES;
    strcpy(path + length - 1, installed);
    return access(path, R_OK) == 0 ? path : CAGD_SOURCES;
}

int main(int argc, char **argv)
{
    const char *out = NULL, *names = NULL;
    char bitcode[IN_SCRATCH], object[IN_SCRATCH];
    FILE *list = NULL;
    int files = 0, cpp = 0, archives = 0, stores = 0, flags = argc;
    if (argc == 2 && strcmp(argv[1], "--tools") == 0)
        return puts(CAGD_LLVM_BIN) == EOF;
    for (int k = 1; k < argc; k++) {
        if (strcmp(argv[k], "--") == 0) {
            flags = k + 1;
            break;
        }
        if (strcmp(argv[k], "-o") == 0 && k + 1 < argc)
            out = argv[++k];
        else if (strcmp(argv[k], "--names") == 0 && k + 1 < argc)
            names = argv[++k];
        else if (strcmp(argv[k], "--stores") == 0)
            stores = 1;
        else
            argv[++files] = argv[k];
    }
    if (out == NULL || files == 0 || argc > MOST_WORDS)
        cagd_code_give_up(2, "usage: cagd-compile-exactly [--stores] [--names LIST] -o OUT.so FILE... [-- FLAG...]",
                          NULL);
    if (make_scratch(scratch, "cagd-code") != 0)
        cagd_code_give_up(1, "no temporary folder", strerror(errno));
    atexit(remove_scratch);
    snprintf(bitcode, sizeof bitcode, "%s/source.bc", scratch);
    snprintf(object, sizeof object, "%s/all.o", scratch);
    if (names != NULL && (list = fopen(names, "w")) == NULL)
        cagd_code_give_up(1, strerror(errno), names);

    for (int k = 1; k <= files; k++) {
        char *name = argv[k];
        cpp = cpp || is_cpp(name);
        if (ends_in(name, ".a")) {
            archives++;
            cagd_code_gather(name);
        } else if (ends_in(name, ".c") || is_cpp(name)) {
            char *word[MOST_WORDS + 20] = {is_cpp(name) ? CAGD_LLVM_BIN "/clang++" : CAGD_LLVM_BIN "/clang",
                                           "-O0",
                                           "-ffp-model=strict",
                                           "-ftrivial-auto-var-init=pattern",
                                           "-fno-builtin",
                                           "-fno-discard-value-names",
                                           "-g",
                                           "-fPIC",
                                           "-c",
                                           "-emit-llvm",
                                           is_cpp(name) ? "-std=gnu++17" : "-std=gnu17",
                                           "-o",
                                           bitcode,
                                           name,
                                           "-idirafter",
                                           (char *)(uintptr_t)folder_of_kernels()};
            int words = 16;
            for (int f = flags; f < argc; f++)
                if (!is_for_the_other_language(argv[f], is_cpp(name)))
                    word[words++] = argv[f];
            run(word);
            LLVMModuleRef module = cagd_code_module_of(cagd_code_bytes_of(bitcode), name);
            if (list != NULL)
                list_names(list, module);
            take(module, name);
        } else {
            LLVMMemoryBufferRef bytes = cagd_code_bytes_of(name);
            if (!cagd_code_is_bitcode(LLVMGetBufferStart(bytes), LLVMGetBufferSize(bytes)))
                cagd_code_give_up(2, "a source in C or C++, bitcode or an archive of it was expected", name);
            take(cagd_code_module_of(bytes, name), name);
        }
    }
    if (archives == files)
        cagd_code_give_up(2, "nothing but archives, of which nothing is missed", NULL);
    cagd_code_take_missed(everything);
    cpp = cpp || needs_cpp(everything);
    if (list != NULL && fclose(list) != 0)
        cagd_code_give_up(1, strerror(errno), names);
    if (ends_in(out, ".bc"))
        return LLVMWriteBitcodeToFile(everything, out) != 0;
    cagd_code_rewrite(everything, is_in_a_library, stores);
    char *message = NULL;
    if (LLVMVerifyModule(everything, LLVMReturnStatusAction, &message))
        cagd_code_give_up(1, "the rewritten module is not well-formed", message);
    write_object(object);
    link_object(object, out, cpp);
    return 0;
}
