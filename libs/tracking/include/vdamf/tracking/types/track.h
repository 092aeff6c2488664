// SPDX-License-Identifier: BSD-3-Clause
// What the tracker says of one object in one frame, and of one frame as a whole.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/plane_motion.h"
#include "vdamf/tracking/types/vehicle_type.h"

namespace vdamf
{
using Matrix5d = Eigen::Matrix<double, 5, 5>;
using Vector5d = Eigen::Matrix<double, 5, 1>;

enum class TrackStatus
{
    Tentative,  ///< new, not yet believed
    Confirmed,  ///< measured often enough to be published
    Coasting,   ///< confirmed, but not measured in this frame
    Ended       ///< last row of this track, unless it turned out of sight and is found again
};

const char* toString(TrackStatus status);
std::optional<TrackStatus> trackStatusFromString(const std::string& text);

/// One track in one frame: the row of tracks.csv and of the annotated rawlog.
struct TrackReport
{
    std::uint64_t id = 0;  ///< unique in a run, from 1
    TrackStatus status = TrackStatus::Tentative;
    std::optional<double> vehicleProbability;  ///< of the discriminator; nothing where none ran
    std::optional<bool> isVehicle;             ///< what the discriminator calls it
    OrientedBox box;                           ///< world frame, m and rad
    double z = 0.0;                            ///< bottom of the box, world, m
    double height = 0.0;                       ///< m
    double speed = 0.0;                        ///< along the heading, negative in reverse, m/s
    double yawRate = 0.0;                      ///< rad/s
    /// That the heading points to the front rather than to the rear; 0.5: nothing tells.
    double forwardProbability = 0.5;
    /// That length and width are not exchanged; 0.5: nothing tells.
    double axesProbability = 0.5;
    int points = 0;      ///< hits assigned in this frame
    double match = 0.0;  ///< matched filter response per hit, 1/m; 0 if none
    /// Normalised innovation squared of this frame's update, 3 degrees of freedom.
    std::optional<double> nis;
    FaceSet facesSeen;
    /// Of the box, along and across, -1 (rear, right) to 1: the point that was measured, which
    /// stays where it is whatever the size.
    Eigen::Vector2d heldPoint = Eigen::Vector2d::Zero();
    /// The box is that around its hits, not the tracked one: it is ruled out as a vehicle.
    bool isOfHits = false;
    /// Covariance of (x, y, heading, speed): m, m, rad, m/s.
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
    double lengthVariance = 0.0;  ///< m^2
    double widthVariance = 0.0;   ///< m^2
    /// The box measured in this frame, before filtering.
    std::optional<OrientedBox> measuredBox;
    /// Where filters of several types measure: the most likely one.
    std::optional<TypeProbability> type;
    /// What the discriminator saw in this frame, where DiscriminatorOptions::keepFeatures asks for
    /// it; else empty.
    std::vector<float> features;
};

/// Whether others are told of it, as of what is believed to be there.
inline bool isPublished(const TrackReport& report)
{
    return report.status == TrackStatus::Confirmed || report.status == TrackStatus::Coasting;
}

/// What the discriminator calls it; where only its probability is known, what is more likely.
/// Nothing where none ran.
std::optional<bool> isCalledVehicle(const TrackReport& report);

/// Everything that one frame led to. The library's one product: it is annotated, tabulated,
/// drawn, evaluated and asserted on.
struct FrameResult
{
    double time = 0.0;                ///< of the frame, s (UNIX)
    std::vector<TrackReport> tracks;  ///< by rising id
    std::size_t points = 0;           ///< in the frame
    std::size_t pointsAboveGround = 0;
    std::size_t clusters = 0;
    /// From the world that the platform's poses say to that of the tracks, about its origin; no
    /// motion as long as these poses do not err.
    PlaneMotion alignment;
};

}  // namespace vdamf
