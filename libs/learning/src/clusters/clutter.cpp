// SPDX-License-Identifier: BSD-3-Clause
#include "clusters/clutter.h"

#include <cmath>

namespace vdamf
{
namespace
{
// A place given in the axes of the box.
Eigen::Vector2d placeAt(const OrientedBox& box, double x, double y)
{
    return box.centre() + rotation(box.heading) * Eigen::Vector2d(x, y);
}
}  // namespace

StandingBody vehicle(ObjectClass body, const BodySize& size, const OrientedBox& box)
{
    constexpr double kAboveTheSensor = 10.0;  // m
    BodySize built = size;
    if (body == ObjectClass::Box) built.height = kAboveTheSensor;
    return {makeBody(body, built), box.centre(), box.heading, size.height};
}

std::vector<StandingBody> mirrors(const BodySize& size, const OrientedBox& box)
{
    constexpr double kBottom = 0.85;             // m
    const BodySize mirrorSize{0.12, 0.2, 0.25};  // m
    Body mirror = makeBody(ObjectClass::Box, mirrorSize);
    for (SolidFace& face : mirror.solids.front().faces) face.offset += kBottom * face.normal.z();
    std::vector<StandingBody> both;
    for (const double side : {-1.0, 1.0})
    {
        const double y = side * 0.5 * (size.width + mirrorSize.width);
        both.push_back(
            {mirror, placeAt(box, size.length / 6.0, y), box.heading, kBottom + mirrorSize.height});
    }
    return both;
}

StandingBody bushBeside(const OrientedBox& box, RandomStream& random)
{
    const double extent = 1.0 + random.uniform();
    const double gap = 0.3 + 0.3 * random.uniform();
    const double along = random.uniform() - 0.5;
    const double sign = random.uniform() < 0.5 ? -1.0 : 1.0;
    const bool beyondEnd = random.uniform() < 0.5;
    const double out = gap + 0.5 * extent;
    const Eigen::Vector2d place =
        beyondEnd ? placeAt(box, sign * (0.5 * box.length + out), along * box.width)
                  : placeAt(box, along * box.length, sign * (0.5 * box.width + out));
    constexpr double kHeight = 1.2;  // m
    return {makeBody(ObjectClass::Bush, {extent, extent, kHeight}), place, 0.0, kHeight};
}

BodyView withClutter(const BodyView& view, const OrientedBox& box, double share,
                     RandomStream& random)
{
    constexpr double kAround = 1.0;  // m
    BodyView all = view;
    const auto hits = static_cast<double>(view.body.size());
    const auto count = static_cast<int>(std::lround(share / (1.0 - share) * hits));
    for (int i = 0; i < count; ++i)
    {
        const double x = (random.uniform() - 0.5) * (box.length + 2.0 * kAround);
        const double y = (random.uniform() - 0.5) * (box.width + 2.0 * kAround);
        const Eigen::Vector2d place = placeAt(box, x, y);
        all.cluster.x.push_back(static_cast<float>(place.x()));
        all.cluster.y.push_back(static_cast<float>(place.y()));
        all.cluster.z.push_back(1.0F);
        all.cluster.height.push_back(1.0F);
        all.body.push_back(1);
    }
    return all;
}

}  // namespace vdamf
