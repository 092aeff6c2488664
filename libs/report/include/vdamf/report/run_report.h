// SPDX-License-Identifier: BSD-3-Clause
// A run as one HTML page that opens offline in any browser: plays it from above and in 3D, tells
// of each track, and where the tracker erred.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "vdamf/evaluation/evaluation.h"
#include "vdamf/report/mistakes.h"
#include "vdamf/tracking/preprocessing/clustering.h"
#include "vdamf/tracking/preprocessing/ground.h"
#include "vdamf/tracking/types/point_cloud.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
struct RunReportOptions
{
    GroundOptions ground;              ///< as in the run: which hits are shown as ground,
    ClusterOptions clustering;         ///< and which as one cluster
    std::size_t hitsPerFrame = 14000;  ///< shown at most, about 60 kB of page a frame
};

/// What the page says of the run besides its frames; all of it text for people.
struct RunFacts
{
    std::string title;          ///< "street.rawlog"
    std::string version;        ///< of the program that tracked
    std::string configuration;  ///< of the run, as ini
    /// Name and value, in order.
    std::vector<std::pair<std::string, std::string>> rows;
    /// By stage, mean of a frame; empty where not known.
    std::vector<std::pair<std::string, double>> stageMillis;
};

/// What truth the page shows and judges by; what it has of other frames than the run's is left out.
struct ReportTruth
{
    std::vector<TruthRow> rows;
    EvaluationOptions evaluation;
    MistakeOptions mistakes;
};

/// Follows a run frame by frame and makes the page of it. Memory: the compressed frames, about
/// 60 kB each, and 250 bytes a track and frame. The same run gives the same bytes.
class RunReport
{
public:
    explicit RunReport(const RunReportOptions& options = {});
    ~RunReport();
    RunReport(RunReport&&) noexcept;
    RunReport& operator=(RunReport&&) noexcept;

    /// Takes the next frame; frames come by rising time.
    void add(const LadarFrame& frame, const FrameResult& result);

    std::size_t frames() const;

    /// The page. Throws std::runtime_error where there is no frame, and as makeSequence() where
    /// the truth does not fit the run.
    std::string html(const RunFacts& facts) const;
    std::string html(const RunFacts& facts, const ReportTruth& truth) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vdamf
