// SPDX-License-Identifier: BSD-3-Clause
#include "hindsight/one_front.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace vdamf
{
namespace
{
// Quarters by which the heading turned from one measured moment to the next, as no vehicle does:
// more or less so, as it errs as well.
int quartersBetween(const TrackMoment& from, const TrackMoment& to)
{
    constexpr double kAtOnce = 0.5;            // s: over more a vehicle may turn itself
    constexpr double kAbout = 25.0 * kDegree;  // of a quarter
    const double dt = to.time - from.time;
    if (dt > kAtOnce) return 0;
    const double itself = dt * from.report.yawRate;
    const double turn = wrapAngle(to.report.box.heading - from.report.box.heading - itself);
    const double quarters = std::round(turn / (0.5 * kPi));
    return std::abs(turn - 0.5 * kPi * quarters) < kAbout ? static_cast<int>(quarters) : 0;
}

// Quarters by which the heading of each moment is turned from that of the first, 0 to 3. What is
// not measured goes on as it was.
std::vector<int> quartersOf(const TrackHistory& history)
{
    std::vector<int> quarters(history.size(), 0);
    std::size_t last = 0;  // measured
    for (std::size_t k = 1; k < history.size(); ++k)
    {
        quarters[k] = quarters[last];
        if (history[k].report.points == 0) continue;
        quarters[k] = (quarters[last] + quartersBetween(history[last], history[k]) + 4) % 4;
        last = k;
    }
    return quarters;
}

// How the axes lie for most hits: 0 as in the first moment, 1 across.
int axesOf(const TrackHistory& history, const std::vector<int>& quarters)
{
    std::array<double, 2> hits{};
    for (std::size_t k = 0; k < history.size(); ++k)
        hits[static_cast<std::size_t>(quarters[k] % 2)] += history[k].report.points;
    return hits[1] > hits[0] ? 1 : 0;
}

// The moment with those axes in which the front was surest, the last of equals.
std::optional<std::size_t> surest(const TrackHistory& history, const std::vector<int>& quarters,
                                  int axes)
{
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < history.size(); ++k)
        if (quarters[k] % 2 == axes && (!best || history[k].report.forwardProbability >=
                                                     history[*best].report.forwardProbability))
            best = k;
    return best;
}

// Front and rear exchanged: it moves as it did.
void reverse(TrackReport& report)
{
    report.speed = -report.speed;
    report.covariance.row(3) *= -1.0;
    report.covariance.col(3) *= -1.0;
}

// Length and width exchanged: what was held of its speed along the heading is void.
void exchangeAxes(TrackReport& report)
{
    constexpr double kUnknownSpeed = 16.0;  // m/s, standard deviation
    std::swap(report.box.length, report.box.width);
    std::swap(report.lengthVariance, report.widthVariance);
    report.speed = 0.0;
    report.yawRate = 0.0;
    report.covariance.row(3).setZero();
    report.covariance.col(3).setZero();
    report.covariance(3, 3) = kUnknownSpeed * kUnknownSpeed;
}

TrackReport turned(TrackReport report, int quarters)
{
    if (quarters == 0) return report;
    report.box.heading = wrapAngle(report.box.heading + 0.5 * kPi * quarters);
    report.facesSeen = turnedBy(report.facesSeen, quarters);
    for (int k = 0; k < quarters; ++k)
        report.heldPoint = {report.heldPoint.y(), -report.heldPoint.x()};
    if (quarters == 2)
        reverse(report);
    else
        exchangeAxes(report);
    return report;
}
}  // namespace

TrackHistory withOneFront(TrackHistory history)
{
    const std::vector<int> quarters = quartersOf(history);
    const auto best = surest(history, quarters, axesOf(history, quarters));
    if (!best) return history;
    const TrackReport surely = history[*best].report;
    for (std::size_t k = 0; k < history.size(); ++k)
    {
        const int turn = (quarters[*best] - quarters[k] + 4) % 4;
        TrackReport& report = history[k].report;
        report = turned(std::move(report), turn);
        history[k].wasAcross = turn % 2 != 0;
        report.forwardProbability = surely.forwardProbability;
        if (history[k].wasAcross) report.axesProbability = surely.axesProbability;
    }
    return history;
}

}  // namespace vdamf
