// SPDX-License-Identifier: BSD-3-Clause
// vdamf-import: recordings of other formats to rawlogs.
#include <exception>
#include <string>

#include "commands.h"

namespace
{
using vdamf::ImportCommand;

struct Subcommand
{
    std::unique_ptr<ImportCommand> command;
    CLI::App* app = nullptr;
};

void declare(CLI::App& app, std::vector<Subcommand>& commands)
{
    app.footer(
        "Examples:\n"
        "  a drive of KITTI's raw data with its labels:\n"
        "    vdamf-import kitti-raw 2011_09_26/2011_09_26_drive_0001_sync -o drive_0001.rawlog "
        "--truth truth.csv\n"
        "  a network capture of a Velodyne sensor:\n"
        "    vdamf-import velodyne-pcap drive.pcap -o drive.rawlog\n"
        "  a folder of point clouds with poses:\n"
        "    vdamf-import clouds scans --poses poses.tum -o scans.rawlog\n"
        "  tracked:\n"
        "    vdamf-track -i drive_0001.rawlog -o tracked.rawlog --tracks tracks.csv\n"
        "'vdamf-import kitti-raw --help' lists its options.");
    app.failure_message(
        [](const CLI::App*, const CLI::Error& error)
        {
            return "vdamf-import: " + std::string(error.what()) +
                   "\nRun with --help for more information.\n";
        });
    app.set_version_flag("--version", "vdamf-import " VDAMF_VERSION);
    app.require_subcommand(1);
    for (const auto& make :
         {vdamf::kittiRawCommand, vdamf::velodynePcapCommand, vdamf::cloudsCommand})
    {
        commands.push_back({make(), nullptr});
        commands.back().app = commands.back().command->declare(app);
    }
}

int run(int argc, char** argv)
{
    CLI::App app("Converts recordings of other formats to MRPT rawlogs.");
    std::vector<Subcommand> commands;
    declare(app, commands);
    ImportCommand* chosen = nullptr;
    try
    {
        app.parse(argc, argv);
        for (const Subcommand& one : commands)
            if (one.app->parsed()) chosen = one.command.get();
        chosen->prepare();
    }
    catch (const CLI::ParseError& error)
    {
        return app.exit(error) == 0 ? vdamf::kDone : vdamf::kBadUse;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "vdamf-import: %s\n", error.what());
        return vdamf::kBadUse;
    }
    vdamf::catchSignals();
    return chosen->run();
}
}  // namespace

int main(int argc, char** argv)
{
    try
    {
        return run(argc, argv);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "vdamf-import: %s\n", error.what());
        return vdamf::kFailed;
    }
}
