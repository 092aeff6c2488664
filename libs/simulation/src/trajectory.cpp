// SPDX-License-Identifier: BSD-3-Clause
// Motion in closed form.
#include "vdamf/simulation/trajectory.h"

#include <cmath>
#include <iterator>

namespace vdamf
{
namespace
{
/// sin(x) / x, with its limit 1 at 0.
double sinc(double x)
{
    return std::abs(x) < 1e-5 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

/// The curvature is constant over the way, so the path is an arc whatever the speed does: its
/// chord has the length s sinc(k s / 2) and the direction heading + k s / 2.
MotionState moved(const MotionState& start, const MotionSegment& motion, double dt)
{
    const double way = (start.speed + 0.5 * motion.acceleration * dt) * dt;
    const double halfTurn = 0.5 * motion.curvature * way;
    const double chord = way * sinc(halfTurn);
    MotionState end;
    end.x = start.x + chord * std::cos(start.heading + halfTurn);
    end.y = start.y + chord * std::sin(start.heading + halfTurn);
    end.heading = start.heading + 2.0 * halfTurn;
    end.speed = start.speed + motion.acceleration * dt;
    end.yawRate = motion.curvature * end.speed;
    return end;
}
}  // namespace

Trajectory::Trajectory(const MotionState& start, const std::vector<MotionSegment>& segments)
{
    double time = 0.0;
    MotionState state = start;
    for (const MotionSegment& segment : segments)
    {
        pieces_.push_back({time, state, segment});
        state = moved(state, segment, segment.duration);
        time += segment.duration;
    }
    pieces_.push_back({time, state, {}});
}

MotionState Trajectory::at(double time) const
{
    auto piece = pieces_.begin();
    while (std::next(piece) != pieces_.end() && std::next(piece)->begin <= time) ++piece;
    return moved(piece->start, piece->motion, time - piece->begin);
}

}  // namespace vdamf
