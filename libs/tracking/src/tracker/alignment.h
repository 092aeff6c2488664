// SPDX-License-Identifier: BSD-3-Clause
// Where the world of the platform's poses lies in that of the tracks, once its poses err.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "tracker/sighting.h"
#include "tracker/track.h"
#include "vdamf/tracking/estimation/platform_errors.h"

namespace vdamf
{
/// Points of what stands, by rising id of its tracks: enough of them, those seen for longest.
std::vector<StandingPoint> standingPoints(const std::vector<Track>& tracks,
                                          const std::vector<std::optional<Sighting>>& sightings,
                                          const VisibilityOptions& options);

class Alignment
{
public:
    explicit Alignment(const AlignmentOptions& options) : options_(options), errors_(options) {}

    /// To a frame at a time (s) whose origin has gone `by` since the one before (m).
    void goOn(const Eigen::Vector2d& by, double time);

    /// What tracks have to follow in a frame, about its origin: what stands has moved so in its
    /// axes. Nothing where the platform's poses do not err. `tracks`: predicted. The covariance is
    /// that of the errors of all measurements of the frame together.
    std::optional<EstimatedMotion> motionOf(const std::vector<Track>& tracks,
                                            const std::vector<std::optional<Sighting>>& sightings,
                                            const VisibilityOptions& options);

    /// From the world of the platform's poses to that of the tracks, for a frame with that origin
    /// (m).
    PlaneMotion inWorld(const Eigen::Vector2d& origin) const { return motion_.about(-origin); }

    /// A report of a frame with that origin (m) as it is in the world of the tracks.
    TrackReport aligned(TrackReport report, const Eigen::Vector2d& origin) const;

private:
    AlignmentOptions options_;
    PlatformErrors errors_;
    std::optional<double> firstTime_;
    double time_ = 0.0;  // of the last frame, s
    double dt_ = 0.0;    // since the one before
    bool begun_ = false;
    PlaneMotion motion_;  // from the frame's axes to the world of the tracks, about its origin
    Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();  // of shift and turn
};

}  // namespace vdamf
