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
struct Mean
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

struct Means
{
    std::vector<Mean> metrics;
    Mean time;
    std::size_t failures = 0;

    void add(const SweepRow& row)
    {
        const bool failed = !row.failure.empty();
        failures += failed ? 1 : 0;
        for (std::size_t k = 0; k < metrics.size(); ++k)
            metrics[k].add(failed ? std::nullopt : row.values[k]);
        time.add(failed ? std::nullopt : std::optional<double>(row.times.trackingMsPerFrame));
    }
};
}  // namespace

std::vector<SettingSummary> summaries(const SweepResults& results)
{
    std::vector<Means> means(results.settings.size());
    for (Means& mean : means) mean.metrics.resize(results.metrics.size());
    for (const SweepRow& row : results.rows) means[row.setting].add(row);
    std::vector<SettingSummary> all;
    for (const Means& mean : means)
    {
        SettingSummary summary;
        for (const Mean& metric : mean.metrics) summary.means.push_back(metric.value());
        summary.msPerFrame = mean.time.value();
        summary.failures = mean.failures;
        all.push_back(std::move(summary));
    }
    return all;
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
