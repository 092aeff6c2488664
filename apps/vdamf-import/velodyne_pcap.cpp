// SPDX-License-Identifier: BSD-3-Clause
// vdamf-import velodyne-pcap
#include <chrono>

#include "commands.h"
#include "vdamf/rawlog/velodyne_import.h"

namespace vdamf
{
namespace
{
class VelodynePcap : public ImportCommand
{
public:
    CLI::App* declare(CLI::App& app) override
    {
        CLI::App* command = app.add_subcommand(
            "velodyne-pcap", "A network capture of Velodyne sensors (VLP-16, HDL-32E, HDL-64E)");
        command->footer(
            "Example:\n  vdamf-import velodyne-pcap drive.pcap -o drive.rawlog --poses poses.txt "
            "--sensor-pose 1.6 0 1.8 0 0 0");
        command->add_option("capture", job_.capture, "File of tcpdump, Wireshark or VeloView")
            ->required();
        command->add_option("--model", model_, "Sensor, where the packets do not say it")
            ->check(CLI::IsMember({"VLP-16", "HDL-32E", "HDL-64E"}));
        command->add_option("--calibration", job_.calibration,
                            "Calibration of the sensor (xml); needed for an HDL-64E");
        command->add_option("--poses", job_.poses,
                            "Poses of the vehicle, TUM format: time tx ty tz qx qy qz qw");
        declareSensorPose(*command, sensorPose_);
        command
            ->add_option("--cut-azimuth-deg", job_.cutAzimuth,
                         "Where revolutions begin, clockwise from forward")
            ->check(within(0.0, 360.0))
            ->capture_default_str();
        declareOutput(*command);
        return command;
    }

    void prepare() override
    {
        job_.output = output();
        job_.sensorInVehicle = sensorPoseFrom(sensorPose_);
        for (const VelodyneModel model :
             {VelodyneModel::VLP16, VelodyneModel::HDL32E, VelodyneModel::HDL64E})
            if (nameOf(model) == model_) job_.model = model;
        checkPaths(job_);
    }

    int run() override
    {
        const auto begin = std::chrono::steady_clock::now();
        const VelodyneImportSummary summary = importVelodyne(job_);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        if (summary.stopped) return saidInterrupted();
        if (!isQuiet()) summarise(summary, taken.count());
        warn(summary);
        if (summary.capture.problem.empty()) return kDone;
        std::fprintf(stderr, "vdamf-import: %s: %s; the %zu scans before are in %s\n",
                     job_.capture.c_str(), summary.capture.problem.c_str(), summary.scans,
                     rawlog_.c_str());
        return kFailed;
    }

private:
    void summarise(const VelodyneImportSummary& summary, double seconds) const
    {
        const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
        std::FILE* const to = summaryStream();
        std::fprintf(to, "%s\n", rawlog_.string().c_str());
        std::fprintf(to, "  frames      %zu (%.1f s)\n", summary.scans, summary.seconds);
        for (const std::string& sensor : summary.sensors)
            std::fprintf(to, "  sensor      %s\n", sensor.c_str());
        std::fprintf(to, "  points      %zu (%.0f a frame)\n", summary.points,
                     static_cast<double>(summary.points) / static_cast<double>(summary.scans));
        std::fprintf(to, "  packets     %llu with returns, %llu with positions, %llu others\n",
                     number(summary.capture.data), number(summary.capture.positions),
                     number(summary.capture.other));
        if (summary.clockRestarts > 0)
            std::fprintf(to, "  clock       the sensor's started anew %zu times\n",
                         summary.clockRestarts);
        std::fprintf(to, "  GPS         %zu positions\n", summary.gps);
        std::fprintf(to, "  poses       %zu%s\n", summary.poses,
                     summary.poses > 0 || summary.gps > 1
                         ? ""
                         : " (a sensor that stood still: vdamf-track --set ins.source=standing)");
        finishSummary(to, summary.scans, seconds);
    }

    // What was left out, on stderr.
    void warn(const VelodyneImportSummary& summary) const
    {
        if (summary.capture.cut > 0)
            std::fprintf(stderr, "%s: left out: %llu packets captured without their end\n",
                         job_.capture.c_str(),
                         static_cast<unsigned long long>(summary.capture.cut));
    }

    VelodyneImport job_;
    std::string model_;
    std::vector<double> sensorPose_;
};
}  // namespace

std::unique_ptr<ImportCommand> velodynePcapCommand()
{
    return std::make_unique<VelodynePcap>();
}

}  // namespace vdamf
