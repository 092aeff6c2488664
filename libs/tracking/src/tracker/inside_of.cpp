// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/inside_of.h"

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
    return {0.5 * foretold.size()(axis) - signOfEnd(end) * place(axis),
            foretold.faceSigma(axis, end)};
}

}  // namespace vdamf
