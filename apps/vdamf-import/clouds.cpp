// SPDX-License-Identifier: BSD-3-Clause
// vdamf-import clouds
#include <chrono>
#include <map>

#include "commands.h"
#include "vdamf/files/ini.h"
#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/annotation.h"
#include "vdamf/rawlog/cloud_import.h"

namespace vdamf
{
namespace
{
const std::map<std::string, PointTime> kPointTimes{
    {"auto", PointTime::Auto},       {"none", PointTime::None},
    {"s", PointTime::Seconds},       {"ms", PointTime::Milliseconds},
    {"us", PointTime::Microseconds}, {"ns", PointTime::Nanoseconds}};

/// Configurations name the sensor to track on by its label.
std::string labelProblem(const std::string& label)
{
    return standsInIni(label) ? "" : inQuotes(label) + ": expected " + kIniText;
}

class Clouds : public ImportCommand
{
public:
    CLI::App* declare(CLI::App& app) override
    {
        CLI::App* command =
            app.add_subcommand("clouds", "A folder of point clouds: PCD, PLY or KITTI's .bin");
        command->footer(
            "Examples:\n"
            "  a sequence of KITTI's odometry data, poses in the sensor's frame:\n"
            "    vdamf-import clouds sequences/00/velodyne --poses 00_velodyne.txt --times "
            "sequences/00/times.txt -o 00.rawlog\n"
            "  files named by their times, poses in TUM format:\n"
            "    vdamf-import clouds scans --poses poses.tum --sensor-pose 1.6 0 1.8 0 0 0 "
            "-o scans.rawlog");
        command->add_option("folder", job_.folder, "Its .pcd, .ply and .bin, by name")->required();
        command->add_option("--poses", job_.poses, "Of the vehicle, TUM or KITTI format");
        CLI::Option* times =
            command->add_option("--times", job_.times, "Times of the clouds, one a line");
        command->add_option("--rate", rate_, "Clouds a second, where there are no times")
            ->check(within(0.1, 100.0))
            ->excludes(times);
        command->add_option("--point-time", pointTime_, "Unit of the field of the hits' times")
            ->check(CLI::IsMember({"auto", "none", "s", "ms", "us", "ns"}))
            ->capture_default_str();
        command->add_option("--label", job_.label, "sensorLabel of the scans")
            ->check(CLI::Validator(labelProblem, ""))
            ->capture_default_str();
        declareSensorPose(*command, sensorPose_);
        declareOutput(*command);
        return command;
    }

    void prepare() override
    {
        checkSensorLabel(job_.label, "--label");
        job_.output = output();
        job_.sensorInVehicle = sensorPoseFrom(sensorPose_);
        job_.pointTime = kPointTimes.at(pointTime_);
        if (rate_ > 0.0) job_.rate = rate_;
        checkPaths(job_);
    }

    int run() override
    {
        const auto begin = std::chrono::steady_clock::now();
        const CloudImportSummary summary = importClouds(job_);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        if (summary.stopped) return saidInterrupted();
        if (!isQuiet()) summarise(summary, taken.count());
        warn(summary);
        return kDone;
    }

private:
    void summarise(const CloudImportSummary& summary, double seconds) const
    {
        std::FILE* const to = summaryStream();
        std::fprintf(to, "%s\n", rawlog_.string().c_str());
        std::fprintf(to, "  frames      %zu (%.1f s)\n", summary.scans, summary.seconds);
        std::fprintf(to, "  points      %zu (%.0f a frame)%s\n", summary.points,
                     static_cast<double>(summary.points) / static_cast<double>(summary.scans),
                     summary.pointTimes ? ", each with its time" : "");
        std::fprintf(to, "  times       %s\n", summary.times.c_str());
        std::fprintf(to, "  poses       %zu%s\n", summary.poses,
                     summary.poses > 0
                         ? ""
                         : " (a sensor that stood still: vdamf-track --set ins.source=standing)");
        finishSummary(to, summary.scans, seconds);
    }

    // What was left out, on stderr.
    void warn(const CloudImportSummary& summary) const
    {
        if (summary.pointsLeftOut > 0)
            std::fprintf(stderr, "%s: left out: %zu hits that are not finite or beyond 1000 km\n",
                         job_.folder.c_str(), summary.pointsLeftOut);
    }

    CloudImport job_;
    double rate_ = 0.0;
    std::string pointTime_ = "auto";
    std::vector<double> sensorPose_;
};
}  // namespace

std::unique_ptr<ImportCommand> cloudsCommand()
{
    return std::make_unique<Clouds>();
}

}  // namespace vdamf
