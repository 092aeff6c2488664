// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
constexpr double kDegrees = 180.0 / kPi;  // of a radian

}  // namespace vdamf
