// SPDX-License-Identifier: BSD-3-Clause
// Hits as a spinning LADAR sees them on a box, for tests of the matched filter.
#pragma once

#include <random>

#include "tracking/sensor_at_origin.h"
#include "vdamf/tracking/matched_filter/hits.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
// A car left ahead of the sensor that shows its back and its left side.
inline const OrientedBox kCar{15.0, 5.0, 0.9, 4.5, 1.8};

/// The corner between its back and its left side.
inline Eigen::Vector2d nearCorner(const OrientedBox& box)
{
    return corners(box)[1];
}

/// A box near it, where a search for it may start.
inline OrientedBox disturbed(const OrientedBox& box, unsigned seed)
{
    std::mt19937 generator(seed);
    std::normal_distribution<double> gauss;
    OrientedBox start = box;
    start.x += 0.3 * gauss(generator);
    start.y += 0.3 * gauss(generator);
    start.heading += 8.0 * kDegree * gauss(generator);
    start.length += 0.3 * gauss(generator);
    start.width += 0.3 * gauss(generator);
    return start;
}

/// `count` hits on the faces of `box` that a sensor at the origin sees, uniform in bearing, with
/// Gaussian range noise, plus a share of hits in the interior.
inline Hits exampleHits(const OrientedBox& box, int count, double noise, double interiorShare,
                        unsigned seed)
{
    std::mt19937 generator(seed);
    const auto uniform = [&](double a, double b)
    { return a + (b - a) * static_cast<double>(generator()) / 4294967295.0; };
    std::normal_distribution<double> gauss(0.0, 1.0);
    const auto corner = corners(box);
    const double centre = std::atan2(box.y, box.x);
    Hits hits;
    const double reach = std::atan2(0.5 * std::hypot(box.length, box.width), box.centre().norm());
    while (static_cast<int>(hits.size()) < count)
    {
        const double bearing = centre + uniform(-reach, reach);
        const Eigen::Vector2d ray(std::cos(bearing), std::sin(bearing));
        double range = 1e9;
        for (std::size_t k = 0; k < 4; ++k)
        {
            const Eigen::Vector2d a = corner[k];
            const Eigen::Vector2d e = corner[(k + 1) % 4] - a;
            const double det = ray.x() * -e.y() + ray.y() * e.x();
            if (std::abs(det) < 1e-9) continue;
            const double r = (a.x() * -e.y() + a.y() * e.x()) / det;
            const double s = (ray.x() * a.y() - ray.y() * a.x()) / det;
            if (s >= 0.0 && s <= 1.0 && r > 0.0) range = std::min(range, r);
        }
        if (range > 1e8) continue;
        Eigen::Vector2d p = (range + noise * gauss(generator)) * ray;
        if (uniform(0.0, 1.0) < interiorShare)
            p = box.centre() +
                rotation(box.heading) * Eigen::Vector2d(uniform(-0.5, 0.5) * box.length,
                                                        uniform(-0.5, 0.5) * box.width);
        hits.x.push_back(p.x());
        hits.y.push_back(p.y());
        hits.weight.push_back(1.0);
        hits.totalWeight += 1.0;
    }
    return hits;
}

}  // namespace vdamf
