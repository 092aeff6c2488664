// SPDX-License-Identifier: BSD-3-Clause
// Vehicles side by side or in line stand alike: what those around tell of one's axes and heading.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "association/plane_index.h"
#include "tracker/discriminate.h"
#include "tracker/sighting.h"
#include "tracker/track.h"

namespace vdamf
{
/// What is known of a heading beforehand.
struct HeadingPrior
{
    double heading = 0.0;   ///< rad
    double variance = 0.0;  ///< rad^2
};

/// The tracks of a frame that are published, or whose axes are known, as neighbours of others.
class Neighbourhood
{
public:
    /// Nobody is around.
    Neighbourhood() : index_({}) {}
    Neighbourhood(const std::vector<Track>& tracks, const Discriminator& discriminator);

    /// Log odds of the axes and of the front that all neighbours together tell at most: what makes
    /// them stand otherwise holds for all.
    static constexpr double kMostEvidence = 3.0;
    static constexpr double kMostOfFront = 4.0;

    /// Log odds that length and width of a box are as they are held rather than exchanged, by the
    /// vehicles around it but for the track `self`. Neighbours count by what they themselves showed
    /// of their axes, never by what their own neighbours tell.
    double axesEvidence(const OrientedBox& box, std::uint64_t self) const;

    /// Log odds that the front of a box lies ahead rather than behind, by the vehicles in line with
    /// it but for `self`, as each of them drove or shows itself.
    double frontEvidence(const OrientedBox& box, std::uint64_t self) const;

    /// Whether a vehicle that is in sight, known to be one and how it lies, but for `self`, fills a
    /// part of that place.
    bool isTaken(const OrientedBox& place, std::uint64_t self) const;

    /// The heading of a vehicle at that place by those around it but for `self`, near that of the
    /// box or its reverse; nothing where none is.
    std::optional<HeadingPrior> heading(const OrientedBox& box, std::uint64_t self) const;

private:
    struct Neighbour
    {
        std::uint64_t id = 0;
        OrientedBox box;
        bool isInSight = false;        // it was, in the last frame
        bool isTurning = false;        // and tells nothing of how others stand
        double headingVariance = 0.0;  // rad^2
        double logOdds = 0.0;          // that another's length lies along its heading
        double front = 0.0;            // log odds that another's front in line lies as its own
    };

    template <class Use>
    void forEachWithin(double reach, const Eigen::Vector2d& centre, std::uint64_t self,
                       const Use& use) const;

    std::vector<Neighbour> neighbours_;
    PlaneIndex index_;
};

/// Log odds that a vehicle does not lie as it was measured, as another one stands there; 0 where
/// none does. `height`: of what is seen, m.
double placeTaken(const Measurement& measurement, double height, const Eigen::Vector2d& sensor,
                  const Neighbourhood& around, std::uint64_t self, const TrackerOptions& options);

/// The sighting with its box turned, about the middle of the hits, towards the heading of the
/// vehicles around it, as far as its own is uncertain. What it says of its errors stays as it is:
/// the neighbours tell the same in each frame. `held`: what is known of the vehicle, if anything:
/// one that is known to stand as they do is taken to where a single frame tells otherwise.
Sighting withHeadingOfNeighbours(Sighting sighting, const Neighbourhood& around, std::uint64_t self,
                                 const VehicleState* held = nullptr);

}  // namespace vdamf
