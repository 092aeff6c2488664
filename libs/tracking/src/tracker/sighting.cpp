// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/sighting.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <utility>

#include "tracker/closed_end.h"
#include "tracker/end_above_bumper.h"
#include "tracker/ends_in_view.h"
#include "tracker/front_by_shape.h"
#include "tracker/layers_of_end.h"
#include "tracker/layers_of_side.h"
#include "tracker/near_end.h"
#include "tracker/partial_faces.h"
#include "tracker/rough_ends.h"
#include "types/hit_bounds.h"
#include "types/lane_bounds.h"
#include "types/lanes.h"
#include "types/wide_lanes.h"
#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
namespace
{
// Sum of the local ground's z below the hits, m.
double groundSum(const Cluster& cluster)
{
    if (cluster.size() == 0) return 0.0;
    // Over that below the first one: little enough for sums in single precision.
    const float base = cluster.z.front() - cluster.height.front();
    double over = 0.0;
    inWideLanes([
        base, z = cluster.z.data(), height = cluster.height.data(), size = cluster.size(),
        result = &over
    ]() __attribute__((always_inline)) {
        Floats sum{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Floats zs;
            Floats heights;
            load(zs, z + first, count);
            load(heights, height + first, count);
            sum += zs - heights;
            if (count == kLanes<Floats>) sum -= base;
        };
        inGroupsOf<kLanes<Floats>>(size, add);
        *result = sumOf(sum);
    });
    const std::size_t rest = cluster.size() % kLanes<Floats>;
    return over + static_cast<double>(base) * static_cast<double>(cluster.size() - rest);
}

constexpr double kMostOver = 0.2;  // m

// Half of what lies between the two highest rows of hits (as in Hits::heights), m: the next one
// above them passed over it. Cars far away have few rows, and are not as high as the next one.
double likelyOver(std::uint64_t heights)
{
    constexpr double kHalf = 0.05;  // of what a bit stands for
    int gap = 0;
    for (; heights > 1; heights >>= 1U)
    {
        const bool isHit = (heights & 1U) != 0;
        gap = isHit ? 1 : gap + 1;
    }
    return std::min(kMostOver, kHalf * gap);
}

using RowHit = std::pair<double, double>;  // along, weight

constexpr double kWideGap = 1.0;  // m: what goes on behind it is something else

// Whether it is plain, without sorting, that the places have no wide gap: a gap leaves bins empty.
bool hasNoGap(const std::vector<RowHit>& places)
{
    constexpr double kBin = 0.45 * kWideGap;
    constexpr double kBins = 64.0;
    if (places.empty()) return false;
    const auto [first, last] = std::minmax_element(places.begin(), places.end());
    const double bins = std::floor((last->first - first->first) / kBin) + 1.0;
    if (bins > kBins) return false;
    std::uint64_t hasHit = 0;
    for (const RowHit& hit : places)
        hasHit |= std::uint64_t{1} << static_cast<unsigned>((hit.first - first->first) / kBin);
    return hasHit == ~std::uint64_t{0} >> static_cast<unsigned>(kBins - bins);
}

// All of the row but the outermost hundredth at either end; its hits lie along a line.
FaceRow rowOf(std::vector<RowHit>::iterator begin, std::vector<RowHit>::iterator end,
              const Eigen::ParametrizedLine<double, 2>& line)
{
    const auto size = static_cast<std::size_t>(end - begin);
    const std::size_t outermost = size / 100;
    FaceRow row;
    if (outermost == 0)
    {
        const auto [first, last] = std::minmax_element(begin, end);
        row.metres = last->first - first->first;
        row.middle = line.pointAt(0.5 * (last->first + first->first));
    }
    else
    {
        std::vector<RowHit> lowest(outermost + 1);
        std::vector<RowHit> highest(outermost + 1);
        std::partial_sort_copy(begin, end, lowest.begin(), lowest.end());
        std::partial_sort_copy(begin, end, highest.begin(), highest.end(), std::greater<>());
        row.metres = highest.back().first - lowest.back().first;
        row.middle = line.pointAt(0.5 * (highest.back().first + lowest.back().first));
    }
    for (auto hit = begin; hit != end; ++hit) row.hits += hit->second;
    return row;
}
}  // namespace

Sighting turnedBy(Sighting sighting, int quarters)
{
    sighting.measurement = turnedBy(sighting.measurement, quarters);
    sighting.around.heading = wrapAngle(sighting.around.heading + 0.5 * kPi * quarters);
    if (quarters % 2 == 0)
    {
        if (quarters % 4 != 0) sighting.front = -sighting.front;
        return sighting;
    }
    std::swap(sighting.around.length, sighting.around.width);
    std::swap(sighting.side, sighting.end);
    sighting.endAboveBumper = 0.0;
    sighting.front = 0.0;
    sighting.isBusEnd = false;
    return sighting;
}

double heightOf(const Cluster& cluster)
{
    if (cluster.height.empty()) return 0.0;
    return greatestOf(cluster.height.data(), cluster.height.size());
}

Hits projected(const Cluster& cluster, double mergeCell, bool planar)
{
    Hits hits = projectHits(cluster, mergeCell);
    if (planar) hits.heights = 0;
    return hits;
}

Lent<Hits> hitsOf(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters)
{
    if (clusters.size() == 1) return Lent<Hits>::from(frame.hits[clusters.front()]);
    Hits all;
    for (const std::size_t k : clusters) all = joined(all, frame.hits[k]);
    return all;
}

OrientedBox rectangleAround(const Hits& hits, double heading)
{
    const HitBounds b = boundsAlong(directionOf(heading), hits);
    const Eigen::Vector2d middle =
        rotation(heading) * Eigen::Vector2d(0.5 * (b.minX + b.maxX), 0.5 * (b.minY + b.maxY));
    return {middle.x(), middle.y(), heading, b.maxX - b.minX, b.maxY - b.minY};
}

FaceRow rowAlongFace(const Hits& hits, const OrientedBox& box, const Eigen::Vector2d& sensor,
                     int axis)
{
    const Eigen::Matrix2d axes = rotation(box.heading);
    const Eigen::Vector2d outwards =
        std::copysign(1.0, toBoxFrame(box, sensor)(axis)) * axes.col(axis);
    const Eigen::Vector2d along = axes.col(1 - axis);
    const double half = 0.5 * (axis == 0 ? box.length : box.width);
    std::vector<RowHit> places(hits.size());
    std::size_t taken = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const double dx = hits.x[i] - box.x;
        const double dy = hits.y[i] - box.y;
        const double behind = half - (outwards.x() * dx + outwards.y() * dy);
        // Written always, counted when taken: whether it is, is hard to foretell.
        places[taken] = {along.x() * dx + along.y() * dy, hits.weight[i]};
        taken += ((behind > -kInFrontOfFace) & (behind < kBehindFace)) ? 1 : 0;
    }
    places.resize(taken);
    const Eigen::ParametrizedLine<double, 2> line(box.centre() + half * outwards, along);
    if (hasNoGap(places)) return rowOf(places.begin(), places.end(), line);
    std::sort(places.begin(), places.end());
    FaceRow best;
    for (auto first = places.begin(), last = first; first != places.end(); first = last)
    {
        do ++last;
        while (last != places.end() && last->first < std::prev(last)->first + kWideGap);
        const FaceRow row = rowOf(first, last, line);
        if (row.hits > best.hits) best = row;
    }
    return best;
}

Measurement goingOnTowards(const Measurement& measurement, const Eigen::Vector2d& point)
{
    const Eigen::Vector2d there = toBoxFrame(measurement.box, point);
    // Rows of hits run along the faces seen; what goes on is one of them.
    const bool alongLength =
        measurement.facesSeen.seesSide() &&
        (!measurement.facesSeen.seesEnd() || std::abs(there.x()) > std::abs(there.y()));
    Measurement m = measurement;
    if (alongLength)
        m.hiddenEnds.add(there.x() > 0.0 ? Face::Front : Face::Back);
    else
        m.hiddenEnds.add(there.y() > 0.0 ? Face::Left : Face::Right);
    return m;
}

Sighting sightingOf(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters,
                    const HitsAtOneTime& seen, const OrientedBox& start,
                    const std::optional<Eigen::Vector2d>& knownLengthWidth,
                    const MeasureOptions& options, const Attention& attention)
{
    const Eigen::Vector2d& sensor = frame.sensor;
    Sighting s;
    s.time = frame.time;
    s.sensor = sensor;
    s.lag = seen.lag;
    s.clusters = clusters;
    s.areParts = seen.areParts;
    s.isCut = seen.isCut;
    s.measurement =
        measureTarget(*seen.hits, sensor, start, options, knownLengthWidth, attention.search);
    Measurement& m = s.measurement;
    double ground = 0.0;
    double count = 0.0;
    for (const std::size_t k : clusters)
    {
        const Cluster& cluster = frame.clusters[k];
        ground += groundSum(cluster);
        s.height = std::max(s.height, heightOf(cluster));
        count += static_cast<double>(cluster.size());
    }
    s.overHits = likelyOver(seen.hits->heights);
    s.groundZ = count > 0.0 ? ground / count : 0.0;
    // Every sensor has level rays.
    const bool isBelowSensor = s.groundZ + s.height + 2.0 * s.overHits < frame.sensorZ;
    s.isRoofSeen = isBelowSensor && s.overHits < kMostOver && !frame.planar;
    m = withEndsOutOfView(s, frame);
    s.around = rectangleAround(*seen.hits, m.box.heading);
    s.end = rowAlongFace(*seen.hits, m.box, sensor, 0);
    s.side = rowAlongFace(*seen.hits, m.box, sensor, 1);
    // Of what is followed many hits are its own; a new cluster may be a hedge with a car in it.
    constexpr double kLeastShare = 0.25;
    const double leastShare = knownLengthWidth ? kLeastShare : 0.0;
    if (!seen.goesOn)
        if (const auto smooth =
                withoutRoughEnd(s, seen, leastShare, options.mergeCell, frame.planar))
            return sightingOf(frame, clusters, *smooth, start, knownLengthWidth, options,
                              attention);
    m = withNearEndOfRow(s);
    m = withinRowOfSide(s, frame);
    if (seen.goesOn) m = goingOnTowards(m, *seen.goesOn);
    if (attention.isPlaceEnough) return s;

    m = withoutEndOfShortSide(s);
    // What is new may be a bush over a car.
    if (knownLengthWidth) m = withoutEndPastRowOfTruck(s);
    m = withRowsBetweenHiddenEnds(s);
    m = withTurnOfSideLayers(s, seen);
    m = withTurnOfLayers(s, seen);
    m = withTurnOfPieces(s);
    m = withTurnOfParts(s, seen);
    s.endAboveBumper = endAboveBumper(s, seen);
    m = withRecessOfEnd(s);
    s.faceHeight = heightOfFaces(s.measurement, sensor, seen);
    s.isBusEnd = isClosedEnd(s, seen);
    s.front = frontByShape(s, seen);
    return s;
}

}  // namespace vdamf
