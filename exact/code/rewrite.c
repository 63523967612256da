/* rewrite.c -- see rewrite.h. */
#include "exact/code/rewrite.h"

#include "exact/code/names.h"

#include <llvm-c/DebugInfo.h>
#include <llvm-c/Target.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* MARGIN: the least, and what margins and alignments are multiples of. */
enum { MARGIN = 32, MARGIN_BYTE = 0xFE, NEVER_FILLED = 0xAA, MOST_OPERANDS = 8 };

static const char PARAMETER[] = ".addr"; /* behind the name of the variable into which clang puts a parameter */

/* What is at hand while a module is rewritten.  `last` is the place that was made last: neighbours often share it. */
struct rewriting {
    int (*is_in_a_library)(const char *name);
    int notes_stores;
    int is_alone; /* nothing of a library is called that may remember earlier calls */
    LLVMModuleRef module;
    LLVMContextRef context;
    LLVMBuilderRef build;
    LLVMTypeRef i1, i8, i32, i64, real, single, nothing, text, place;
    LLVMTargetDataRef layout;
    LLVMValueRef at, last;
    const char *last_file, *last_function;
    unsigned last_line;
};

/* ---- types -------------------------------------------------------------------------------------------- */

static int is_floating(LLVMTypeRef t)
{
    switch (LLVMGetTypeKind(t)) {
    case LLVMHalfTypeKind:
    case LLVMBFloatTypeKind:
    case LLVMFloatTypeKind:
    case LLVMDoubleTypeKind:
    case LLVMX86_FP80TypeKind:
    case LLVMFP128TypeKind:
    case LLVMPPC_FP128TypeKind:
        return 1;
    default:
        return 0;
    }
}

static int is_vector(LLVMTypeRef t) { return LLVMGetTypeKind(t) == LLVMVectorTypeKind; }
static LLVMTypeRef lane(LLVMTypeRef t) { return is_vector(t) ? LLVMGetElementType(t) : t; }

/* double and float; everything else that floats is refused. */
static int is_carried(LLVMTypeRef t)
{
    LLVMTypeKind kind = LLVMGetTypeKind(lane(t));
    return kind == LLVMDoubleTypeKind || kind == LLVMFloatTypeKind;
}

static const char *name_of_type(LLVMTypeRef t)
{
    switch (LLVMGetTypeKind(lane(t))) {
    case LLVMX86_FP80TypeKind:
        return "long double";
    case LLVMFP128TypeKind:
        return "a floating-point number of 128 bits";
    default:
        return "a floating-point number of 16 bits";
    }
}

/* Whether numbers are among what an object of this type holds, not counting what it points to. */
static int holds_numbers(LLVMTypeRef t)
{
    switch (LLVMGetTypeKind(t)) {
    case LLVMArrayTypeKind:
    case LLVMVectorTypeKind:
        return holds_numbers(LLVMGetElementType(t));
    case LLVMStructTypeKind:
        for (unsigned k = 0; k < LLVMCountStructElementTypes(t); k++)
            if (holds_numbers(LLVMStructGetTypeAtIndex(t, k)))
                return 1;
        return 0;
    default:
        return is_floating(t);
    }
}

/* ---- calls -------------------------------------------------------------------------------------------- */

static LLVMValueRef called(struct rewriting *r, const char *name, LLVMTypeRef result, unsigned count,
                           LLVMValueRef argument[])
{
    LLVMTypeRef types[MOST_OPERANDS];
    for (unsigned k = 0; k < count; k++)
        types[k] = LLVMTypeOf(argument[k]);
    LLVMTypeRef type = LLVMFunctionType(result, types, count, 0);
    LLVMValueRef function = LLVMGetNamedFunction(r->module, name);
    if (function == NULL)
        function = LLVMAddFunction(r->module, name, type);
    return LLVMBuildCall2(r->build, type, function, argument, count, "");
}

static LLVMValueRef whole(LLVMTypeRef type, unsigned long long value) { return LLVMConstInt(type, value, 0); }

static LLVMValueRef string(struct rewriting *r, const char *bytes)
{
    return LLVMBuildGlobalStringPtr(r->build, bytes, "");
}

/* Points the builder before the instruction, and cagd_code_at to its place in the source. */
static void stand_before(struct rewriting *r, LLVMValueRef instruction)
{
    LLVMPositionBuilderBefore(r->build, instruction);
    unsigned length = 0, line = LLVMGetDebugLocLine(instruction);
    const char *file = line ? LLVMGetDebugLocFilename(instruction, &length) : NULL;
    LLVMValueRef inside = LLVMGetBasicBlockParent(LLVMGetInstructionParent(instruction));
    size_t size;
    const char *function = LLVMGetValueName2(inside, &size);
    if (r->last == NULL || r->last_line != line || r->last_file != file || r->last_function != function) {
        char path[512];
        snprintf(path, sizeof path, "%.*s", (int)length, file ? file : "");
        LLVMValueRef member[3] = {string(r, path), string(r, function), whole(r->i32, line)};
        r->last = LLVMAddGlobal(r->module, r->place, "");
        LLVMSetInitializer(r->last, LLVMConstNamedStruct(r->place, member, 3));
        LLVMSetLinkage(r->last, LLVMPrivateLinkage);
        LLVMSetGlobalConstant(r->last, 1);
        r->last_line = line, r->last_file = file, r->last_function = function;
    }
    LLVMBuildStore(r->build, r->last, r->at);
}

static void refuse(struct rewriting *r, const char *what)
{
    called(r, "cagd_code_refuse", r->nothing, 1, (LLVMValueRef[]){string(r, what)});
}

/* ---- operations on one number ---------------------------------------------------------------------------- */

static LLVMValueRef widened(struct rewriting *r, LLVMValueRef x)
{
    return LLVMGetTypeKind(LLVMTypeOf(x)) == LLVMFloatTypeKind ? called(r, "cagd_code_widen", r->real, 1, &x) : x;
}

static LLVMValueRef narrowed(struct rewriting *r, LLVMValueRef x, LLVMTypeRef type)
{
    return LLVMGetTypeKind(type) == LLVMFloatTypeKind ? called(r, "cagd_code_narrow", r->single, 1, &x) : x;
}

/* What is done with the lanes of the operands: a function of ours of so many numbers, or one of the words below, with `detail`. */
struct operation {
    const char *name;
    unsigned count;
    int detail;
};
static const char COMPARE[] = "compare";
static const char TO_SIGNED[] = "to signed";
static const char TO_UNSIGNED[] = "to unsigned";
static const char FROM_SIGNED[] = "from signed";
static const char FROM_UNSIGNED[] = "from unsigned";
static const char RESIZE[] = "resize";
static const char CLASS[] = "class";
static const char WHOLE_POWER[] = "whole power";

static LLVMValueRef operate(struct rewriting *r, const struct operation *o, LLVMTypeRef type, LLVMValueRef x[])
{
    if (o->name == COMPARE) {
        LLVMValueRef argument[3] = {widened(r, x[0]), widened(r, x[1]), whole(r->i32, (unsigned)o->detail)};
        LLVMValueRef answer = called(r, "cagd_code_compare", r->i32, 3, argument);
        return LLVMBuildICmp(r->build, LLVMIntNE, answer, whole(r->i32, 0), "");
    }
    if (o->name == CLASS) {
        LLVMValueRef argument[2] = {widened(r, x[0]), x[1]};
        LLVMValueRef answer = called(r, "cagd_code_class", r->i32, 2, argument);
        return LLVMBuildICmp(r->build, LLVMIntNE, answer, whole(r->i32, 0), "");
    }
    if (o->name == TO_SIGNED || o->name == TO_UNSIGNED) {
        unsigned bits = LLVMGetIntTypeWidth(type);
        LLVMValueRef argument[3] = {widened(r, x[0]), whole(r->i32, bits), whole(r->i32, o->name == TO_SIGNED)};
        LLVMValueRef answer = called(r, "cagd_code_to_integer", r->i64, 3, argument);
        return bits < 64 ? LLVMBuildTrunc(r->build, answer, type, "") : answer;
    }
    if (o->name == FROM_SIGNED || o->name == FROM_UNSIGNED) {
        LLVMValueRef argument = LLVMBuildIntCast2(r->build, x[0], r->i64, o->name == FROM_SIGNED, "");
        const char *name = o->name == FROM_SIGNED ? "cagd_code_from_signed" : "cagd_code_from_unsigned";
        return narrowed(r, called(r, name, r->real, 1, &argument), type);
    }
    if (o->name == RESIZE)
        return narrowed(r, widened(r, x[0]), type);
    if (o->name == WHOLE_POWER) {
        LLVMValueRef argument[2] = {widened(r, x[0]), x[1]};
        return narrowed(r, called(r, "cagd_code_power", r->real, 2, argument), type);
    }
    LLVMValueRef argument[MOST_OPERANDS];
    for (unsigned k = 0; k < o->count; k++)
        argument[k] = widened(r, x[k]);
    if (LLVMGetTypeKind(type) == LLVMIntegerTypeKind) { /* lround and its like */
        LLVMValueRef answer = called(r, o->name, r->i64, o->count, argument);
        return LLVMGetIntTypeWidth(type) < 64 ? LLVMBuildTrunc(r->build, answer, type, "") : answer;
    }
    return narrowed(r, called(r, o->name, r->real, o->count, argument), type);
}

/* The instruction gives way to the operation, lane by lane where it is one on vectors. */
static void replace(struct rewriting *r, LLVMValueRef instruction, const struct operation *o, LLVMValueRef x[])
{
    LLVMTypeRef type = LLVMTypeOf(instruction);
    LLVMValueRef result;
    if (!is_vector(type)) {
        result = operate(r, o, type, x);
    } else {
        result = LLVMGetUndef(type);
        for (unsigned k = 0; k < LLVMGetVectorSize(type); k++) {
            LLVMValueRef part[MOST_OPERANDS], index = whole(r->i32, k);
            for (unsigned j = 0; j < o->count; j++)
                part[j] = is_vector(LLVMTypeOf(x[j])) ? LLVMBuildExtractElement(r->build, x[j], index, "") : x[j];
            result = LLVMBuildInsertElement(r->build, result, operate(r, o, LLVMGetElementType(type), part), index, "");
        }
    }
    LLVMReplaceAllUsesWith(instruction, result);
    LLVMInstructionEraseFromParent(instruction);
}

/* Behind a refusal the instruction is not reached; the machine might ask for functions of its own to do it. */
static void drop_unreached(LLVMValueRef instruction)
{
    LLVMReplaceAllUsesWith(instruction, LLVMGetUndef(LLVMTypeOf(instruction)));
    LLVMInstructionEraseFromParent(instruction);
}

/* Refused where one of the types that take part is not carried. */
static int refused_by_type(struct rewriting *r, LLVMTypeRef type)
{
    LLVMTypeRef t = lane(type);
    if (is_floating(t) && !is_carried(t))
        refuse(r, name_of_type(t));
    else if (LLVMGetTypeKind(t) == LLVMIntegerTypeKind && LLVMGetIntTypeWidth(t) > 64)
        refuse(r, "an integer of more than 64 bits as a number");
    else
        return 0;
    return 1;
}

static void rewrite_operation(struct rewriting *r, LLVMValueRef instruction, const char *name, unsigned count,
                              int detail)
{
    struct operation o = {name, count, detail};
    LLVMValueRef x[MOST_OPERANDS];
    stand_before(r, instruction);
    int refused = refused_by_type(r, LLVMTypeOf(instruction));
    for (unsigned k = 0; k < count; k++) {
        x[k] = LLVMGetOperand(instruction, k);
        refused = refused || refused_by_type(r, LLVMTypeOf(x[k]));
    }
    if (refused)
        drop_unreached(instruction);
    else
        replace(r, instruction, &o, x);
}

/* ---- objects and their margins ------------------------------------------------------------------------------ */

static unsigned long long bytes_of(struct rewriting *r, LLVMTypeRef type) { return LLVMABISizeOfType(r->layout, type); }

/* As wide as the object, within bounds, a multiple of its alignment. */
static unsigned margin_of(struct rewriting *r, LLVMTypeRef type, unsigned alignment)
{
    enum { MOST_MARGIN = 1024 };
    unsigned long long size = bytes_of(r, type), unit = alignment > MARGIN ? alignment : MARGIN;
    size = size > MOST_MARGIN ? MOST_MARGIN : size;
    return (unsigned)((size + unit - 1) / unit * unit + (size == 0) * unit);
}

static LLVMTypeRef margined(struct rewriting *r, LLVMTypeRef type, unsigned margin)
{
    LLVMTypeRef bytes = LLVMArrayType(r->i8, margin), member[3] = {bytes, type, bytes};
    return LLVMStructTypeInContext(r->context, member, 3, 0);
}

static LLVMValueRef as_bytes(struct rewriting *r, LLVMValueRef at)
{
    return LLVMBuildPointerCast(r->build, at, r->text, "");
}

static void fill(struct rewriting *r, LLVMValueRef at, unsigned byte, LLVMValueRef bytes)
{
    LLVMBuildMemSet(r->build, as_bytes(r, at), whole(r->i8, byte), bytes, 1);
}

/* Whether the address of a variable goes anywhere: it is more than read and written by name. */
static int is_taken(LLVMValueRef local)
{
    for (LLVMUseRef use = LLVMGetFirstUse(local); use != NULL; use = LLVMGetNextUse(use)) {
        LLVMValueRef user = LLVMGetUser(use);
        if (!LLVMIsALoadInst(user) && !(LLVMIsAStoreInst(user) && LLVMGetOperand(user, 0) != local))
            return 1;
    }
    return 0;
}

static void widen_local(struct rewriting *r, LLVMValueRef local)
{
    LLVMTypeRef type = LLVMGetAllocatedType(local);
    LLVMValueRef count = LLVMGetOperand(local, 0), inside, bytes;
    int is_one = LLVMIsAConstantInt(count) && LLVMConstIntGetZExtValue(count) == 1;
    unsigned alignment = LLVMGetAlignment(local), margin = margin_of(r, type, alignment);
    char name[200];
    size_t length;
    snprintf(name, sizeof name, "%s", LLVMGetValueName2(local, &length));
    if (is_one && !is_taken(local))
        return;
    stand_before(r, local);
    if (is_one) {
        LLVMTypeRef wide = margined(r, type, margin);
        LLVMValueRef all = LLVMBuildAlloca(r->build, wide, "");
        LLVMSetAlignment(all, alignment > MARGIN ? alignment : MARGIN);
        if (holds_numbers(type)) {
            fill(r, LLVMBuildStructGEP2(r->build, wide, all, 0, ""), MARGIN_BYTE, whole(r->i64, margin));
            /* clang fills what has no constructor, and so neither all objects of C++ nor its temporaries */
            fill(r, LLVMBuildStructGEP2(r->build, wide, all, 1, ""), NEVER_FILLED, whole(r->i64, bytes_of(r, type)));
            fill(r, LLVMBuildStructGEP2(r->build, wide, all, 2, ""), MARGIN_BYTE, whole(r->i64, margin));
        }
        inside = LLVMBuildStructGEP2(r->build, wide, all, 1, "");
        bytes = whole(r->i64, bytes_of(r, type));
    } else { /* an array of variable length: so many more elements on either side that they have the margin */
        LLVMTypeRef counted = LLVMTypeOf(count);
        unsigned long long size = bytes_of(r, type) > 0 ? bytes_of(r, type) : 1;
        LLVMValueRef extra = whole(counted, (margin + size - 1) / size);
        LLVMValueRef wide = LLVMBuildAdd(r->build, count, LLVMBuildAdd(r->build, extra, extra, ""), "");
        LLVMValueRef all = LLVMBuildArrayAlloca(r->build, type, wide, "");
        LLVMSetAlignment(all, alignment > MARGIN ? alignment : MARGIN);
        margin = (unsigned)((margin + size - 1) / size * size);
        inside = LLVMBuildGEP2(r->build, type, all, &extra, 1, "");
        fill(r, all, MARGIN_BYTE, whole(r->i64, margin));
        fill(r, LLVMBuildGEP2(r->build, type, inside, &count, 1, ""), MARGIN_BYTE, whole(r->i64, margin));
        bytes = LLVMBuildMul(r->build, LLVMBuildIntCast2(r->build, count, r->i64, 0, ""), whole(r->i64, size), "");
    }
    LLVMValueRef argument[4] = {as_bytes(r, inside), bytes, whole(r->i64, margin), string(r, name)};
    called(r, "cagd_code_local", r->nothing, 4, argument);
    LLVMReplaceAllUsesWith(local, inside);
    LLVMInstructionEraseFromParent(local);
    LLVMSetValueName2(LLVMGetOperand(inside, 0), name, strlen(name));
}

/* What belongs to the language's own tables, and what must lie in a section, stays as it is. */
static int is_an_object(LLVMValueRef global, const char *name)
{
    const char *section = LLVMGetSection(global);
    return !LLVMIsDeclaration(global) && (section == NULL || *section == 0) && strncmp(name, "llvm.", 5) != 0 &&
           strncmp(name, "_ZT", 3) != 0;
}

/* The global gets margins; `begin` is the function that tells of it before anything else runs. */
static void widen_global(struct rewriting *r, LLVMValueRef global, LLVMValueRef begin)
{
    LLVMTypeRef type = LLVMGlobalGetValueType(global);
    size_t length;
    char name[200];
    snprintf(name, sizeof name, "%s", LLVMGetValueName2(global, &length));
    if (!is_an_object(global, name))
        return;
    LLVMSetThreadLocal(global, 0); /* there is one thread */
    unsigned alignment = LLVMGetAlignment(global), size = margin_of(r, type, alignment);
    char *bytes = malloc(size);
    if (bytes == NULL)
        exit(3);
    memset(bytes, MARGIN_BYTE, size);
    LLVMValueRef margin = LLVMConstStringInContext(r->context, bytes, size, 1);
    free(bytes);
    LLVMTypeRef wide_type = margined(r, type, size);
    LLVMValueRef member[3] = {margin, LLVMGetInitializer(global), margin};
    LLVMValueRef wide = LLVMAddGlobal(r->module, wide_type, "");
    LLVMSetInitializer(wide, LLVMConstStructInContext(r->context, member, 3, 0));
    LLVMSetLinkage(wide, LLVMInternalLinkage);
    LLVMSetAlignment(wide, alignment > MARGIN ? alignment : MARGIN);
    LLVMSetGlobalConstant(wide, LLVMIsGlobalConstant(global));
    LLVMValueRef index[2] = {whole(r->i32, 0), whole(r->i32, 1)};
    LLVMValueRef inside = LLVMConstGEP2(wide_type, wide, index, 2);
    LLVMPositionBuilderBefore(r->build, LLVMGetBasicBlockTerminator(LLVMGetEntryBasicBlock(begin)));
    LLVMValueRef argument[4] = {as_bytes(r, inside), whole(r->i64, bytes_of(r, type)), whole(r->i64, size),
                                string(r, strncmp(name, ".str", 4) == 0 ? "a string" : name)};
    called(r, "cagd_code_global", r->nothing, 4, argument);
    LLVMReplaceAllUsesWith(global, inside);
    strncat(name, PARAMETER, sizeof name - strlen(name) - 1); /* the name alone is still another's */
    LLVMSetValueName2(wide, name, strlen(name));
}

/* An empty function that runs before all constructors. */
static LLVMValueRef first_constructor(struct rewriting *r)
{
    static const char list[] = "llvm.global_ctors";
    LLVMTypeRef type = LLVMFunctionType(r->nothing, NULL, 0, 0);
    LLVMValueRef begin = LLVMAddFunction(r->module, "cagd_code_begin", type);
    LLVMSetLinkage(begin, LLVMInternalLinkage);
    LLVMPositionBuilderAtEnd(r->build, LLVMAppendBasicBlockInContext(r->context, begin, ""));
    LLVMBuildRetVoid(r->build);
    LLVMValueRef old = LLVMGetNamedGlobal(r->module, list);
    unsigned had = old != NULL ? LLVMGetArrayLength(LLVMGlobalGetValueType(old)) : 0;
    LLVMTypeRef field[3] = {r->i32, LLVMPointerType(type, 0), r->text};
    LLVMTypeRef row = LLVMStructTypeInContext(r->context, field, 3, 0);
    LLVMValueRef member[3] = {whole(r->i32, 0), begin, LLVMConstNull(r->text)};
    LLVMValueRef *rows = calloc(had + 1, sizeof *rows);
    if (rows == NULL)
        exit(3);
    rows[0] = LLVMConstStructInContext(r->context, member, 3, 0);
    for (unsigned k = 0; k < had; k++)
        rows[k + 1] = LLVMGetOperand(LLVMGetInitializer(old), k);
    LLVMValueRef new = LLVMAddGlobal(r->module, LLVMArrayType(row, had + 1), "");
    LLVMSetInitializer(new, LLVMConstArray(row, rows, had + 1));
    LLVMSetLinkage(new, LLVMAppendingLinkage);
    free(rows);
    if (old != NULL)
        LLVMDeleteGlobal(old);
    LLVMSetValueName2(new, list, sizeof list - 1);
    return begin;
}

/* ---- addresses ---------------------------------------------------------------------------------------------- */

static int is_element_pointer(LLVMValueRef v)
{
    return LLVMIsAGetElementPtrInst(v) != NULL ||
           (LLVMIsAConstantExpr(v) && LLVMGetConstOpcode(v) == LLVMGetElementPtr);
}

/* Casts of pointers change no address. */
static LLVMValueRef without_casts(LLVMValueRef at)
{
    while (LLVMIsABitCastInst(at) || (LLVMIsAConstantExpr(at) && LLVMGetConstOpcode(at) == LLVMBitCast))
        at = LLVMGetOperand(at, 0);
    return at;
}

/* Whether an address is a variable's own: the variable, or what widen_local put into its place, of that size at least. */
static int is_by_name(struct rewriting *r, LLVMValueRef at, unsigned long long bytes)
{
    LLVMValueRef base = without_casts(at);
    if (LLVMIsAAllocaInst(base))
        return bytes <= bytes_of(r, LLVMGetAllocatedType(base));
    if (!LLVMIsAGetElementPtrInst(base) || !LLVMIsAAllocaInst(LLVMGetOperand(base, 0)))
        return 0;
    LLVMTypeRef wide = LLVMGetAllocatedType(LLVMGetOperand(base, 0));
    return LLVMGetTypeKind(wide) == LLVMStructTypeKind && LLVMCountStructElementTypes(wide) == 3 &&
           bytes <= bytes_of(r, LLVMStructGetTypeAtIndex(wide, 1));
}

/* Before the instruction so many bytes are read from the address, or written to it. */
static void look_where_it_reaches(struct rewriting *r, LLVMValueRef instruction, LLVMValueRef at, LLVMValueRef bytes,
                                  int writes)
{
    if (LLVMIsAConstantInt(bytes) && is_by_name(r, at, LLVMConstIntGetZExtValue(bytes)))
        return;
    stand_before(r, instruction);
    LLVMValueRef base = without_casts(at);
    if (LLVMIsAConstantExpr(base)) { /* an element of a global, as a constant */
        while (is_element_pointer(base))
            base = without_casts(LLVMGetOperand(base, 0));
        called(r, "cagd_code_step", r->nothing, 2, (LLVMValueRef[]){as_bytes(r, base), as_bytes(r, at)});
    }
    LLVMValueRef argument[3] = {as_bytes(r, at), LLVMBuildIntCast2(r->build, bytes, r->i64, 0, ""),
                                whole(r->i32, (unsigned)writes)};
    called(r, "cagd_code_reach", r->nothing, 3, argument);
}

static void look_at_access(struct rewriting *r, LLVMValueRef instruction, LLVMValueRef at, LLVMTypeRef type, int writes)
{
    look_where_it_reaches(r, instruction, at, whole(r->i64, LLVMStoreSizeOfType(r->layout, type)), writes);
}

/* Whether an element is read or written by that address and no more: nothing keeps it. */
static int is_only_used(LLVMValueRef address)
{
    for (LLVMUseRef use = LLVMGetFirstUse(address); use != NULL; use = LLVMGetNextUse(use)) {
        LLVMValueRef user = LLVMGetUser(use);
        if (!LLVMIsALoadInst(user) && !(LLVMIsAStoreInst(user) && LLVMGetOperand(user, 0) != address))
            return 0;
    }
    return 1;
}

/* The indices into arrays of known length stay in them; of length 1 is what is meant to go on behind a structure. */
static void rewrite_indices(struct rewriting *r, LLVMValueRef element, int is_used)
{
    LLVMTypeRef type = LLVMGetGEPSourceElementType(element);
    for (unsigned k = 2; k < (unsigned)LLVMGetNumOperands(element); k++) {
        LLVMValueRef index = LLVMGetOperand(element, k);
        int last = k + 1 == (unsigned)LLVMGetNumOperands(element);
        switch (LLVMGetTypeKind(type)) {
        case LLVMStructTypeKind:
            type = LLVMStructGetTypeAtIndex(type, (unsigned)LLVMConstIntGetZExtValue(index));
            continue;
        case LLVMArrayTypeKind:
            break;
        default:
            return;
        }
        unsigned length = LLVMGetArrayLength(type);
        type = LLVMGetElementType(type);
        int is_zero = LLVMIsAConstantInt(index) && LLVMConstIntGetZExtValue(index) == 0;
        if (length <= 1 || is_zero)
            continue;
        LLVMValueRef argument[3] = {LLVMBuildIntCast2(r->build, index, r->i64, 1, ""), whole(r->i64, length),
                                    whole(r->i32, !last || is_used)};
        called(r, "cagd_code_index", r->nothing, 3, argument);
    }
}

static void rewrite_element_pointer(struct rewriting *r, LLVMValueRef element)
{
    if (is_vector(LLVMTypeOf(element)))
        return;
    int is_itself = 1; /* all indices are 0: an array as the address of its first element */
    for (unsigned k = 1; k < (unsigned)LLVMGetNumOperands(element); k++)
        is_itself = is_itself && LLVMIsAConstantInt(LLVMGetOperand(element, k)) &&
                    LLVMConstIntGetZExtValue(LLVMGetOperand(element, k)) == 0;
    if (is_itself)
        return;
    stand_before(r, element); /* the place; and then behind it */
    LLVMPositionBuilderBefore(r->build, LLVMGetNextInstruction(element));
    int is_used = is_only_used(element);
    LLVMValueRef from = LLVMGetOperand(element, 0);
    rewrite_indices(r, element, is_used);
    called(r, "cagd_code_step", r->nothing, 2, (LLVMValueRef[]){as_bytes(r, from), as_bytes(r, element)});
}

/* memcpy, memmove and memset as LLVM's own; the call stays. */
static void look_at_copied(struct rewriting *r, LLVMValueRef call, const char *name)
{
    int copies = strncmp(name, "llvm.memcpy.", 12) == 0 || strncmp(name, "llvm.memmove.", 13) == 0;
    if (!copies && strncmp(name, "llvm.memset.", 12) != 0)
        return;
    LLVMValueRef bytes = LLVMGetOperand(call, 2);
    if (copies)
        look_where_it_reaches(r, call, LLVMGetOperand(call, 1), bytes, 0);
    look_where_it_reaches(r, call, LLVMGetOperand(call, 0), bytes, 1);
    if (strncmp(name, "llvm.memcpy.", 12) != 0)
        return;
    stand_before(r, call);
    LLVMValueRef argument[3] = {as_bytes(r, LLVMGetOperand(call, 0)), as_bytes(r, LLVMGetOperand(call, 1)),
                                LLVMBuildIntCast2(r->build, bytes, r->i64, 0, "")};
    called(r, "cagd_code_apart", r->nothing, 3, argument);
}

/* Intrinsics that are about storage: how long a variable lives is known from the stack; there is one thread.  Whether it was one. */
static int rewrite_storage(struct rewriting *r, LLVMValueRef call, const char *name)
{
    look_at_copied(r, call, name);
    if (strncmp(name, "llvm.threadlocal.address", 24) == 0)
        LLVMReplaceAllUsesWith(call, LLVMGetOperand(call, 0));
    else if (strncmp(name, "llvm.lifetime.", 14) != 0)
        return 0;
    LLVMInstructionEraseFromParent(call);
    return 1;
}

/* ---- calls of the source -------------------------------------------------------------------------------- */

static const struct {
    const char *name, *function;
    unsigned count;
} intrinsics[] = {{"fadd", "cagd_code_add", 2},
                  {"fsub", "cagd_code_sub", 2},
                  {"fmul", "cagd_code_mul", 2},
                  {"fdiv", "cagd_code_div", 2},
                  {"frem", "cagd_code_lib_fmod", 2},
                  {"fma", "cagd_code_lib_fma", 3},
                  {"fmuladd", "cagd_code_lib_fma", 3},
                  {"minnum", "cagd_code_lib_fmin", 2},
                  {"maxnum", "cagd_code_lib_fmax", 2},
                  {"minimum", "cagd_code_minimum", 2},
                  {"maximum", "cagd_code_maximum", 2},
                  {"fptosi", TO_SIGNED, 1},
                  {"fptoui", TO_UNSIGNED, 1},
                  {"sitofp", FROM_SIGNED, 1},
                  {"uitofp", FROM_UNSIGNED, 1},
                  {"fptrunc", RESIZE, 1},
                  {"fpext", RESIZE, 1},
                  {"canonicalize", RESIZE, 1},
                  {"powi", WHOLE_POWER, 2},
                  {"is.fpclass", CLASS, 2},
                  {"lround", "cagd_code_lib_lround", 1},
                  {"llround", "cagd_code_lib_llround", 1},
                  {"lrint", "cagd_code_lib_lrint", 1},
                  {"llrint", "cagd_code_lib_llrint", 1},
#define ONE(name) {#name, "cagd_code_lib_" #name, 1},
#define TWO(name) {#name, "cagd_code_lib_" #name, 2},
                  CAGD_CODE_ONE(ONE) CAGD_CODE_TWO(TWO)
#undef ONE
#undef TWO
};

/* LLVM's predicates are sums: 1 equal, 2 greater, 4 less, 8 unordered. */
static int predicate_of(const char *word, unsigned length)
{
    static const char *const names[] = {"false", "oeq", "ogt", "oge", "olt", "ole", "one", "ord",
                                        "uno",   "ueq", "ugt", "uge", "ult", "ule", "une", "true"};
    for (int k = 0; k < 16; k++)
        if (strlen(names[k]) == length && strncmp(names[k], word, length) == 0)
            return k;
    return 0;
}

/* "llvm.experimental.constrained.fadd.f64" is "fadd".  Whether the name is that of an intrinsic on numbers. */
static int rewrite_intrinsic(struct rewriting *r, LLVMValueRef call, const char *name)
{
    const char *word = name + strlen("llvm.");
    if (strncmp(word, "experimental.constrained.", strlen("experimental.constrained.")) == 0)
        word += strlen("experimental.constrained.");
    if (strncmp(word, "fcmp", 4) == 0) {
        unsigned length = 0;
        const char *predicate = LLVMGetMDString(LLVMGetOperand(call, 2), &length);
        rewrite_operation(r, call, COMPARE, 2, predicate_of(predicate, length));
        return 1;
    }
    for (size_t k = 0; k < sizeof intrinsics / sizeof *intrinsics; k++) {
        size_t length = strlen(intrinsics[k].name);
        if (strncmp(word, intrinsics[k].name, length) == 0 && (word[length] == '.' || word[length] == 0)) {
            rewrite_operation(r, call, intrinsics[k].function, intrinsics[k].count, 0);
            return 1;
        }
    }
    return 0;
}

/* The sums and products of all lanes, from another module than ours: taken apart. */
static int rewrite_reduction(struct rewriting *r, LLVMValueRef call, const char *name)
{
    int sum = strncmp(name, "llvm.vector.reduce.fadd.", 24) == 0;
    if (!sum && strncmp(name, "llvm.vector.reduce.fmul.", 24) != 0)
        return 0;
    stand_before(r, call);
    LLVMValueRef total = LLVMGetOperand(call, 0), vector = LLVMGetOperand(call, 1);
    struct operation o = {sum ? "cagd_code_add" : "cagd_code_mul", 2, 0};
    for (unsigned k = 0; k < LLVMGetVectorSize(LLVMTypeOf(vector)); k++) {
        LLVMValueRef x[2] = {total, LLVMBuildExtractElement(r->build, vector, whole(r->i32, k), "")};
        total = operate(r, &o, LLVMTypeOf(call), x);
    }
    LLVMReplaceAllUsesWith(call, total);
    LLVMInstructionEraseFromParent(call);
    return 1;
}

static int takes_numbers(LLVMTypeRef function)
{
    LLVMTypeRef types[256];
    unsigned count = LLVMCountParamTypes(function);
    if (holds_numbers(LLVMGetReturnType(function)) || count > 256)
        return 1;
    LLVMGetParamTypes(function, types);
    for (unsigned k = 0; k < count; k++)
        if (holds_numbers(types[k]))
            return 1;
    return 0;
}

/* Assembly without a word, a barrier for the compiler, does nothing; LLVM's C interface does not read it, but prints it. */
static int is_empty_assembly(LLVMValueRef assembly)
{
    char *printed = LLVMPrintValueToString(assembly);
    const char *quote = strchr(printed, '"');
    int empty = quote != NULL && quote[1] == '"';
    LLVMDisposeMessage(printed);
    return empty;
}

static void rewrite_call(struct rewriting *r, LLVMValueRef call)
{
    LLVMValueRef function = LLVMGetCalledValue(call);
    if (LLVMIsAInlineAsm(function)) {
        stand_before(r, call);
        if (!is_empty_assembly(function))
            refuse(r, "inline assembly");
        return;
    }
    if (!LLVMIsAFunction(function)) {
        stand_before(r, call);
        return;
    }
    size_t length;
    const char *name = LLVMGetValueName2(function, &length);
    if (!LLVMIsDeclaration(function)) { /* without a line of its own: it may be one that is refused */
        if (LLVMGetSubprogram(function) == NULL)
            stand_before(r, call);
        return;
    }
    if (strncmp(name, "llvm.", 5) == 0) {
        if (rewrite_storage(r, call, name))
            return;
        if (strncmp(name, "llvm.dbg.", 9) == 0 || rewrite_intrinsic(r, call, name) || rewrite_reduction(r, call, name))
            return;
        if (takes_numbers(LLVMGlobalGetValueType(function))) {
            stand_before(r, call);
            refuse(r, name);
        }
        return;
    }
    if (strncmp(name, "cagd_code_", 10) == 0 && strncmp(name, "cagd_code_lib_", 14) != 0)
        return;
    stand_before(r, call);
    for (unsigned k = 0; k < LLVMGetNumArgOperands(call); k++) { /* "%Lf" */
        LLVMTypeRef type = LLVMTypeOf(LLVMGetOperand(call, k));
        if (is_floating(type) && !is_carried(type)) {
            refuse(r, name_of_type(type));
            return;
        }
    }
    /* A function of variable arguments that nobody here knows gets numbers that it would not understand. */
    if (strncmp(name, "cagd_code_", 10) != 0 && LLVMIsFunctionVarArg(LLVMGlobalGetValueType(function)))
        for (unsigned k = 0; k < LLVMGetNumArgOperands(call); k++)
            if (holds_numbers(LLVMTypeOf(LLVMGetOperand(call, k)))) {
                refuse(r, name);
                return;
            }
}

/* ---- bits of numbers ----------------------------------------------------------------------------------- */

/* Whether bits are only carried elsewhere: stored, returned, handed over, made a number again. */
static int only_carries(LLVMValueRef user, LLVMValueRef bits)
{
    if (LLVMIsAStoreInst(user))
        return LLVMGetOperand(user, 0) == bits;
    if (LLVMIsABitCastInst(user))
        return is_floating(lane(LLVMTypeOf(user)));
    return LLVMIsACallInst(user) || LLVMIsAInvokeInst(user) || LLVMIsAReturnInst(user) || LLVMIsAPHINode(user) ||
           LLVMIsAInsertValueInst(user) || LLVMIsAAtomicCmpXchgInst(user) || LLVMIsAExtractValueInst(user);
}

static int are_only_carried(LLVMValueRef bits)
{
    for (LLVMUseRef use = LLVMGetFirstUse(bits); use != NULL; use = LLVMGetNextUse(use))
        if (!only_carries(LLVMGetUser(use), bits))
            return 0;
    return 1;
}

/* Whether the comparison has the same outcome for all of 0, ..., most, compared as numbers without sign: the constant is above them; or it
 * is the last of them, and it is asked whether they are beyond it. */
static int asks_whether_beyond(LLVMValueRef user, LLVMValueRef bits, unsigned long long most)
{
    if (!LLVMIsAICmpInst(user) || LLVMGetOperand(user, 0) != bits || !LLVMIsAConstantInt(LLVMGetOperand(user, 1)))
        return 0;
    unsigned long long constant = LLVMConstIntGetZExtValue(LLVMGetOperand(user, 1));
    switch (LLVMGetICmpPredicate(user)) {
    case LLVMIntEQ:
    case LLVMIntNE:
    case LLVMIntULT:
    case LLVMIntUGE:
        return constant > most;
    case LLVMIntUGT:
    case LLVMIntULE:
        return constant >= most;
    default:
        return 0;
    }
}

/* Whether it is the difference of the constant and the bits, and of that the first bit alone is used: whether the bits are above the
 * constant.  So clang asks whether a number is a NaN. */
static int is_sign_of_difference(LLVMValueRef user, LLVMValueRef bits, unsigned width, unsigned long long constant)
{
    if (!LLVMIsABinaryOperator(user) || LLVMGetInstructionOpcode(user) != LLVMSub || LLVMGetOperand(user, 1) != bits ||
        !LLVMIsAConstantInt(LLVMGetOperand(user, 0)) || LLVMConstIntGetZExtValue(LLVMGetOperand(user, 0)) != constant)
        return 0;
    for (LLVMUseRef use = LLVMGetFirstUse(user); use != NULL; use = LLVMGetNextUse(use)) {
        LLVMValueRef shift = LLVMGetUser(use);
        if (!LLVMIsABinaryOperator(shift) || LLVMGetInstructionOpcode(shift) != LLVMLShr ||
            LLVMGetOperand(shift, 0) != user || !LLVMIsAConstantInt(LLVMGetOperand(shift, 1)) ||
            LLVMConstIntGetZExtValue(LLVMGetOperand(shift, 1)) != width - 1)
            return 0;
    }
    return 1;
}

/* Whether of the bits without their sign it is asked only whether they are those of an infinity or of a NaN, which is the same for all
 * numbers: 0x7FF0... and 0x7F800000 are those of infinity.  `doubled`: they were shifted to the left, over the sign. */
static int ask_for_no_number(LLVMValueRef bits, unsigned width, int doubled)
{
    unsigned long long infinity = width == 64 ? 0x7FFull << 52 : 0xFFull << 23;
    unsigned long long most = doubled ? 2 * (infinity - 1) : infinity - 1;
    for (LLVMUseRef use = LLVMGetFirstUse(bits); use != NULL; use = LLVMGetNextUse(use)) {
        LLVMValueRef user = LLVMGetUser(use);
        if (!asks_whether_beyond(user, bits, most) && (doubled || !is_sign_of_difference(user, bits, width, infinity)))
            return 0;
    }
    return 1;
}

/* Of the bits that are used here: the sign alone ("less than 0"), or all but the sign ("and 0x7FF...", "shl 1"), by which isnan and
 * isfinite are asked. */
enum { THE_SIGN = 1, ALL_BUT_THE_SIGN = 2 };

static int part_used(LLVMValueRef user, LLVMTypeRef type)
{
    LLVMValueRef other = LLVMGetNumOperands(user) == 2 ? LLVMGetOperand(user, 1) : NULL;
    if (other == NULL || !LLVMIsAConstantInt(other))
        return 0;
    unsigned width = LLVMGetIntTypeWidth(type);
    unsigned long long constant = LLVMConstIntGetZExtValue(other), sign = 1ull << (width - 1);
    if (LLVMIsAICmpInst(user))
        return LLVMGetICmpPredicate(user) == LLVMIntSLT && constant == 0 ? THE_SIGN : 0;
    if (!LLVMIsABinaryOperator(user))
        return 0;
    LLVMOpcode code = LLVMGetInstructionOpcode(user);
    int doubled = code == LLVMShl && constant == 1;
    if (!doubled && !(code == LLVMAnd && constant == sign - 1))
        return 0;
    return ask_for_no_number(user, width, doubled) ? ALL_BUT_THE_SIGN : 0;
}

/* The bits of a number as an integer. */
static void rewrite_bits(struct rewriting *r, LLVMValueRef cast)
{
    LLVMValueRef x = LLVMGetOperand(cast, 0);
    LLVMTypeRef from = LLVMTypeOf(x), to = LLVMTypeOf(cast);
    if (!is_floating(lane(from)) || is_floating(lane(to)) || are_only_carried(cast))
        return;
    stand_before(r, cast);
    int parts = is_carried(from) && !is_vector(from) && LLVMGetTypeKind(to) == LLVMIntegerTypeKind ? 3 : 0;
    for (LLVMUseRef use = LLVMGetFirstUse(cast); parts != 0 && use != NULL; use = LLVMGetNextUse(use))
        parts &= part_used(LLVMGetUser(use), to);
    if (parts == 0) {
        refuse(r, "the bits of a number");
        return;
    }
    LLVMValueRef argument[2] = {widened(r, x), whole(r->i32, LLVMGetIntTypeWidth(to))};
    LLVMValueRef answer = parts == THE_SIGN ? called(r, "cagd_code_sign_bits", r->i64, 1, argument)
                                            : called(r, "cagd_code_size_bits", r->i64, 2, argument);
    LLVMReplaceAllUsesWith(cast, LLVMBuildIntCast2(r->build, answer, to, 1, ""));
    LLVMInstructionEraseFromParent(cast);
}

static void rewrite_load(struct rewriting *r, LLVMValueRef load)
{
    LLVMTypeRef type = LLVMTypeOf(load);
    if (LLVMGetTypeKind(type) != LLVMIntegerTypeKind || LLVMGetIntTypeWidth(type) % 8 != 0 ||
        LLVMGetIntTypeWidth(type) > 64 || are_only_carried(load))
        return;
    stand_before(r, load);
    LLVMValueRef at = LLVMGetOperand(load, 0);
    LLVMValueRef argument[3] = {LLVMBuildPointerCast(r->build, at, r->text, ""),
                                whole(r->i32, LLVMGetIntTypeWidth(type) / 8),
                                whole(r->i32, (unsigned)is_by_name(r, at, LLVMGetIntTypeWidth(type) / 8))};
    called(r, "cagd_code_look", r->nothing, 3, argument);
}

/* The name of the variable that is stored to, or of that whose pointer leads there; without what clang adds to parameters. */
static void name_of_address(LLVMValueRef at, size_t room, char name[])
{
    size_t length;
    for (;;) {
        const char *own = LLVMGetValueName2(at, &length);
        snprintf(name, room, "%.*s", (int)length, own);
        if (LLVMIsALoadInst(at) || LLVMIsABitCastInst(at) || is_element_pointer(at))
            at = LLVMGetOperand(at, 0);
        else
            break;
    }
    char *end = strstr(name, PARAMETER);
    if (end != NULL)
        *end = 0;
}

/* What clang puts into a variable before its first value. */
static int is_filling(LLVMValueRef x)
{
    LLVMBool lost;
    double d = LLVMIsAConstantFP(x) ? LLVMConstRealGetDouble(x, &lost) : 0;
    return d != d;
}

/* At the store: what number it puts where. */
static void note_store(struct rewriting *r, LLVMValueRef store)
{
    LLVMValueRef x = LLVMGetOperand(store, 0);
    char name[200];
    if (!r->notes_stores || !is_carried(LLVMTypeOf(x)) || is_vector(LLVMTypeOf(x)) || is_filling(x))
        return;
    stand_before(r, store);
    name_of_address(LLVMGetOperand(store, 1), sizeof name, name);
    called(r, "cagd_code_stored", r->nothing, 2, (LLVMValueRef[]){widened(r, x), string(r, name)});
}

/* The address that an integer is made of; NULL. */
static LLVMValueRef address_in(LLVMValueRef x)
{
    int is_one = LLVMIsAPtrToIntInst(x) || (LLVMIsAConstantExpr(x) && LLVMGetConstOpcode(x) == LLVMPtrToInt);
    return is_one ? LLVMGetOperand(x, 0) : NULL;
}

/* Two addresses that are ordered, or of which the distance is taken. */
static void look_whether_together(struct rewriting *r, LLVMValueRef instruction)
{
    LLVMValueRef a = LLVMGetOperand(instruction, 0), b = LLVMGetOperand(instruction, 1);
    if (LLVMGetInstructionOpcode(instruction) == LLVMSub) {
        a = address_in(a);
        b = address_in(b);
    } else if (LLVMGetICmpPredicate(instruction) == LLVMIntEQ || LLVMGetICmpPredicate(instruction) == LLVMIntNE) {
        return;
    }
    if (a == NULL || b == NULL || LLVMGetTypeKind(LLVMTypeOf(a)) != LLVMPointerTypeKind)
        return;
    stand_before(r, instruction);
    called(r, "cagd_code_together", r->nothing, 2, (LLVMValueRef[]){as_bytes(r, a), as_bytes(r, b)});
}

/* ---- the module --------------------------------------------------------------------------------------- */

static void rewrite_instruction(struct rewriting *r, LLVMValueRef instruction)
{
    switch (LLVMGetInstructionOpcode(instruction)) {
    case LLVMFAdd:
        rewrite_operation(r, instruction, "cagd_code_add", 2, 0);
        break;
    case LLVMFSub:
        rewrite_operation(r, instruction, "cagd_code_sub", 2, 0);
        break;
    case LLVMFMul:
        rewrite_operation(r, instruction, "cagd_code_mul", 2, 0);
        break;
    case LLVMFDiv:
        rewrite_operation(r, instruction, "cagd_code_div", 2, 0);
        break;
    case LLVMFRem:
        rewrite_operation(r, instruction, "cagd_code_lib_fmod", 2, 0);
        break;
    case LLVMFNeg:
        rewrite_operation(r, instruction, "cagd_code_neg", 1, 0);
        break;
    case LLVMFCmp:
        rewrite_operation(r, instruction, COMPARE, 2, (int)LLVMGetFCmpPredicate(instruction));
        break;
    case LLVMFPToSI:
        rewrite_operation(r, instruction, TO_SIGNED, 1, 0);
        break;
    case LLVMFPToUI:
        rewrite_operation(r, instruction, TO_UNSIGNED, 1, 0);
        break;
    case LLVMSIToFP:
        rewrite_operation(r, instruction, FROM_SIGNED, 1, 0);
        break;
    case LLVMUIToFP:
        rewrite_operation(r, instruction, FROM_UNSIGNED, 1, 0);
        break;
    case LLVMFPTrunc:
    case LLVMFPExt:
        rewrite_operation(r, instruction, RESIZE, 1, 0);
        break;
    case LLVMBitCast:
        rewrite_bits(r, instruction);
        break;
    case LLVMLoad:
        look_at_access(r, instruction, LLVMGetOperand(instruction, 0), LLVMTypeOf(instruction), 0);
        rewrite_load(r, instruction);
        break;
    case LLVMStore:
        look_at_access(r, instruction, LLVMGetOperand(instruction, 1), LLVMTypeOf(LLVMGetOperand(instruction, 0)), 1);
        note_store(r, instruction);
        break;
    case LLVMICmp:
    case LLVMSub:
        look_whether_together(r, instruction);
        break;
    case LLVMAtomicCmpXchg:
        look_at_access(r, instruction, LLVMGetOperand(instruction, 0), LLVMTypeOf(LLVMGetOperand(instruction, 1)), 1);
        break;
    case LLVMGetElementPtr:
        rewrite_element_pointer(r, instruction);
        break;
    case LLVMAtomicRMW:
        look_at_access(r, instruction, LLVMGetOperand(instruction, 0), LLVMTypeOf(instruction), 1);
        if (is_floating(LLVMTypeOf(instruction))) {
            stand_before(r, instruction);
            refuse(r, "an atomic operation on a number");
        }
        break;
    case LLVMAlloca:
        widen_local(r, instruction);
        break;
    case LLVMCall:
    case LLVMInvoke:
        rewrite_call(r, instruction);
        break;
    default:
        break;
    }
}

/* Functions that are declared alone: ours by another name, known to be harmless, or refused once they are called. */
static void settle_declaration(struct rewriting *r, LLVMValueRef function)
{
    static const char *const ours[] = {
#define ONE(name)   #name, #name "f", #name "l",
#define OTHER(name) #name,
        CAGD_CODE_ONE(ONE) CAGD_CODE_TWO(ONE) CAGD_CODE_OTHER(OTHER)};
    static const char *const native[] = {CAGD_CODE_NATIVE(OTHER)};
    static const char *const never[] = {CAGD_CODE_REFUSED_NAMES(OTHER)};
#undef ONE
#undef OTHER
    char name[256], renamed[300];
    size_t length;
    snprintf(name, sizeof name, "%s", LLVMGetValueName2(function, &length));
    if (strncmp(name, "llvm.", 5) == 0 || strncmp(name, "cagd_code_", 10) == 0)
        return;
    LLVMTypeRef type = LLVMGlobalGetValueType(function);
    int carried = 1; /* no long double of 80 bits among the arguments */
    LLVMTypeRef types[256];
    if (LLVMCountParamTypes(type) <= 256) {
        LLVMGetParamTypes(type, types);
        for (unsigned k = 0; k < LLVMCountParamTypes(type); k++)
            carried = carried && (!is_floating(types[k]) || is_carried(types[k]));
    }
    for (size_t k = 0; carried && k < sizeof ours / sizeof *ours; k++)
        if (strcmp(name, ours[k]) == 0) {
            snprintf(renamed, sizeof renamed, "cagd_code_lib_%s", name);
            LLVMValueRef ready = LLVMGetNamedFunction(r->module, renamed);
            if (ready == NULL)
                LLVMSetValueName2(function, renamed, strlen(renamed));
            else
                LLVMReplaceAllUsesWith(function, LLVMConstBitCast(ready, LLVMTypeOf(function)));
            return;
        }
    for (size_t k = 0; k < sizeof native / sizeof *native; k++)
        if (strcmp(name, native[k]) == 0)
            return;
    int known = r->is_in_a_library(name), refused = takes_numbers(type);
    for (size_t k = 0; k < sizeof never / sizeof *never; k++)
        refused = refused || strcmp(name, never[k]) == 0;
    if (known && !refused) {
        r->is_alone = 0;
        return;
    }
    snprintf(renamed, sizeof renamed, "the function %s%s", name, known ? "" : ", which is not in the sources");
    LLVMSetLinkage(function, LLVMInternalLinkage);
    LLVMPositionBuilderAtEnd(r->build, LLVMAppendBasicBlockInContext(r->context, function, ""));
    refuse(r, renamed);
    LLVMBuildUnreachable(r->build);
}

/* Each value of the list, taken before anything is added to it; NULL at the end.  The caller frees it. */
static LLVMValueRef *listed(LLVMValueRef first, LLVMValueRef (*next)(LLVMValueRef))
{
    size_t count = 0;
    for (LLVMValueRef v = first; v != NULL; v = next(v))
        count++;
    LLVMValueRef *list = calloc(count + 1, sizeof(LLVMValueRef));
    if (list == NULL)
        exit(3);
    count = 0;
    for (LLVMValueRef v = first; v != NULL; v = next(v))
        list[count++] = v;
    return list;
}

static void rewrite_function(struct rewriting *r, LLVMValueRef function)
{
    for (LLVMBasicBlockRef block = LLVMGetFirstBasicBlock(function); block != NULL;
         block = LLVMGetNextBasicBlock(block)) {
        LLVMValueRef *list = listed(LLVMGetFirstInstruction(block), LLVMGetNextInstruction);
        for (size_t k = 0; list[k] != NULL; k++)
            rewrite_instruction(r, list[k]);
        free(list);
    }
}

void cagd_code_rewrite(LLVMModuleRef module, int (*is_in_a_library)(const char *name), int notes_stores)
{
    struct rewriting r = {.module = module,
                          .context = LLVMGetModuleContext(module),
                          .is_in_a_library = is_in_a_library,
                          .notes_stores = notes_stores,
                          .is_alone = 1};
    r.build = LLVMCreateBuilderInContext(r.context);
    r.i1 = LLVMInt1TypeInContext(r.context);
    r.i8 = LLVMInt8TypeInContext(r.context);
    r.i32 = LLVMInt32TypeInContext(r.context);
    r.i64 = LLVMInt64TypeInContext(r.context);
    r.real = LLVMDoubleTypeInContext(r.context);
    r.single = LLVMFloatTypeInContext(r.context);
    r.nothing = LLVMVoidTypeInContext(r.context);
    r.text = LLVMPointerType(r.i8, 0);
    LLVMTypeRef member[3] = {r.text, r.text, r.i32};
    r.place = LLVMStructTypeInContext(r.context, member, 3, 0);
    r.at = LLVMAddGlobal(module, LLVMPointerType(r.place, 0), "cagd_code_at");

    r.layout = LLVMGetModuleDataLayout(module);
    LLVMValueRef begin = first_constructor(&r);
    LLVMValueRef *globals = listed(LLVMGetFirstGlobal(module), LLVMGetNextGlobal);
    LLVMValueRef *functions = listed(LLVMGetFirstFunction(module), LLVMGetNextFunction);
    for (size_t k = 0; globals[k] != NULL; k++) {
        r.is_alone = r.is_alone && (globals[k] == r.at || !LLVMIsDeclaration(globals[k]));
        widen_global(&r, globals[k], begin);
    }
    for (size_t k = 0; functions[k] != NULL; k++)
        if (LLVMIsDeclaration(functions[k]))
            settle_declaration(&r, functions[k]);
    for (size_t k = 0; functions[k] != NULL; k++)
        rewrite_function(&r, functions[k]);
    free(globals);
    free(functions);
    if (r.is_alone)
        LLVMSetInitializer(LLVMAddGlobal(module, r.i8, "cagd_code_is_alone"), whole(r.i8, 1));
    LLVMStripModuleDebugInfo(module);
    LLVMDisposeBuilder(r.build);
}
