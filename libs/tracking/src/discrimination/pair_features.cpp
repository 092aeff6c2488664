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

constexpr double kThickness[] = {0.01, 0.035, 0.08, 0.15, 0.35};
constexpr double kBend[] = {0.03, 0.1, 0.2, 0.35, 0.7};
constexpr double kSlope[] = {-0.2, 0.0, 0.05, 0.15, 0.4};
constexpr double kRagged[] = {0.0, 0.02, 0.08, 0.3, 1.0};
constexpr double kLowWidth[] = {0.1, 0.5, 1.2, 1.8, 2.6};
constexpr double kHighWidth[] = {0.15, 0.7, 1.3, 1.8, 3.0};

enum class Needs
{
    Nothing,
    Heights
};

struct Number
{
    const char* name;
    Knots knots;
    Needs needs;
    std::optional<double> (*of)(const Descriptors&);
};

template <auto number>
std::optional<double> ofLowHits(const Descriptors& d)
{
    if (!d.low) return std::nullopt;
    return (*d.low).*number;
}

template <auto number>
std::optional<double> direct(const Descriptors& d)
{
    return d.*number;
}

template <auto number>
std::optional<double> ofSilhouette(const Descriptors& d)
{
    return d.silhouette.*number;
}

using D = Descriptors;
using L = Descriptors::LowHits;
using S = Silhouette;

constexpr std::array<Number, 25> kNumbers = {{
    {"length", knotsOf(kLength), Needs::Nothing, direct<&D::length>},
    {"width", knotsOf(kWidth), Needs::Nothing, direct<&D::width>},
    {"outside", knotsOf(kOutside), Needs::Nothing, direct<&D::outside>},
    {"beyond", knotsOf(kOutside), Needs::Nothing, direct<&D::beyond>},
    {"density", knotsOf(kDensity), Needs::Nothing, direct<&D::density>},
    {"bearing", knotsOf(kBearing), Needs::Nothing, direct<&D::bearing>},
    {"breadth", knotsOf(kBreadth), Needs::Nothing, ofSilhouette<&S::breadth>},
    {"coverage", knotsOf(kCoverage), Needs::Nothing, ofSilhouette<&S::coverage>},
    {"thickness", knotsOf(kThickness), Needs::Nothing, ofSilhouette<&S::thickness>},
    {"bend", knotsOf(kBend), Needs::Nothing, ofSilhouette<&S::bend>},
    {"match", knotsOf(kMatch), Needs::Nothing, direct<&D::match>},
    {"depth", knotsOf(kDepth), Needs::Nothing, ofLowHits<&L::depth>},
    {"near", knotsOf(kShare), Needs::Nothing, ofLowHits<&L::near>},
    {"straightness", knotsOf(kStraightness), Needs::Nothing, ofLowHits<&L::straightness>},
    {"on_side", knotsOf(kShare), Needs::Nothing, ofLowHits<&L::onSide>},
    {"top", knotsOf(kTop), Needs::Heights, direct<&D::top>},
    {"shoulder", knotsOf(kShoulder), Needs::Heights, direct<&D::shoulder>},
    {"middle", knotsOf(kMiddle), Needs::Heights, direct<&D::middle>},
    {"bottom", knotsOf(kBottom), Needs::Heights, direct<&D::bottom>},
    {"columns", knotsOf(kColumns), Needs::Heights, direct<&D::columns>},
    {"high", knotsOf(kHigh), Needs::Heights, direct<&D::high>},
    {"slope", knotsOf(kSlope), Needs::Heights, ofSilhouette<&S::slope>},
    {"ragged", knotsOf(kRagged), Needs::Heights, ofSilhouette<&S::ragged>},
    {"low_width", knotsOf(kLowWidth), Needs::Heights, direct<&D::lowWidth>},
    {"high_width", knotsOf(kHighWidth), Needs::Heights, direct<&D::highWidth>},
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
