// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace vdamf
{
/// Accelerations and steering rates hold for about this long before they change, s.
constexpr double kHold = 0.1;

}  // namespace vdamf
