/* test_memory_new.cpp -- the operator new of test_memory.c, which throws where an allocation is to fail. */
#include <cstdlib>
#include <exception>
#include <new>
#include <unistd.h>

/* Those of test_memory.c: whether the next allocation is to fail, and malloc and free as they are.  Blocks are not counted, because
 * Ceres does not give all of its own back when it is interrupted. */
extern "C" int refuses();
extern "C" void *__real_malloc(std::size_t size);
extern "C" void __real_free(void *block);

void *operator new(std::size_t size)
{
    void *block = refuses() ? nullptr : __real_malloc(size > 0 ? size : 1);
    if (block == nullptr)
        throw std::bad_alloc();
    return block;
}

void operator delete(void *block) noexcept { __real_free(block); }
void operator delete(void *block, std::size_t) noexcept { __real_free(block); }

namespace
{

/* An exception that nobody catches is the current one; one that a destructor would let out is not, and ends the trial as LOST. */
[[noreturn]] void terminate()
{
    if (!std::current_exception())
        _exit(3);
    std::abort();
}

const std::terminate_handler before = std::set_terminate(terminate);

} // namespace
