// Counts what a whole program allocates, by replacing the operator. For the one source of a test program: the operators
// may be defined once only. Qt's own allocations are counted, too, so nothing of Qt may stand between two looks.
// Not inlined: GCC 12 would take free for the wrong partner of new.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

inline std::size_t allocations = 0;

[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* const memory = std::malloc(size))
        return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
