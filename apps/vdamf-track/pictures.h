// SPDX-License-Identifier: BSD-3-Clause
// What a run of vdamf-track can be looked at with: picture, page, scene.
#pragma once

#include <optional>
#include <string>

#include "vdamf/files/output_file.h"
#include "vdamf/rawlog/run_scene.h"
#include "vdamf/rawlog/track_rawlog.h"
#include "vdamf/report/birds_eye.h"
#include "vdamf/report/run_report.h"

namespace vdamf
{
/// Names of the files to write; empty: not asked for.
struct PicturePaths
{
    std::string picture;  ///< bird's-eye view of the last frame, SVG
    std::string report;   ///< page of the run, HTML
    std::string scene;    ///< for SceneViewer3D
};

/// Opens its files first, so that a run does not end on one that cannot be written.
class Pictures
{
public:
    Pictures(const PicturePaths& paths, const TrackRawlogJob& job)
    {
        const auto open = [&job](std::optional<OutputFile>& file, const std::string& path)
        {
            if (!path.empty()) file.emplace(path, job.existing, OutputFile::Unfinished::Discard);
        };
        open(picture_, paths.picture);
        open(reportFile_, paths.report);
        open(sceneFile_, paths.scene);
        if (!reportFile_) return;
        RunReportOptions options;
        options.ground = job.configuration.tracker.ground;
        options.clustering = job.configuration.tracker.clustering;
        report_.emplace(options);
    }

    void add(const LadarFrame& frame, const FrameResult& result)
    {
        if (picture_) birdsEye_.add(frame, result);
        if (report_) report_->add(frame, result);
        if (sceneFile_) scene_.add(frame, result);
    }

    /// Writes the files, which appear under their names.
    void commit(const TrackRawlogJob& job, const TrackRawlogSummary& summary)
    {
        const auto write = [](std::optional<OutputFile>& file, const auto& content)
        {
            if (!file) return;
            file->write(content());
            file->commit();
        };
        write(picture_, [this] { return birdsEye_.svg(); });
        write(reportFile_, [&] { return report_->html(factsOf(job, summary)); });
        write(sceneFile_, [this] { return scene_.bytes(); });
    }

private:
    static RunFacts factsOf(const TrackRawlogJob& job, const TrackRawlogSummary& summary)
    {
        RunFacts facts;
        facts.title = job.input.filename().string();
        facts.version = job.version;
        facts.configuration = toIni(job.configuration);
        std::string sensors;
        for (const std::string& label : summary.sensors)
            sensors += (sensors.empty() ? "" : ", ") + label;
        facts.rows = {
            {"Rawlog", facts.title}, {"LADAR", sensors}, {"INS poses", summary.insSource}};
        const auto stage = [&](const std::string& name, double seconds) {
            facts.stageMillis.emplace_back(name,
                                           1e3 * seconds / static_cast<double>(summary.frames));
        };
        stage("reading", summary.readSeconds);
        stage("to world frame", summary.frameSeconds);
        for (std::size_t k = 0; k < summary.stageSeconds.size(); ++k)
            stage(toString(static_cast<Stage>(k)), summary.stageSeconds[k]);
        stage("writing", summary.writeSeconds);
        return facts;
    }

    std::optional<OutputFile> picture_;
    std::optional<OutputFile> reportFile_;
    std::optional<OutputFile> sceneFile_;
    BirdsEye birdsEye_;
    std::optional<RunReport> report_;
    RunScene scene_;
};

}  // namespace vdamf
