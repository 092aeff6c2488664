// SPDX-License-Identifier: BSD-3-Clause
// Which hits are a vehicle's, by its predicted box.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "vdamf/tracking/association/auction.h"
#include "vdamf/tracking/types/cluster.h"

namespace vdamf
{
/// m; of a size along which a vehicle may be outgrown: widths that are assumed are that sure, and
/// lengths are not.
inline constexpr double kSureSize = 0.35;

/// A vehicle as hits see it.
class VehicleSurface
{
public:
    VehicleSurface(const PredictedTarget& vehicle, const Eigen::Vector2d& sensor,
                   const AssociationOptions& options)
        : half_(0.5 * vehicle.box.length, 0.5 * vehicle.box.width),
          centre_(vehicle.box.centre()),
          velocity_(vehicle.velocity),
          toBox_(rotation(vehicle.box.heading).transpose())
    {
        const Eigen::Vector2d view = toBoxFrame(vehicle.box, sensor);
        const Eigen::Vector2d slack(options.lengthSlack, options.widthSlack);
        const Eigen::Vector2d sizeSigma(vehicle.lengthSigma, vehicle.widthSigma);
        most_ = 2.0 * half_ + slack + 2.0 * sizeSigma;
        // No hits far beyond a face that was measured, and is where it was, are the vehicle's.
        constexpr double kSure = 0.1;  // m
        constexpr double kAny = 1e30;
        const Eigen::Array2d sideSigma =
            Eigen::Array2d::Constant(std::max(sizeSigma.y(), vehicle.positionSigma.y()));
        const Eigen::Array2d faceSigma[2] = {vehicle.endSigma.array(), sideSigma};
        for (int axis = 0; axis < 2; ++axis)
        {
            const Eigen::Array2d reach = half_(axis) + slack(axis) + 4.0 * faceSigma[axis];
            const Eigen::Array2d far = (faceSigma[axis] < kSure).select(reach, kAny);
            lowest_(axis) = -far(0);
            highest_(axis) = far(1);
            if (sizeSigma(axis) >= kSureSize) most_(axis) = kAny;
        }
        const auto weightOf = [&options](double sigma)
        { return 1.0 / (sigma * sigma + options.surfaceSigma * options.surfaceSigma); };
        weights_.row(1).setConstant(weightOf(vehicle.positionSigma.y()));
        for (int end = 0; end < 2; ++end)
        {
            const double sigma = vehicle.endSigma(end);
            const bool isOpen = sigma >= kSureSize && sigma < PredictedTarget::kUnknown;
            weights_(0, end) = weightOf(isOpen ? sigma : vehicle.positionSigma.x());
            // Behind the faces that look away from the sensor the vehicle hides what there is of
            // it, so what is seen there is not its own, unless it may be longer at that end.
            for (int axis = 0; axis < 2; ++axis)
                if ((end == 0 ? view(axis) : -view(axis)) > half_(axis) && !(axis == 0 && isOpen))
                    weights_(axis, end) = std::numeric_limits<double>::infinity();
        }
    }

    /// Along and across the box, from its centre at the time of the hit.
    Eigen::Vector2d placeOf(const Cluster& cluster, std::size_t i) const
    {
        Eigen::Vector2d p(static_cast<double>(cluster.x[i]), static_cast<double>(cluster.y[i]));
        if (!cluster.time.empty()) p -= static_cast<double>(cluster.time[i]) * velocity_;
        return toBox_ * (p - centre_);
    }

    /// Whether not all hits of a cluster may be the vehicle's.
    bool isOutgrownBy(const Cluster& cluster) const;

    /// Whether a hit there is the vehicle's: they scatter about its box.
    bool has(const Eigen::Vector2d& place) const
    {
        double squares = 0.0;
        for (int axis = 0; axis < 2; ++axis)
        {
            const double out = std::abs(place(axis)) - half_(axis);
            if (out > 0.0) squares += out * out * weights_(axis, place(axis) > 0.0 ? 1 : 0);
        }
        return squares < 1.0;
    }

    /// The same of all hits of a cluster that belong to `none` so far: those that are the vehicle's
    /// belong to `vehicle` from then on. Returns how many they are.
    std::size_t claim(const Cluster& cluster, std::int32_t vehicle, std::int32_t none,
                      std::vector<std::int32_t>& owner) const;

private:
    Eigen::Vector2d half_;  // m
    Eigen::Vector2d centre_;
    Eigen::Vector2d velocity_;
    Eigen::Matrix2d toBox_;
    // Of each axis' ends: inverse variances, 1/m^2; infinite where the vehicle ends for sure.
    Eigen::Matrix2d weights_;
    Eigen::Vector2d most_;   // extents of a cluster that is the vehicle's alone, m
    Eigen::Array2d lowest_;  // places of its hits along and across, m
    Eigen::Array2d highest_;
};

}  // namespace vdamf
