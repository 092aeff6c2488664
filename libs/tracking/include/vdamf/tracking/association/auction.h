// SPDX-License-Identifier: BSD-3-Clause
// Section 2: clusters are assigned to tracks by a simple auction; a track may take several
// clusters if they are consistent with its predicted box.
#pragma once

#include <cstddef>
#include <vector>

#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/hits.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
struct AssociationOptions
{
    double surfaceSigma = 0.3;      ///< m
    double gateProbability = 0.99;  ///< that a hit of a target lies inside its gate
    double lengthSlack = 0.6;       ///< m
    double widthSlack = 0.5;        ///< m

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.surfaceSigma, "surface_sigma_m", 0.05, 2.0,
              "scatter of a target's hits about its predicted box");
        field(self.gateProbability, "gate_probability", 0.1, 0.999999,
              "share of a target's hits that lie inside its gate about the predicted box; hits "
              "outside of it speak against the target");
        field(self.lengthSlack, "length_slack_m", 0.0, 5.0,
              "by which several clusters together may exceed the predicted length");
        field(self.widthSlack, "width_slack_m", 0.0, 5.0,
              "by which several clusters together may exceed the predicted width");
    }
};

/// What the auction knows of a track.
struct PredictedTarget
{
    static constexpr double kUnknown = 1e3;  ///< m

    OrientedBox box;  ///< in the frame of the hits
    Eigen::Vector2d positionSigma =
        Eigen::Vector2d::Zero();  ///< of the centre along and across the box, m
    double lengthSigma = 0.0;     ///< m
    double widthSigma = 0.0;      ///< m
    /// With which the box moves on to the time of each cluster (Hits::time), m/s.
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    /// Of the places of its rear and its front along the box, m.
    Eigen::Vector2d endSigma = Eigen::Vector2d::Constant(kUnknown);
    /// Of the speed along the box, m/s, and its covariance with the place of the centre along it,
    /// m^2/s: at the time of a cluster that place is better or less known than at the frame's.
    double speedSigma = 0.0;
    double speedCovariance = 0.0;
    /// The most that counts of what its place is uncertain by, m: farther off, hits are no likelier
    /// its own than those of a new one.
    double greatestSigma = 2.0;
    /// Surely a vehicle that ends where its box does: what goes on beyond is something else. Trucks
    /// are open between their axles, and what is taken for the end of one may be: a truck is where
    /// its size is known.
    bool isBounded = false;
    /// Surely a truck or bus that drives: what lies beside it is something else.
    bool isDrivingTruck = false;
    bool isClutter = false;  ///< surely, and no vehicle
    double hits = 0.0;       ///< with which it was seen last; 0: not known
};

/// For each target the indices of its clusters, rising; a cluster goes to one target at most.
///
/// A cluster's benefit for a target is the log likelihood of its hits about the predicted box
/// against that of a new object. Every cluster bids for the target that it benefits most from; a
/// target takes the best bids whose union stays within its box plus slack (the best one always)
/// and turns down the rest, which then bid elsewhere. Ends as no pair is turned down twice.
/// `isVehicle`, where not empty: clusters that are no clutter's.
std::vector<std::vector<std::size_t>> assignClusters(const std::vector<PredictedTarget>& targets,
                                                     const std::vector<Hits>& clusters,
                                                     const AssociationOptions& options,
                                                     const std::vector<bool>& isVehicle = {});

}  // namespace vdamf
