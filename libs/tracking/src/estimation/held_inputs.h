// SPDX-License-Identifier: BSD-3-Clause
// What vehicles do to their motion, as models take it.
#pragma once

namespace vdamf
{
/// Accelerations and steering rates hold for about this long before they change, s.
inline constexpr double kHold = 0.1;

}  // namespace vdamf
