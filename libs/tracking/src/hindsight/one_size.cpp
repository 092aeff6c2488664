// SPDX-License-Identifier: BSD-3-Clause
#include "hindsight/one_size.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace vdamf
{
namespace
{
struct KnownSize
{
    double metres = 0.0;
    double variance = 0.0;  // m^2
};

struct WeighedSize
{
    KnownSize size;
    double hits = 0.0;
};

KnownSize sizeOf(const TrackReport& report, int axis)
{
    if (axis == 0) return {report.box.length, report.lengthVariance};
    return {report.box.width, report.widthVariance};
}

bool tellsSize(const TrackMoment& moment)
{
    return isPublished(moment.report) && !moment.report.isOfHits && !moment.wasAcross &&
           moment.report.points > 0;
}

// The median, weighed by hits.
double medianOf(std::vector<WeighedSize> sizes)
{
    const auto less = [](const WeighedSize& a, const WeighedSize& b)
    { return a.size.metres < b.size.metres; };
    std::sort(sizes.begin(), sizes.end(), less);
    const auto add = [](double sum, const WeighedSize& each) { return sum + each.hits; };
    const double half = 0.5 * std::accumulate(sizes.begin(), sizes.end(), 0.0, add);
    double below = 0.0;
    for (const WeighedSize& each : sizes)
    {
        below += each.hits;
        if (below >= half) return each.size.metres;
    }
    return sizes.back().size.metres;
}

// A filter's last word has all of the others in it, but where for a while others' hits are taken
// for the vehicle's own: the last one that agrees with most of those almost as sure as the surest.
KnownSize bestKnown(const TrackHistory& history, int axis)
{
    constexpr double kAlmostAsSure = 1.5;  // of the variances
    constexpr double kAgrees = 2.0;        // sigmas
    std::vector<WeighedSize> sizes;
    for (const TrackMoment& moment : history)
        if (tellsSize(moment))
            sizes.push_back({sizeOf(moment.report, axis), double(moment.report.points)});
    const auto surer = [](const WeighedSize& a, const WeighedSize& b)
    { return a.size.variance < b.size.variance; };
    const double enough =
        kAlmostAsSure * std::min_element(sizes.begin(), sizes.end(), surer)->size.variance;
    const auto isVague = [&](const WeighedSize& each) { return each.size.variance > enough; };
    sizes.erase(std::remove_if(sizes.begin(), sizes.end(), isVague), sizes.end());
    const double most = medianOf(sizes);
    const auto agrees = [&](const WeighedSize& each)
    { return std::abs(each.size.metres - most) <= kAgrees * std::sqrt(each.size.variance); };
    const auto last = std::find_if(sizes.rbegin(), sizes.rend(), agrees);
    return (last != sizes.rend() ? *last : sizes.back()).size;
}

// The centre errs by half of what the size does, away from what was measured.
void resize(TrackReport& report, int axis, const KnownSize& size)
{
    constexpr double kLeastShare = 0.1;  // of a variance: something else erred as well
    const KnownSize before = sizeOf(report, axis);
    const Eigen::Vector2d along = rotation(report.box.heading).col(axis);
    const double lever = 0.5 * report.heldPoint(axis);
    const Eigen::Vector2d centre =
        report.box.centre() + lever * (before.metres - size.metres) * along;
    report.box.x = centre.x();
    report.box.y = centre.y();
    (axis == 0 ? report.box.length : report.box.width) = size.metres;
    (axis == 0 ? report.lengthVariance : report.widthVariance) = size.variance;

    const double variance = along.dot(report.covariance.topLeftCorner<2, 2>() * along);
    const double bySize = lever * lever * (before.variance - size.variance);
    if (!(variance > 0.0) || bySize <= 0.0) return;
    const double share = std::max(kLeastShare, 1.0 - bySize / variance);
    Eigen::Matrix4d less = Eigen::Matrix4d::Identity();
    less.topLeftCorner<2, 2>() -= (1.0 - std::sqrt(share)) * along * along.transpose();
    report.covariance = less * report.covariance * less;
}
}  // namespace

TrackHistory withOneSize(TrackHistory history)
{
    if (std::none_of(history.begin(), history.end(), tellsSize)) return history;
    for (const int axis : {0, 1})
    {
        const KnownSize size = bestKnown(history, axis);
        for (TrackMoment& moment : history) resize(moment.report, axis, size);
    }
    return history;
}

}  // namespace vdamf
