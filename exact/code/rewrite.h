/* rewrite.h -- a module of LLVM in which every operation on floating-point numbers is a call of ours. */
#ifndef CAGD_CODE_REWRITE_H
#define CAGD_CODE_REWRITE_H

#include <llvm-c/Core.h>

/* Storage, copying, control and calls stay as they are: a double is still 64 bits.  Each operation, comparison, conversion and
 * function of the C library becomes a call of cagd_code_... (machine.h), before which the global cagd_code_at is set to the place in
 * the source.  What cannot be carried becomes a call of cagd_code_refuse with its name, which is made only if it is reached;
 * so does a function that is neither defined nor in a library of the language.
 * Variables whose address is taken, and all global ones, get margins and are told of (objects.h), and every address that is computed
 * or used is looked at.  What stands in the margins and in what was never written is recognised when it is taken for a number.
 * notes_stores: each number that is put into a variable is told of. */
void cagd_code_rewrite(LLVMModuleRef module, int (*is_in_a_library)(const char *name), int notes_stores);
#endif
