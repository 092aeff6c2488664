// SPDX-License-Identifier: BSD-3-Clause
// Which targets a cluster could belong to, and how much speaks for it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "association/plane_index.h"
#include "types/lanes.h"
#include "vdamf/tracking/association/auction.h"

namespace vdamf
{
/// Where the predicted box has its hits: with their scatter about it and its own uncertainty.
class TargetSurface
{
public:
    /// At the time of some hits, s after the frame's.
    TargetSurface(const PredictedTarget& target, double time, const AssociationOptions& options);

    /// Squared distance of a place from the box in standard deviations, 0 inside.
    double squaredDistance(double x, double y) const
    {
        const double dx = x - centre_.x();
        const double dy = y - centre_.y();
        const double outX =
            std::max(0.0, std::abs(forward_.cos * dx + forward_.sin * dy) - half_.x());
        const double outY =
            std::max(0.0, std::abs(forward_.cos * dy - forward_.sin * dx) - half_.y());
        return outX * outX * weight_.x() + outY * outY * weight_.y();
    }

    /// Log likelihood ratio of hits: on this target against on a new object.
    double benefit(const Hits& hits) const;

    /// Weight of the hits whose squared distance is greater than that.
    double weightBeyond(double squaredDistance, const Hits& hits) const;

private:
    // Squared distances of some places in standard deviations.
    [[gnu::always_inline]] void squares(const double* px, const double* py, std::size_t count,
                                        Doubles& square) const
    {
        Doubles x;
        Doubles y;
        load(x, px, count);
        load(y, py, count);
        x -= centre_.x();
        y -= centre_.y();
        const Doubles along = forward_.cos * x + forward_.sin * y;
        const Doubles across = forward_.cos * y - forward_.sin * x;
        const Doubles outX = (along < 0.0 ? -along : along) - half_.x();
        const Doubles outY = (across < 0.0 ? -across : across) - half_.y();
        const Doubles farX = outX > 0.0 ? outX : Doubles{};
        const Doubles farY = outY > 0.0 ? outY : Doubles{};
        square = weight_.x() * farX * farX + weight_.y() * farY * farY;
    }

    Eigen::Vector2d centre_;
    Eigen::Vector2d half_;
    Direction forward_;
    Eigen::Vector2d weight_;  // inverse variances along and across, 1/m^2
    double worth_;            // of a hit in the box
};

/// Squared distance of the gate, of a Gaussian in the plane: chi-square with 2 degrees of freedom.
double squaredGate(const AssociationOptions& options);

struct Candidate
{
    std::size_t target;
    double benefit;  ///< log likelihood ratio of all hits
};

/// Finds targets by place.
class CandidateFinder
{
public:
    /// For these clusters and no others; the targets have to outlive it.
    CandidateFinder(const std::vector<PredictedTarget>& targets, const std::vector<Hits>& clusters,
                    const AssociationOptions& options);

    /// Targets within whose gates a cluster may have hits, rising.
    std::vector<std::size_t> inReach(const Hits& hits) const;
    /// Targets that a cluster benefits from, best first; the earlier one of equals.
    std::vector<Candidate> candidates(const Hits& hits) const;

    /// Of a target at the time of some hits.
    TargetSurface surfaceOf(std::size_t target, const Hits& hits) const
    {
        return {targets_[target], hits.time, options_};
    }

private:
    const std::vector<PredictedTarget>& targets_;
    AssociationOptions options_;
    PlaneIndex index_;
};

}  // namespace vdamf
