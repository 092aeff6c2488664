// SPDX-License-Identifier: BSD-3-Clause
// A folder with a small scenario, and vdamf-simulate run in it.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "apps/command_line.h"
#include "files/temporary_folder.h"

namespace vdamf
{
inline const char* const kScenario = R"([scenario]
duration_s = 0.5
start_time_s = 1700000000
[sensor]
model = @
half_loss_strength = 0
[platform]
x_m = 20
y_m = -7
heading_deg = 30
speed_mps = 6
[object ahead]
class = car
x_m = 30
y_m = 0
heading_deg = 30
speed_mps = 5
segments = 1 0 0.05
[object pole]
class = pole
x_m = 25
y_m = 5
)";

class SimulateFixture : public TemporaryFolder
{
protected:
    void SetUp() override { writeScenario("VLP-16"); }

    std::filesystem::path path(const std::string& name) const { return at(name); }

    void writeScenario(const std::string& model)
    {
        std::string text = kScenario;
        text.replace(text.find('@'), 1, model);
        std::ofstream(path("scene.ini")) << text;
    }

    /// Runs the program in the folder; its exit code. Output: out.txt, errors: err.txt.
    int run(const std::string& arguments) const
    {
        return runShell("cd '" + at("").string() + "' && '" VDAMF_APPS_DIR "/vdamf-simulate' " +
                        arguments + " >out.txt 2>err.txt")
            .exitCode;
    }
};

}  // namespace vdamf
