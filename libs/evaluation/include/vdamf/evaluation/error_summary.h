// SPDX-License-Identifier: BSD-3-Clause
// Pose errors in a few numbers: over all pairs, and by range, hits and faces seen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vdamf/evaluation/pose_errors.h"
#include "vdamf/evaluation/statistics.h"

namespace vdamf
{
/// Statistics of each member of PoseError; metres, radians, m/s.
struct ErrorSummary
{
    std::size_t pairs = 0;
    std::size_t flips = 0;                ///< pairs with front taken for rear
    std::size_t exchanged = 0;            ///< with length taken for width
    std::size_t exchangedThoughSure = 0;  ///< of those, that a track said to be 99 % sure not to be
    /// Of the pairs with the front where it is; nothing without pairs.
    std::optional<double> frontShare() const;
    ErrorStatistics position;
    ErrorStatistics longitudinal;
    ErrorStatistics lateral;
    ErrorStatistics corner;
    ErrorStatistics heading;
    ErrorStatistics headingAxis;
    ErrorStatistics speed;
    ErrorStatistics yawRate;
    ErrorStatistics length;
    ErrorStatistics width;
    ErrorStatistics overlap;  ///< of the IoU itself, not of an error
};

ErrorSummary summaryOf(const std::vector<PoseError>& errors);

/// The errors of the pairs that have something in common.
struct ErrorGroup
{
    std::string name;  ///< for example "10-20"
    ErrorSummary errors;
};

// Every group is there, also those without pairs. Pairs of which the quantity is unknown are in
// none of them.
/// Metres from the sensor: 0-10, 10-20, 20-40, 40-60, 60+.
std::vector<ErrorGroup> byRange(const std::vector<PoseError>& errors);
/// Hits on the object: 0-19, 20-49, 50-199, 200+.
std::vector<ErrorGroup> byPoints(const std::vector<PoseError>& errors);
/// Faces that the track says were seen: end only, side only, both, none.
std::vector<ErrorGroup> byFaces(const std::vector<PoseError>& errors);
/// Standard deviation of the length that the track tells, cm: 0-25, 25-50, 50-100, 100+. Where the
/// far end of a vehicle was not seen, half of what its length errs is in its position.
std::vector<ErrorGroup> byLengthSigma(const std::vector<PoseError>& errors);

/// Pairs with front taken for rear whose object moves: at standstill nothing tells the front.
std::size_t flipsOfMoving(const std::vector<PoseError>& errors, double stillSpeed);

/// Sizes of the speeds that tracks claim for objects whose true speed is below `stillSpeed`, m/s.
ErrorStatistics phantomSpeed(const std::vector<PoseError>& errors, double stillSpeed);

/// How far the positions of each track on an object whose true speed is below `stillSpeed` (m/s)
/// lie from their own mean, m: the RMS is the scatter of what stands still.
ErrorStatistics standingScatter(const std::vector<PoseError>& errors, double stillSpeed);

}  // namespace vdamf
