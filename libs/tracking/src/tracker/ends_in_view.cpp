// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/ends_in_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "tracker/discriminate.h"
#include "tracker/inside_of.h"
#include "types/box_changes.h"
#include "vdamf/tracking/estimation/occlusion.h"

namespace vdamf
{
namespace
{
constexpr double kNearEnd = 1.6;          // m, from the place just past an end
constexpr double kLowestSeenOver = 1.85;  // m
constexpr double kCab = 2.4;              // m: what a truck carries may be higher than its cab
constexpr double kLevel = 0.004;          // rise over run by which hits of one row differ
constexpr std::size_t kInRow = 3;         // hits that make one
constexpr double kLeastRun = 0.01;        // m: what is nearer lies along no ray

// Rise over run from the sensor of the hits near a place, rising.
std::vector<double> slopesNear(const Eigen::Vector2d& place, const Sighting& sighting,
                               const SegmentedFrame& frame)
{
    std::vector<double> slopes;
    for (const std::size_t k : sighting.clusters)
    {
        const Cluster& cluster = frame.clusters[k];
        for (std::size_t i = 0; i < cluster.size(); ++i)
        {
            const Eigen::Vector2d hit(cluster.x[i], cluster.y[i]);
            const double run = (hit - frame.sensor).norm();
            if (run > kLeastRun && (hit - place).squaredNorm() < kNearEnd * kNearEnd)
                slopes.push_back((cluster.z[i] - frame.sensorZ) / run);
        }
    }
    std::sort(slopes.begin(), slopes.end());
    return slopes;
}

// By the rays past an end.
enum class PastEnd
{
    Open,     // down to where cabs are
    Upper,    // over what hides the rest
    Blocked,  // or the face goes on
};

// `slopes`: of the hits near the end, rising.
PastEnd viewPast(const Eigen::Vector2d& place, const std::vector<double>& slopes,
                 const Sighting& sighting, const SegmentedFrame& frame)
{
    constexpr double kNearer = 0.6;  // m: what is less so is the rest of the face
    if (slopes.size() < kInRow) return PastEnd::Blocked;
    const Eigen::Vector2d ray = place - frame.sensor;
    const double range = ray.norm();
    const double bearing = std::atan2(ray.y(), ray.x());
    // What is higher is as the highest layer.
    constexpr double kHighestLayer =
        RangeProfile::kLowestLayer + RangeProfile::kLayers * RangeProfile::kLayer;
    const double highest = std::min(slopes[slopes.size() - kInRow] - kLevel, kHighestLayer);
    double free = std::numeric_limits<double>::infinity();
    for (double slope = highest; slope > RangeProfile::kLowestLayer; slope -= RangeProfile::kLayer)
    {
        const double reached = frame.profile.at(bearing, slope);
        if (reached < range - kNearer) break;
        if (reached < range + kFreeRange) return PastEnd::Blocked;
        free = slope;
    }
    // Rays are where hits are.
    const auto lowest = std::lower_bound(slopes.begin(), slopes.end(), free);
    if (slopes.end() - lowest < static_cast<std::ptrdiff_t>(kInRow)) return PastEnd::Blocked;
    const double height = frame.sensorZ + lowest[kInRow - 1] * range - sighting.groundZ;
    return height > kCab ? PastEnd::Upper : PastEnd::Open;
}

// Ends of the side of a car or van near which it has hits on its windows alone: bonnet and boot go
// on there, and are out of view, as below the lowest rays of a sensor close beside it.
FaceSet windowEnds(const Sighting& sighting, const SegmentedFrame& frame)
{
    constexpr double kBonnet = 1.0;  // m above the ground, the highest ones
    constexpr double kLowest = 1.2;  // m: what is lower has no windows
    constexpr double kNear = 1.0;    // m before an end of the row ...
    constexpr double kPast = 0.1;    // ... and past it
    const Measurement& m = sighting.measurement;
    FaceSet ends;
    const bool isCar = sighting.height > kLowest && sighting.height < kLowestTruck;
    if (!isCar || frame.planar || !m.facesSeen.seesSide()) return ends;
    const double outwards = m.facesSeen.has(Face::Left) ? 1.0 : -1.0;
    const Eigen::Matrix2d toBox = rotation(m.box.heading).transpose();
    std::array<std::size_t, 2> hits{};
    std::array<bool, 2> areLow{};
    for (const std::size_t k : sighting.clusters)
    {
        const Cluster& cluster = frame.clusters[k];
        for (std::size_t i = 0; i < cluster.size(); ++i)
        {
            const Eigen::Vector2d hit(cluster.x[i], cluster.y[i]);
            const Eigen::Vector2d at = toBox * (hit - m.box.centre());
            const double past = std::abs(at.x()) - 0.5 * m.box.length;
            const double before = outwards * at.y() - 0.5 * m.box.width;
            if (past < -kNear || past > kPast) continue;
            if (before > kInFrontOfFace || before < -kBehindFace) continue;
            const std::size_t end = at.x() > 0.0 ? 1 : 0;
            ++hits[end];
            areLow[end] = areLow[end] || cluster.height[i] < kBonnet;
        }
    }
    for (std::size_t end = 0; end < 2; ++end)
    {
        const Face face = kFaceAt[0][end];
        if (hits[end] >= kInRow && !areLow[end] && !m.facesSeen.has(face)) ends.add(face);
    }
    return ends;
}
}  // namespace

Measurement withEndsOutOfView(const Sighting& sighting, const SegmentedFrame& frame)
{
    constexpr double kUpperSigma = 1.0;  // m
    Measurement m = sighting.measurement;
    m.shadowEdges = shadowEdges(m.box, m.facesSeen, frame.sensor, frame.profile);
    const FaceSet blocked = blockedEnds(m.box, m.facesSeen, frame.sensor, frame.profile);
    const FaceSet grazed = grazedEnds(m.box, m.facesSeen, frame.sensor);
    m.hiddenEnds = blocked | grazed | windowEnds(sighting, frame);
    if (sighting.height < kLowestSeenOver || blocked.empty()) return m;
    const bool isTruck = sighting.height >= kLowestTruck;
    // Of a van no more than its length: beside its windscreen its sides recede.
    for (int axis = 0; axis < (isTruck ? 2 : 1); ++axis)
        for (int end = 0; end < 2; ++end)
        {
            const Face face = kFaceAt[axis][end];
            if (!blocked.has(face) || grazed.has(face)) continue;
            const auto past = [&](double metres)
            { return placePastEnd(m.box, frame.sensor, axis, end, metres); };
            const std::vector<double> slopes = slopesNear(past(kPastEnd), sighting, frame);
            PastEnd worst = PastEnd::Open;
            for (const double metres : kFartherPastEnd)
                worst = std::max(worst, viewPast(past(metres), slopes, sighting, frame));
            if (worst == PastEnd::Blocked) continue;
            m.hiddenEnds.remove(face);
            if (isTruck && worst == PastEnd::Open) continue;
            m.upperEnds.add(face);
            const Vector5d change = byFace(rotation(m.box.heading), axis, end);
            m.covariance += kUpperSigma * kUpperSigma * change * change.transpose();
        }
    return m;
}

Measurement withoutShadowEdges(const Measurement& measurement, const VehicleState& foretold,
                               const Eigen::Vector2d& hits)
{
    constexpr double kInside = 0.1;  // m
    constexpr double kSigmas = 2.0;
    constexpr double kTurn = 0.15;     // rad, by hits along them
    constexpr double kMayTurn = 0.05;  // rad: even where it seems to be the side
    Measurement m = measurement;
    for (int axis = 0; axis < 2; ++axis)
        for (int end = 0; end < 2; ++end)
        {
            const Face face = kFaceAt[axis][end];
            if (!m.shadowEdges.has(face)) continue;
            if (axis == 1) m = withTurn(m, kMayTurn, hits);
            const Inside inside = insideOf(foretold, m.box, axis, end, hits);
            if (inside.metres < std::max(kInside, kSigmas * inside.sigma)) continue;
            m.facesSeen.remove(face);
            m.hiddenEnds.add(face);
            m = withTurn(m, kTurn, hits);
        }
    return m;
}

Measurement withoutUpperFront(const Measurement& measurement, double height,
                              double forwardProbability, FaceSet known)
{
    constexpr double kSurely = 0.9;
    Measurement m = measurement;
    if (height >= kLowestTruck || !m.facesSeen.seesSide()) return m;
    for (int end = 0; end < 2; ++end)
    {
        const Face face = kFaceAt[0][end];
        const Face other = kFaceAt[0][1 - end];
        const bool isOtherTold = !m.hiddenEnds.has(other) && !m.upperEnds.has(other);
        const bool isRear = face == Face::Back && forwardProbability > kSurely;
        if (m.upperEnds.has(face) && (isOtherTold || known.has(other)) && !isRear)
            m.hiddenEnds.add(face);
    }
    return m;
}

Measurement withoutShortUpperEnds(const Measurement& measurement, const OrientedBox& foretold)
{
    constexpr double kShort = 0.8;  // m
    Measurement m = measurement;
    for (int end = 0; end < 2; ++end)
    {
        const Face face = kFaceAt[0][end];
        if (m.upperEnds.has(face) && outsideOf(foretold, m.box, 0, end) < -kShort)
            m.hiddenEnds.add(face);
    }
    return m;
}

}  // namespace vdamf
