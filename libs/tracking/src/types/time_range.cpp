// SPDX-License-Identifier: BSD-3-Clause
#include "types/time_range.h"

#include <algorithm>

#include "types/lanes.h"

namespace vdamf
{
TimeRange timeRangeOf(const std::vector<float>& times)
{
    constexpr std::size_t kEach = kLanes<Floats>;
    TimeRange range;
    Floats first = Floats{} + range.first;
    Floats last = Floats{} + range.last;
    inGroupsOf<kEach>(times.size(),
                      [&](std::size_t i, std::size_t count)
                      {
                          Floats t;
                          load(t, &times[i], count);
                          const auto counts =
                              (t - t == 0.0F) & (kLaneNumbers < static_cast<float>(count));
                          first = counts & (t < first) ? t : first;
                          last = counts & (t > last) ? t : last;
                      });
    for (std::size_t k = 0; k < kEach; ++k)
    {
        range.first = std::min(range.first, first[k]);
        range.last = std::max(range.last, last[k]);
    }
    return range;
}

}  // namespace vdamf
