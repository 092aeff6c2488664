// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/densest_corner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr int kHeadings = 30;       // over a quarter turn
constexpr double kBin = 0.1;        // m
constexpr std::size_t kBins = 160;  // along an axis; what lies beyond is no vehicle
constexpr double kMiddle = 0.5 * kBin * static_cast<double>(kBins);  // m

// The most hits in two neighbouring bins of one axis.
struct Peak
{
    double at = 0.0;  // m
    double weight = 0.0;
};

class AxisBins
{
public:
    void clear() { bins_.fill(0.0F); }

    void add(double at, double weight)
    {
        const double bin = (at + kMiddle) / kBin;
        if (bin >= 0.0 && bin < static_cast<double>(kBins))
            bins_[static_cast<std::size_t>(bin)] += static_cast<float>(weight);
    }

    Peak peak() const
    {
        float most = 0.0F;
        std::size_t at = 0;
        for (std::size_t k = 1; k < kBins; ++k)
        {
            const float both = bins_[k - 1] + bins_[k];
            if (both <= most) continue;
            most = both;
            at = k;
        }
        return {kBin * static_cast<double>(at) - kMiddle, most};
    }

private:
    std::array<float, kBins> bins_{};
};

struct Corner
{
    double heading = 0.0;
    Peak x, y;  // along the heading and across it

    double weight() const { return x.weight + y.weight; }
};

Corner densestCorner(const Hits& hits, const Eigen::Vector2d& origin)
{
    AxisBins alongX;
    AxisBins alongY;
    Corner best;
    for (int k = 0; k < kHeadings; ++k)
    {
        const double heading = 0.5 * kPi * k / kHeadings;
        const double c = std::cos(heading);
        const double s = std::sin(heading);
        alongX.clear();
        alongY.clear();
        for (std::size_t i = 0; i < hits.size(); ++i)
        {
            const double dx = hits.x[i] - origin.x();
            const double dy = hits.y[i] - origin.y();
            alongX.add(c * dx + s * dy, hits.weight[i]);
            alongY.add(c * dy - s * dx, hits.weight[i]);
        }
        const Corner corner{heading, alongX.peak(), alongY.peak()};
        if (corner.weight() > best.weight()) best = corner;
    }
    return best;
}
}  // namespace

OrientedBox boxInDensestCorner(const Hits& hits, const OrientedBox& start,
                               const Eigen::Vector2d& sensor)
{
    const Corner corner = densestCorner(hits, start.centre());
    Eigen::Vector2d near(corner.x.at, corner.y.at);
    const double quarters = std::round((start.heading - corner.heading) / (0.5 * kPi));
    OrientedBox box = start;
    box.heading = wrapAngle(corner.heading + 0.5 * kPi * quarters);
    // From the axes of the corner to those of the box.
    near = rotation(-0.5 * kPi * quarters) * near;
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const Eigen::Vector2d half(0.5 * box.length, 0.5 * box.width);
    Eigen::Vector2d middle = near;
    for (int axis = 0; axis < 2; ++axis)
        middle(axis) -= view(axis) > near(axis) ? half(axis) : -half(axis);
    const Eigen::Vector2d centre = start.centre() + rotation(box.heading) * middle;
    box.x = centre.x();
    box.y = centre.y();
    return box;
}

double shareOnNearFaces(const Hits& hits, const OrientedBox& box, const Eigen::Vector2d& sensor,
                        double scale)
{
    if (hits.totalWeight <= 0.0) return 0.0;
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const double signX = view.x() > 0.0 ? 1.0 : -1.0;
    const double signY = view.y() > 0.0 ? 1.0 : -1.0;
    const double c = std::cos(box.heading);
    const double s = std::sin(box.heading);
    const double perWidth = 1.0 / (32.0 * scale * scale);
    double sum = 0.0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const double dx = hits.x[i] - box.x;
        const double dy = hits.y[i] - box.y;
        // Outwards of the two near faces.
        const double end = signX * (c * dx + s * dy) - 0.5 * box.length;
        const double side = signY * (c * dy - s * dx) - 0.5 * box.width;
        const bool byEnd = signX * view.x() > 0.5 * box.length && side < scale;
        const bool bySide = signY * view.y() > 0.5 * box.width && end < scale;
        double square = 1e30;
        if (byEnd && side > -box.width - scale) square = end * end;
        if (bySide && end > -box.length - scale) square = std::min(square, side * side);
        // exp() by its limit, as in line_sums.cpp.
        const double base = std::max(0.0, 1.0 - square * perWidth);
        const double fourth = base * base * base * base;
        sum += hits.weight[i] * fourth * fourth * fourth * fourth;
    }
    return sum / hits.totalWeight;
}

}  // namespace vdamf
