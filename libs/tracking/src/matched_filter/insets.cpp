// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/insets.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kEndInset = 0.32;     // m, up to kOblique ...
constexpr double kGrazingInset = 0.1;  // ... and where it is seen at a grazing angle
constexpr double kOblique = 45.0 * kPi / 180.0;
constexpr double kGrazing = 75.0 * kPi / 180.0;
constexpr double kSideInset = 0.285;    // m
constexpr double kLengthExcess = 0.05;  // m
constexpr double kWidthExcess = 0.15;   // m

double endInset(double aspect)
{
    const double share = std::clamp((aspect - kOblique) / (kGrazing - kOblique), 0.0, 1.0);
    return kEndInset + share * (kGrazingInset - kEndInset);
}
}  // namespace

OrientedBox withInsets(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor)
{
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const double aspect = std::atan2(std::abs(view.y()), std::abs(view.x()));
    // Places of the middle along the axes, and sizes: the near face goes inwards by its inset.
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    OrientedBox inner = box;
    if (seen.seesEnd())
    {
        inner.length = std::max(0.5 * box.length, box.length - kLengthExcess);
        middle.x() = -std::copysign(endInset(aspect) - 0.5 * kLengthExcess, view.x());
    }
    if (seen.seesSide())
    {
        inner.width = std::max(0.5 * box.width, box.width - kWidthExcess);
        middle.y() = -std::copysign(kSideInset - 0.5 * kWidthExcess, view.y());
    }
    const Eigen::Vector2d centre = box.centre() + rotation(box.heading) * middle;
    inner.x = centre.x();
    inner.y = centre.y();
    return inner;
}

}  // namespace vdamf
