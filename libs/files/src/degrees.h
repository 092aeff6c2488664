// SPDX-License-Identifier: BSD-3-Clause
// Degrees of ini files, radians inside.
#pragma once

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
inline double radians(double degrees)
{
    return degrees * kPi / 180.0;
}
inline double degrees(double radians)
{
    return radians * 180.0 / kPi;
}

}  // namespace vdamf
