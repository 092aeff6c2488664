// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/partial_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "types/box_changes.h"
#include "vdamf/tracking/estimation/assumed_size.h"
#include "vdamf/tracking/estimation/occlusion.h"
#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
namespace
{
constexpr double kDepth = 0.1;     // m, by which a piece of a body departs from a plane
constexpr double kBow = 0.25;      // m, the same of bumpers
constexpr double kLeastRow = 0.3;  // m
constexpr double kShortEnd = 1.4;  // m: hardly a car is as narrow
constexpr double kSlopeOfShortEnd = 0.12;
constexpr std::size_t kFew = 3;  // hits that show how high a face is seen

// Whether nothing stands in the gap past the front (end 1) or rear (0) of a box, nor before it.
bool isOpenPast(const OrientedBox& box, int end, const Eigen::Vector2d& sensor,
                const RangeProfile& profile)
{
    return std::all_of(
        std::begin(kFartherPastEnd), std::end(kFartherPastEnd),
        [&](double metres)
        {
            const Eigen::Vector2d ray = placePastEnd(box, sensor, 0, end, metres) - sensor;
            return profile.at(std::atan2(ray.y(), ray.x())) > ray.norm() + kFreeRange;
        });
}

// The end of a box that the sensor does not face, and how far it lies past the row of hits on its
// side, m.
struct FarEnd
{
    double sign;  // along the heading
    Face face;
    double pastRow;
};

FarEnd farEndOf(const OrientedBox& box, const FaceRow& side, const Eigen::Vector2d& sensor)
{
    const double sign = toBoxFrame(box, sensor).x() > 0.0 ? -1.0 : 1.0;
    const double rowEnds = sign * toBoxFrame(box, side.middle).x() + 0.5 * side.metres;
    return {sign, sign > 0.0 ? Face::Front : Face::Back, 0.5 * box.length - rowEnds};
}
}  // namespace

Measurement withRowsBetweenHiddenEnds(const Sighting& sighting)
{
    Measurement m = sighting.measurement;
    for (const int axis : {0, 1})
    {
        const FaceRow& row = axis == 0 ? sighting.side : sighting.end;
        const FaceSet located = locatedFaces(m);
        if (!m.facesSeen.seesAlong(axis) || located.has(kFaceAt[axis][0]) ||
            located.has(kFaceAt[axis][1]) || row.hits == 0.0)
            continue;
        const Eigen::Vector2d to =
            toBoxFrame(m.box, row.middle)(axis) * rotation(m.box.heading).col(axis);
        m.box.x += to.x();
        m.box.y += to.y();
        (axis == 0 ? m.box.length : m.box.width) = std::max(0.1, row.metres);
    }
    return m;
}

Measurement withoutEndOfShortSide(const Sighting& sighting)
{
    constexpr double kMany = 200.0;  // hits: of those none are missing that would show more of it
    Measurement m = sighting.measurement;
    const bool isCars = m.facesSeen.seesEnd() && isCarsEnd(m.box.width, sighting.height);
    const bool mayBeCut = sighting.side.hits < kMany;
    if (isCars && mayBeCut && locatesLength(m) && m.box.length < kShortestUsual)
        m.hiddenEnds.add(m.facesSeen.has(Face::Front) ? Face::Back : Face::Front);
    return m;
}

Measurement withinRowOfSide(const Sighting& sighting, const SegmentedFrame& frame)
{
    constexpr double kBeyond = 0.6;  // m
    constexpr double kLong = 5.0;    // m, for a car
    constexpr double kWhole = 6.0;   // m, of a row that is all of a truck, open between its axles
    Measurement m = sighting.measurement;
    const FaceRow& row = sighting.side;
    const bool isLow = sighting.height < kLowVehicle;
    if (!m.facesSeen.seesSide() || row.hits == 0.0 || m.box.length < kLong ||
        (!isLow && row.metres < kWhole))
        return m;
    const FarEnd far = farEndOf(m.box, row, sighting.sensor);
    if (far.pastRow < kBeyond) return m;
    OrientedBox within = m.box;
    const Eigen::Vector2d shift = -0.5 * far.sign * far.pastRow * rotation(m.box.heading).col(0);
    within.x += shift.x();
    within.y += shift.y();
    within.length -= far.pastRow;
    const double headingSigma = std::sqrt(m.covariance(2, 2));
    const bool isGrazed =
        grazedEnds(within, m.facesSeen, sighting.sensor, headingSigma).has(far.face);
    m.upperEnds.remove(far.face);
    if (isGrazed || !isOpenPast(within, far.sign > 0.0 ? 1 : 0, sighting.sensor, frame.profile))
        m.hiddenEnds.add(far.face);
    else
        m.hiddenEnds.remove(far.face);
    // Where both ends are hidden, the box is what withRowsBetweenHiddenEnds() makes it.
    if (locatedFaces(m).seesEnd()) m.box = within;
    return m;
}

Measurement withoutEndPastRowOfTruck(const Sighting& sighting)
{
    constexpr double kPast = 1.0;         // m
    constexpr double kNarrowest = 2.2;    // m, of an end of a truck or bus
    constexpr double kLeastHeight = 2.4;  // m
    Measurement m = sighting.measurement;
    const bool isTrucks = sighting.height >= kLeastHeight && m.box.width >= kNarrowest &&
                          m.box.width <= kWidestTruck && !isCarsEnd(m.box.width, sighting.height);
    if (!isTrucks || !m.facesSeen.seesEnd() || !m.facesSeen.seesSide()) return m;
    const FarEnd far = farEndOf(m.box, sighting.side, sighting.sensor);
    if (sighting.side.hits == 0.0 || far.pastRow > kPast) m.hiddenEnds.add(far.face);
    return m;
}

Measurement withTurnOfPieces(const Sighting& sighting)
{
    Measurement m = sighting.measurement;
    double slope = std::numeric_limits<double>::infinity();
    for (const int axis : {0, 1})
    {
        if (!m.facesSeen.seesAlong(axis)) continue;
        const double metres = axis == 0 ? sighting.side.metres : sighting.end.metres;
        // It is a piece where something hides the rest, or where hardly a car is as narrow.
        const bool isShort = axis == 1 && metres < kShortEnd && sighting.height < kLowVehicle;
        if (!m.hiddenEnds.seesAcross(axis))
        {
            if (!isShort) return m;
            slope = std::min(slope, kSlopeOfShortEnd);
            continue;
        }
        const bool isBow = axis == 1 && sighting.height < kTruckHeight;
        if (metres > 0.0)
            slope = std::min(slope, (isBow ? kBow : kDepth) / std::max(metres, kLeastRow));
    }
    if (!std::isfinite(slope)) return m;
    return withTurn(m, std::atan(slope), sighting.around.centre());
}

Measurement withTurnOfParts(const Sighting& sighting, const HitsAtOneTime& seen)
{
    return withTurn(sighting.measurement, seen.turnSigma, sighting.around.centre());
}

double heightOfFaces(const Measurement& m, const Eigen::Vector2d& sensor, const HitsAtOneTime& seen)
{
    constexpr float kOn = 0.25F;   // m, before and behind the face
    constexpr float kPast = 0.1F;  // m, beside it
    if (seen.hits->heights == 0 || m.facesSeen.empty()) return 0.0;
    const Eigen::Matrix2f toBox = rotation(m.box.heading).transpose().cast<float>();
    const Eigen::Vector2f centre = m.box.centre().cast<float>();
    const Eigen::Array2f half(static_cast<float>(0.5 * m.box.length),
                              static_cast<float>(0.5 * m.box.width));
    const Eigen::Vector2d view = toBoxFrame(m.box, sensor);
    std::array<float, kFew> highest{};
    const Cluster& hits = *seen.each;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        if (hits.height[i] <= highest.back()) continue;
        const Eigen::Vector2f place = toBox * (Eigen::Vector2f(hits.x[i], hits.y[i]) - centre);
        const Eigen::Array2f past = place.array().abs() - half;
        if ((past > kPast).any()) continue;
        const Eigen::Array2f off = past.abs();
        const Eigen::Array2d towards = place.cast<double>().array() * view.array();
        const bool isOnEnd = m.facesSeen.seesEnd() && off.x() <= kOn && towards.x() > 0.0;
        const bool isOnSide = m.facesSeen.seesSide() && off.y() <= kOn && towards.y() > 0.0;
        if (!isOnEnd && !isOnSide) continue;
        highest.back() = hits.height[i];
        std::sort(highest.begin(), highest.end(), std::greater<>());
    }
    return static_cast<double>(highest.back());
}

}  // namespace vdamf
