// SPDX-License-Identifier: BSD-3-Clause
// The shipped street: nothing runs into anything, and there is something to track.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "simulation/solid_objects.h"
#include "vdamf/evaluation/box_overlap.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
namespace
{
Scenario street()
{
    return readScenario(IniDocument::load(VDAMF_SOURCE_DIR "/datasets/street/scenario.ini"));
}

/// Foliage may overlap; all else is solid.
TEST(Street, NothingCollides)
{
    const Scenario scenario = street();
    SceneObject platform;
    platform.name = "platform";
    platform.size = {4.8, 1.9, 1.6};
    platform.rearAxleOffset = 0.28 * platform.size.length;
    platform.trajectory = scenario.scene.platform;
    std::vector<SceneObject> objects{platform};
    for (const SceneObject& object : scenario.scene.objects)
    {
        if (isSolid(object)) objects.push_back(object);
    }
    for (double time = 0.0; time <= scenario.run.duration; time += 0.1)
    {
        for (std::size_t i = 0; i < objects.size(); ++i)
        {
            for (std::size_t k = i + 1; k < objects.size(); ++k)
            {
                const double overlap =
                    birdsEyeIou(boxAt(objects[i], time), boxAt(objects[k], time));
                EXPECT_EQ(overlap, 0.0)
                    << objects[i].name << " and " << objects[k].name << " at " << time << " s";
            }
        }
    }
}

TEST(Street, EveryVehicleIsSeenAndTheMovingOnesForAWhile)
{
    const Scenario scenario = street();
    std::map<std::string, int> seenFrames;
    for (int i = 0; i < scenario.frames(); i += 5)
    {
        for (const TruthRow& row : simulateFrame(scenario, i).truth)
        {
            seenFrames[row.objectId] += row.points >= 20 ? 1 : 0;
        }
    }
    EXPECT_EQ(seenFrames.size(), 26U);
    for (const auto& [name, frames] : seenFrames)
    {
        const bool moves = name.find("parked") == std::string::npos;
        EXPECT_GE(frames, moves ? 6 : 2) << name;
    }
}

TEST(Street, ShippedTruthIsWhatTheScenarioGives)
{
    const Scenario scenario = street();
    const std::vector<TruthRow> shipped = readTruth(VDAMF_SOURCE_DIR "/datasets/street/truth.csv");
    const std::size_t vehicles = 26;
    ASSERT_EQ(shipped.size(), vehicles * static_cast<std::size_t>(scenario.frames()));
    for (const int frame : {0, 61, 119})
    {
        const std::vector<TruthRow> rows = simulateFrame(scenario, frame).truth;
        ASSERT_EQ(rows.size(), vehicles);
        for (std::size_t i = 0; i < vehicles; ++i)
        {
            const TruthRow& row = shipped[vehicles * static_cast<std::size_t>(frame) + i];
            EXPECT_EQ(row.objectId, rows[i].objectId);
            EXPECT_NEAR(row.time, rows[i].time, 2e-6);
            EXPECT_NEAR(row.box.x, rows[i].box.x, 2e-4);
            EXPECT_NEAR(row.box.y, rows[i].box.y, 2e-4);
            EXPECT_NEAR(row.speed, rows[i].speed, 2e-4);
            // Another mathematical library may move a ray over an edge.
            EXPECT_NEAR(row.points, rows[i].points, 2 + rows[i].points / 100);
        }
    }
}
}  // namespace
}  // namespace vdamf
