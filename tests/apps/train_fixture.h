// SPDX-License-Identifier: BSD-3-Clause
// A folder in which programs learn from the shipped street.
#pragma once

#include <string>

#include "apps/command_line.h"
#include "files/temporary_folder.h"

namespace vdamf
{
inline const std::string kStreetFolder = VDAMF_SOURCE_DIR "/datasets/street/";

class TrainFixture : public TemporaryFolder
{
protected:
    // The program's exit code; what it printed is `output_`.
    int run(const std::string& app, const std::string& arguments)
    {
        const Outcome outcome = runShell("cd '" + at("").string() + "' && '" VDAMF_APPS_DIR "/" +
                                         app + "' " + arguments);
        output_ = outcome.output;
        return outcome.exitCode;
    }

    std::string output_;
};

}  // namespace vdamf
