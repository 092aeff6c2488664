// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/roc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "vdamf/evaluation/statistics.h"

namespace vdamf
{
namespace
{
using Curve = std::vector<RocPoint>;

/// `samples` by falling score, `weights` one a sample. Empty without vehicles or clutter.
Curve curveOf(const std::vector<ClassifierSample>& samples, const std::vector<double>& weights)
{
    double vehicles = 0.0;
    double clutter = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
        (samples[i].vehicle ? vehicles : clutter) += weights[i];
    }
    if (!(vehicles > 0.0 && clutter > 0.0)) return {};
    Curve curve = {{std::numeric_limits<double>::infinity(), 0.0, 0.0}};
    double hits = 0.0;
    double falseOnes = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
        (samples[i].vehicle ? hits : falseOnes) += weights[i];
        // Samples of one score are called vehicles together.
        const bool isLast = i + 1 == samples.size() || samples[i + 1].score < samples[i].score;
        if (isLast) curve.push_back({samples[i].score, falseOnes / clutter, hits / vehicles});
    }
    return curve;
}

double areaUnder(const Curve& curve)
{
    double area = 0.0;
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
        area += 0.5 * (curve[i].falsePositiveRate - curve[i - 1].falsePositiveRate) *
                (curve[i].truePositiveRate + curve[i - 1].truePositiveRate);
    }
    return area;
}

double equalErrorRate(const Curve& curve)
{
    const auto excess = [](const RocPoint& p)
    { return p.falsePositiveRate - (1.0 - p.truePositiveRate); };
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
        if (excess(curve[i]) < 0.0) continue;
        const double before = excess(curve[i - 1]);
        const double part = -before / (excess(curve[i]) - before);
        const double from = curve[i - 1].falsePositiveRate;
        return from + part * (curve[i].falsePositiveRate - from);
    }
    return 1.0;
}

double missRateAt(const Curve& curve, double falsePositiveRate)
{
    double found = 0.0;
    for (const RocPoint& point : curve)
    {
        if (point.falsePositiveRate <= falsePositiveRate)
            found = std::max(found, point.truePositiveRate);
    }
    return 1.0 - found;
}

RocScores scoresOf(const Curve& curve, std::size_t clutterSamples)
{
    RocScores scores;
    scores.areaUnderCurve = areaUnder(curve);
    scores.equalErrorRate = equalErrorRate(curve);
    if (clutterSamples >= 1000) scores.missRateAtOnePerMille = missRateAt(curve, 1e-3);
    if (clutterSamples >= 100) scores.missRateAtOnePercent = missRateAt(curve, 1e-2);
    return scores;
}

/// Index of each sample's track, from 0.
std::vector<std::size_t> trackIndices(const std::vector<ClassifierSample>& samples)
{
    std::map<std::uint64_t, std::size_t> indices;
    std::vector<std::size_t> result;
    result.reserve(samples.size());
    for (const ClassifierSample& sample : samples)
    {
        result.push_back(indices.try_emplace(sample.trackId, indices.size()).first->second);
    }
    return result;
}

/// Rates at which the band is told.
std::vector<double> bandRates()
{
    constexpr int kSteps = 60;
    constexpr double kDecades = 4.0;
    std::vector<double> rates;
    for (int i = 0; i <= kSteps; ++i)
        rates.push_back(std::pow(10.0, kDecades * (i - kSteps) / kSteps));
    return rates;
}

/// True positive rates at rising false positive rates.
std::vector<double> foundAt(const Curve& curve, const std::vector<double>& rates)
{
    std::vector<double> found;
    std::size_t next = 0;
    double best = 0.0;
    for (const double rate : rates)
    {
        for (; next < curve.size() && curve[next].falsePositiveRate <= rate; ++next)
            best = curve[next].truePositiveRate;
        found.push_back(best);
    }
    return found;
}

/// One draw of tracks.
struct Replicate
{
    RocScores scores;
    std::vector<double> found;  ///< at bandRates()
};

std::vector<Replicate> bootstrap(const std::vector<ClassifierSample>& samples,
                                 const std::vector<std::size_t>& trackOf, std::size_t tracks,
                                 const Roc& roc, const RocOptions& options)
{
    std::mt19937_64 random(options.seed);
    std::vector<Replicate> replicates;
    for (int k = 0; k < options.replicates; ++k)
    {
        std::vector<double> drawn(tracks, 0.0);
        for (std::size_t i = 0; i < tracks; ++i) drawn[random() % tracks] += 1.0;
        std::vector<double> weights;
        weights.reserve(samples.size());
        for (const std::size_t track : trackOf) weights.push_back(drawn[track]);
        const Curve curve = curveOf(samples, weights);
        if (curve.empty()) continue;
        replicates.push_back({scoresOf(curve, roc.clutterSamples), foundAt(curve, bandRates())});
    }
    return replicates;
}

double quantileOfMember(const std::vector<Replicate>& replicates, double RocScores::*member,
                        double fraction)
{
    std::vector<double> values;
    for (const Replicate& r : replicates) values.push_back(r.scores.*member);
    std::sort(values.begin(), values.end());
    return quantileOf(values, fraction);
}

std::optional<double> quantileOfMember(const std::vector<Replicate>& replicates,
                                       std::optional<double> RocScores::*member, double fraction)
{
    std::vector<double> values;
    for (const Replicate& r : replicates)
    {
        if (r.scores.*member) values.push_back(*(r.scores.*member));
    }
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    return quantileOf(values, fraction);
}

RocScores quantileOfScores(const std::vector<Replicate>& replicates, double fraction)
{
    const auto of = [&](auto member) { return quantileOfMember(replicates, member, fraction); };
    return {of(&RocScores::areaUnderCurve), of(&RocScores::equalErrorRate),
            of(&RocScores::missRateAtOnePerMille), of(&RocScores::missRateAtOnePercent)};
}

std::vector<RocBandPoint> bandOf(const std::vector<Replicate>& replicates)
{
    std::vector<RocBandPoint> band;
    if (replicates.empty()) return band;
    const std::vector<double> rates = bandRates();
    for (std::size_t i = 0; i < rates.size(); ++i)
    {
        std::vector<double> found;
        for (const Replicate& r : replicates) found.push_back(r.found[i]);
        std::sort(found.begin(), found.end());
        band.push_back({rates[i], quantileOf(found, 0.025), quantileOf(found, 0.975)});
    }
    return band;
}
}  // namespace

std::optional<Roc> rocOf(const std::vector<ClassifierSample>& samples, const RocOptions& options)
{
    std::vector<ClassifierSample> sorted = samples;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.score > b.score; });
    Roc roc;
    for (const ClassifierSample& sample : sorted)
    {
        ++(sample.vehicle ? roc.vehicleSamples : roc.clutterSamples);
    }
    roc.curve = curveOf(sorted, std::vector<double>(sorted.size(), 1.0));
    if (roc.curve.empty()) return std::nullopt;
    roc.scores = scoresOf(roc.curve, roc.clutterSamples);
    const std::vector<std::size_t> trackOf = trackIndices(sorted);
    roc.tracks = 1 + *std::max_element(trackOf.begin(), trackOf.end());
    const std::vector<Replicate> replicates = bootstrap(sorted, trackOf, roc.tracks, roc, options);
    roc.low = quantileOfScores(replicates, 0.025);
    roc.high = quantileOfScores(replicates, 0.975);
    roc.band = bandOf(replicates);
    return roc;
}

}  // namespace vdamf
