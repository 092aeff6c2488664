// SPDX-License-Identifier: BSD-3-Clause
// One scan of a LADAR through a scene.
#include "vdamf/simulation/ray_caster.h"

#include <algorithm>
#include <cmath>

#include "placed_objects.h"

namespace vdamf
{
namespace
{
struct Target
{
    SurfaceHit hit;
    int object;
};

/// Paint and glass mirror most of the light away, so that little of it comes back from a slanted
/// surface. Asphalt and the like are rough: however flat the ray, it meets grains that face it.
/// HDL-64E scans show asphalt, all of it, to 60 m, where rays come in at 2 degrees.
double shareTowardsSensor(Material material, double cosIncidence)
{
    constexpr double kRough = 0.6;
    switch (material)
    {
        case Material::Paint:
        case Material::Glass:
        case Material::Metal:
            return cosIncidence;
        default:
            return std::max(cosIncidence, kRough);
    }
}

Target nearestSurface(const Terrain& ground, const std::vector<PlacedObject>& objects,
                      const Fan& fan, const Ray& ray, double maxRange, RandomStream& random)
{
    Target nearest{{maxRange, 0.0, Material::Asphalt}, LadarReturn::kNone};
    for (const int index : fan.objects)
    {
        const PlacedObject& object = objects[static_cast<std::size_t>(index)];
        if (!mayHit(object, ray)) continue;
        const std::optional<SurfaceHit> hit =
            firstHit(*object.body, inBodyFrame(object, ray), random);
        if (hit && hit->range < nearest.hit.range) nearest = {*hit, index};
    }
    const std::optional<SurfaceHit> onGround = ground.firstHit(ray, nearest.hit.range);
    if (onGround) nearest = {*onGround, LadarReturn::kGround};
    return nearest;
}

double reflectivityOf(const Scene& scene, const Target& target)
{
    if (target.hit.material != Material::Paint || target.object < 0)
    {
        return reflectivity(target.hit.material);
    }
    return scene.objects[static_cast<std::size_t>(target.object)].paint;
}

/// What of a target comes back: losses, then noise.
LadarReturn received(const Target& target, double targetReflectivity, const LadarMount& mount,
                     RandomStream& random)
{
    const SurfaceHit& hit = target.hit;
    if (target.object == LadarReturn::kNone) return {};
    if (hit.range < mount.ladar.minRange) return {};
    if (hit.material == Material::Glass && random.uniform() < mount.glassLoss) return {};
    const double spread = 10.0 / hit.range;
    const double strength =
        targetReflectivity * shareTowardsSensor(hit.material, hit.cosIncidence) * spread * spread;
    const double lossRatio = mount.halfLossStrength / strength;
    const double lossOdds = lossRatio * lossRatio;
    if (random.uniform() * (1.0 + lossOdds) < lossOdds) return {};
    const double range = hit.range + mount.ladar.rangeNoise * random.gaussian();
    if (range < mount.ladar.minRange || range > mount.ladar.maxRange) return {};
    return {range, targetReflectivity, target.object};
}

/// The sensor in the scene.
struct SensorPose
{
    Eigen::Vector3d position;
    Eigen::Matrix3d attitude;
    bool isUpright;
};

SensorPose sensorAt(const Scene& scene, const LadarMount& mount, double time)
{
    const GroundPose platform = platformPoseAt(scene, time);
    const Eigen::Matrix3d attitude = platform.attitude();
    const bool isUpright =
        platform.pitch == 0.0 && platform.roll == 0.0 && mount.pitch == 0.0 && mount.roll == 0.0;
    return {platform.position + attitude * mount.position,
            attitude * attitudeOf(mount.heading, mount.pitch, mount.roll), isUpright};
}

/// Sines and cosines of the elevations, and azimuths of the lasers within a firing.
struct Beams
{
    std::vector<double> cosElevation;
    std::vector<double> sinElevation;
    std::vector<double> azimuthDelay;  ///< rad
};

Beams beamsOf(const SpinningLadar& ladar, const Sweep& sweep)
{
    Beams beams;
    for (std::size_t laser = 0; laser < ladar.elevations.size(); ++laser)
    {
        beams.cosElevation.push_back(std::cos(ladar.elevations[laser]));
        beams.sinElevation.push_back(std::sin(ladar.elevations[laser]));
        beams.azimuthDelay.push_back(ladar.laserDelays[laser] / sweep.period * sweep.azimuthStep);
    }
    return beams;
}

/// Directions of a firing's rays in the scene.
std::vector<Eigen::Vector3d> directionsOf(const Beams& beams, const SensorPose& sensor,
                                          double azimuth)
{
    std::vector<Eigen::Vector3d> directions;
    directions.reserve(beams.cosElevation.size());
    for (std::size_t laser = 0; laser < beams.cosElevation.size(); ++laser)
    {
        const double angle = azimuth + beams.azimuthDelay[laser];
        const double horizontal = beams.cosElevation[laser];
        directions.push_back(sensor.attitude * Eigen::Vector3d(horizontal * std::cos(angle),
                                                               -horizontal * std::sin(angle),
                                                               beams.sinElevation[laser]));
    }
    return directions;
}

double bearing(const Eigen::Vector3d& direction)
{
    return std::atan2(direction.y(), direction.x());
}

/// What the rays of one firing may meet. Those of an upright sensor differ in their bearing by
/// one step at most; those of a tilted one by more.
Fan fanOfFiring(const std::vector<PlacedObject>& objects, const SensorPose& sensor,
                const std::vector<Eigen::Vector3d>& directions, double azimuthStep)
{
    const double first = bearing(directions.front());
    double width = std::abs(azimuthStep);
    if (!sensor.isUpright)
    {
        for (const Eigen::Vector3d& direction : directions)
        {
            width = std::max(width, std::abs(wrapAngle(bearing(direction) - first)));
        }
    }
    return fanOf(objects, sensor.position.head<2>(), first, width);
}

/// Platform and objects at one instant.
struct Instant
{
    std::vector<PlacedObject> objects;
    SensorPose sensor;
};

Instant instantAt(const Scene& scene, const LadarMount& mount, double time)
{
    return {placedAt(scene, time), sensorAt(scene, mount, time)};
}

std::vector<LadarReturn> castFiring(const Scene& scene, const Instant& instant,
                                    const LadarMount& mount,
                                    const std::vector<Eigen::Vector3d>& directions, const Fan& fan,
                                    RandomStream& random)
{
    std::vector<LadarReturn> returns(directions.size());
    for (std::size_t laser = 0; laser < returns.size(); ++laser)
    {
        const Ray ray{instant.sensor.position, directions[laser]};
        const Target target =
            nearestSurface(scene.terrain, instant.objects, fan, ray, mount.ladar.maxRange, random);
        returns[laser] = received(target, reflectivityOf(scene, target), mount, random);
    }
    return returns;
}
}  // namespace

std::vector<LadarFiring> castScan(const Scene& scene, const LadarMount& mount, double time,
                                  RandomStream& random)
{
    const Sweep sweep = sweepOf(mount.ladar, mount.rate, mount.fieldOfView);
    const Beams beams = beamsOf(mount.ladar, sweep);
    std::vector<LadarFiring> firings(static_cast<std::size_t>(sweep.firings));
    Instant instant = instantAt(scene, mount, time);
    for (int i = 0; i < sweep.firings; ++i)
    {
        LadarFiring& firing = firings[static_cast<std::size_t>(i)];
        firing.time = time + i * sweep.period;
        firing.azimuth = sweep.firstAzimuth + i * sweep.azimuthStep;
        if (std::abs(wrapAngle(firing.azimuth)) > 0.5 * mount.fieldOfView + 1e-9)
        {
            firing.returns.resize(mount.ladar.elevations.size());
            continue;
        }
        if (!mount.instantaneous) instant = instantAt(scene, mount, firing.time);
        const auto directions = directionsOf(beams, instant.sensor, firing.azimuth);
        const Fan fan = fanOfFiring(instant.objects, instant.sensor, directions, sweep.azimuthStep);
        firing.returns = castFiring(scene, instant, mount, directions, fan, random);
    }
    return firings;
}

std::vector<int> countHits(const std::vector<LadarFiring>& scan, std::size_t objects)
{
    std::vector<int> hits(objects, 0);
    for (const LadarFiring& firing : scan)
    {
        for (const LadarReturn& one : firing.returns)
        {
            if (one.object >= 0) ++hits[static_cast<std::size_t>(one.object)];
        }
    }
    return hits;
}

}  // namespace vdamf
