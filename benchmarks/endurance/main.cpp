// SPDX-License-Identifier: BSD-3-Clause
// vdamf_benchmark_endurance: hours of driving from one short drive, as fast as the machine can.
#include <cstdio>

#include "endurance/endurance.h"
#include "program.h"

namespace
{
void print(const vdamf::endurance::Row& row)
{
    std::printf("%8.2f %10.1f %10llu %10.3f %10.1f %9.3f %9.3f\n", row.hours, row.kilometres,
                static_cast<unsigned long long>(row.frames), row.milliseconds, row.megabytes,
                100.0 * row.same, 100.0 * row.alike);
    std::fflush(stdout);
}

void print(const vdamf::endurance::Result& result)
{
    const auto line = [](const char* name, std::uint64_t value)
    { std::printf("  %-34s %llu\n", name, static_cast<unsigned long long>(value)); };
    line("rounds", result.rounds);
    line("tracks", result.tracks);
    line("confirmed", result.confirmed);
    line("identities used twice", result.reused);
}

void declare(CLI::App& app, vdamf::endurance::Plan& plan)
{
    app.add_option("-i,--input", plan.rawlog, "rawlog of poses (CObservationRobotPose) and scans");
    app.add_option("--hours", plan.hours, "of recording time")->check(CLI::PositiveNumber);
    app.add_option("--drift-m", plan.drift, "to the east and north from round to round");
    app.add_option("--rows", plan.rows, "of the table")->check(CLI::Range(1, 1000));
}

int replay(const vdamf::endurance::Plan& plan)
{
    std::printf("%8s %10s %10s %10s %10s %9s %9s\n", "hours", "km", "frames", "ms/frame", "MB",
                "same_%", "alike_%");
    const auto result =
        vdamf::endurance::run(plan, [](const vdamf::endurance::Row& row) { print(row); });
    print(result);
    return result.reused == 0 ? vdamf::kDone : vdamf::kFailed;
}
}  // namespace

int main(int argc, char** argv)
{
    vdamf::endurance::Plan plan;
    plan.rawlog = VDAMF_SOURCE_DIR "/datasets/street/street.rawlog";
    return vdamf::runProgram(
        argc, argv,
        {"vdamf_benchmark_endurance",
         "Replays a drive for hours of recording time, ever farther from where it began.",
         "Example:\n  vdamf_benchmark_endurance --hours 24",
         [&](CLI::App& app) { declare(app, plan); }, nullptr, [&] { return replay(plan); }});
}
