// SPDX-License-Identifier: BSD-3-Clause
#include "discrimination/pair_features.h"

#include <array>
#include <optional>

#include "discrimination/knots.h"

namespace vdamf
{
namespace
{
constexpr double kLength[] = {0.3, 1.0, 1.8, 3.0, 4.3, 6.0, 11.0};
constexpr double kWidth[] = {0.2, 0.8, 1.4, 1.8, 2.5};
constexpr double kTop[] = {0.6, 1.1, 1.4, 1.7, 2.1, 2.7, 3.0};
constexpr double kBottom[] = {0.22, 0.5, 1.0};
constexpr double kShoulder[] = {0.5, 0.9, 1.2, 1.5, 2.0, 2.6};
constexpr double kMiddle[] = {0.3, 0.6, 0.9, 1.3, 2.0};
constexpr double kColumns[] = {0.1, 0.3, 0.6, 1.0, 1.6};
constexpr double kHigh[] = {0.0, 0.05, 0.2, 0.6};
constexpr double kOutside[] = {0.0, 0.1, 0.3, 0.7};
constexpr double kDensity[] = {-3.0, -1.5, -0.5, 0.5, 1.5};
constexpr double kBearing[] = {0.0, 0.3, 0.8, 1.3, 1.57};
constexpr double kBreadth[] = {0.5, 1.2, 2.0, 4.0, 8.0};
constexpr double kCoverage[] = {0.3, 0.6, 0.85, 1.0};
constexpr double kDepth[] = {0.02, 0.1, 0.25, 0.6};
constexpr double kShare[] = {0.0, 0.3, 0.7, 1.0};
constexpr double kStraightness[] = {0.01, 0.05, 0.12, 0.3};
constexpr double kMatch[] = {0.0, 0.3, 0.6, 1.0};

enum class Needs
{
    Nothing,
    Heights,
    LowHits
};

struct Number
{
    const char* name;
    Knots knots;
    Needs needs;
    double (*of)(const Descriptors&);
};

const std::array<Number, 19> kNumbers = {{
    {"length", knotsOf(kLength), Needs::Nothing, [](const Descriptors& d) { return d.length; }},
    {"width", knotsOf(kWidth), Needs::Nothing, [](const Descriptors& d) { return d.width; }},
    {"outside", knotsOf(kOutside), Needs::Nothing, [](const Descriptors& d) { return d.outside; }},
    {"beyond", knotsOf(kOutside), Needs::Nothing, [](const Descriptors& d) { return d.beyond; }},
    {"density", knotsOf(kDensity), Needs::Nothing, [](const Descriptors& d) { return d.density; }},
    {"bearing", knotsOf(kBearing), Needs::Nothing, [](const Descriptors& d) { return d.bearing; }},
    {"breadth", knotsOf(kBreadth), Needs::Nothing, [](const Descriptors& d) { return d.breadth; }},
    {"coverage", knotsOf(kCoverage), Needs::Nothing,
     [](const Descriptors& d) { return d.coverage; }},
    {"match", knotsOf(kMatch), Needs::Nothing, [](const Descriptors& d) { return d.match; }},
    {"depth", knotsOf(kDepth), Needs::LowHits, [](const Descriptors& d) { return d.low->depth; }},
    {"near", knotsOf(kShare), Needs::LowHits, [](const Descriptors& d) { return d.low->near; }},
    {"straightness", knotsOf(kStraightness), Needs::LowHits,
     [](const Descriptors& d) { return d.low->straightness; }},
    {"on_side", knotsOf(kShare), Needs::LowHits,
     [](const Descriptors& d) { return d.low->onSide; }},
    {"top", knotsOf(kTop), Needs::Heights, [](const Descriptors& d) { return d.top; }},
    {"shoulder", knotsOf(kShoulder), Needs::Heights,
     [](const Descriptors& d) { return d.shoulder; }},
    {"middle", knotsOf(kMiddle), Needs::Heights, [](const Descriptors& d) { return d.middle; }},
    {"bottom", knotsOf(kBottom), Needs::Heights, [](const Descriptors& d) { return d.bottom; }},
    {"columns", knotsOf(kColumns), Needs::Heights, [](const Descriptors& d) { return d.columns; }},
    {"high", knotsOf(kHigh), Needs::Heights, [](const Descriptors& d) { return d.high; }},
}};

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

Layout makeLayout()
{
    Layout layout;
    for (const bool planar : {false, true})
        for (std::size_t i = 0; i < kNumbers.size(); ++i)
            for (std::size_t j = i + 1; j < kNumbers.size(); ++j)
            {
                const Number& a = kNumbers[i];
                const Number& b = kNumbers[j];
                if (planar && (a.needs == Needs::Heights || b.needs == Needs::Heights)) continue;
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

std::optional<KnotPlace> placeIn(const Number& number, const Descriptors& d, bool planar)
{
    if (number.needs == Needs::LowHits && !d.low) return std::nullopt;
    if (number.needs == Needs::Heights && planar) return std::nullopt;
    return placeOf(number.knots, number.of(d));
}
// Calls each(first, rowSize, a, b) for the pairs of the descriptors that an object has: the feature
// of the two lower knots, knots of the second one, shares of the upper knots of both.
template <class Each>
void forEachPair(const Descriptors& descriptors, bool planar, Each each)
{
    std::array<std::optional<KnotPlace>, kNumbers.size()> places;
    for (std::size_t i = 0; i < kNumbers.size(); ++i)
        places[i] = placeIn(kNumbers[i], descriptors, planar);
    for (const Pair& pair : planar ? layout().planar : layout().all)
    {
        const auto& a = places[pair.first];
        const auto& b = places[pair.second];
        if (!a || !b) continue;
        const std::size_t rowSize = kNumbers[pair.second].knots.count;
        each(pair.begin + a->below * rowSize + b->below, rowSize, a->shareAbove, b->shareAbove);
    }
}

// The many pairs are not to drown the cells.
constexpr double kScale = 0.5;
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
                    const double above = kScale * a;
                    const double below = kScale - above;
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
    return kScale * score;
}

}  // namespace vdamf
