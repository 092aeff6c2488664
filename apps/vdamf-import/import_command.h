// SPDX-License-Identifier: BSD-3-Clause
// One subcommand of vdamf-import, and what all of them share.
#pragma once

#include <Eigen/Geometry>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "program.h"
#include "vdamf/rawlog/import_output.h"

namespace vdamf
{
class ImportCommand
{
public:
    virtual ~ImportCommand() = default;
    /// Adds the subcommand with its options.
    virtual CLI::App* declare(CLI::App& app) = 0;
    /// After parsing: throws std::exception where the options make no job.
    virtual void prepare() = 0;
    /// Does the job; the exit code. Throws std::exception where it fails.
    virtual int run() = 0;

protected:
    void declareOutput(CLI::App& command);
    /// The output as asked for. Throws std::invalid_argument for '-'.
    ImportOutput output() const;
    bool isQuiet() const { return quiet_; }
    /// True as long as no signal asked to stop; shows the progress on a terminal, unless quiet.
    bool goOn(std::size_t scans, double share) const;
    /// Where the summary goes: not into the midst of an output.
    std::FILE* summaryStream(const std::vector<std::filesystem::path>& others = {}) const;
    /// The last lines of each summary. Throws where the stream cannot be written.
    void finishSummary(std::FILE* to, std::size_t scans, double seconds) const;

    std::filesystem::path rawlog_;

private:
    bool overwrite_ = false;
    bool quiet_ = false;
    int gzLevel_ = 1;
};

/// Throws std::invalid_argument for '-', which is no file.
void refuseDash(const std::filesystem::path& output);

/// --sensor-pose: six numbers from -1000 to 1000.
void declareSensorPose(CLI::App& command, std::vector<double>& numbers);

/// "x y z yaw pitch roll", m and deg.
Eigen::Isometry3d sensorPoseFrom(const std::vector<double>& numbers);

int saidInterrupted();

}  // namespace vdamf
