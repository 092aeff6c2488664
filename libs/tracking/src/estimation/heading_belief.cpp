// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/heading_belief.h"

#include <algorithm>
#include <cmath>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kCertain = 9.0;       // most of them that are kept: even habit can be wrong
constexpr double kLongest = 0.2;       // s, that count for one frame
constexpr double kCourseRate = 20.0;   // log odds a second
constexpr double kSizeRate = 10.0;     // log odds a second, for sizes that leave no doubt
constexpr double kReverseSpeed = 4.0;  // m/s: nobody reverses faster on a road
constexpr double kSideways = 0.5;      // cosine, below which a course is neither forth nor back

// Log odds that a face is an end and no side, of one frame; 0 for what is smaller than the ends of
// cars. Ends may be shortened sides, but no end is longer than the widest one.
constexpr double kSure = 3.0;
double endNotSide(double extent, double widestEnd)
{
    constexpr double kSmallest = 1.3;    // m
    constexpr double kTransition = 0.3;  // m
    if (extent < kSmallest) return 0.0;
    return std::clamp((widestEnd - extent) / kTransition, -kSure, 1.0);
}

double sizeEvidence(const HeadingCues& cues)
{
    const bool bothAreSides =
        cues.width && cues.length && std::min(*cues.width, *cues.length) > cues.widestEnd;
    if (bothAreSides)
        return std::clamp(kSure * std::log(*cues.length / *cues.width), -kSure, kSure);
    double sum = 0.0;
    if (cues.width) sum += endNotSide(*cues.width, cues.widestEnd);
    if (cues.length) sum -= endNotSide(*cues.length, cues.widestEnd);
    return std::clamp(sum, -kSure, kSure);
}
}  // namespace

HeadingBelief HeadingBelief::after(const HeadingCues& cues) const
{
    HeadingBelief next = *this;
    const double dt = std::min(cues.dt, kLongest);
    const double size = 0.5 * kSizeRate * dt * sizeEvidence(cues);
    for (std::size_t k = 0; k < 4; ++k) next.log_[k] += k % 2 == 0 ? size : -size;
    for (std::size_t k = 0; cues.course && k < 4; ++k)
    {
        const double along = std::cos(cues.course->direction - 0.5 * kPi * static_cast<double>(k));
        // Who has been seen to drive forward may drive slowly in reverse as well.
        constexpr double kKnown = 4.0;
        const bool mayReverse =
            cues.course->speed < kReverseSpeed && log_[k] - log_[(k + 2) % 4] > kKnown;
        const bool fits = along > kSideways || (along < -kSideways && mayReverse);
        if (!fits) next.log_[k] -= kCourseRate * dt;
    }
    const double best = *std::max_element(next.log_.begin(), next.log_.end());
    for (double& log : next.log_) log = std::max(log - best, -kCertain);
    return next;
}

int HeadingBelief::turnDue(double logOdds) const
{
    const auto best = std::max_element(log_.begin(), log_.end());
    return *best - log_[0] > logOdds ? static_cast<int>(best - log_.begin()) : 0;
}

HeadingBelief HeadingBelief::turned(int quarters) const
{
    HeadingBelief next;
    for (int k = 0; k < 4; ++k)
        next.log_[static_cast<std::size_t>(k)] =
            log_[static_cast<std::size_t>((k + quarters % 4 + 4) % 4)];
    return next;
}

double HeadingBelief::forwardProbability() const
{
    return 1.0 / (1.0 + std::exp(log_[2] - log_[0]));
}

double HeadingBelief::axesProbability() const
{
    const double right = std::exp(log_[0]) + std::exp(log_[2]);
    return right / (right + std::exp(log_[1]) + std::exp(log_[3]));
}

}  // namespace vdamf
