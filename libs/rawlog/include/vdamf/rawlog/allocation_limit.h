// SPDX-License-Identifier: BSD-3-Clause
// Keeps a corrupt recording from eating the memory.
#pragma once

#include <cstddef>

namespace vdamf
{
/// While it lives, no single allocation of this thread may be larger than `bytes`; larger ones
/// throw std::bad_alloc. MRPT sizes its vectors by numbers from the file, so a flipped bit may ask
/// for tens of gigabytes.
///
/// It works only in programs that link the object library `vdamf_allocation_guard`, which replaces
/// the global operator new: the programs of this project do. Elsewhere it does nothing, because
/// operator new belongs to the program, not to a library. Limits nest; the inner one counts.
class AllocationLimit
{
public:
    explicit AllocationLimit(std::size_t bytes);
    ~AllocationLimit();
    AllocationLimit(const AllocationLimit&) = delete;
    AllocationLimit& operator=(const AllocationLimit&) = delete;

    /// The limit in force in this thread, bytes; the largest number where there is none.
    static std::size_t current() noexcept;

private:
    std::size_t before_;
};

}  // namespace vdamf
