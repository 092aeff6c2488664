// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/closed_end.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kNarrowest = 2.3;     // m, of buses
constexpr double kLowestClosed = 2.6;  // m
// Bars of trucks end at 0.6 m at most above the ground, their floors begin at a metre.
constexpr float kAboveBar = 0.66F;    // m
constexpr float kBelowFloor = 0.95F;  // m
constexpr float kDeep = 0.25F;        // m, before and behind the end
constexpr int kLeastHits = 6;
constexpr double kLeastShare = 0.7;  // of the width
constexpr double kFarthest = 35.0;   // m: beyond it the ground below is not known to a decimetre
}  // namespace

bool isClosedEnd(const Sighting& sighting, const HitsAtOneTime& seen)
{
    const Measurement& m = sighting.measurement;
    const bool isNear = (m.box.centre() - sighting.sensor).norm() < kFarthest;
    const bool isLarge = m.box.width >= kNarrowest && sighting.height >= kLowestClosed;
    if (!isNear || !isLarge || !m.facesSeen.seesEnd() || seen.hits->heights == 0) return false;
    const float sign = m.facesSeen.has(Face::Front) ? 1.0F : -1.0F;
    const Eigen::Matrix2f axes = rotation(m.box.heading).cast<float>();
    const Eigen::Vector2f outwards = sign * axes.col(0);
    const Eigen::Vector2f end =
        m.box.centre().cast<float>() + static_cast<float>(0.5 * m.box.length) * outwards;
    const Cluster& each = *seen.each;
    int hits = 0;
    float rightmost = 0.0F;
    float leftmost = 0.0F;
    for (std::size_t i = 0; i < each.size(); ++i)
    {
        if (each.height[i] < kAboveBar || each.height[i] > kBelowFloor) continue;
        const Eigen::Vector2f place = Eigen::Vector2f(each.x[i], each.y[i]) - end;
        if (std::abs(outwards.dot(place)) > kDeep) continue;
        const float left = axes.col(1).dot(place);
        leftmost = hits == 0 ? left : std::max(leftmost, left);
        rightmost = hits == 0 ? left : std::min(rightmost, left);
        ++hits;
    }
    return hits >= kLeastHits && leftmost - rightmost >= kLeastShare * m.box.width;
}

}  // namespace vdamf
