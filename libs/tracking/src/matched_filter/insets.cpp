// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/insets.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kOblique = 45.0 * kPi / 180.0;
constexpr double kGrazing = 75.0 * kPi / 180.0;

double endInset(double aspect, const InsetParameters& insets)
{
    const double share = std::clamp((aspect - kOblique) / (kGrazing - kOblique), 0.0, 1.0);
    return insets.end + share * (insets.grazingEnd - insets.end);
}
}  // namespace

OrientedBox withInsets(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                       const InsetParameters& insets)
{
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const double aspect = std::atan2(std::abs(view.y()), std::abs(view.x()));
    // Places of the middle along the axes, and sizes: the near face goes inwards by its inset.
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    OrientedBox inner = box;
    if (seen.seesEnd())
    {
        inner.length = std::max(0.5 * box.length, box.length - insets.length);
        middle.x() = -std::copysign(endInset(aspect, insets) - 0.5 * insets.length, view.x());
    }
    if (seen.seesSide())
    {
        inner.width = std::max(0.5 * box.width, box.width - insets.width);
        middle.y() = -std::copysign(insets.side - 0.5 * insets.width, view.y());
    }
    const Eigen::Vector2d centre = box.centre() + rotation(box.heading) * middle;
    inner.x = centre.x();
    inner.y = centre.y();
    return inner;
}

}  // namespace vdamf
