/* archive.h -- archives of bitcode, of whose members those are taken that are missed; only for the program cagd-compile-exactly. */
#ifndef CAGD_CODE_ARCHIVE_H
#define CAGD_CODE_ARCHIVE_H

#include <llvm-c/Core.h>

/* Ends the program with that code and one line: what, and about what (or NULL). */
_Noreturn void cagd_code_give_up(int code, const char *what, const char *about);

/* The bytes of a file, or a line and the end.  Whether they are bitcode. */
LLVMMemoryBufferRef cagd_code_bytes_of(const char *path);
int cagd_code_is_bitcode(const char *bytes, size_t size);
LLVMModuleRef cagd_code_module_of(LLVMMemoryBufferRef bytes, const char *name); /* takes the bytes */

/* The members of the archive, a thin one too, join those that wait; one that is no bitcode ends the program. */
void cagd_code_gather(const char *path);
/* Of all members that wait, those join `everything` that define what it misses, also what those miss, in the order of the archives, as a linker
 * has it that looks through them again and again.  The others are given up. */
void cagd_code_take_missed(LLVMModuleRef everything);
#endif
