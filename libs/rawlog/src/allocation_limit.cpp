// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/allocation_limit.h"

namespace vdamf
{
namespace
{
thread_local std::size_t largestAllowed = AllocationLimit::kNone;
thread_local std::size_t leftOfSum = AllocationLimit::kNone;
}  // namespace

AllocationLimit::AllocationLimit(std::size_t bytes, std::size_t sum)
    : largestBefore_(largestAllowed), leftBefore_(leftOfSum)
{
    largestAllowed = bytes;
    leftOfSum = sum;
}

AllocationLimit::~AllocationLimit()
{
    largestAllowed = largestBefore_;
    leftOfSum = leftBefore_;
}

std::size_t AllocationLimit::current() noexcept
{
    return largestAllowed;
}

bool AllocationLimit::take(std::size_t bytes) noexcept
{
    if (bytes > largestAllowed || bytes > leftOfSum) return false;
    if (leftOfSum != kNone) leftOfSum -= bytes;
    return true;
}

}  // namespace vdamf
