// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/front_by_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "vdamf/tracking/estimation/assumed_size.h"

namespace vdamf
{
namespace
{
// Heights at which windows are looked for, m above the ground, the best first.
constexpr std::array<float, 3> kPaneHeights = {1.2F, 1.1F, 1.0F};
constexpr double kLean = 1.5;         // m that windows of cars recede over a metre of height
constexpr double kHighestCar = 1.7;   // m
constexpr double kLowestVan = 1.9;    // m: between them it may be either
constexpr double kLowestBus = 2.4;    // m: what is as high may be flat at both ends
constexpr double kWidest = 2.3;       // m, of vans
constexpr double kBeforeEnd = 0.5;    // m, hits before an end
constexpr double kBeside = 0.2;       // m, hits beside a side
constexpr double kDeepest = 2.6;      // m: no window of an end begins as far behind it
constexpr double kMostOfShape = 2.5;  // log odds, of one sighting
constexpr double kUnlookedFor = 0.5;  // share of what missing hits tell

// Of a depth behind an end, m.
struct DepthDensity
{
    double mean;
    double sigma;

    double operator()(double depth) const
    {
        const double z = (depth - mean) / sigma;
        return 0.3989422804 / sigma * std::exp(-0.5 * z * z);
    }
};

// Where windows begin behind the front, behind the rear of cars with a tailgate and behind that of
// cars with a boot. By the simulated cars and vans; those of the labelled recordings lie alike.
struct WindowDepths
{
    DepthDensity front;
    DepthDensity tailgate;
    DepthDensity boot;
    double tailgates;  // share of the rears
    double boots;

    double atRear(double depth) const { return tailgates * tailgate(depth) + boots * boot(depth); }
};

// Of an end that is seen. What a row along the side tells of one that is not hangs on its end.
constexpr WindowDepths kSeenOfCar = {{1.45, 0.3}, {0.35, 0.22}, {0.95, 0.3}, 0.55, 0.45};
constexpr WindowDepths kUnseenOfCar = {{1.75, 0.4}, {0.5, 0.3}, {1.3, 0.4}, 0.55, 0.45};
// No van has a boot; no depth is negative, so that all of the density lies on one side.
constexpr WindowDepths kSeenOfVan = {{0.8, 0.35}, {0.0, 0.15}, {0.0, 0.15}, 2.0, 0.0};
constexpr WindowDepths kUnseenOfVan = {{0.9, 0.35}, {0.0, 0.25}, {0.0, 0.25}, 2.0, 0.0};

// Log odds that an end with windows as far behind it is the front of a vehicle, which is a van with
// that probability.
double frontOdds(double depth, bool isSeen, double van)
{
    constexpr double kAnywhere = 0.06;  // density, 1/m, of what is not as usual
    const WindowDepths& ofCar = isSeen ? kSeenOfCar : kUnseenOfCar;
    const WindowDepths& ofVan = isSeen ? kSeenOfVan : kUnseenOfVan;
    const double front = (1.0 - van) * ofCar.front(depth) + van * ofVan.front(depth);
    const double rear = (1.0 - van) * ofCar.atRear(depth) + van * ofVan.atRear(depth);
    return std::log((front + kAnywhere) / (rear + kAnywhere));
}

// Along a box from its centre, m, of hits at least as high as some windows.
struct PaneReach
{
    float least = 1e9F;
    float most = -1e9F;
};
using PaneReaches = std::array<PaneReach, kPaneHeights.size()>;

PaneReaches paneReachesOf(const OrientedBox& box, const Cluster& hits)
{
    const Eigen::Matrix2f axes = rotation(box.heading).cast<float>();
    const Eigen::Vector2f centre = box.centre().cast<float>();
    const auto halfLength = static_cast<float>(0.5 * box.length + kBeforeEnd);
    const auto halfWidth = static_cast<float>(0.5 * box.width + kBeside);
    PaneReaches reaches;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        if (hits.height[i] < kPaneHeights.back()) continue;
        const Eigen::Vector2f place = Eigen::Vector2f(hits.x[i], hits.y[i]) - centre;
        const float along = axes.col(0).dot(place);
        if (std::abs(along) > halfLength || std::abs(axes.col(1).dot(place)) > halfWidth) continue;
        for (std::size_t k = 0; k < kPaneHeights.size(); ++k)
        {
            if (hits.height[i] < kPaneHeights[k]) continue;
            reaches[k].least = std::min(reaches[k].least, along);
            reaches[k].most = std::max(reaches[k].most, along);
        }
    }
    return reaches;
}

// How far behind the end in the direction of `sign` along the box hits at the height of windows
// begin, m; of lower ones, where those would.
std::optional<double> depthOfWindows(const PaneReaches& reaches, const OrientedBox& box,
                                     double sign)
{
    for (std::size_t k = 0; k < kPaneHeights.size(); ++k)
    {
        if (reaches[k].least > reaches[k].most) continue;
        const double reach = static_cast<double>(sign > 0.0 ? reaches[k].most : -reaches[k].least);
        const double depth = std::max(0.0, 0.5 * box.length - reach);
        if (depth > kDeepest) return std::nullopt;
        return depth + kLean * static_cast<double>(kPaneHeights.front() - kPaneHeights[k]);
    }
    return std::nullopt;
}
}  // namespace

double frontByShape(const Sighting& sighting, const HitsAtOneTime& seen)
{
    const Measurement& m = sighting.measurement;
    if (seen.hits->heights == 0 || sighting.height >= kLowestBus || m.box.width < kNarrowestCar ||
        m.box.width > kWidest)
        return 0.0;
    const double van =
        std::clamp((sighting.height - kHighestCar) / (kLowestVan - kHighestCar), 0.0, 1.0);
    const PaneReaches reaches = paneReachesOf(m.box, *seen.each);
    double odds = 0.0;
    for (const Face end : {Face::Front, Face::Back})
    {
        const bool isSeen = m.facesSeen.has(end);
        const bool isInView = !m.hiddenEnds.has(end) && !m.upperEnds.has(end);
        if (!isInView || !(isSeen || m.facesSeen.seesSide())) continue;
        const double sign = end == Face::Front ? 1.0 : -1.0;
        const auto depth = depthOfWindows(reaches, m.box, sign);
        if (!depth) continue;
        // Where no end is seen, hits may be missing that no ray has looked for: panes let them
        // through.
        const double front = frontOdds(*depth, isSeen, van);
        odds += sign * (isSeen || front < 0.0 ? front : kUnlookedFor * front);
    }
    return std::clamp(odds, -kMostOfShape, kMostOfShape);
}

}  // namespace vdamf
