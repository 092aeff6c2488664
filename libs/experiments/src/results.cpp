// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/results.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
std::string shortText(double value, int digits)
{
    std::array<char, 40> text = {};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    return toText(std::strtod(text.data(), nullptr));
}

// Sums grow in the rows' order, so that a mean has the same bits every time.
struct MeanIfKnown
{
    double sum = 0.0;
    std::size_t count = 0;
    bool isKnown = true;

    void add(std::optional<double> value)
    {
        isKnown = isKnown && value.has_value();
        sum += value.value_or(0.0);
        ++count;
    }
    std::optional<double> value() const
    {
        if (!isKnown || count == 0) return std::nullopt;
        return sum / static_cast<double>(count);
    }
};

std::optional<double> valueOf(const SweepRow& row, std::size_t metric)
{
    return row.failure.empty() ? row.values[metric] : std::nullopt;
}

std::optional<double> timeOf(const SweepRow& row)
{
    if (!row.failure.empty()) return std::nullopt;
    return row.times.trackingMsPerFrame;
}

// By recording: whether any setting knows the value.
template <class Value>
std::vector<bool> recordingsThatTell(const SweepResults& results, const Value& value)
{
    std::vector<bool> tell(results.recordings.size(), false);
    for (const SweepRow& row : results.rows)
        if (value(row)) tell[row.recording] = true;
    return tell;
}

// By setting, over the recordings that tell something of it.
template <class Value>
std::vector<std::optional<double>> meansOf(const SweepResults& results, const Value& value)
{
    const std::vector<bool> tell = recordingsThatTell(results, value);
    std::vector<MeanIfKnown> means(results.settings.size());
    for (const SweepRow& row : results.rows)
        if (tell[row.recording]) means[row.setting].add(value(row));
    std::vector<std::optional<double>> values;
    for (const MeanIfKnown& mean : means) values.push_back(mean.value());
    return values;
}
}  // namespace

std::vector<SettingSummary> summaries(const SweepResults& results)
{
    std::vector<SettingSummary> all(results.settings.size());
    for (std::size_t k = 0; k < results.metrics.size(); ++k)
    {
        const auto means = meansOf(results, [k](const SweepRow& row) { return valueOf(row, k); });
        for (std::size_t s = 0; s < all.size(); ++s) all[s].means.push_back(means[s]);
    }
    const auto times = meansOf(results, timeOf);
    for (std::size_t s = 0; s < all.size(); ++s) all[s].msPerFrame = times[s];
    for (const SweepRow& row : results.rows)
        all[row.setting].failures += row.failure.empty() ? 0 : 1;
    return all;
}

std::vector<std::string> silentRecordings(const SweepResults& results)
{
    const std::size_t goal = goalIndex(results);
    const std::vector<bool> tell =
        recordingsThatTell(results, [goal](const SweepRow& row) { return valueOf(row, goal); });
    std::vector<std::string> names;
    for (std::size_t r = 0; r < tell.size(); ++r)
        if (!tell[r]) names.push_back(results.recordings[r]);
    return names;
}

std::size_t goalIndex(const SweepResults& results)
{
    const auto found =
        std::find(results.metrics.begin(), results.metrics.end(), results.goal.metric);
    return static_cast<std::size_t>(found - results.metrics.begin());
}

std::optional<std::size_t> bestSetting(const SweepResults& results)
{
    const std::vector<SettingSummary> all = summaries(results);
    const std::size_t goal = goalIndex(results);
    std::optional<std::size_t> best;
    for (std::size_t s = 0; s < all.size(); ++s)
    {
        const auto mine = all[s].means[goal];
        if (!mine) continue;
        const bool isBetter = !best || (results.goal.highest ? *mine > *all[*best].means[goal]
                                                             : *mine < *all[*best].means[goal]);
        if (isBetter) best = s;
    }
    return best;
}

std::vector<std::size_t> paretoFront(const SweepResults& results)
{
    const std::vector<SettingSummary> all = summaries(results);
    const std::size_t goal = goalIndex(results);
    const double sign = results.goal.highest ? 1.0 : -1.0;
    const auto score = [&](std::size_t s) { return sign * *all[s].means[goal]; };
    std::vector<std::size_t> known;
    for (std::size_t s = 0; s < all.size(); ++s)
        if (all[s].means[goal] && all[s].msPerFrame) known.push_back(s);
    std::sort(known.begin(), known.end(),
              [&](std::size_t a, std::size_t b)
              {
                  if (*all[a].msPerFrame != *all[b].msPerFrame)
                      return *all[a].msPerFrame < *all[b].msPerFrame;
                  return score(a) > score(b);
              });
    std::vector<std::size_t> front;
    for (const std::size_t s : known)
        if (front.empty() || score(s) > score(front.back())) front.push_back(s);
    return front;
}

std::string tableCsv(const SweepResults& results)
{
    constexpr int kDigits = 9;
    std::string table = "setting,recording";
    for (const std::string& key : results.keys) table += "," + key;
    table += ",status,run";
    for (const std::string& metric : results.metrics) table += "," + metric;
    table += "\n";
    for (const SweepRow& row : results.rows)
    {
        const bool failed = !row.failure.empty();
        table += std::to_string(row.setting + 1) + "," + results.recordings[row.recording];
        for (const std::string& value : results.settings[row.setting].values) table += "," + value;
        table += std::string(failed ? ",failed," : ",done,") + row.run;
        for (std::size_t k = 0; k < results.metrics.size(); ++k)
            table += "," + (failed || !row.values[k] ? "" : shortText(*row.values[k], kDigits));
        table += "\n";
    }
    return table;
}

std::string timesCsv(const SweepResults& results)
{
    constexpr int kDigits = 5;
    std::string table = "setting,recording,run,frames,seconds,tracking_ms_per_frame\n";
    for (const SweepRow& row : results.rows)
    {
        if (!row.failure.empty()) continue;
        table += std::to_string(row.setting + 1) + "," + results.recordings[row.recording] + "," +
                 row.run + "," + std::to_string(row.times.frames) + "," +
                 shortText(row.times.seconds, kDigits) + "," +
                 shortText(row.times.trackingMsPerFrame, kDigits) + "\n";
    }
    return table;
}

}  // namespace vdamf
