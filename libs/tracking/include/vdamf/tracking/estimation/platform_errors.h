// SPDX-License-Identifier: BSD-3-Clause
// By how much the platform's own pose errs, as what stands tells it: where an INS drifts or jumps,
// everything seems to move alike.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vdamf/tracking/estimation/box_measurement.h"
#include "vdamf/tracking/types/options.h"
#include "vdamf/tracking/types/plane_motion.h"

namespace vdamf
{
struct AlignmentOptions
{
    bool enabled = true;
    double from = 0.04;                ///< m
    double fromTurn = 0.15 * kDegree;  ///< rad
    double returnTime = 120.0;         ///< s

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.enabled, "enabled",
              "where the poses err, tracks go by what stands: parked cars stay parked");
        field(self.from, "from_m", 0.0, 10.0,
              "standard deviation of the change of their errors from frame to frame, from which "
              "tracks do so");
        field(self.fromTurn, "from_deg", 0.0, 10.0, "the same of the heading");
        field(self.returnTime, "return_s", 1.0, 1e6,
              "time constant with which tracks come back to the world that the poses say");
    }
};

/// A point of something that stands: where it is seen, and by how much that is off.
struct StandingPoint
{
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< m
    Innovation innovation;  ///< of its place and heading; covariance with that of what was known
};

/// Place and heading of what is at a point by shift and turn of everything: their derivative.
Eigen::Matrix3d byMotion(const Eigen::Vector2d& point);

/// A motion with its covariance: of the shift by x and y and the turn, m and rad.
struct EstimatedMotion
{
    PlaneMotion motion;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// What all points have moved by together: least squares with the weights of Student's
/// distribution, as some of what stood sets off. `prior`: variances of what is known beforehand,
/// about no motion: by x and y, of the turn.
EstimatedMotion commonMotion(const std::vector<StandingPoint>& points,
                             const Eigen::Vector3d& prior);

/// Follows how much the error of the platform's pose changes from frame to frame.
class PlatformErrors
{
public:
    explicit PlatformErrors(const AlignmentOptions& options) : options_(options) {}

    /// By how much everything that stands has moved in the frame's axes since the frame before,
    /// `dt` seconds ago; nothing as long as such motions are no greater than options say.
    std::optional<EstimatedMotion> after(const std::vector<StandingPoint>& points, double dt);

    /// Variances of such a motion by x and y and of its turn, m^2 and rad^2: by what was seen of
    /// late.
    Eigen::Vector3d variances() const;

private:
    // Variance of what was seen of late, as far as it is more than its own errors; 0 at first.
    class Spread
    {
    public:
        void fade(double kept);
        void add(double square, double variance);
        double value() const;

    private:
        double sum_ = 0.0;
        double frames_ = 0.0;
    };

    AlignmentOptions options_;
    Spread shift_, turn_;
};

}  // namespace vdamf
