// SPDX-License-Identifier: BSD-3-Clause
// One revolution of a spinning LADAR through a scene.
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

Target nearestSurface(const std::vector<PlacedObject>& objects, const Fan& fan, const Ray& ray,
                      RandomStream& random)
{
    Target nearest{{0.0, 0.0, Material::Asphalt}, LadarReturn::kNone};
    if (ray.direction.z() < 0.0)
    {
        nearest.object = LadarReturn::kGround;
        nearest.hit.range = -ray.origin.z() / ray.direction.z();
        nearest.hit.cosIncidence = -ray.direction.z();
    }
    for (const int index : fan.objects)
    {
        const PlacedObject& object = objects[static_cast<std::size_t>(index)];
        if (!mayHit(object, ray)) continue;
        const std::optional<SurfaceHit> hit =
            firstHit(*object.body, inBodyFrame(object, ray), random);
        if (!hit) continue;
        const bool isNearer =
            nearest.object == LadarReturn::kNone || hit->range < nearest.hit.range;
        if (isNearer) nearest = {*hit, index};
    }
    return nearest;
}

/// What of a target comes back: losses, then noise.
LadarReturn received(const Target& target, const LadarMount& mount, RandomStream& random)
{
    const SurfaceHit& hit = target.hit;
    if (target.object == LadarReturn::kNone) return {};
    if (hit.range < mount.ladar.minRange || hit.range > mount.ladar.maxRange) return {};
    if (hit.material == Material::Glass && random.uniform() < mount.glassLoss) return {};
    const double spread = 10.0 / hit.range;
    const double strength = reflectivity(hit.material) * hit.cosIncidence * spread * spread;
    const double lossRatio = mount.halfLossStrength / strength;
    const double lossOdds = lossRatio * lossRatio;
    if (random.uniform() * (1.0 + lossOdds) < lossOdds) return {};
    const double range = hit.range + mount.ladar.rangeNoise * random.gaussian();
    if (range < mount.ladar.minRange || range > mount.ladar.maxRange) return {};
    return {range, reflectivity(hit.material), target.object};
}

/// The sensor in the scene.
struct SensorPose
{
    Eigen::Vector3d position;
    double heading;
};

SensorPose sensorAt(const Scene& scene, const LadarMount& mount, double time)
{
    const MotionState platform = scene.platform.at(time);
    const Eigen::Vector2d inScene = Eigen::Vector2d(platform.x, platform.y) +
                                    rotation(platform.heading) * mount.position.head<2>();
    return {{inScene.x(), inScene.y(), mount.position.z()}, platform.heading + mount.heading};
}

/// Sines and cosines of the elevations, and azimuths of the lasers within a firing.
struct Beams
{
    std::vector<double> cosElevation;
    std::vector<double> sinElevation;
    std::vector<double> azimuthDelay;  ///< rad
    double azimuthStep;                ///< from firing to firing, rad
};

Beams beamsOf(const SpinningLadar& ladar, int firings)
{
    Beams beams;
    beams.azimuthStep = 2.0 * kPi / firings;
    for (std::size_t laser = 0; laser < ladar.elevations.size(); ++laser)
    {
        beams.cosElevation.push_back(std::cos(ladar.elevations[laser]));
        beams.sinElevation.push_back(std::sin(ladar.elevations[laser]));
        beams.azimuthDelay.push_back(ladar.laserDelays[laser] / ladar.firingPeriod *
                                     beams.azimuthStep);
    }
    return beams;
}

std::vector<LadarReturn> castFiring(const std::vector<PlacedObject>& objects,
                                    const LadarMount& mount, const SensorPose& sensor,
                                    const Beams& beams, double azimuth, RandomStream& random)
{
    const double heading = sensor.heading - azimuth;  // azimuth counts clockwise
    const Fan fan = fanOf(objects, sensor.position.head<2>(), heading, beams.azimuthStep);
    std::vector<LadarReturn> returns(beams.cosElevation.size());
    for (std::size_t laser = 0; laser < returns.size(); ++laser)
    {
        const double direction = heading - beams.azimuthDelay[laser];
        const double horizontal = beams.cosElevation[laser];
        const Ray ray{sensor.position,
                      {horizontal * std::cos(direction), horizontal * std::sin(direction),
                       beams.sinElevation[laser]}};
        returns[laser] = received(nearestSurface(objects, fan, ray, random), mount, random);
    }
    return returns;
}
}  // namespace

std::vector<LadarFiring> castRevolution(const Scene& scene, const LadarMount& mount, double time,
                                        RandomStream& random)
{
    const int count = mount.ladar.firingsPerRevolution(mount.rate);
    const Beams beams = beamsOf(mount.ladar, count);
    std::vector<LadarFiring> firings(static_cast<std::size_t>(count));
    std::vector<PlacedObject> objects = placedAt(scene, time);
    SensorPose sensor = sensorAt(scene, mount, time);
    for (int i = 0; i < count; ++i)
    {
        LadarFiring& firing = firings[static_cast<std::size_t>(i)];
        firing.time = time + i * mount.ladar.firingPeriod;
        firing.azimuth = i * beams.azimuthStep;
        if (!mount.instantaneous)
        {
            objects = placedAt(scene, firing.time);
            sensor = sensorAt(scene, mount, firing.time);
        }
        if (std::abs(wrapAngle(firing.azimuth)) > 0.5 * mount.fieldOfView + 1e-9)
        {
            firing.returns.resize(mount.ladar.elevations.size());
            continue;
        }
        firing.returns = castFiring(objects, mount, sensor, beams, firing.azimuth, random);
    }
    return firings;
}

std::vector<int> countHits(const std::vector<LadarFiring>& revolution, std::size_t objects)
{
    std::vector<int> hits(objects, 0);
    for (const LadarFiring& firing : revolution)
    {
        for (const LadarReturn& one : firing.returns)
        {
            if (one.object >= 0) ++hits[static_cast<std::size_t>(one.object)];
        }
    }
    return hits;
}

}  // namespace vdamf
