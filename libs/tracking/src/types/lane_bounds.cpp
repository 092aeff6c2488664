// SPDX-License-Identifier: BSD-3-Clause
#include "types/lane_bounds.h"

#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
// `keep(number, best)` keeps the better one in the second, of numbers and of lanes of them.
template <class Keep>
float bestOf(const float* numbers, std::size_t count, Keep keep)
{
    float best = *numbers;
    inWideLanes([ numbers, count, keep, result = &best ]() __attribute__((always_inline)) {
        Floats each = Floats{} + *result;
        const auto add = [&](std::size_t first, std::size_t size) __attribute__((always_inline))
        {
            Floats next;
            loadRepeating(next, numbers + first, size);
            keep(next, each);
        };
        inGroupsOf<kLanes<Floats>>(count, add);
        for (std::size_t k = 0; k < kLanes<Floats>; ++k) keep(each[k], *result);
    });
    return best;
}
}  // namespace

float leastOf(const float* numbers, std::size_t count)
{
    return bestOf(
        numbers, count, [](const auto& a, auto& best) __attribute__((always_inline)) {
            best = a < best ? a : best;
        });
}

float greatestOf(const float* numbers, std::size_t count)
{
    return bestOf(
        numbers, count, [](const auto& a, auto& best) __attribute__((always_inline)) {
            best = a > best ? a : best;
        });
}

}  // namespace vdamf
