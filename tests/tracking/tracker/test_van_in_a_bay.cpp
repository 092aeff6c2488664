// SPDX-License-Identifier: BSD-3-Clause
// A van that stands with its front away from the sensor, beside a car that hides all below its
// roof: the roof ends at the windscreen, a metre and a half before the van does.
#include <gtest/gtest.h>

#include <cmath>

#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
TEST(VanInABay, ItIsNotAsShortAsItsRoof)
{
    constexpr const char* kScene =
        "[scenario]\nduration_s = 4\n[sensor]\nx_m = 0.8\nz_m = 1.9\n"
        "[platform]\nx_m = -4\ny_m = 0\n"
        "[object car]\nclass = car\nx_m = 22.4\ny_m = -8.2\nheading_deg = -89.5\n"
        "[object van]\nclass = van\nx_m = 25.1\ny_m = -7.8\nheading_deg = -89\n";
    for (const int seed : {1, 2, 3})
    {
        double squares = 0.0;
        double count = 0.0;
        const auto objects = trackedObjects(scenarioOf(kScene, seed));
        for (const Seen& seen : objects.at("van"))
        {
            if (seen.time < 1.0 || seen.tracks.empty()) continue;
            squares += (seen.tracks.front().box.centre() - seen.truth.box.centre()).squaredNorm();
            count += 1.0;
        }
        ASSERT_GT(count, 25.0) << seed;
        EXPECT_LT(std::sqrt(squares / count), 0.4) << seed;
    }
}
}  // namespace
}  // namespace vdamf
