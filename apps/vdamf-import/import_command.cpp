// SPDX-License-Identifier: BSD-3-Clause
#include "import_command.h"

#include <stdexcept>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
void ImportCommand::declareOutput(CLI::App& command)
{
    command.add_option("-o,--output", rawlog_, "Rawlog to write")->required();
    command.add_flag("--overwrite", overwrite_, "Replace existing outputs");
    command.add_flag("-q,--quiet", quiet_, "No progress, no summary");
    command.add_option("--gz-level", gzLevel_, "Compression, 0 (none) to 9")
        ->check(CLI::Range(0, 9))
        ->capture_default_str();
}

ImportOutput ImportCommand::output() const
{
    refuseDash(rawlog_);
    ImportOutput output;
    output.rawlog = rawlog_;
    output.existing = overwrite_ ? OutputFile::Existing::Overwrite : OutputFile::Existing::Refuse;
    output.gzLevel = gzLevel_;
    output.progress = [this](std::size_t scans, double share) { return goOn(scans, share); };
    return output;
}

std::FILE* ImportCommand::summaryStream(const std::vector<std::filesystem::path>& others) const
{
    bool taken = isStandardOutput(rawlog_);
    for (const std::filesystem::path& other : others) taken = taken || isStandardOutput(other);
    return taken ? stderr : stdout;
}

void ImportCommand::finishSummary(std::FILE* to, std::size_t scans, double seconds) const
{
    std::error_code ignored;
    const std::uintmax_t bytes = std::filesystem::file_size(rawlog_, ignored);
    if (!ignored) std::fprintf(to, "  size        %.1f MB\n", static_cast<double>(bytes) / 1e6);
    std::fprintf(to, "  time taken  %.1f s (%.1f frames/s)\n", seconds,
                 static_cast<double>(scans) / seconds);
    checkPrinted(to);
}

bool ImportCommand::goOn(std::size_t scans, double share) const
{
    const bool stops = isInterrupted();
    if (!quiet_ && isTerminal())
        std::fprintf(stderr, "\rscan %zu, %3.0f %%%s", scans, 100.0 * share,
                     share >= 1.0 || stops ? "\n" : "");
    return !stops;
}

void refuseDash(const std::filesystem::path& output)
{
    if (output == "-")
        throw std::invalid_argument(
            "'-' is no file: for the standard output name /dev/stdout (or ./- for a file of this "
            "name)");
}

void declareSensorPose(CLI::App& command, std::vector<double>& numbers)
{
    constexpr double kFarthest = 1000.0;
    command
        .add_option("--sensor-pose", numbers,
                    "Of the sensor on the vehicle: x y z (m) yaw pitch roll (deg)")
        ->check(within(-kFarthest, kFarthest))
        ->expected(6);
}

Eigen::Isometry3d sensorPoseFrom(const std::vector<double>& n)
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    if (n.empty()) return pose;
    pose.translation() = Eigen::Vector3d(n.at(0), n.at(1), n.at(2));
    pose.linear() = (Eigen::AngleAxisd(n.at(3) * kDegree, Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(n.at(4) * kDegree, Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(n.at(5) * kDegree, Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
    return pose;
}

int saidInterrupted()
{
    std::fprintf(stderr, "vdamf-import: interrupted; no output was kept\n");
    return kFailed;
}

}  // namespace vdamf
