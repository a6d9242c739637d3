#pragma once
// Arrays of a million entries and more: where pages are new, touching them costs as much as what fills them.

#include <sys/mman.h>

#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

namespace reliefbake {

/// Asks for huge pages where they help, and leaves trivial entries uninitialised in resize().
template <class T>
struct LargeAllocator {
    using value_type = T;
    static constexpr std::size_t page = std::size_t(2) << 20, large = 4 * page; ///< bytes

    LargeAllocator() = default;
    template <class U>
    LargeAllocator(const LargeAllocator<U>&) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (bytes < large) return static_cast<T*>(::operator new(bytes));
        const std::size_t whole = (bytes + page - 1) / page * page;
        void* memory = std::aligned_alloc(page, whole);
        if (!memory) throw std::bad_alloc();
        ::madvise(memory, whole, MADV_HUGEPAGE); // a wish: without it all works as well
        return static_cast<T*>(memory);
    }

    void deallocate(T* memory, std::size_t count) {
        if (count * sizeof(T) < large) ::operator delete(memory);
        else std::free(memory);
    }

    template <class U>
    void construct(U* place) {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Args>
    void construct(U* place, Args&&... args) {
        ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
    }

    friend bool operator==(const LargeAllocator&, const LargeAllocator&) { return true; }
};

template <class T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

} // namespace reliefbake
