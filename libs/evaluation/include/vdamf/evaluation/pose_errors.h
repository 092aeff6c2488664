// SPDX-License-Identifier: BSD-3-Clause
// How far tracks are from the objects that they follow, pair by pair.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/evaluation/matching.h"
#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
/// Bird's-eye IoU of the pairs whose errors are told. Loose, unlike that of detection: at 0.5 the
/// worst poses would be no pairs, and the errors of the rest would look better than they are.
inline constexpr double kPairOverlap = 0.1;

/// One track on one object in one frame. Differences are track minus truth; metres, radians, m/s.
struct PoseError
{
    double time = 0.0;
    std::string objectId;
    std::uint64_t trackId = 0;
    TrackStatus status = TrackStatus::Confirmed;

    double position = 0.0;      ///< distance of the centres
    double longitudinal = 0.0;  ///< of the centre, along the object's true heading
    double lateral = 0.0;       ///< to its left
    /// Distance from the object's corner that is nearest to the sensor to the nearest one of the
    /// track's: what a sensor can see, free of the hidden end.
    std::optional<double> corner;
    double heading = 0.0;      ///< (-pi, pi]
    double headingAxis = 0.0;  ///< the same modulo pi, (-pi/2, pi/2]: front or rear does not count
    bool flipped = false;      ///< front taken for rear: |heading| above 90 deg
    bool exchanged = false;    ///< length taken for width: |headingAxis| above 45 deg
    double axesProbability = 0.5;  ///< that it is not, as the track says
    /// Along the object's true heading: the track's speed counts backwards where it is flipped.
    double speed = 0.0;
    double trueSpeed = 0.0;
    double trackSpeed = 0.0;  ///< as the track says it, along its own heading
    std::optional<double> yawRate;
    double length = 0.0;
    double width = 0.0;
    std::optional<double> lengthSigma;  ///< how sure of its length the track says it is
    double overlap = 0.0;               ///< bird's-eye IoU

    std::optional<double> range;  ///< of the object's centre from the sensor
    int points = -1;              ///< hits on the object, -1 if unknown
    FaceSet facesSeen;            ///< as the track says

    // Normalised squared errors e^T P^-1 e with the track's covariance; negative where that is not
    // positive definite. Heading modulo pi, speed along the true heading: a flip is a wrong
    // hypothesis, counted of its own, and no matter of the covariance.
    double neesPose = 0.0;      ///< x, y, heading: 3 degrees of freedom
    double neesSpeed = 0.0;     ///< 1
    double neesSize = 0.0;      ///< length and width, 2
    std::optional<double> nis;  ///< of the track's update in this frame, 3
};

/// By time, then by object. The yaw rate of the truth is the central difference of the headings in
/// the frames before and after, where both hold the object within 0.5 s.
std::vector<PoseError> poseErrors(const Sequence& sequence,
                                  const std::vector<FrameMatches>& matches);

}  // namespace vdamf
