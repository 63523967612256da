/* archive.c -- see archive.h.
 *
 * An archive is "!<arch>\n", and for each member a head of 60 bytes, its name in the first 16, its size in the ten from 48 on, and its
 * bytes, made even.  "/" is a table of symbols, "//" one of names, in which "/123" is the one that begins at 123.  In a thin archive,
 * "!<thin>\n", there are heads and no bytes: a name is that of a file, seen from the archive. */
#include "exact/code/archive.h"

#include <llvm-c/BitReader.h>
#include <llvm-c/Linker.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_MEMBERS = 1 << 16, HEAD = 60, NAME = 16, SIZE_AT = 48, SIZE = 10, MOST_PATH = 4096 };

static struct {
    LLVMModuleRef module;
    char path[MOST_PATH]; /* of the archive */
} * member[MOST_MEMBERS];
static size_t count;

int cagd_code_is_bitcode(const char *bytes, size_t size) { return size > 4 && memcmp(bytes, "BC\xC0\xDE", 4) == 0; }

LLVMMemoryBufferRef cagd_code_bytes_of(const char *path)
{
    LLVMMemoryBufferRef bytes;
    char *message = NULL;
    if (LLVMCreateMemoryBufferWithContentsOfFile(path, &bytes, &message))
        cagd_code_give_up(1, message, path);
    return bytes;
}

LLVMModuleRef cagd_code_module_of(LLVMMemoryBufferRef bytes, const char *name)
{
    LLVMModuleRef module;
    if (LLVMParseBitcode2(bytes, &module))
        cagd_code_give_up(1, "no bitcode of this version of LLVM or an older one", name);
    return module;
}

/* ---- reading ------------------------------------------------------------------------------------------------ */

static void add(LLVMMemoryBufferRef bytes, const char *archive, const char *name)
{
    if (count == MOST_MEMBERS)
        cagd_code_give_up(1, "an archive of too many members", archive);
    if (!cagd_code_is_bitcode(LLVMGetBufferStart(bytes), LLVMGetBufferSize(bytes))) {
        char what[2 * MOST_PATH];
        snprintf(what, sizeof what, "the member %s of the archive is no bitcode; compile it with -emit-llvm", name);
        cagd_code_give_up(1, what, archive);
    }
    member[count] = malloc(sizeof *member[count]);
    if (member[count] == NULL)
        exit(3);
    member[count]->module = cagd_code_module_of(bytes, archive);
    snprintf(member[count++]->path, MOST_PATH, "%s", archive);
}

/* The name of a member: up to "/" in its head, or up to "/" and a new line in the table. */
static void read_name(const char *head, const char *names, size_t size, char name[MOST_PATH])
{
    size_t at = head[0] == '/' ? strtoul(head + 1, NULL, 10) : 0, length = 0;
    const char *text = head[0] == '/' ? names + at : head;
    size_t room = head[0] == '/' ? (at < size ? size - at : 0) : NAME;
    while (length < room && length + 1 < MOST_PATH &&
           !(text[length] == '/' && (head[0] != '/' || length + 1 == room || text[length + 1] == '\n')))
        length++;
    snprintf(name, MOST_PATH, "%.*s", (int)length, text);
}

static LLVMMemoryBufferRef file_beside(const char *archive, const char *name)
{
    char path[2 * MOST_PATH];
    const char *slash = strrchr(archive, '/');
    int folder = slash != NULL && name[0] != '/' ? (int)(slash + 1 - archive) : 0;
    snprintf(path, sizeof path, "%.*s%s", folder, archive, name);
    return cagd_code_bytes_of(path);
}

void cagd_code_gather(const char *path)
{
    LLVMMemoryBufferRef bytes = cagd_code_bytes_of(path);
    const char *start = LLVMGetBufferStart(bytes), *names = "";
    size_t size = LLVMGetBufferSize(bytes), names_size = 0;
    int thin = size >= 8 && memcmp(start, "!<thin>\n", 8) == 0;
    if (!thin && (size < 8 || memcmp(start, "!<arch>\n", 8) != 0))
        cagd_code_give_up(1, "no archive", path);
    for (size_t at = 8; at + HEAD <= size;) {
        const char *head = start + at, *inside = head + HEAD;
        char digits[SIZE + 1] = {0}, name[MOST_PATH];
        memcpy(digits, head + SIZE_AT, SIZE);
        size_t length = strtoul(digits, NULL, 10);
        int is_names = memcmp(head, "// ", 3) == 0;
        int is_table = is_names || memcmp(head, "/ ", 2) == 0 || memcmp(head, "/SYM64/ ", 8) == 0;
        int has_bytes = is_table || !thin;
        if (has_bytes && length > size - at - HEAD)
            cagd_code_give_up(1, "an archive that ends too early", path);
        if (is_names)
            names = inside, names_size = length;
        if (!is_table) {
            read_name(head, names, names_size, name);
            add(thin ? file_beside(path, name) : LLVMCreateMemoryBufferWithMemoryRangeCopy(inside, length, path), path,
                name);
        }
        at += HEAD + (has_bytes ? length + length % 2 : 0);
    }
    LLVMDisposeMemoryBuffer(bytes);
}

/* ---- what is missed ------------------------------------------------------------------------------------------ */

/* Whether others see what a module defines so. */
static int is_seen(LLVMValueRef v)
{
    LLVMLinkage linkage = LLVMGetLinkage(v);
    return !LLVMIsDeclaration(v) && linkage != LLVMInternalLinkage && linkage != LLVMPrivateLinkage &&
           linkage != LLVMAvailableExternallyLinkage && linkage != LLVMAppendingLinkage;
}

/* Whether `everything` uses the name and does not define it. */
static int misses(LLVMModuleRef everything, LLVMValueRef v)
{
    size_t length;
    const char *name = LLVMGetValueName2(v, &length);
    LLVMValueRef known = LLVMGetNamedFunction(everything, name);
    if (known == NULL)
        known = LLVMGetNamedGlobal(everything, name);
    return known != NULL && LLVMIsDeclaration(known) && LLVMGetLinkage(known) != LLVMExternalWeakLinkage;
}

static int is_missed(LLVMModuleRef everything, LLVMModuleRef module)
{
    for (LLVMValueRef v = LLVMGetFirstFunction(module); v != NULL; v = LLVMGetNextFunction(v))
        if (is_seen(v) && misses(everything, v))
            return 1;
    for (LLVMValueRef v = LLVMGetFirstGlobal(module); v != NULL; v = LLVMGetNextGlobal(v))
        if (is_seen(v) && misses(everything, v))
            return 1;
    for (LLVMValueRef v = LLVMGetFirstGlobalAlias(module); v != NULL; v = LLVMGetNextGlobalAlias(v))
        if (is_seen(v) && misses(everything, v))
            return 1;
    return 0;
}

void cagd_code_take_missed(LLVMModuleRef everything)
{
    for (int again = 1; again;) {
        again = 0;
        for (size_t k = 0; k < count; k++)
            if (member[k]->module != NULL && is_missed(everything, member[k]->module)) {
                if (LLVMLinkModules2(everything, member[k]->module))
                    cagd_code_give_up(1, "it cannot be linked with the others", member[k]->path);
                member[k]->module = NULL;
                again = 1;
            }
    }
    for (size_t k = 0; k < count; free(member[k++]))
        if (member[k]->module != NULL)
            LLVMDisposeModule(member[k]->module);
    count = 0;
}
