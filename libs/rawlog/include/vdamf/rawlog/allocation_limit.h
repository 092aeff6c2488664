// SPDX-License-Identifier: BSD-3-Clause
// Keeps a corrupt recording from eating the memory.
#pragma once

#include <cstddef>
#include <limits>

namespace vdamf
{
/// While it lives, no single allocation of this thread may be larger than `bytes`, nor may all of
/// them together, those given back included, be larger than `sum`: what is beyond throws
/// std::bad_alloc. MRPT sizes its containers by numbers from the file, so a flipped bit may ask for
/// tens of gigabytes, in one piece or in millions.
///
/// It works only in programs that link the object library `vdamf_allocation_guard`, which replaces
/// the global operator new: the programs of this project do. Elsewhere it does nothing, because
/// operator new belongs to the program, not to a library. Limits nest; the inner one counts.
class AllocationLimit
{
public:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    explicit AllocationLimit(std::size_t bytes, std::size_t sum = kNone);
    ~AllocationLimit();
    AllocationLimit(const AllocationLimit&) = delete;
    AllocationLimit& operator=(const AllocationLimit&) = delete;

    /// The limit of one allocation in force in this thread, bytes; kNone where there is none.
    static std::size_t current() noexcept;
    /// Counts an allocation; false where it must not be. For the guard.
    static bool take(std::size_t bytes) noexcept;

private:
    std::size_t largestBefore_;
    std::size_t leftBefore_;
};

}  // namespace vdamf
