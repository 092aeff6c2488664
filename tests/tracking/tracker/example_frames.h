// SPDX-License-Identifier: BSD-3-Clause
// Small synthetic frames for tests of the whole tracker: flat ground and box-shaped bodies seen by
// a spinning LADAR, hits by exact ray casting in the plane.
#pragma once

#include <random>
#include <vector>

#include "vdamf/tracking/tracker/tracker.h"
#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
struct ExampleBody
{
    OrientedBox box;  ///< world
    double height = 1.5;
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< during a revolution, world, m/s
};

/// Range along a ray in the plane to a box, or a large number.
inline double rangeTo(const OrientedBox& box, const Eigen::Vector2d& from,
                      const Eigen::Vector2d& ray)
{
    const auto corner = corners(box);
    double range = 1e9;
    for (std::size_t k = 0; k < 4; ++k)
    {
        const Eigen::Vector2d a = corner[k] - from;
        const Eigen::Vector2d e = corner[(k + 1) % 4] - corner[k];
        const double det = ray.y() * e.x() - ray.x() * e.y();
        if (std::abs(det) < 1e-9) continue;
        const double r = (a.y() * e.x() - a.x() * e.y()) / det;
        const double s = (ray.x() * a.y() - ray.y() * a.x()) / det;
        if (r > 0.0 && s >= 0.0 && s <= 1.0) range = std::min(range, r);
    }
    return range;
}

/// A frame at `time` (s) from a sensor 1.8 m above flat ground at `sensor` (world, m). With a
/// `period` (s) the sensor turns once in it, counter-clockwise from +x, and hits have times.
inline LadarFrame exampleFrame(double time, const Eigen::Vector2d& sensor,
                               const std::vector<ExampleBody>& bodies, unsigned seed,
                               double period = 0.0)
{
    constexpr double kSensorHeight = 1.8;
    constexpr double kMaxRange = 60.0;
    constexpr double kNoise = 0.02;
    std::mt19937 generator(seed);
    std::normal_distribution<double> gauss;
    LadarFrame frame;
    frame.time = time;
    frame.sensor = {sensor.x(), sensor.y(), kSensorHeight};
    frame.origin = Eigen::Vector3d(sensor.x(), sensor.y(), 0.0).array().round();
    for (int column = 0; column < 1200; ++column)
    {
        const double bearing = 2.0 * kPi * column / 1200;
        const Eigen::Vector2d ray(std::cos(bearing), std::sin(bearing));
        const double later = period * column / 1200;
        for (double elevation = -24.0; elevation <= 2.0; elevation += 0.8)
        {
            const double slope = std::tan(elevation * kPi / 180.0);
            double range = slope < 0.0 ? kSensorHeight / -slope : 1e9;
            for (const ExampleBody& body : bodies)
            {
                OrientedBox box = body.box;
                box.x += later * body.velocity.x();
                box.y += later * body.velocity.y();
                const double r = rangeTo(box, sensor, ray);
                const double z = kSensorHeight + slope * r;
                if (r < range && z > 0.0 && z < body.height) range = r;
            }
            if (range > kMaxRange) continue;
            range += kNoise * gauss(generator);
            const Eigen::Vector2d p = sensor + range * ray;
            frame.points.x.push_back(static_cast<float>(p.x() - frame.origin.x()));
            frame.points.y.push_back(static_cast<float>(p.y() - frame.origin.y()));
            frame.points.z.push_back(static_cast<float>(kSensorHeight + slope * range));
            if (period > 0.0) frame.points.time.push_back(static_cast<float>(later));
        }
    }
    return frame;
}

/// Upright boxes are hardly vehicles to the discriminator: options without it.
inline TrackerOptions optionsForBoxes()
{
    TrackerOptions options;
    options.discriminator.model = "none";
    return options;
}

/// Null: none within so many metres.
inline const TrackReport* confirmedNear(const FrameResult& frame, const Eigen::Vector2d& position,
                                        double within = 1.5)
{
    for (const TrackReport& track : frame.tracks)
        if (track.status == TrackStatus::Confirmed &&
            (track.box.centre() - position).norm() < within)
            return &track;
    return nullptr;
}

}  // namespace vdamf
