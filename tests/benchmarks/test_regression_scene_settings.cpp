// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "regression/scene_settings.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
using testing::ElementsAre;

RegressionScenario scenarioIn(const std::string& name, const std::string& text)
{
    const std::string file = testing::TempDir() + name + ".ini";
    writeTextFile(file, text);
    RegressionScenario scenario;
    scenario.name = name;
    scenario.make = {"vdamf-simulate", file};
    return scenario;
}

TEST(RegressionSceneSettings, AreForEachSensorOfTheSimulatedScenarios)
{
    const RegressionScenario one = scenarioIn("one", "[sensor]\nz_m = 1.9\n");
    const RegressionScenario two =
        scenarioIn("two", "[sensor left]\nz_m = 1.7\n[sensor right]\nz_m = 1.7\n");
    RegressionScenario recorded;
    recorded.make = {"vdamf-import", "kitti-raw"};
    const auto all =
        withSceneSettings({one, recorded, two}, {"sensor.model=HDL-64E", "scenario.duration_s=5"});
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[1].name, "two");
    EXPECT_THAT(all[0].make, ElementsAre("vdamf-simulate", one.make[1], "--set",
                                         "sensor.model=HDL-64E", "--set", "scenario.duration_s=5"));
    EXPECT_THAT(
        all[1].make,
        ElementsAre("vdamf-simulate", two.make[1], "--set", "sensor left.model=HDL-64E", "--set",
                    "sensor right.model=HDL-64E", "--set", "scenario.duration_s=5"));
}

}  // namespace
}  // namespace vdamf
