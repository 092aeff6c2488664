// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/inside_of.h"

#include <algorithm>
#include <cmath>

#include "vdamf/tracking/types/faces.h"

namespace vdamf
{
Inside insideOf(const VehicleState& foretold, const OrientedBox& box, int axis, int end,
                const Eigen::Vector2d& hits)
{
    const Eigen::Vector2d half(0.5 * box.length, 0.5 * box.width);
    Eigen::Vector2d beside = toBoxFrame(box, hits);
    beside(axis) = signOfEnd(end) * half(axis);
    const OrientedBox before = foretold.box();
    const Eigen::Vector2d place = toBoxFrame(before, box.centre() + rotation(box.heading) * beside);
    StateVector change = StateVector::Zero();
    change.head<2>() = signOfEnd(end) * rotation(before.heading).col(axis);
    change(kLength) = axis == 0 ? 0.5 : 0.0;
    const double variance = change.dot(foretold.covariance * change) +
                            (axis == 1 ? 0.25 * foretold.widthVariance : 0.0);
    return {0.5 * foretold.size()(axis) - signOfEnd(end) * place(axis),
            std::sqrt(std::max(0.0, variance))};
}

}  // namespace vdamf
