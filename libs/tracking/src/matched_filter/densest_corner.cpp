// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/densest_corner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "matched_filter/body_profile.h"
#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
constexpr int kHeadings = 30;               // over a quarter turn
constexpr double kCornerBin = 0.1;          // m
constexpr std::uint16_t kCornerBins = 160;  // along an axis; what lies beyond is no vehicle
constexpr double kMiddle = 0.5 * kCornerBin * static_cast<double>(kCornerBins);  // m

// The most hits in two neighbouring bins of one axis.
struct Peak
{
    double at = 0.0;  // m
    double weight = 0.0;
};

// Weights of hits by their place along an axis.
class AxisBins
{
public:
    // Each of the hits may lie in kCornerBins: nowhere. They take turns in the two tables, as most
    // of them share a few bins and each would wait for the one before it.
    AxisBins(const std::vector<std::uint16_t>& bins, const std::vector<float>& weights)
    {
        if (bins.empty()) return;
        inWideLanes([ from = bins.data(), size = bins.size(), first = &first_, last = &last_ ]()
                        __attribute__((always_inline)) {
                            std::uint16_t least = kCornerBins;
                            std::uint16_t most = 0;
                            for (std::size_t i = 0; i < size; ++i)
                            {
                                least = from[i] < least ? from[i] : least;
                                most = from[i] > most ? from[i] : most;
                            }
                            *first = least;
                            *last = most;
                        });
        for (auto& table : bins_)
            std::fill(table.data() + first_ + kPadding - 1, table.data() + last_ + 2 * kPadding,
                      0.0F);
        std::size_t i = 0;
        for (; i + 1 < bins.size(); i += 2)
        {
            bins_[0][bins[i] + kPadding] += weights[i];
            bins_[1][bins[i + 1] + kPadding] += weights[i + 1];
        }
        if (i < bins.size()) bins_[0][bins[i] + kPadding] += weights[i];
    }

    // Of equal ones the first.
    Peak peak() const
    {
        Heaviest all;
        inWideLanes([
            first = std::max<std::size_t>(first_, 1),
            end = std::min<std::size_t>(last_ + 2U, kCornerBins), even = bins_[0].data() + kPadding,
            odd = bins_[1].data() + kPadding, result = &all
        ]() __attribute__((always_inline)) {
            Heaviest heaviest;
            for (std::size_t k = first; k < end; k += kLanes<Floats>)
            {
                Floats a, b, aBefore, bBefore;
                load(a, even + k);
                load(b, odd + k);
                load(aBefore, even + k - 1);
                load(bBefore, odd + k - 1);
                const Floats both = (aBefore + bBefore) + (a + b);
                const Floats at = static_cast<float>(k) + kLaneNumbers;
                const auto isNew = (both > heaviest.weight) & (at < static_cast<float>(end));
                heaviest.weight = isNew ? both : heaviest.weight;
                heaviest.at = isNew ? at : heaviest.at;
            }
            *result = heaviest;
        });
        std::size_t best = 0;
        for (std::size_t k = 1; k < kLanes<Floats>; ++k)
        {
            const bool isFirst = all.weight[k] == all.weight[best] && all.at[k] < all.at[best];
            if (all.weight[k] > all.weight[best] || isFirst) best = k;
        }
        return {kCornerBin * static_cast<double>(all.at[best]) - kMiddle,
                static_cast<double>(all.weight[best])};
    }

private:
    static constexpr std::size_t kPadding = kLanes<Floats>;
    struct Heaviest
    {
        Floats weight{};
        Floats at{};
    };

    // From the bin before first_ to those that a look at some of them reads behind last_.
    std::array<std::array<float, kCornerBins + 1 + 2 * kPadding>, 2> bins_;
    std::uint16_t first_ = kCornerBins;
    std::uint16_t last_ = 0;
};

// Some of the hits about an origin, with room for the bins that they lie in at a heading.
class TurnedHits
{
public:
    TurnedHits(const Hits& hits, const Eigen::Vector2d& origin)
    {
        // So many show where rows of them are as well as all.
        constexpr std::size_t kEnough = 128;
        const std::size_t step = (hits.size() + kEnough - 1) / kEnough;
        for (std::size_t i = 0; i < hits.size(); i += step)
        {
            x_.push_back(static_cast<float>(hits.x[i] - origin.x()));
            y_.push_back(static_cast<float>(hits.y[i] - origin.y()));
            weight_.push_back(static_cast<float>(hits.weight[i]));
        }
        binX_.resize(x_.size());
        binY_.resize(x_.size());
    }

    void turnTo(double heading)
    {
        const Direction forward = directionOf(heading);
        inWideLanes([
            =, size = x_.size(), c = static_cast<float>(forward.cos),
            s = static_cast<float>(forward.sin), px = x_.data(), py = y_.data(), toX = binX_.data(),
            toY = binY_.data()
        ]() __attribute__((always_inline)) {
            constexpr auto kScale = static_cast<float>(1.0 / kCornerBin);
            constexpr auto kOffset = static_cast<float>(kMiddle / kCornerBin);
            constexpr auto kEnd = static_cast<float>(kCornerBins);
            VDAMF_INDEPENDENT_LANES
            for (std::size_t i = 0; i < size; ++i)
            {
                const float x = (c * px[i] + s * py[i]) * kScale + kOffset;
                const float y = (c * py[i] - s * px[i]) * kScale + kOffset;
                toX[i] = static_cast<std::uint16_t>(((x >= 0.0F) & (x < kEnd)) ? x : kEnd);
                toY[i] = static_cast<std::uint16_t>(((y >= 0.0F) & (y < kEnd)) ? y : kEnd);
            }
        });
    }

    // Along the heading and across it.
    std::pair<Peak, Peak> peaks() const
    {
        return {AxisBins(binX_, weight_).peak(), AxisBins(binY_, weight_).peak()};
    }

private:
    std::vector<float> x_, y_, weight_;
    std::vector<std::uint16_t> binX_, binY_;
};

struct Corner
{
    double heading = 0.0;
    Peak x, y;  // along the heading and across it

    double weight() const { return x.weight + y.weight; }
};

Corner densestCorner(const Hits& hits, const Eigen::Vector2d& origin)
{
    TurnedHits turned(hits, origin);
    const auto cornerAt = [&turned](int k)
    {
        const double heading = 0.5 * kPi * k / kHeadings;
        turned.turnTo(heading);
        const auto [x, y] = turned.peaks();
        return Corner{heading, x, y};
    };
    // Every other heading, then those beside the best one.
    int best = 0;
    Corner corner = cornerAt(best);
    const auto tryAt = [&](int k)
    {
        const Corner other = cornerAt(k);
        if (other.weight() <= corner.weight()) return;
        corner = other;
        best = k;
    };
    for (int k = 2; k < kHeadings; k += 2) tryAt(k);
    const int middle = best;
    for (const int k : {middle - 1, middle + 1}) tryAt((k + kHeadings) % kHeadings);
    return corner;
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
    const Direction forward = directionOf(box.heading);
    const double perWidth = 1.0 / (32.0 * scale * scale);
    // What is not beside a face towards the sensor is far from it.
    constexpr double kFar = 1e30;
    const double noEnd = signX * view.x() > 0.5 * box.length ? 0.0 : kFar;
    const double noSide = signY * view.y() > 0.5 * box.width ? 0.0 : kFar;
    // Without heights any number stands for them.
    const bool hasRoof = isCarWithHeights(hits);
    const double* const heights = hasRoof ? hits.height.data() : hits.weight.data();
    const double roof = hasRoof ? kCarRoof : kFar;
    double share = 0.0;
    inWideLanes([
        =, c = forward.cos, s = forward.sin, size = hits.size(), px = hits.x.data(),
        py = hits.y.data(), weights = hits.weight.data(), result = &share
    ]() __attribute__((always_inline)) {
        Doubles sum{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Doubles dx;
            Doubles dy;
            Doubles weight;
            Doubles height;
            load(dx, px + first, count);
            load(dy, py + first, count);
            load(weight, weights + first, count);
            load(height, heights + first, count);
            dx -= box.x;
            dy -= box.y;
            // Outwards of the two near faces.
            const Doubles end = signX * (c * dx + s * dy) - 0.5 * box.length;
            const Doubles side = signY * (c * dy - s * dx) - 0.5 * box.width;
            const auto besideEnd = (side < scale) & (side > -box.width - scale);
            const auto besideSide = (end < scale) & (end > -box.length - scale) & (height <= roof);
            const Doubles far = Doubles{} + kFar;
            const Doubles byEnd = (besideEnd ? end * end : far) + noEnd;
            const Doubles bySide = (besideSide ? side * side : far) + noSide;
            const Doubles square = byEnd < bySide ? byEnd : bySide;
            // exp() by its limit, as in line_sums.cpp.
            const Doubles falling = 1.0 - square * perWidth;
            const Doubles base = falling > 0.0 ? falling : Doubles{};
            const Doubles fourth = base * base * base * base;
            sum += weight * (fourth * fourth) * (fourth * fourth);
        };
        inGroupsOf<kLanes<Doubles>>(size, add);
        *result = sumOf(sum);
    });
    return share / hits.totalWeight;
}

}  // namespace vdamf
