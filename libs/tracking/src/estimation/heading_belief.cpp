// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/heading_belief.h"

#include <algorithm>
#include <cmath>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kCertain = 9.0;      // most of them that are kept: even habit can be wrong
constexpr double kLongest = 0.2;      // s, that count for one frame
constexpr double kCourseRate = 20.0;  // log odds a second
constexpr double kFrameRate = 10.0;   // frames that count for themselves, a second
constexpr double kSideways = 0.5;     // cosine, below which a course is neither forth nor back
// Who has been seen to drive forward, by so much log odds, may drive slowly in reverse as well.
constexpr double kKnown = 4.0;
// Frames show the same thing again and again: all of them say at most so many times what one does.
// Those of parts say less, as the same things hide the rest of the face: less than the vehicles
// around.
constexpr double kRepeats = 3.0;
constexpr double kPartsRepeat = 2.6;
// Sizes never outweigh a course that goes on: two-wheelers have sides as wide as cars.
constexpr double kMostBySizes = 5.0;
// Nor does a shape outweigh a course that goes on.
constexpr double kMostByShape = 4.0;
// The axle does, but only where it is slow enough to reverse.
constexpr double kMostByAxle = 7.0;
constexpr double kAxleRepeats = 1.75;  // frames tell of nearly the same bend
constexpr double kReverse = 0.03;      // of what moves

double withEvidence(double odds, double evidence, double frames, double repeats,
                    double mostEver = kCertain)
{
    const double most = std::clamp(repeats * evidence, -mostEver, mostEver);
    const double next = odds + frames * evidence;
    return evidence > 0.0 ? std::max(odds, std::min(next, most))
                          : std::min(odds, std::max(next, most));
}

// Logarithm of the sum of two numbers given by theirs.
double logOfSum(double a, double b)
{
    return std::max(a, b) + std::log1p(std::exp(-std::abs(a - b)));
}

// The longest row of a face of late; nothing where no row of it was ever seen.
std::optional<FaceExtent> longerOf(const std::optional<FaceExtent>& before,
                                   const std::optional<FaceExtent>& now, double dt)
{
    constexpr double kForgotten = 0.3;  // m/s: rows may have been too long for once
    if (!before || (now && now->isCut)) return now;
    FaceExtent kept = *before;
    kept.metres -= kForgotten * dt;
    return now && now->metres >= kept.metres ? now : kept;
}

// How many times what one frame tells all that show the same tell at most.
double repeatsOf(const HeadingCues& cues)
{
    double whole = 0.0;
    for (const auto& face : {cues.side, cues.end})
        if (face) whole = std::max(whole, face->whole);
    return kPartsRepeat + (kRepeats - kPartsRepeat) * whole;
}

bool grown(const std::optional<FaceExtent>& before, const std::optional<FaceExtent>& now)
{
    constexpr double kGrown = 0.3;  // m
    return before && now && now->metres > before->metres + kGrown;
}

// Log odds that what moves does so with its front ahead.
double frontEvidence(double forth, double fast)
{
    constexpr double kFastReverse = 0.001;  // of what moves fast, or else its heading errs
    const double reverse = fast * kFastReverse + (1.0 - fast) * kReverse;
    const double ahead = forth * (1.0 - reverse) + (1.0 - forth) * reverse;
    return std::log(ahead / (1.0 - ahead));
}
}  // namespace

double axesEvidence(const HeadingCues& cues)
{
    double sum = 0.0;
    if (cues.end) sum += endOverSide(*cues.end, cues.height, cues.isHeightSeen);
    if (cues.side) sum -= endOverSide(*cues.side, cues.height, cues.isHeightSeen);
    // Hits that are not the vehicle's may make any face long.
    constexpr double kSure = 4.0;
    return std::clamp(sum, -kSure, kSure);
}

HeadingBelief::HeadingBelief(const HeadingCues& cues)
    : axes_(axesEvidence(cues)),
      ends_{cues.end, cues.end},
      sides_{cues.side, cues.side},
      shape_(cues.shape)
{
}

HeadingBelief::Rows HeadingBelief::Rows::with(const std::optional<FaceExtent>& row, double dt) const
{
    const bool isLonger = row && last && row->metres > last->metres;
    return {row ? row : last, longerOf(longest, isLonger ? last : row, dt)};
}

HeadingBelief HeadingBelief::after(const HeadingCues& cues) const
{
    HeadingBelief next = *this;
    const double dt = std::min(cues.dt, kLongest);
    const double frames = kFrameRate * dt;
    next.ends_ = ends_.with(cues.end, dt);
    next.sides_ = sides_.with(cues.side, dt);
    HeadingCues sizes = cues;
    if (cues.end) sizes.end = longerOf(ends_.longest, cues.end, dt);
    if (cues.side) sizes.side = longerOf(sides_.longest, cues.side, dt);
    const double evidence = axesEvidence(sizes);
    // What shorter rows told was told by parts of them.
    const bool isNew = grown(ends_.longest, sizes.end) || grown(sides_.longest, sizes.side);
    const double before = isNew && axes_ * evidence < 0.0 ? 0.0 : axes_;
    next.axes_ = withEvidence(before, evidence, frames, repeatsOf(sizes), kMostBySizes);
    next.shape_ = withEvidence(shape_, cues.shape, frames, kRepeats, kMostByShape);
    next.axle_ = withEvidence(axle_, cues.axle, std::min(frames, 1.0), kAxleRepeats, kMostByAxle);
    next.neighbours_ = cues.neighbours;
    next.inLine_ = cues.inLine;
    const double forth = course_[0] - course_[2];
    if (std::abs(forth) < kKnown)
    {
        // Whichever way it moves along an axis, both ways together are as likely as before.
        const double either = logOfSum(course_[0], course_[2]);
        const double after = withEvidence(forth, frontEvidence(cues.forth, cues.fast), frames, 1.0);
        next.course_[0] = either - logOfSum(0.0, -after);
        next.course_[2] = either - logOfSum(0.0, after);
    }
    if (cues.course) next.followCourse(*cues.course, dt);
    const double best = *std::max_element(next.course_.begin(), next.course_.end());
    for (double& log : next.course_) log = std::max(log - best, -kCertain);
    next.acrossFor_ = next.axesProbability() < 0.5 ? acrossFor_ + 1 : 0;
    return next;
}

// Log odds of the axle for a front k quarter turns ahead rather than behind.
double HeadingBelief::byAxle(std::size_t k) const
{
    return k % 2 == 1 ? 0.0 : k == 0 ? axle_ : -axle_;
}

// Who may reverse has any course. Where the axle shows that it does, that is as likely as for any.
void HeadingBelief::followCourse(const HeadingCues::Course& course, double dt)
{
    const Direction direction = directionOf(course.direction);
    const std::array<double, 4> before = course_;
    for (std::size_t k = 0; k < 4; ++k)
    {
        const double opposite = before[(k + 2) % 4];
        const double along = (k < 2 ? 1.0 : -1.0) * (k % 2 == 0 ? direction.cos : direction.sin);
        const bool isSlow = course.speed < kReverseSpeed;
        const bool isShown = isSlow && byAxle(k) > kKnown;
        const bool mayReverse = isShown || (isSlow && before[k] - opposite > kKnown);
        const bool fits = along > kSideways || (along < -kSideways && mayReverse);
        if (!fits) course_[k] -= kCourseRate * dt;
        if (fits && isShown)
            course_[k] = std::max(course_[k], opposite + std::log(kReverse / (1.0 - kReverse)));
    }
}

std::array<double, 4> HeadingBelief::logs() const
{
    std::array<double, 4> all = course_;
    for (std::size_t k = 1; k < 4; k += 2) all[k] -= axes_ + neighbours_;
    const double told = shape_ + inLine_ + axle_;
    if (told == 0.0) return all;
    // Whichever way it lies along its axis, both ways together are as likely as before.
    const double either = logOfSum(all[0], all[2]);
    const double forth = all[0] - all[2] + told;
    all[0] = either - logOfSum(0.0, -forth);
    all[2] = either - logOfSum(0.0, forth);
    return all;
}

int HeadingBelief::turnDue(double logOdds) const
{
    const std::array<double, 4> all = logs();
    if (logOfSum(all[1], all[3]) - logOfSum(all[0], all[2]) > logOdds)
        return all[1] >= all[3] ? 1 : 3;
    return all[2] - all[0] > logOdds ? 2 : 0;
}

HeadingBelief HeadingBelief::turned(int quarters) const
{
    HeadingBelief next;
    for (int k = 0; k < 4; ++k)
        next.course_[static_cast<std::size_t>(k)] =
            course_[static_cast<std::size_t>((k + quarters % 4 + 4) % 4)];
    const double sign = quarters % 2 == 0 ? 1.0 : -1.0;
    next.axes_ = sign * axes_;
    next.ends_ = quarters % 2 == 0 ? ends_ : sides_;
    next.sides_ = quarters % 2 == 0 ? sides_ : ends_;
    next.neighbours_ = sign * neighbours_;
    if (quarters % 2 == 0)
    {
        next.acrossFor_ = acrossFor_;
        const double front = quarters % 4 == 0 ? 1.0 : -1.0;
        next.shape_ = front * shape_;
        next.inLine_ = front * inLine_;
        next.axle_ = front * axle_;
    }
    return next;
}

double HeadingBelief::forwardProbability() const
{
    return 1.0 / (1.0 + std::exp(course_[2] - course_[0] - axle_ - shape_ - inLine_));
}

double HeadingBelief::forwardProbabilityByCourse() const
{
    return 1.0 / (1.0 + std::exp(course_[2] - course_[0] - axle_));
}

double HeadingBelief::forwardProbabilityByShape() const
{
    return 1.0 / (1.0 + std::exp(-shape_));
}

double HeadingBelief::axesProbability() const
{
    const std::array<double, 4> all = logs();
    const double right = std::exp(all[0]) + std::exp(all[2]);
    return right / (right + std::exp(all[1]) + std::exp(all[3]));
}

double HeadingBelief::ownAxesProbability() const
{
    HeadingBelief alone = *this;
    alone.neighbours_ = alone.inLine_ = 0.0;
    return alone.axesProbability();
}

}  // namespace vdamf
