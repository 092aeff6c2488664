// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/truth_frames.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
template <class Row>
std::optional<TimeSpan> spanOfRows(const std::vector<Row>& rows)
{
    const auto earlier = [](const Row& a, const Row& b) { return a.time < b.time; };
    const auto [first, last] = std::minmax_element(rows.begin(), rows.end(), earlier);
    if (first == rows.end()) return std::nullopt;
    return TimeSpan{first->time, last->time};
}

template <class Row>
std::vector<double> timesOfRows(const std::vector<Row>& rows)
{
    std::vector<double> times;
    times.reserve(rows.size());
    for (const Row& row : rows) times.push_back(row.time);
    return times;
}

template <class IsKept>
std::vector<TruthRow> rowsThat(const std::vector<TruthRow>& truth, const IsKept& isKept)
{
    std::vector<TruthRow> kept;
    std::copy_if(truth.begin(), truth.end(), std::back_inserter(kept), isKept);
    return kept;
}
}  // namespace

std::optional<TimeSpan> spanOf(const std::vector<TruthRow>& truth)
{
    return spanOfRows(truth);
}

std::optional<TimeSpan> spanOf(const std::vector<TrackRow>& tracks)
{
    return spanOfRows(tracks);
}

std::string inWords(const TimeSpan& span)
{
    return toFixedText(span.first, 6) + " to " + toFixedText(span.last, 6) + " s";
}

std::vector<TruthRow> truthWithin(const std::vector<TruthRow>& truth, const TimeSpan& span,
                                  double tolerance)
{
    return rowsThat(
        truth, [&](const TruthRow& row)
        { return row.time >= span.first - tolerance && row.time <= span.last + tolerance; });
}

std::vector<TruthRow> truthAt(const std::vector<TruthRow>& truth, std::vector<double> times,
                              double tolerance)
{
    std::sort(times.begin(), times.end());
    return rowsThat(truth,
                    [&](const TruthRow& row)
                    {
                        const auto next =
                            std::lower_bound(times.begin(), times.end(), row.time - tolerance);
                        return next != times.end() && *next <= row.time + tolerance;
                    });
}

std::vector<double> frameTimes(const std::vector<TruthRow>& truth, double tolerance)
{
    return frameTimes(timesOfRows(truth), tolerance);
}

std::vector<double> frameTimes(const std::vector<TrackRow>& tracks, double tolerance)
{
    return frameTimes(timesOfRows(tracks), tolerance);
}

std::vector<double> frameTimes(std::vector<double> ofRows, double tolerance)
{
    std::sort(ofRows.begin(), ofRows.end());
    std::vector<double> times;
    for (const double time : ofRows)
        if (times.empty() || time > times.back() + tolerance) times.push_back(time);
    return times;
}

std::size_t nearestTime(const std::vector<double>& times, double time)
{
    const auto after = std::lower_bound(times.begin(), times.end(), time);
    if (after == times.begin()) return 0;
    const auto before = std::prev(after);
    const bool takeAfter = after != times.end() && *after - time < time - *before;
    return static_cast<std::size_t>((takeAfter ? after : before) - times.begin());
}

void failNothingCommon(const TimeSpan& truth, const TimeSpan& tracks)
{
    throw std::runtime_error("no frame of the truth (" + inWords(truth) +
                             ") has a time of the tracks (" + inWords(tracks) +
                             "); are both of the same recording?");
}

}  // namespace vdamf
