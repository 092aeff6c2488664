// SPDX-License-Identifier: BSD-3-Clause
// Makes AllocationLimit effective: replaces the global operator new and delete, and MRPT's
// aligned_malloc(), whose callers do not check for null. Part of programs only, never of a library.
#include <mrpt/core/aligned_allocator.h>

#include <cstdlib>
#include <cstring>
#include <new>

#include "vdamf/rawlog/allocation_limit.h"

namespace
{
void* allocate(std::size_t size, std::size_t alignment)
{
    if (!vdamf::AllocationLimit::take(size)) throw std::bad_alloc();
    const bool ordinary = alignment <= alignof(std::max_align_t);
    // aligned_alloc() wants whole multiples of the alignment.
    const std::size_t whole = ordinary ? size : (size + alignment - 1) / alignment * alignment;
    if (whole < size) throw std::bad_alloc();
    for (;;)
    {
        const std::size_t atLeastOne = whole == 0 ? 1 : whole;
        void* memory =
            ordinary ? std::malloc(atLeastOne) : std::aligned_alloc(alignment, atLeastOne);
        if (memory != nullptr) return memory;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}
}  // namespace

// The array forms of the standard library call these. So do its nothrow forms, but not those of the
// sanitizers, which would then meet our delete: they are replaced as well.
void* operator new(std::size_t size)
{
    return allocate(size, 0);
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
    return allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    try
    {
        return allocate(size, 0);
    }
    catch (const std::bad_alloc&)
    {
        return nullptr;
    }
}
void operator delete(void* memory) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
    std::free(memory);
}

namespace mrpt
{
void* aligned_malloc(std::size_t size, std::size_t alignment)
{
    return allocate(size, alignment);
}

void* aligned_calloc(std::size_t bytes, std::size_t alignment)
{
    void* memory = allocate(bytes, alignment);
    std::memset(memory, 0, bytes);
    return memory;
}

void aligned_free(void* memory)
{
    std::free(memory);
}
}  // namespace mrpt
