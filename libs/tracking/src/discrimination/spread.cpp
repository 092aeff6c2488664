// SPDX-License-Identifier: BSD-3-Clause
#include "discrimination/spread.h"

#include <algorithm>
#include <numeric>

#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
FloatRange rangeOf(const std::vector<float>& values)
{
    FloatRange range{values[0], values[0]};
    inWideLanes([ from = values.data(), size = values.size(), result = &range ]()
                    __attribute__((always_inline)) {
                        Floats low = Floats{} + from[0];
                        Floats high = low;
                        std::size_t i = 0;
                        for (; i + kLanes<Floats> <= size; i += kLanes<Floats>)
                        {
                            Floats v;
                            load(v, from + i);
                            low = v < low ? v : low;
                            high = v > high ? v : high;
                        }
                        FloatRange all{low[0], high[0]};
                        for (std::size_t k = 0; k < kLanes<Floats>; ++k)
                            all = {std::min(all.min, low[k]), std::max(all.max, high[k])};
                        for (; i < size; ++i)
                            all = {std::min(all.min, from[i]), std::max(all.max, from[i])};
                        *result = all;
                    });
    return range;
}

std::vector<std::int32_t> cellNumbers(const std::vector<float>& values, float first, float perMetre,
                                      std::size_t cells)
{
    std::vector<std::int32_t> numbers(values.size());
    inWideLanes([
        =, from = values.data(), size = values.size(), last = static_cast<float>(cells - 1),
        to = numbers.data()
    ]() __attribute__((always_inline)) {
        VDAMF_INDEPENDENT_LANES
        for (std::size_t i = 0; i < size; ++i)
        {
            const float cell = (from[i] - first) * perMetre;
            const float below = cell < last ? cell : last;
            to[i] = static_cast<std::int32_t>(below > 0.0F ? below : 0.0F);
        }
    });
    return numbers;
}

Spread::Spread(const std::vector<float>& values) : size_(values.size())
{
    const FloatRange range = rangeOf(values);
    min_ = range.min;
    max_ = range.max;
    width_ = (max_ - min_) / static_cast<float>(kCells - 1);
    // Else they are all but equal, or so far apart that cells overflow.
    isCounted_ = width_ > 1e-6F && width_ < 1e6F;
    if (!isCounted_) return;
    for (const std::int32_t cell : cellNumbers(values, min_, 1.0F / width_, kCells))
        ++counts_[static_cast<std::size_t>(cell)];
    for (std::size_t block = 0; block < blocks_.size(); ++block)
    {
        const std::uint16_t* const counts = counts_.data() + block * kBlock;
        blocks_[block] = std::accumulate(counts, counts + kBlock, std::uint16_t{0});
    }
}

double Spread::above(double share) const
{
    if (!isCounted_) return min_;
    return min_ + width_ * static_cast<float>(cellOf(rankOf(share)));
}

double Spread::below(double share) const
{
    if (!isCounted_) return max_;
    const std::size_t cell = cellOf(size_ - 1 - rankOf(share));
    return std::min(max_, min_ + width_ * static_cast<float>(cell + 1));
}

std::size_t Spread::rankOf(double share) const
{
    return static_cast<std::size_t>(share * static_cast<double>(size_));
}

// Of the value with so many before it.
std::size_t Spread::cellOf(std::size_t rank) const
{
    std::size_t before = 0;
    std::size_t block = 0;
    while (before + blocks_[block] <= rank) before += blocks_[block++];
    std::size_t cell = block * kBlock;
    while (before + counts_[cell] <= rank) before += counts_[cell++];
    return cell;
}

}  // namespace vdamf
