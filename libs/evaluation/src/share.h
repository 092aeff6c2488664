// SPDX-License-Identifier: BSD-3-Clause
// Shares of a whole that may be nothing.
#pragma once

#include <limits>

namespace vdamf
{
/// Not a number where there is no whole.
inline double share(double part, double whole)
{
    return whole > 0.0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace vdamf
