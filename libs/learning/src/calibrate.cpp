// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/calibrate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vdamf/learning/logistic.h"

namespace vdamf
{
namespace
{
using JudgedTracks = std::vector<std::vector<JudgedFrame>>;

/// Slopes must not turn: a higher score never speaks against a vehicle.
FrameCalibration withoutTurn(FrameCalibration c)
{
    constexpr double kLeastSlope = 1e-3;
    constexpr double kLow = -1.0;  // decades of hits beside 50
    constexpr double kHigh = 1.6;
    const double least =
        std::min(c.slope + kLow * c.slopePerDecade, c.slope + kHigh * c.slopePerDecade);
    if (least > 0.0) return c;
    c.slopePerDecade = 0.0;
    c.slope = std::max(kLeastSlope, c.slope);
    return c;
}

double priorOf(const std::vector<ScoredSample>& samples)
{
    double vehicles = 0.5;
    double clutter = 0.5;
    for (const ScoredSample& sample : samples) (sample.vehicle ? vehicles : clutter) += 1.0;
    return std::log(vehicles / clutter);
}

/// Evidence with slope 1 and offset 0 at the frames that count, and what they are.
LogisticData evidenceOf(const JudgedTracks& tracks, TrackCalibration trial, double prior)
{
    trial.slope = 1.0;
    trial.offset = 0.0;
    trial.cap = 1e9;
    std::vector<double> evidence;
    std::vector<double> outcomes;
    for (const std::vector<JudgedFrame>& track : tracks)
    {
        const std::vector<double> course = courseOf(track, trial, prior);
        for (std::size_t i = 0; i < track.size(); ++i)
        {
            if (!track[i].counts) continue;
            evidence.push_back(course[i]);
            outcomes.push_back(track[i].vehicle ? 1.0 : 0.0);
        }
    }
    const auto n = static_cast<Eigen::Index>(evidence.size());
    LogisticData data{Eigen::MatrixXd::Ones(n, 2), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i)
    {
        data.predictors(i, 0) = evidence[static_cast<std::size_t>(i)];
        data.outcomes(i) = outcomes[static_cast<std::size_t>(i)];
    }
    return data;
}
}  // namespace

FrameCalibration calibrateFrames(const std::vector<ScoredSample>& samples)
{
    const auto n = static_cast<Eigen::Index>(samples.size());
    LogisticData data{Eigen::MatrixXd(n, 4), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i)
    {
        const ScoredSample& sample = samples[static_cast<std::size_t>(i)];
        const double decades = hitDecades(sample.hits);
        data.predictors.row(i) << sample.score, 1.0, decades * sample.score, decades;
        data.outcomes(i) = sample.vehicle ? 1.0 : 0.0;
    }
    const Eigen::VectorXd c = fitLogistic(data);
    return withoutTurn({c(0), c(1), c(2), c(3), priorOf(samples)});
}

std::vector<double> courseOf(const std::vector<JudgedFrame>& track,
                             const TrackCalibration& calibration, double prior)
{
    std::vector<double> course;
    VehicleEvidence evidence;
    for (const JudgedFrame& frame : track)
    {
        evidence = withFrame(evidence, frame.logOdds, calibration, prior);
        course.push_back(trackLogOdds(evidence, calibration));
    }
    return course;
}

TrackCalibration calibrateTracks(const JudgedTracks& tracks, double prior)
{
    TrackCalibration best;
    double least = std::numeric_limits<double>::infinity();
    for (const double memory : {1.0, 0.98, 0.95, 0.9, 0.8})
        for (const double correlation : {0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0})
        {
            TrackCalibration trial;
            trial.memory = memory;
            trial.correlation = correlation;
            const LogisticData data = evidenceOf(tracks, trial, prior);
            const Eigen::VectorXd c = fitLogistic(data);
            const double loss = logLoss(data.predictors * c, data.outcomes);
            if (!(loss < least) || !(c(0) > 0.0)) continue;
            least = loss;
            trial.slope = c(0);
            trial.offset = c(1);
            best = trial;
        }
    return best;
}

}  // namespace vdamf
