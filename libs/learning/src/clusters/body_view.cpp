// SPDX-License-Identifier: BSD-3-Clause
#include "clusters/body_view.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "vdamf/simulation/spinning_ladar.h"

namespace vdamf
{
namespace
{
constexpr double kGlassLoss = 0.8;

struct NearestHit
{
    SurfaceHit hit;
    std::size_t body;
};

std::optional<NearestHit> nearestHit(const std::vector<StandingBody>& bodies, const Ray& ray,
                                     RandomStream& random)
{
    std::optional<NearestHit> nearest;
    for (std::size_t k = 0; k < bodies.size(); ++k)
    {
        const StandingBody& standing = bodies[k];
        const Eigen::Matrix2d toBody = rotation(-standing.heading);
        Ray local = ray;
        local.origin.head<2>() = toBody * (ray.origin.head<2>() - standing.position);
        local.direction.head<2>() = toBody * ray.direction.head<2>();
        const std::optional<SurfaceHit> hit = firstHit(standing.body, local, random);
        if (!hit || (nearest && nearest->hit.range < hit->range)) continue;
        if (ray.origin.z() + hit->range * ray.direction.z() > standing.visibleTop) continue;
        nearest = {*hit, k};
    }
    return nearest;
}

void add(BodyView& view, const Eigen::Vector3d& point, std::size_t body)
{
    constexpr double kLowest = 0.22;  // m
    constexpr double kHighest = 3.0;  // m
    if (point.z() < kLowest || point.z() > kHighest) return;
    view.cluster.x.push_back(static_cast<float>(point.x()));
    view.cluster.y.push_back(static_cast<float>(point.y()));
    view.cluster.z.push_back(static_cast<float>(point.z()));
    view.cluster.height.push_back(static_cast<float>(point.z()));
    view.body.push_back(body);
}

void addHit(BodyView& view, std::size_t from, const BodyView& other)
{
    add(view, {other.cluster.x[from], other.cluster.y[from], other.cluster.z[from]},
        other.body[from]);
}
}  // namespace

std::size_t BodyView::hitsOn(std::size_t which) const
{
    return static_cast<std::size_t>(std::count(body.begin(), body.end(), which));
}

BodyView viewOf(const std::vector<StandingBody>& bodies, const OrientedBox& target,
                double rangeNoise, RandomStream& random)
{
    constexpr double kAround = 3.0;  // m
    const SpinningLadar ladar = ladarOf(LadarModel::HDL32E);
    const double step = 2.0 * kPi / ladar.firingsPerRevolution(10.0);
    const double height = 1.7 + 0.4 * random.uniform();
    const double bearing = std::atan2(target.y, target.x);
    const double reach = 0.5 * std::hypot(target.length, target.width) + kAround;
    const double half = std::atan2(reach, std::max(1.0, target.centre().norm() - reach));
    BodyView view;
    for (double azimuth = bearing - half + step * random.uniform(); azimuth < bearing + half;
         azimuth += step)
    {
        for (const double elevation : ladar.elevations)
        {
            const Eigen::Vector3d direction(std::cos(elevation) * std::cos(azimuth),
                                            std::cos(elevation) * std::sin(azimuth),
                                            std::sin(elevation));
            const Ray ray{{0.0, 0.0, height}, direction};
            const std::optional<NearestHit> nearest = nearestHit(bodies, ray, random);
            if (!nearest) continue;
            if (nearest->hit.material == Material::Glass && random.uniform() < kGlassLoss) continue;
            const double range = nearest->hit.range + rangeNoise * random.gaussian();
            add(view, ray.origin + range * direction, nearest->body);
        }
    }
    return view;
}

BodyView partlyHidden(const BodyView& view, RandomStream& random)
{
    if (view.body.empty()) return view;
    const double middle = std::atan2(view.cluster.y[0], view.cluster.x[0]);
    std::vector<double> bearings;
    for (std::size_t i = 0; i < view.body.size(); ++i)
    {
        bearings.push_back(wrapAngle(std::atan2(view.cluster.y[i], view.cluster.x[i]) - middle));
    }
    const auto [low, high] = std::minmax_element(bearings.begin(), bearings.end());
    const double hidden = (0.3 + 0.3 * random.uniform()) * (*high - *low);
    const bool fromLow = random.uniform() < 0.5;
    BodyView rest;
    for (std::size_t i = 0; i < view.body.size(); ++i)
    {
        const double fromEnd = fromLow ? bearings[i] - *low : *high - bearings[i];
        if (fromEnd >= hidden) addHit(rest, i, view);
    }
    return rest;
}

}  // namespace vdamf
