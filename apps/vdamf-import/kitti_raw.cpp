// SPDX-License-Identifier: BSD-3-Clause
// vdamf-import kitti-raw
#include <chrono>

#include "commands.h"
#include "vdamf/rawlog/kitti_import.h"

namespace vdamf
{
namespace
{
class KittiRaw : public ImportCommand
{
public:
    CLI::App* declare(CLI::App& app) override
    {
        CLI::App* command =
            app.add_subcommand("kitti-raw", "A synchronised drive of KITTI's raw data");
        command->footer(
            "Example:\n  vdamf-import kitti-raw 2011_09_26/2011_09_26_drive_0001_sync "
            "-o drive_0001.rawlog --truth truth.csv");
        command->add_option("drive", job_.drive, "Folder like 2011_09_26_drive_0001_sync")
            ->required();
        command->add_option("--truth", truth_, "Truth table to write (csv), from the tracklets");
        declareOutput(*command);
        return command;
    }

    void prepare() override
    {
        const ImportOutput wanted = output();
        refuseDash(truth_);
        job_.rawlog = wanted.rawlog;
        job_.existing = wanted.existing;
        job_.gzLevel = wanted.gzLevel;
        if (!truth_.empty()) job_.truth = truth_;
        job_.progress = [this](std::size_t done, std::size_t all)
        { return goOn(done, static_cast<double>(done) / static_cast<double>(all)); };
        checkPaths(job_);
    }

    int run() override
    {
        const auto begin = std::chrono::steady_clock::now();
        const KittiImportSummary summary = importKittiDrive(job_);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        if (summary.stopped) return saidInterrupted();
        if (!isQuiet()) summarise(summary, taken.count());
        warn(summary);
        return kDone;
    }

private:
    void summarise(const KittiImportSummary& summary, double seconds) const
    {
        std::FILE* const to = summaryStream({truth_});
        std::fprintf(to, "%s\n", rawlog_.string().c_str());
        std::fprintf(to, "  frames      %zu (%.1f s)\n", summary.scans, summary.seconds);
        std::fprintf(to, "  points      %zu (%.0f a frame)\n", summary.points,
                     static_cast<double>(summary.points) / static_cast<double>(summary.scans));
        std::fprintf(to, "  poses       %zu\n", summary.poses);
        if (!truth_.empty())
            std::fprintf(to, "  labels      %zu of %zu objects in %s\n", summary.labels,
                         summary.objects, truth_.string().c_str());
        finishSummary(to, summary.scans, seconds);
    }

    // What was left out, on stderr.
    void warn(const KittiImportSummary& summary) const
    {
        const auto line = [this](std::size_t count, const char* what)
        {
            if (count > 0)
                std::fprintf(stderr, "%s: left out: %zu %s\n", job_.drive.c_str(), count, what);
        };
        line(summary.missingScans, "scans that have a time, but no file");
        line(summary.labelsWithoutPose, "labels without an INS pose at the time of their scan");
    }

    KittiImport job_;
    std::filesystem::path truth_;
};
}  // namespace

std::unique_ptr<ImportCommand> kittiRawCommand()
{
    return std::make_unique<KittiRaw>();
}

}  // namespace vdamf
