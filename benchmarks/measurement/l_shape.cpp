// SPDX-License-Identifier: BSD-3-Clause
// The rectangle search of Zhang et al., IV 2017.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "measurement/baselines.h"

namespace vdamf
{
namespace
{
// Single precision, from a point amid the hits: twice as fast, and exact to a micrometre.
using Coordinates = Eigen::ArrayXf;

// Distances of all points to one of the two edges across an axis: the one that is closer to all of
// them together (lines 3 and 5 of Algorithm 3, 3 and 4 of Algorithm 4). In place: nothing is
// allocated within the search.
void toDistances(Coordinates& along)
{
    const float high = along.maxCoeff();
    const float low = along.minCoeff();
    const float toHigh = (high - along).square().sum();
    const float toLow = (along - low).square().sum();
    if (toHigh < toLow)
        along = high - along;
    else
        along -= low;
}

float closeness(const Coordinates& d1, const Coordinates& d2)
{
    constexpr float kClosest = 0.01F;  // d_0, m
    return d1.min(d2).max(kClosest).inverse().sum();
}

// Of the distances that are less than the others.
float varianceOf(const Coordinates& d, const Coordinates& other)
{
    const auto mine = (d < other).cast<float>();
    const float count = mine.sum();
    if (count < 1.0F) return 0.0F;
    const float mean = (mine * d).sum() / count;
    return (mine * (d - mean).square()).sum() / count;
}

float leastVariance(const Coordinates& d1, const Coordinates& d2)
{
    return -varianceOf(d1, d2) - varianceOf(d2, d1);
}

template <class Criterion>
OrientedBox bestRectangle(const PlanePoints& points, Criterion&& criterion)
{
    constexpr int kDegrees = 90;
    const Eigen::Vector2d middle = points.rowwise().mean();
    const Coordinates x = (points.row(0).array() - middle.x()).cast<float>();
    const Coordinates y = (points.row(1).array() - middle.y()).cast<float>();
    Coordinates d1(x.size());
    Coordinates d2(x.size());
    float best = -std::numeric_limits<float>::infinity();
    double bestHeading = 0.0;
    for (int degree = 0; degree < kDegrees; ++degree)
    {
        const double heading = degree * kPi / 180.0;
        const auto c = static_cast<float>(std::cos(heading));
        const auto s = static_cast<float>(std::sin(heading));
        d1 = c * x + s * y;
        d2 = c * y - s * x;
        toDistances(d1);
        toDistances(d2);
        const float score = criterion(d1, d2);
        if (score <= best) continue;
        best = score;
        bestHeading = heading;
    }
    return boundingBox(points, bestHeading);
}
}  // namespace

OrientedBox boundingBox(const PlanePoints& points, double heading)
{
    const Eigen::Matrix2d toBox = rotation(-heading);
    const PlanePoints turned = toBox * points;
    const Eigen::Vector2d low = turned.rowwise().minCoeff();
    const Eigen::Vector2d high = turned.rowwise().maxCoeff();
    const Eigen::Vector2d centre = toBox.transpose() * (0.5 * (low + high));
    OrientedBox box{centre.x(), centre.y(), heading, high.x() - low.x(), high.y() - low.y()};
    if (box.length < box.width)
    {
        std::swap(box.length, box.width);
        box.heading += 0.5 * kPi;
    }
    box.heading = wrapAngle(box.heading);
    return box;
}

OrientedBox lShapeByCloseness(const PlanePoints& points)
{
    return bestRectangle(points, closeness);
}

OrientedBox lShapeByVariance(const PlanePoints& points)
{
    return bestRectangle(points, leastVariance);
}

}  // namespace vdamf
