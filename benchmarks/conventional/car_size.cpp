// SPDX-License-Identifier: BSD-3-Clause
#include "conventional/car_size.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vdamf
{
namespace
{
struct SizeRange
{
    double least, most;  // m

    double middle() const { return 0.5 * (least + most); }
    bool has(double size) const { return least < size && size < most; }
};

constexpr SizeRange kWidths{1.2, 2.5};
constexpr SizeRange kLengths{3.0, 5.8};

// Along its axis 0 (heading) or 1, at least so deep, away from the sensor.
OrientedBox deepened(const OrientedBox& box, int axis, double least, const Eigen::Vector2d& sensor)
{
    OrientedBox deeper = box;
    double& size = axis == 0 ? deeper.length : deeper.width;
    const double grown = std::max(0.0, least - size);
    size += grown;
    const Eigen::Vector2d away = -std::copysign(0.5 * grown, toBoxFrame(box, sensor)(axis)) *
                                 rotation(box.heading).col(axis);
    deeper.x += away.x();
    deeper.y += away.y();
    return deeper;
}

OrientedBox alongLongerSide(OrientedBox box)
{
    if (box.length >= box.width) return box;
    std::swap(box.length, box.width);
    box.heading = wrapAngle(box.heading + 0.5 * kPi);
    return box;
}
}  // namespace

OrientedBox completedToACar(const OrientedBox& box, const Eigen::Vector2d& sensor)
{
    const Eigen::Vector2d size(box.length, box.width);
    const Eigen::Vector2d from = toBoxFrame(box, sensor).cwiseAbs();
    // The face across an axis looks to the sensor where that is beyond it.
    const bool sees[2] = {from.x() > 0.5 * size.x(), from.y() > 0.5 * size.y()};
    // Of two, the nearer one's depth is the one that is less known.
    const int nearer = from.x() - 0.5 * size.x() > from.y() - 0.5 * size.y() ? 0 : 1;
    for (const int axis : {nearer, 1 - nearer})
        if (sees[axis] && kWidths.has(size(1 - axis)) && size(axis) < kLengths.most)
            return alongLongerSide(deepened(box, axis, kLengths.middle(), sensor));
    for (const int axis : {nearer, 1 - nearer})
        if (sees[axis] && kLengths.has(size(1 - axis)) && size(axis) < kWidths.most)
            return alongLongerSide(deepened(box, axis, kWidths.middle(), sensor));
    return alongLongerSide(box);
}

}  // namespace vdamf
