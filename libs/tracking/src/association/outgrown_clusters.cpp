// SPDX-License-Identifier: BSD-3-Clause
#include "association/outgrown_clusters.h"

#include <algorithm>
#include <cmath>

#include "types/append_hit.h"
#include "types/cluster_bounds.h"

namespace vdamf
{
namespace
{
constexpr double kSurePosition = 0.5;  // m; vaguer targets do not tell where to cut
// m; of a size along which a vehicle may be outgrown: widths that are assumed are that sure, and
// lengths are not.
constexpr double kSureSize = 0.35;
constexpr std::size_t kLeastHits = 5;  // on a vehicle, and off it

std::vector<PredictedTarget> knownAmong(const std::vector<PredictedTarget>& targets)
{
    std::vector<PredictedTarget> known;
    for (const PredictedTarget& t : targets)
        if (t.isCar && t.positionSigma.maxCoeff() < kSurePosition &&
            std::min(t.lengthSigma, t.widthSigma) < kSureSize)
            known.push_back(t);
    return known;
}

std::vector<PlaneBounds> boundsOf(const std::vector<PredictedTarget>& targets)
{
    std::vector<PlaneBounds> bounds;
    bounds.reserve(targets.size());
    for (const PredictedTarget& t : targets)
        bounds.push_back(
            PlaneBounds::around(t.box.centre(), 0.5 * std::hypot(t.box.length, t.box.width)));
    return bounds;
}

PlaneBounds planeBoundsOf(const Cluster& cluster)
{
    const ClusterBounds b = boundsOf(cluster);
    return {Eigen::Vector2f(b.minX, b.minY).cast<double>(),
            Eigen::Vector2f(b.maxX, b.maxY).cast<double>()};
}

// A vehicle as hits see it.
class VehicleSurface
{
public:
    VehicleSurface(const PredictedTarget& vehicle, const Eigen::Vector2d& sensor,
                   const AssociationOptions& options)
        : half_(0.5 * vehicle.box.length, 0.5 * vehicle.box.width),
          centre_(vehicle.box.centre()),
          velocity_(vehicle.velocity),
          toBox_(rotation(vehicle.box.heading).transpose()),
          view_(toBoxFrame(vehicle.box, sensor)),
          weight_(
              (vehicle.positionSigma.array().square() + options.surfaceSigma * options.surfaceSigma)
                  .inverse())
    {
        const auto most = [](double size, double slack, double sigma)
        { return sigma < kSureSize ? size + slack + 2.0 * sigma : 1e30; };
        most_ = {most(vehicle.box.length, options.lengthSlack, vehicle.lengthSigma),
                 most(vehicle.box.width, options.widthSlack, vehicle.widthSigma)};
    }

    // Along and across the box, from its centre at the time of the hit.
    Eigen::Vector2d placeOf(const Cluster& cluster, std::size_t i) const
    {
        Eigen::Vector2d p(static_cast<double>(cluster.x[i]), static_cast<double>(cluster.y[i]));
        if (!cluster.time.empty()) p -= static_cast<double>(cluster.time[i]) * velocity_;
        return toBox_ * (p - centre_);
    }

    bool isOutgrownBy(const Cluster& cluster) const
    {
        Eigen::Vector2d min(1e30, 1e30);
        Eigen::Vector2d max = -min;
        for (std::size_t i = 0; i < cluster.size(); ++i)
        {
            const Eigen::Vector2d p = placeOf(cluster, i);
            min = min.cwiseMin(p);
            max = max.cwiseMax(p);
            if (((max - min).array() > most_.array()).any()) return true;
        }
        return false;
    }

    // Behind the faces that look away from the sensor the vehicle hides what there is of it, so
    // what is seen there is not its own. Elsewhere its hits scatter about its box.
    bool has(const Eigen::Vector2d& place) const
    {
        double squares = 0.0;
        for (int axis = 0; axis < 2; ++axis)
        {
            const double out = std::abs(place(axis)) - half_(axis);
            if (out <= 0.0) continue;
            const bool isBehind =
                std::abs(view_(axis)) > half_(axis) && view_(axis) * place(axis) < 0.0;
            if (isBehind) return false;
            squares += out * out * weight_(axis);
        }
        return squares < 1.0;
    }

private:
    Eigen::Vector2d half_;  // m
    Eigen::Vector2d centre_;
    Eigen::Vector2d velocity_;
    Eigen::Matrix2d toBox_;
    Eigen::Vector2d view_;    // of the sensor, in the box
    Eigen::Vector2d weight_;  // inverse variances along and across, 1/m^2
    Eigen::Vector2d most_;    // extents of a cluster that is the vehicle's alone, m
};

// Whose the hits of a cluster are: of the first vehicle that has them, or of none.
struct Shares
{
    Shares(const Cluster& cluster, const std::vector<VehicleSurface>& vehicles)
        : owner(cluster.size(), vehicles.size()), hits(vehicles.size() + 1, 0)
    {
        for (std::size_t k = 0; k < vehicles.size(); ++k)
            for (std::size_t i = 0; i < cluster.size(); ++i)
                if (owner[i] == vehicles.size() && vehicles[k].has(vehicles[k].placeOf(cluster, i)))
                    owner[i] = k;
        for (const std::size_t k : owner) ++hits[k];
    }

    // Of both.
    bool areEnough() const
    {
        return hits.back() >= kLeastHits &&
               std::any_of(hits.begin(), hits.end() - 1,
                           [](std::size_t count) { return count >= kLeastHits; });
    }

    std::vector<std::size_t> owner;  // of each hit, among the vehicles and then none
    std::vector<std::size_t> hits;   // of each owner
};
}  // namespace

KnownVehicles::KnownVehicles(const std::vector<PredictedTarget>& targets,
                             const AssociationOptions& options)
    : options_(options), vehicles_(knownAmong(targets)), index_(boundsOf(vehicles_))
{
}

std::optional<CutCluster> KnownVehicles::cut(const Cluster& cluster,
                                             const Eigen::Vector2d& sensor) const
{
    if (cluster.size() < 2 * kLeastHits || vehicles_.empty()) return std::nullopt;
    std::vector<VehicleSurface> outgrown;
    for (const std::size_t k : index_.overlapping(planeBoundsOf(cluster)))
    {
        const VehicleSurface surface(vehicles_[k], sensor, options_);
        if (surface.isOutgrownBy(cluster)) outgrown.push_back(surface);
    }
    if (outgrown.empty()) return std::nullopt;
    const Shares shares(cluster, outgrown);
    if (!shares.areEnough()) return std::nullopt;
    CutCluster parts;
    parts.vehicles.resize(outgrown.size());
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const std::size_t k = shares.owner[i];
        appendHit(k < outgrown.size() ? parts.vehicles[k] : parts.rest, cluster, i);
    }
    parts.vehicles.erase(
        std::remove_if(parts.vehicles.begin(), parts.vehicles.end(),
                       [](const Cluster& piece) { return piece.size() < kLeastHits; }),
        parts.vehicles.end());
    return parts;
}

}  // namespace vdamf
