// SPDX-License-Identifier: BSD-3-Clause
// Every shipped scenario: it reads, its first frame shows something, and its truth is sane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "simulation/solid_objects.h"
#include "vdamf/evaluation/box_overlap.h"
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
namespace
{
/// By name; those that need data from elsewhere are left out.
std::vector<std::filesystem::path> shippedScenarios()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(VDAMF_SOURCE_DIR "/datasets/scenarios"))
    {
        const std::filesystem::path& path = entry.path();
        if (path.extension() == ".ini" && path.stem() != "argoverse") files.push_back(path);
    }
    std::sort(files.begin(), files.end());
    return files;
}

class Library : public testing::TestWithParam<std::filesystem::path>
{
protected:
    const Scenario scenario_ = readScenario(IniDocument::load(GetParam()));
};

/// The solid objects, and a car around the platform.
std::vector<SceneObject> bodiesOf(const Scenario& scenario)
{
    SceneObject platform;
    platform.name = "platform";
    platform.size = {4.6, 1.8, 1.6};
    platform.rearAxleOffset = 0.28 * platform.size.length;
    platform.trajectory = scenario.scene.platform;
    std::vector<SceneObject> bodies{platform};
    for (const SceneObject& object : scenario.scene.objects)
    {
        if (isSolid(object)) bodies.push_back(object);
    }
    return bodies;
}

bool overlap(const OrientedBox& a, const OrientedBox& b)
{
    const double reach = 0.5 * (std::hypot(a.length, a.width) + std::hypot(b.length, b.width));
    return (a.centre() - b.centre()).norm() < reach && birdsEyeIou(a, b) > 0.0;
}

TEST_P(Library, NothingCollides)
{
    const std::vector<SceneObject> bodies = bodiesOf(scenario_);
    for (int frame = 0; frame < scenario_.frames(); ++frame)
    {
        const double time = scenario_.frameTime(frame);
        std::vector<OrientedBox> boxes;
        for (const SceneObject& body : bodies) boxes.push_back(boxAt(body, time));
        for (std::size_t i = 0; i < boxes.size(); ++i)
        {
            for (std::size_t k = i + 1; k < boxes.size(); ++k)
            {
                ASSERT_FALSE(overlap(boxes[i], boxes[k]))
                    << bodies[i].name << " and " << bodies[k].name << " at " << time << " s";
            }
        }
    }
}

TEST_P(Library, FirstFrameShowsSomething)
{
    const SimulatedFrame frame = simulateFrame(scenario_, 0);
    ASSERT_FALSE(frame.truth.empty());
    const auto seen = std::count_if(frame.truth.begin(), frame.truth.end(),
                                    [](const TruthRow& row) { return row.points >= 5; });
    EXPECT_GE(seen, 1);
}

TEST_P(Library, MovesAsVehiclesCan)
{
    EXPECT_GE(scenario_.run.duration, 10.0);
    EXPECT_LE(scenario_.run.duration, 20.0);
    for (const SceneObject& body : bodiesOf(scenario_))
    {
        for (double time = 0.0; time <= scenario_.run.duration; time += 0.05)
        {
            const MotionState state = body.trajectory.at(time);
            EXPECT_LE(std::abs(state.speed), 40.0) << body.name;
            EXPECT_LE(std::abs(state.yawRate), 1.0) << body.name << " at " << time;
            EXPECT_LE(std::abs(state.yawRate * state.speed), 6.0) << body.name << " at " << time;
        }
    }
}

TEST_P(Library, SaysWhatItTests)
{
    const std::string name = GetParam().stem().string();
    std::ifstream file(GetParam());
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line.rfind("# Tests ", 0), 0U) << name;
    std::ifstream readme(VDAMF_SOURCE_DIR "/datasets/scenarios/README.md");
    const std::string text((std::istreambuf_iterator<char>(readme)), {});
    EXPECT_NE(text.find("`" + name + ".ini`"), std::string::npos) << name;
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Library, testing::ValuesIn(shippedScenarios()),
                         [](const auto& scenario) { return scenario.param.stem().string(); });
}  // namespace
}  // namespace vdamf
