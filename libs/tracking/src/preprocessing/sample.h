// SPDX-License-Identifier: BSD-3-Clause
// Some of a frame's hits, where those are enough to tell.
#pragma once

#include <cstddef>

namespace vdamf
{
/// From one hit to the next of a sample of some four thousand. Odd: rings come by powers of two.
constexpr std::size_t sampleStep(std::size_t hits)
{
    return (hits / 4000) | 1U;
}

}  // namespace vdamf
