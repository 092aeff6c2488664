// SPDX-License-Identifier: BSD-3-Clause
// Motion in closed form.
#include "vdamf/simulation/trajectory.h"

#include <array>
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
MotionState movedOnArc(const MotionState& start, const MotionSegment& motion, double dt)
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

/// Curvature k + r t, speed v + a t: the heading is the integral of their product,
///     heading + k v t + (k a + r v) t^2 / 2 + r a t^3 / 3,
/// and the position that of speed times direction.
struct Clothoid
{
    MotionState start;
    double acceleration;
    double curvature;
    double curvatureRate;  ///< 1/(m s)

    double speedAt(double t) const { return start.speed + acceleration * t; }

    double headingAt(double t) const
    {
        const double linear = curvature * start.speed;
        const double quadratic = 0.5 * (curvature * acceleration + curvatureRate * start.speed);
        const double cubic = curvatureRate * acceleration / 3.0;
        return start.heading + t * (linear + t * (quadratic + t * cubic));
    }

    double largestYawRate(double dt) const
    {
        const double speed = std::abs(start.speed) + std::abs(acceleration * dt);
        return speed * (std::abs(curvature) + std::abs(curvatureRate * dt));
    }
};

/// Gauss-Legendre quadrature with 8 nodes; the heading turns by less than 1 rad over each of its
/// stretches, so that the error is below 1e-12 of the way.
MotionState movedOnClothoid(const Clothoid& clothoid, double dt)
{
    constexpr std::array<double, 4> kNodes{0.1834346424956498, 0.5255324099163290,
                                           0.7966664774136267, 0.9602898564975363};
    constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873,
                                             0.2223810344533745, 0.1012285362903763};
    const double turn = std::abs(dt) * clothoid.largestYawRate(dt);
    const int stretches = 1 + static_cast<int>(turn);
    const double half = 0.5 * dt / stretches;
    MotionState end = clothoid.start;
    for (int i = 0; i < stretches; ++i)
    {
        for (std::size_t node = 0; node < kNodes.size(); ++node)
        {
            for (const double side : {-1.0, 1.0})
            {
                const double t = half * (2 * i + 1 + side * kNodes[node]);
                const double way = kWeights[node] * half * clothoid.speedAt(t);
                end.x += way * std::cos(clothoid.headingAt(t));
                end.y += way * std::sin(clothoid.headingAt(t));
            }
        }
    }
    end.heading = clothoid.headingAt(dt);
    end.speed = clothoid.speedAt(dt);
    end.yawRate = (clothoid.curvature + clothoid.curvatureRate * dt) * end.speed;
    return end;
}

MotionState moved(const MotionState& start, const MotionSegment& motion, double dt)
{
    const double change = motion.endCurvature.value_or(motion.curvature) - motion.curvature;
    if (change == 0.0) return movedOnArc(start, motion, dt);
    return movedOnClothoid({start, motion.acceleration, motion.curvature, change / motion.duration},
                           dt);
}

class SegmentMotion : public Motion
{
public:
    SegmentMotion(const MotionState& start, const std::vector<MotionSegment>& segments)
    {
        double time = 0.0;
        MotionState state = start;
        for (const MotionSegment& segment : segments)
        {
            pieces_.push_back({time, state, segment});
            state = moved(state, segment, segment.duration);
            // Rounding must not leave a crawl behind a stop.
            if (std::abs(state.speed) < 1e-12) state.speed = 0.0;
            time += segment.duration;
        }
        pieces_.push_back({time, state, {}});
    }

    MotionState at(double time) const override
    {
        auto piece = pieces_.begin();
        while (std::next(piece) != pieces_.end() && std::next(piece)->begin <= time) ++piece;
        return moved(piece->start, piece->motion, time - piece->begin);
    }

private:
    struct Piece
    {
        double begin;  ///< s
        MotionState start;
        MotionSegment motion;
    };
    std::vector<Piece> pieces_;
};
}  // namespace

Trajectory::Trajectory(const MotionState& start, const std::vector<MotionSegment>& segments)
    : motion_(std::make_shared<SegmentMotion>(start, segments))
{
}

}  // namespace vdamf
