// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/allocation_limit.h"

namespace vdamf
{
namespace
{
thread_local std::size_t largest = AllocationLimit::kNone;
thread_local std::size_t left = AllocationLimit::kNone;  // of the sum
}  // namespace

AllocationLimit::AllocationLimit(std::size_t bytes, std::size_t sum)
    : largestBefore_(largest), leftBefore_(left)
{
    largest = bytes;
    left = sum;
}

AllocationLimit::~AllocationLimit()
{
    largest = largestBefore_;
    left = leftBefore_;
}

std::size_t AllocationLimit::current() noexcept
{
    return largest;
}

bool AllocationLimit::take(std::size_t bytes) noexcept
{
    if (bytes > largest || bytes > left) return false;
    if (left != kNone) left -= bytes;
    return true;
}

}  // namespace vdamf
