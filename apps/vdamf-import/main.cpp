// SPDX-License-Identifier: BSD-3-Clause
// vdamf-import: recordings of other formats to rawlogs.
#include <algorithm>
#include <memory>
#include <vector>

#include "commands.h"
#include "program.h"

namespace
{
using vdamf::ImportCommand;

struct Subcommand
{
    std::unique_ptr<ImportCommand> command;
    CLI::App* app = nullptr;
};

std::vector<Subcommand> declared(CLI::App& app)
{
    app.require_subcommand(1);
    std::vector<Subcommand> commands;
    for (const auto& make :
         {vdamf::kittiRawCommand, vdamf::velodynePcapCommand, vdamf::cloudsCommand})
    {
        commands.push_back({make(), nullptr});
        commands.back().app = commands.back().command->declare(app);
    }
    return commands;
}

// The one that the command line names.
ImportCommand& chosenFrom(const std::vector<Subcommand>& commands)
{
    const auto isParsed = [](const Subcommand& one) { return one.app->parsed(); };
    return *std::find_if(commands.begin(), commands.end(), isParsed)->command;
}
}  // namespace

int main(int argc, char** argv)
{
    std::vector<Subcommand> commands;
    const auto work = [&]
    {
        vdamf::catchSignals();
        return chosenFrom(commands).run();
    };
    return vdamf::runProgram(
        argc, argv,
        {"vdamf-import", "Converts recordings of other formats to MRPT rawlogs.",
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
         "'vdamf-import kitti-raw --help' lists its options.",
         [&](CLI::App& app) { commands = declared(app); }, [&] { chosenFrom(commands).prepare(); },
         work});
}
