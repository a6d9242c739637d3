#pragma once
// Arrays of a million entries and more: where pages are new, touching them costs as much as what fills them. Some do not fit
// into memory: they live in storage that the caller brings.

#include <sys/mman.h>

#include <cstdlib>
#include <memory_resource>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace reliefbake {

/// Asks for huge pages where they help, and leaves trivial entries uninitialised in resize(). A moved array keeps its storage; a
/// copy lies on the heap.
template <class T>
struct LargeAllocator {
    using value_type = T;
    using propagate_on_container_move_assignment = std::true_type;
    using propagate_on_container_swap = std::true_type;
    using is_always_equal = std::false_type;
    static constexpr std::size_t page = std::size_t(2) << 20, large = 4 * page; ///< bytes

    std::pmr::memory_resource* storage = nullptr; ///< null: the heap

    LargeAllocator() = default;
    explicit LargeAllocator(std::pmr::memory_resource* where) : storage(where) {}
    template <class U>
    LargeAllocator(const LargeAllocator<U>& other) : storage(other.storage) {}
    LargeAllocator select_on_container_copy_construction() const { return {}; }

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (storage) return static_cast<T*>(storage->allocate(bytes, alignof(T)));
        if (bytes < large) return static_cast<T*>(::operator new(bytes, std::align_val_t(alignof(T))));
        const std::size_t whole = (bytes + page - 1) / page * page;
        void* memory = std::aligned_alloc(page, whole);
        if (!memory) throw std::bad_alloc();
        ::madvise(memory, whole, MADV_HUGEPAGE); // a wish: without it all works as well
        return static_cast<T*>(memory);
    }

    void deallocate(T* memory, std::size_t count) {
        if (storage) storage->deallocate(memory, count * sizeof(T), alignof(T));
        else if (count * sizeof(T) < large) ::operator delete(memory, std::align_val_t(alignof(T)));
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

    friend bool operator==(const LargeAllocator& a, const LargeAllocator& b) { return a.storage == b.storage; }
};

template <class T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

} // namespace reliefbake
