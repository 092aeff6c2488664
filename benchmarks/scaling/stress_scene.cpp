// SPDX-License-Identifier: BSD-3-Clause
#include "scaling/stress_scene.h"

#include <algorithm>
#include <cmath>

#include "vdamf/simulation/random_stream.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kSensorHeight = 2.0;  // m
constexpr double kAlong = 7.0;         // m from car to car
constexpr double kAcross = 4.0;        // m from lane to lane
constexpr double kLength = 4.5;        // m
constexpr double kWidth = 1.8;         // m
constexpr double kSpacing = 0.27;      // m between columns of hits on a face
constexpr double kNoise = 0.02;        // m
constexpr double kFrameTime = 0.1;     // s

void addHit(PointCloud& points, double x, double y, double z, RandomStream& random)
{
    points.x.push_back(static_cast<float>(x + kNoise * random.gaussian()));
    points.y.push_back(static_cast<float>(y + kNoise * random.gaussian()));
    points.z.push_back(static_cast<float>(z - kSensorHeight));
}

// Columns of hits at three heights, from a to b.
void addFace(PointCloud& points, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
             RandomStream& random)
{
    const int columns = std::max(2, static_cast<int>((b - a).norm() / kSpacing));
    for (int k = 0; k < columns; ++k)
    {
        const Eigen::Vector2d p = a + (b - a) * ((k + 0.5) / columns);
        for (const double height : {0.5, 0.9, 1.3}) addHit(points, p.x(), p.y(), height, random);
    }
}

void addCar(PointCloud& points, const Eigen::Vector2d& centre, RandomStream& random)
{
    const double l = 0.5 * kLength;
    const double w = 0.5 * kWidth;
    const double end = centre.x() > 0.0 ? centre.x() - l : centre.x() + l;
    const double side = centre.y() > 0.0 ? centre.y() - w : centre.y() + w;
    if (std::abs(centre.x()) > l)
        addFace(points, {end, centre.y() - w}, {end, centre.y() + w}, random);
    if (std::abs(centre.y()) > w)
        addFace(points, {centre.x() - l, side}, {centre.x() + l, side}, random);
}

void addGround(PointCloud& points, RandomStream& random)
{
    constexpr int kColumns = 720;
    for (int beam = 0; beam < 48; ++beam)
    {
        const double range = kSensorHeight / std::tan((24.0 - 0.48 * beam) * kPi / 180.0);
        for (int column = 0; column < kColumns; ++column)
        {
            const double bearing = 2.0 * kPi * column / kColumns;
            addHit(points, range * std::cos(bearing), range * std::sin(bearing), 0.0, random);
        }
    }
}
}  // namespace

LadarFrame StressScene::frame(int number) const
{
    RandomStream random(1, static_cast<std::uint64_t>(number));
    LadarFrame frame;
    frame.time = kFrameTime * number;
    addGround(frame.points, random);
    const double side = std::sqrt(targets * kAlong * kAcross);
    const int lanes = std::max(1, static_cast<int>(std::lround(side / kAcross)));
    for (int k = 0; k < targets; ++k)
    {
        const int lane = k % lanes;
        const double speed = (lane % 2 == 0 ? 1.0 : -1.0) * (5.0 + (3 * lane) % 11);
        const double x = kAlong * (k / lanes + 0.5) - 0.5 * side + speed * frame.time;
        addCar(frame.points, {x, kAcross * (lane + 0.5) - 0.5 * side}, random);
    }
    return frame;
}

}  // namespace vdamf
