// SPDX-License-Identifier: BSD-3-Clause
#include "pose_samples.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "heading_of.h"

namespace vdamf
{
namespace
{
// The course at a sample looks back to positions this much older at most.
constexpr double kCourseMemory = 3.0;
constexpr double kSoon = 1.0;  // s
// Velocities into an interval take in samples that are this much of its length away: into a gap,
// that between neighbours would carry their noise, times its length over theirs.
constexpr double kLookAround = 0.5;

bool earlier(const PoseSample& sample, double time)
{
    return sample.time < time;
}

/// Derivative at the middle one of three points on a parabola.
Eigen::Vector3d slopeAt(const PoseSample& a, const PoseSample& middle, const PoseSample& b)
{
    const double before = middle.time - a.time;
    const double after = b.time - middle.time;
    const Eigen::Vector3d in = (middle.position - a.position) / before;
    const Eigen::Vector3d out = (b.position - middle.position) / after;
    return (in * after + out * before) / (before + after);
}

Eigen::Vector3d slope(const PoseSample& a, const PoseSample& b)
{
    return (b.position - a.position) / (b.time - a.time);
}

/// Adds the gap between two samples that follow each other, where it is one.
void addGap(InsReport& report, const PoseSample& a, const PoseSample& b, double longestBridged)
{
    const double gap = b.time - a.time;
    if (gap <= longestBridged) return;
    if (report.gaps++ == 0) report.firstGapAt = a.time;
    report.longestGap = std::max(report.longestGap, gap);
}

Eigen::Quaterniond fromHeading(double heading)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()));
}
}  // namespace

bool PoseSamples::insert(const PoseSample& sample)
{
    const auto place = std::lower_bound(samples_.begin(), samples_.end(), sample.time, earlier);
    if (place != samples_.end() && place->time == sample.time) return false;
    const bool newest = place == samples_.end();
    samples_.insert(place, sample);
    if (newest && !sample.attitude)
    {
        if (const auto course = courseOf(samples_.size() - 1))
        {
            lastCourse_ = course;
            compareWithCourse(*course);
        }
    }
    return true;
}

void PoseSamples::forgetBefore(double time)
{
    // Samples before the interval, which may be as long as a gap, give its velocity; more, the
    // course.
    const double forVelocity =
        (1.0 + kLookAround) * std::max(options_.maxGap, options_.maxExtrapolation);
    while (samples_.size() > 3 && samples_[3].time < time - forVelocity &&
           (samples_.front().attitude || samples_.front().time < time - kCourseMemory))
    {
        addGap(forgotten_, samples_[0], samples_[1], options_.maxGap);
        samples_.pop_front();
    }
}

bool PoseSamples::covers(double time) const
{
    const auto place = std::lower_bound(samples_.begin(), samples_.end(), time, earlier);
    return place != samples_.end() && place->time <= time + std::max(kSoon, options_.maxGap);
}

void PoseSamples::compareWithCourse(double course)
{
    const auto attitude = imu_ ? imu_->at(samples_.back().time) : std::nullopt;
    if (!attitude) return;
    const double difference = headingOf(*attitude * Eigen::Vector3d::UnitX()) - course;
    imuLessCourse_ += Eigen::Vector2d(std::cos(difference), std::sin(difference));
}

InsReport PoseSamples::report() const
{
    InsReport report = forgotten_;
    for (std::size_t i = 1; i < samples_.size(); ++i)
        addGap(report, samples_[i - 1], samples_[i], options_.maxGap);
    if (!imuLessCourse_.isZero())
        report.imuLessCourse = std::atan2(imuLessCourse_.y(), imuLessCourse_.x());
    return report;
}

/// Whether the interval before sample i is one to look across.
bool PoseSamples::connected(std::size_t i) const
{
    return i > 0 && i < samples_.size() &&
           samples_[i].time - samples_[i - 1].time <= options_.maxGap;
}

std::optional<VehiclePose> PoseSamples::at(double time) const
{
    const auto place = std::lower_bound(samples_.begin(), samples_.end(), time, earlier);
    const auto i = static_cast<std::size_t>(place - samples_.begin());
    if (place != samples_.end() && place->time == time)
    {
        const auto attitude = attitudeOf(i);
        if (!attitude) return std::nullopt;
        return poseOf(time, place->position, *attitude, i);
    }
    const std::size_t count = samples_.size();
    if (connected(i)) return interpolated(i, time);
    if (i >= 2 && connected(i - 1))
    {
        const std::size_t other = before(i - 1, kLookAround * (time - samples_[i - 1].time));
        if (auto pose = extrapolated(i - 1, other, time)) return pose;
    }
    if (i < count && connected(i + 1))
        return extrapolated(i, after(i, kLookAround * (samples_[i].time - time)), time);
    return std::nullopt;
}

/// The newest sample at least `reach` seconds before sample i; where gaps cut it off, the oldest
/// one behind them; i itself if there is none.
std::size_t PoseSamples::before(std::size_t i, double reach) const
{
    std::size_t k = i;
    while (connected(k) && (k == i || samples_[i].time - samples_[k].time < reach)) --k;
    return k;
}

std::size_t PoseSamples::after(std::size_t i, double reach) const
{
    std::size_t k = i;
    while (connected(k + 1) && (k == i || samples_[k].time - samples_[i].time < reach)) ++k;
    return k;
}

/// In the interval before sample i.
std::optional<VehiclePose> PoseSamples::interpolated(std::size_t i, double time) const
{
    const PoseSample& a = samples_[i - 1];
    const PoseSample& b = samples_[i];
    const auto from = attitudeOf(i - 1);
    const auto to = attitudeOf(i);
    if (!from || !to) return std::nullopt;
    const double h = b.time - a.time;
    const double s = (time - a.time) / h;
    // Cubic Hermite.
    const double r = 1.0 - s;
    const auto [atA, atB] = velocitiesIn(i);
    const Eigen::Vector3d position = r * r * (1.0 + 2.0 * s) * a.position +
                                     s * s * (1.0 + 2.0 * r) * b.position +
                                     h * s * r * (r * atA - s * atB);
    return poseOf(time, position, from->slerp(s, *to), i);
}

/// Beyond sample `from`, away from `other`, with the motion between the two.
std::optional<VehiclePose> PoseSamples::extrapolated(std::size_t from, std::size_t other,
                                                     double time) const
{
    const PoseSample& a = samples_[other];
    const PoseSample& b = samples_[from];
    if (std::abs(time - b.time) > options_.maxExtrapolation) return std::nullopt;
    const auto before = attitudeOf(other);
    const auto last = attitudeOf(from);
    if (!before || !last) return std::nullopt;
    const double steps = (time - b.time) / (b.time - a.time);
    Eigen::AngleAxisd turn(before->conjugate() * *last);
    turn.angle() *= steps;
    return poseOf(time, b.position + steps * (b.position - a.position),
                  *last * Eigen::Quaterniond(turn), from);
}

VehiclePose PoseSamples::poseOf(double time, const Eigen::Vector3d& position,
                                const Eigen::Quaterniond& attitude, std::size_t like) const
{
    return {time, position - attitude * samples_[like].antenna, attitude.normalized()};
}

/// At both ends of the interval before sample i: of the parabolas through them and what lies before
/// and after; where nothing does, of the other one of them.
std::pair<Eigen::Vector3d, Eigen::Vector3d> PoseSamples::velocitiesIn(std::size_t i) const
{
    const PoseSample& a = samples_[i - 1];
    const PoseSample& b = samples_[i];
    const double reach = kLookAround * (b.time - a.time);
    const std::size_t first = before(i - 1, reach);
    const std::size_t last = after(i, reach);
    const Eigen::Vector3d between = slope(a, b);
    if (first == i - 1 && last == i) return {between, between};
    if (first == i - 1)
    {
        const Eigen::Vector3d atB = slopeAt(a, b, samples_[last]);
        return {2.0 * between - atB, atB};
    }
    const Eigen::Vector3d atA = slopeAt(samples_[first], a, b);
    return {atA, last == i ? 2.0 * between - atA : slopeAt(a, b, samples_[last])};
}

std::optional<Eigen::Quaterniond> PoseSamples::attitudeOf(std::size_t i) const
{
    if (samples_[i].attitude) return samples_[i].attitude;
    if (imu_)
    {
        if (const auto attitude = imu_->at(samples_[i].time)) return attitude;
    }
    if (options_.gpsHeading == GpsHeading::Imu) return std::nullopt;
    const auto course = courseOf(i);
    if (course) return fromHeading(*course);
    if (lastCourse_) return fromHeading(*lastCourse_);
    return std::nullopt;
}

std::optional<double> PoseSamples::courseOf(std::size_t i) const
{
    const auto before = drivenBefore(i);
    const auto after = drivenAfter(i);
    if (before && after)
    {
        return headingOf(slopeAt(samples_[*before], samples_[i], samples_[*after]));
    }
    if (before) return headingOf(slope(samples_[*before], samples_[i]));
    if (after) return headingOf(slope(samples_[i], samples_[*after]));
    return std::nullopt;
}

/// The newest sample before i from where the vehicle has driven far enough, without a gap.
std::optional<std::size_t> PoseSamples::drivenBefore(std::size_t i) const
{
    for (std::size_t k = i; connected(k); --k)
    {
        const Eigen::Vector3d driven = samples_[i].position - samples_[k - 1].position;
        if (samples_[i].time - samples_[k - 1].time > kCourseMemory) return std::nullopt;
        if (driven.head<2>().norm() >= options_.minCourseDistance) return k - 1;
    }
    return std::nullopt;
}

std::optional<std::size_t> PoseSamples::drivenAfter(std::size_t i) const
{
    for (std::size_t k = i + 1; connected(k); ++k)
    {
        const Eigen::Vector3d driven = samples_[k].position - samples_[i].position;
        if (samples_[k].time - samples_[i].time > kCourseMemory) return std::nullopt;
        if (driven.head<2>().norm() >= options_.minCourseDistance) return k;
    }
    return std::nullopt;
}

}  // namespace vdamf
