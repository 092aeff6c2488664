// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/allocation_limit.h"

#include <limits>

namespace vdamf
{
namespace
{
thread_local std::size_t limitOfThread = std::numeric_limits<std::size_t>::max();
}  // namespace

AllocationLimit::AllocationLimit(std::size_t bytes) : before_(limitOfThread)
{
    limitOfThread = bytes;
}

AllocationLimit::~AllocationLimit()
{
    limitOfThread = before_;
}

std::size_t AllocationLimit::current() noexcept
{
    return limitOfThread;
}

}  // namespace vdamf
