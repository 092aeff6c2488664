// SPDX-License-Identifier: BSD-3-Clause
#include "discrimination/pair_features.h"

#include <array>
#include <optional>

#include "discrimination/descriptor_numbers.h"

namespace vdamf
{
namespace
{
struct Pair
{
    std::size_t first;
    std::size_t second;
    std::size_t begin;  // of its features
};

struct Layout
{
    std::vector<PairBlock> blocks;
    std::vector<Pair> all;
    std::vector<Pair> planar;
    std::size_t size = 0;
};

bool isPair(const DescriptorNumber& a, const DescriptorNumber& b, bool planar)
{
    if (planar && (a.needs == Needs::Heights || b.needs == Needs::Heights)) return false;
    const auto isBandWithOther = [](Role first, Role second)
    { return first == Role::Band && second == Role::Other; };
    return !isBandWithOther(a.role, b.role) && !isBandWithOther(b.role, a.role);
}

Layout makeLayout()
{
    const auto& numbers = descriptorNumbers();
    Layout layout;
    for (const bool planar : {false, true})
        for (std::size_t i = 0; i < numbers.size(); ++i)
            for (std::size_t j = i + 1; j < numbers.size(); ++j)
            {
                const DescriptorNumber& a = numbers[i];
                const DescriptorNumber& b = numbers[j];
                if (!isPair(a, b, planar)) continue;
                (planar ? layout.planar : layout.all).push_back({i, j, layout.size});
                const std::size_t size = a.knots.count * b.knots.count;
                layout.blocks.push_back(
                    {std::string(planar ? "flat_" : "") + a.name + '_' + b.name, size});
                layout.size += size;
            }
    return layout;
}

const Layout& layout()
{
    static const Layout kLayout = makeLayout();
    return kLayout;
}

std::optional<KnotPlace> placeIn(const DescriptorNumber& number, const Descriptors& d, bool planar)
{
    if (number.needs == Needs::Heights && planar) return std::nullopt;
    const std::optional<double> value = number.of(d);
    if (!value) return std::nullopt;
    return placeOf(number.knots, *value);
}

// Calls each(first, rowSize, a, b) for the pairs of the descriptors that an object has: the feature
// of the two lower knots, knots of the second one, shares of the upper knots of both.
template <class Each>
void forEachPair(const Descriptors& descriptors, bool planar, Each each)
{
    const auto& numbers = descriptorNumbers();
    std::array<std::optional<KnotPlace>, kDescriptorNumbers> places;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        places[i] = placeIn(numbers[i], descriptors, planar);
    for (const Pair& pair : planar ? layout().planar : layout().all)
    {
        const auto& a = places[pair.first];
        const auto& b = places[pair.second];
        if (!a || !b) continue;
        const std::size_t rowSize = numbers[pair.second].knots.count;
        each(pair.begin + a->below * rowSize + b->below, rowSize, a->shareAbove, b->shareAbove);
    }
}

// The many pairs are not to drown the cells.
constexpr double kPairScale = 0.5;
}  // namespace

const std::vector<PairBlock>& pairBlocks()
{
    return layout().blocks;
}

std::size_t pairFeatureCount()
{
    return layout().size;
}

void putPairs(const Descriptors& descriptors, bool planar, float* features)
{
    forEachPair(descriptors, planar,
                [&](std::size_t first, std::size_t rowSize, double a, double b)
                {
                    float* const row = features + first;
                    const double above = kPairScale * a;
                    const double below = kPairScale - above;
                    row[0] += static_cast<float>(below * (1.0 - b));
                    row[1] += static_cast<float>(below * b);
                    row[rowSize] += static_cast<float>(above * (1.0 - b));
                    row[rowSize + 1] += static_cast<float>(above * b);
                });
}

double pairScore(const Descriptors& descriptors, bool planar, const double* weights)
{
    double score = 0.0;
    forEachPair(descriptors, planar,
                [&](std::size_t first, std::size_t rowSize, double a, double b)
                {
                    const double* const row = weights + first;
                    const double below = row[0] + b * (row[1] - row[0]);
                    const double above = row[rowSize] + b * (row[rowSize + 1] - row[rowSize]);
                    score += below + a * (above - below);
                });
    return kPairScale * score;
}

}  // namespace vdamf
