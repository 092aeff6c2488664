// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/unrest.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kUnrestMemory = 2.0;  // s
constexpr double kUnknown = 1.0;
constexpr double kMostSurprise = 4.0;  // of one measurement
// Vehicles that go on in recorded traffic are foretold about so well (seven in eight of them no
// better than 0.26), and their speeds err as much as is said of them. Where bodies and drivers are
// steadier, the error of the speed is seen to fall with about the square of the surprise.
constexpr double kOfTraffic = 0.45;
constexpr double kLeastCalm = 0.03;

double shareOfMemory(double dt)
{
    return 1.0 - std::exp(-dt / kUnrestMemory);
}
}  // namespace

double Unrest::calm() const
{
    const double ratio = value_ / kOfTraffic;
    return std::clamp(ratio * ratio, kLeastCalm, 1.0);
}

Unrest Unrest::later(double dt) const
{
    Unrest next = *this;
    next.value_ += shareOfMemory(dt) * (kUnknown - value_);
    next.unmeasured_ += dt;
    return next;
}

// As if what was taken for unknown since the last measurement had been measured.
Unrest Unrest::after(double surprise) const
{
    Unrest next;
    next.value_ =
        value_ + shareOfMemory(unmeasured_) * (std::min(surprise, kMostSurprise) - kUnknown);
    return next;
}

}  // namespace vdamf
