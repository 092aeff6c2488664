// SPDX-License-Identifier: BSD-3-Clause
// Many runs on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace vdamf
{
/// Calls `work` with 0 to count - 1, in this order, on `jobs` threads; `work` throws nothing.
void sideBySide(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work);

}  // namespace vdamf
