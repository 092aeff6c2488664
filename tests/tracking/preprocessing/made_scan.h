// SPDX-License-Identifier: BSD-3-Clause
// Scans of a made landscape with blocks on it, and which hit lies on what.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf::test
{
/// An upright block; bottom and top are heights over the landscape at its centre.
struct Block
{
    OrientedBox box;
    double bottom = 0.0;
    double top = 1.5;
};

struct Landscape
{
    /// Height at a place; the sensor stands over the place (0, 0).
    std::function<double(double, double)> ground = [](double, double) { return 0.0; };
    std::vector<Block> blocks;
};

struct Scanner
{
    int beams;
    double lowest;   ///< elevation, deg
    double highest;  ///< elevation, deg
    int columns;     ///< in a turn
};
inline constexpr Scanner kHdl64e{64, -24.8, 2.0, 1200};
inline constexpr Scanner kHdl32e{32, -30.67, 10.67, 1200};
inline constexpr Scanner kVlp16{16, -15.0, 15.0, 900};

struct MadeScan
{
    LadarFrame frame;
    std::vector<int> block;      ///< of each hit; -1: ground
    std::vector<double> height;  ///< of each hit over the landscape below it, m
};

namespace detail
{
// Way along the ray into the block; infinity where it passes. World axes, heights absolute.
inline double enters(const Block& block, double base, const Eigen::Vector3d& from,
                     const Eigen::Vector3d& ray)
{
    const Eigen::Matrix2d toBox = rotation(-block.box.heading);
    const Eigen::Vector2d p = toBox * (from.head<2>() - block.box.centre());
    const Eigen::Vector2d d = toBox * ray.head<2>();
    const double lower[3] = {-0.5 * block.box.length, -0.5 * block.box.width, base + block.bottom};
    const double upper[3] = {0.5 * block.box.length, 0.5 * block.box.width, base + block.top};
    const double start[3] = {p.x(), p.y(), from.z()};
    const double step[3] = {d.x(), d.y(), ray.z()};
    double in = 0.0;
    double out = INFINITY;
    for (int k = 0; k < 3; ++k)
    {
        const double a = (lower[k] - start[k]) / step[k];
        const double b = (upper[k] - start[k]) / step[k];
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
    }
    return in < out ? in : INFINITY;
}

// Way along the ray to the ground, up to 90 m; infinity where it does not get there.
inline double meetsGround(const Landscape& scene, const Eigen::Vector3d& from,
                          const Eigen::Vector3d& ray)
{
    const auto over = [&](double way)
    {
        const Eigen::Vector3d p = from + way * ray;
        return p.z() - scene.ground(p.x(), p.y());
    };
    double near = 0.0;
    for (double far = 0.5; far < 90.0; far += 0.25)
    {
        if (over(far) > 0.0)
        {
            near = far;
            continue;
        }
        for (int i = 0; i < 20; ++i)
            (over(0.5 * (near + far)) > 0.0 ? near : far) = 0.5 * (near + far);
        return near;
    }
    return INFINITY;
}

// Way along the ray to what it meets first, and the number of the block (-1: the ground).
inline std::pair<double, int> firstMet(const Landscape& scene, const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& ray)
{
    std::pair<double, int> first{meetsGround(scene, from, ray), -1};
    for (std::size_t i = 0; i < scene.blocks.size(); ++i)
    {
        const Block& block = scene.blocks[i];
        const double base = scene.ground(block.box.x, block.box.y);
        const double enter = enters(block, base, from, ray);
        if (enter < first.first) first = {enter, static_cast<int>(i)};
    }
    return first;
}
}  // namespace detail

/// One turn of a scanner `sensorHeight` above the landscape, with 2 cm range noise. The frame's
/// world is shifted, so that nothing can rely on an origin at the sensor or a known height.
inline MadeScan scan(const Landscape& scene, const Scanner& scanner, double sensorHeight)
{
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.02);
    const Eigen::Vector3d from(0.0, 0.0, scene.ground(0.0, 0.0) + sensorHeight);
    const Eigen::Vector3d originInScene(3.0, -2.0, 1.0);
    MadeScan made;
    made.frame.origin = {731.0, -2500.0, 114.0};
    made.frame.sensor = made.frame.origin + from - originInScene;
    const double step = (scanner.highest - scanner.lowest) / (scanner.beams - 1);
    for (int i = 0; i < scanner.beams * scanner.columns; ++i)
    {
        const int beam = i / scanner.columns;
        const double elevation = (scanner.lowest + step * beam) * kPi / 180.0;
        const double azimuth = (i % scanner.columns + 0.5) * 2.0 * kPi / scanner.columns;
        const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                  std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        const auto [way, block] = detail::firstMet(scene, from, ray);
        if (way > 100.0) continue;
        const Eigen::Vector3d inScene = from + (way + noise(random)) * ray;
        const Eigen::Vector3f point = (inScene - originInScene).cast<float>();
        made.frame.points.x.push_back(point.x());
        made.frame.points.y.push_back(point.y());
        made.frame.points.z.push_back(point.z());
        made.block.push_back(block);
        made.height.push_back(inScene.z() - scene.ground(inScene.x(), inScene.y()));
    }
    return made;
}

/// Cars of 4.5 x 1.8 x 1.5 m around the sensor, 5 to 35 m away.
inline std::vector<Block> parkedCars()
{
    std::vector<Block> cars;
    for (int i = 0; i < 12; ++i)
    {
        const double angle = 0.3 + i * 2.0 * kPi / 12.0;
        const double range = 6.0 + 2.5 * i;
        cars.push_back({{range * std::cos(angle), range * std::sin(angle), 1.1 * i, 4.5, 1.8}});
    }
    return cars;
}

}  // namespace vdamf::test
