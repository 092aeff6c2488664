// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/rough_ends.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "tracker/discriminate.h"
#include "types/append_hit.h"

namespace vdamf
{
namespace
{
constexpr double kBinLength = 0.25;   // m, along a face
constexpr double kAlongFace = 0.15;   // m: hits along a face lie so near to it
constexpr double kAboutBefore = 0.8;  // m: those about it ...
constexpr double kAboutBehind = 1.0;  // ... lie so far before and behind it
constexpr double kShareOn = 0.35;     // of hits about a face, of those along it, where there is one
constexpr double kShareOff = 0.35;    // and where there is none
constexpr double kShareBefore = 0.2;
constexpr double kShortestFace = 0.9;  // m, of a face
constexpr double kLongestRow = 20.0;   // m, of a row
constexpr double kShortestRest = 0.5;  // m, past its end: corners are round
constexpr std::size_t kFewInRest = 6;  // hits there

struct RowBin
{
    std::size_t about = 0;
    std::size_t along = 0;
    std::size_t before = 0;

    bool holdsFace() const
    {
        return static_cast<double>(along) >= kShareOn * static_cast<double>(about);
    }
};

RowBin sumOfBins(const std::vector<RowBin>& bins, std::size_t begin, std::size_t end)
{
    RowBin sum;
    for (std::size_t i = begin; i < end; ++i)
    {
        sum.about += bins[i].about;
        sum.along += bins[i].along;
        sum.before += bins[i].before;
    }
    return sum;
}

// A face towards the sensor, its row of hits in bins from `low` on, m along the box.
struct RowInBins
{
    Eigen::Vector2d along;     // unit
    Eigen::Vector2d outwards;  // unit
    double face = 0.0;         // m outwards of the box's centre
    double low = 0.0;
    std::vector<RowBin> bins;

    double place(const Eigen::Vector2d& fromCentre) const { return along.dot(fromCentre); }
};

RowInBins rowInBins(const Cluster& hits, const OrientedBox& box, const Eigen::Vector2d& sensor,
                    int axis, const FaceRow& row)
{
    const Eigen::Matrix2d axes = rotation(box.heading);
    RowInBins r;
    r.along = axes.col(1 - axis);
    r.outwards = std::copysign(1.0, toBoxFrame(box, sensor)(axis)) * axes.col(axis);
    r.face = 0.5 * (axis == 0 ? box.length : box.width);
    r.low = r.place(row.middle - box.centre()) - 0.5 * row.metres;
    r.bins.resize(static_cast<std::size_t>(std::ceil(row.metres / kBinLength)) + 1);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const Eigen::Vector2d hit = Eigen::Vector2d(hits.x[i], hits.y[i]) - box.centre();
        const double at = (r.place(hit) - r.low) / kBinLength;
        const double before = r.outwards.dot(hit) - r.face;
        if (at < 0.0 || at >= static_cast<double>(r.bins.size())) continue;
        if (before > kAboutBefore || before < -kAboutBehind) continue;
        RowBin& bin = r.bins[static_cast<std::size_t>(at)];
        ++bin.about;
        if (std::abs(before) < kAlongFace) ++bin.along;
        if (before > kAlongFace) ++bin.before;
    }
    return r;
}

struct BinsOfFace
{
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t along = 0;
};

// The bins next to each other with most hits along the face.
BinsOfFace faceIn(const std::vector<RowBin>& bins)
{
    BinsOfFace best;
    for (std::size_t begin = 0; begin < bins.size();)
    {
        std::size_t end = begin;
        while (end < bins.size() && bins[end].holdsFace()) ++end;
        const std::size_t along = sumOfBins(bins, begin, end).along;
        if (along > best.along) best = {begin, end, along};
        begin = end + 1;
    }
    return best;
}

bool isRough(const RowBin& rest, std::size_t bins)
{
    return static_cast<double>(bins) * kBinLength >= kShortestRest && rest.about >= kFewInRest &&
           static_cast<double>(rest.along) < kShareOff * static_cast<double>(rest.about) &&
           static_cast<double>(rest.before) > kShareBefore * static_cast<double>(rest.about);
}
}  // namespace

std::optional<HitsAtOneTime> withoutRoughEnd(const Sighting& sighting, const HitsAtOneTime& seen,
                                             double leastShare, double mergeCell, bool planar)
{
    const Measurement& m = sighting.measurement;
    if (sighting.height > kLowestTruck) return std::nullopt;
    for (const int axis : {0, 1})
    {
        const FaceRow& row = axis == 0 ? sighting.end : sighting.side;
        const bool isSeen = m.facesSeen.seesAcross(axis);
        if (!isSeen || row.metres < kShortestFace + kShortestRest || row.metres > kLongestRow)
            continue;
        const RowInBins r = rowInBins(*seen.each, m.box, sighting.sensor, axis, row);
        const BinsOfFace face = faceIn(r.bins);
        if (static_cast<double>(face.end - face.begin) * kBinLength < kShortestFace) continue;
        const bool low = isRough(sumOfBins(r.bins, 0, face.begin), face.begin);
        const bool high =
            isRough(sumOfBins(r.bins, face.end, r.bins.size()), r.bins.size() - face.end);
        if (low == high) continue;
        const double end = r.low + kBinLength * static_cast<double>(low ? face.begin : face.end);
        Cluster kept;
        Eigen::Vector2d rest = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < seen.each->size(); ++i)
        {
            const Eigen::Vector2d hit(seen.each->x[i], seen.each->y[i]);
            const double at = r.place(hit - m.box.centre());
            if (low ? at < end : at > end)
                rest += hit;
            else
                appendHit(kept, *seen.each, i);
        }
        if (static_cast<double>(kept.size()) < leastShare * static_cast<double>(seen.each->size()))
            continue;
        HitsAtOneTime smooth = seen;
        smooth.goesOn = rest / static_cast<double>(seen.each->size() - kept.size());
        smooth.isCut = true;
        smooth.hits = projected(kept, mergeCell, planar);
        smooth.each = std::move(kept);
        return smooth;
    }
    return std::nullopt;
}

}  // namespace vdamf
