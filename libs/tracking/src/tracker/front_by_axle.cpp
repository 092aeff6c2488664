// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/front_by_axle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vdamf
{
namespace
{
constexpr double kBendIsEnough = 0.35;  // rad, from which on older points are left out
constexpr double kLeastBend = 0.17;     // rad
constexpr double kMostAtOnce = 4.0;     // log odds: fits of single frames err

// The end of a path, from its point `first` on.
struct PathBend
{
    std::size_t first = 0;
    double turn = 0.0;  // rad
};

PathBend lastBend(const std::vector<PathPoint>& path)
{
    PathBend bend{path.size() - 1};
    for (; bend.first > 0 && std::abs(bend.turn) < kBendIsEnough; --bend.first)
    {
        const PathPoint& to = path[bend.first];
        const PathPoint& from = path[bend.first - 1];
        if (!from.located.seesAcross(1) || !to.located.seesAcross(1)) break;
        bend.turn += wrapAngle(to.box.heading - from.box.heading);
    }
    return bend;
}

// Of the centre along the path, m.
struct WayInBend
{
    double length = 0.0;
    double across = 0.0;  // to the left of the headings
};

WayInBend wayFrom(const std::vector<PathPoint>& path, std::size_t first)
{
    WayInBend way;
    for (std::size_t k = path.size() - 1; k > first; --k)
    {
        const OrientedBox& from = path[k - 1].box;
        const OrientedBox& to = path[k].box;
        const Eigen::Vector2d move = to.centre() - from.centre();
        const double heading = from.heading + 0.5 * wrapAngle(to.heading - from.heading);
        way.length += move.norm();
        way.across += rotation(heading).col(1).dot(move);
    }
    return way;
}

// Whether vehicles can turn like this: in both halves, and on no tighter a circle. Else it is the
// fit that turned.
bool isDriven(const PathPoint& from, const PathPoint& middle, const PathPoint& to, double turn)
{
    constexpr double kLeastWay = 1.5;     // m
    constexpr double kLeastRadius = 3.0;  // m
    constexpr double kMostOfTurn = 0.75;  // in one half
    const auto mayBe = [&](const PathPoint& a, const PathPoint& b)
    {
        const double part = std::abs(wrapAngle(b.box.heading - a.box.heading));
        const double chord = (b.box.centre() - a.box.centre()).norm();
        return part <= kMostOfTurn * std::abs(turn) && chord >= kLeastRadius * part;
    };
    return (to.box.centre() - from.box.centre()).norm() >= kLeastWay && mayBe(from, middle) &&
           mayBe(middle, to);
}
}  // namespace

double frontByAxle(const std::vector<PathPoint>& path, const MotionOptions& motion)
{
    constexpr double kPlaceSigma = 0.1;      // m
    constexpr double kHeadingSigma = 0.026;  // rad, over all of the way
    constexpr double kLongest = 7.0;         // m: longer ones may be articulated
    if (path.size() < 3 || path.back().box.length > kLongest) return 0.0;
    const PathBend bend = lastBend(path);
    if (std::abs(bend.turn) < kLeastBend) return 0.0;
    const PathPoint& from = path[bend.first];
    const PathPoint& to = path.back();
    if (!isDriven(from, path[(bend.first + path.size() - 1) / 2], to, bend.turn)) return 0.0;
    const WayInBend way = wayFrom(path, bend.first);
    // The centre lies d before the point without slip: it moves by d times the turn to the left.
    const double d = motion.axisFraction * to.box.length;
    const double sigma = motion.axisFractionSigma * to.box.length;
    // Where the width grows, the centre moves by half of that; it lies half a length from the end
    // that is seen.
    const double growth = 0.5 * (to.box.width - from.box.width);
    const double variance =
        std::pow(kPlaceSigma, 2) + std::pow(growth, 2) + std::pow(kHeadingSigma * way.length, 2) +
        std::pow(0.5 * to.box.length, 2) * (from.headingVariance + to.headingVariance) +
        std::pow(sigma * bend.turn, 2);
    // Of two Gaussians at d and -d.
    const double odds = 2.0 * d * bend.turn * way.across / variance;
    return std::clamp(odds, -kMostAtOnce, kMostAtOnce);
}

}  // namespace vdamf
