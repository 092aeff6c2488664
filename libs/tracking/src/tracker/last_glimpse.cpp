// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/last_glimpse.h"

#include <cmath>

#include "tracker/inside_of.h"
#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
namespace
{
// Whether the box around some hits lies on another one, grown by a margin (m).
bool isWithin(const OrientedBox& hits, const OrientedBox& box, double margin)
{
    for (const Eigen::Vector2d& corner : corners(hits))
    {
        const Eigen::Vector2d p = toBoxFrame(box, corner).cwiseAbs();
        if (p.x() > 0.5 * box.length + margin || p.y() > 0.5 * box.width + margin) return false;
    }
    return true;
}

// Whether a face measured at some hits (their middle, m) lies far inside of where it is foretold.
bool isFarInside(const Measurement& m, const VehicleState& foretold, int axis, int end,
                 const Eigen::Vector2d& hits)
{
    constexpr double kFar = 0.5;     // m
    constexpr double kSurely = 3.0;  // sigmas
    const Inside inside = insideOf(foretold, m.box, axis, end, hits);
    const double lever = toBoxFrame(foretold.box(), hits)(1 - axis);
    const double byTurn = lever * std::sqrt(foretold.covariance(kHeading, kHeading));
    return inside.metres > kFar + kSurely * std::hypot(inside.sigma, byTurn);
}

// Whether it shows a face. A piece between what hides the rest of it may be any edge of the body,
// where it is far inside of the face that it is taken for; of one that lies across that is not
// told, as its faces are others.
bool showsFace(const Sighting& sighting, const VehicleState& foretold)
{
    const Measurement m = alignedWith(sighting.measurement, foretold.mean(kHeading));
    const bool isAcross = liesAcross(m, foretold.mean(kHeading));
    const Eigen::Vector2d hits = sighting.around.centre();
    for (const int axis : {0, 1})
        for (const int end : {0, 1})
        {
            const auto& across = kFaceAt[1 - axis];
            const bool isPiece = m.hiddenEnds.has(across[0]) && m.hiddenEnds.has(across[1]);
            if (m.facesSeen.has(kFaceAt[axis][end]) &&
                !(isPiece && !isAcross && isFarInside(m, foretold, axis, end, hits)))
                return true;
        }
    return false;
}
}  // namespace

bool isLastGlimpse(const Track& track, const Sighting& sighting, const VehicleState& foretold,
                   double margin)
{
    constexpr double kPart = 0.25;   // of the length
    constexpr double kTurned = 0.2;  // rad: nothing turns as much from one frame to the next
    constexpr int kFew = 8;          // hits
    const Measurement& m = sighting.measurement;
    if (!track.told.length) return false;
    const double turned =
        std::abs(std::remainder(m.box.heading - foretold.mean(kHeading), 0.5 * kPi));
    const double mayTurn = track.stands()
                               ? kTurned
                               : kTurned + 3.0 * std::sqrt(foretold.covariance(kHeading, kHeading));
    const bool showsFaces = m.hits >= kFew && turned <= mayTurn &&
                            (track.stands() ? m.hiddenEnds.empty() : showsFace(sighting, foretold));
    const bool isPart =
        std::hypot(sighting.around.length, sighting.around.width) < kPart * foretold.mean(kLength);
    return isPart && !showsFaces && isWithin(sighting.around, foretold.box(), margin);
}

}  // namespace vdamf
