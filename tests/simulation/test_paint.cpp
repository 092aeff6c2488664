// SPDX-License-Identifier: BSD-3-Clause
// Brightness of vehicles.
#include "vdamf/simulation/paint.h"

#include <gtest/gtest.h>

#include <string>

#include "simulation/small_scenes.h"

namespace vdamf
{
namespace
{
TEST(Paint, IsBetweenBlackAndWhiteAndTheNamesOwn)
{
    int dark = 0;
    for (int i = 0; i < 200; ++i)
    {
        const std::string name = "car_" + std::to_string(i);
        const double paint = paintOf(name);
        EXPECT_EQ(paint, paintOf(name));
        EXPECT_GE(paint, 0.015);
        EXPECT_LE(paint, 0.4);
        dark += paint < paintReflectivity(0.5) ? 1 : 0;
    }
    EXPECT_NEAR(dark, 100, 30);
}

TEST(Paint, DarkCarsFadeWithRangeBeforeBrightOnes)
{
    const auto hits = [](double paint, double range)
    {
        Scene scene;
        scene.objects = {objectAt(ObjectClass::Car, {range, 3.0, 0.1, 0, 0}, {4.5, 1.8, 1.5})};
        scene.objects[0].paint = paint;
        LadarMount mount = idealMount();
        mount.ladar = ladarOf(LadarModel::HDL64E);
        mount.halfLossStrength = mount.ladar.halfLossStrength;
        return countHits(cast(scene, mount), 1).at(0);
    };
    EXPECT_GT(hits(0.02, 8.0), 0.7 * hits(0.4, 8.0));
    EXPECT_LT(hits(0.015, 45.0), 0.6 * hits(0.4, 45.0));
}
}  // namespace
}  // namespace vdamf
