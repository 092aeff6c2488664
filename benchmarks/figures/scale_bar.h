// SPDX-License-Identifier: BSD-3-Clause
// How long a metre is in a picture.
#pragma once

#include <string>

namespace vdamf
{
/// A bar of `length_m` that ends at a pixel, with its length above it. `scale`: pixels a metre.
std::string scaleBar(double endX, double y, double scale, double length_m);

}  // namespace vdamf
