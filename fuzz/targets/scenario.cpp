// SPDX-License-Identifier: BSD-3-Clause
// The scenario file of vdamf-simulate.
#include "vdamf/simulation/scenario.h"
#include "memory_file.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    fuzz::mayRefuse(
        [&]
        {
            const Scenario scenario =
                readScenario(IniDocument::parse(fuzz::textOf(data, size), "scenario.ini"));
            fuzz::require(scenario.frames() > 0, "a scenario has frames");
        });
    return 0;
}
