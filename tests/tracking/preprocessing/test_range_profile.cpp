// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/preprocessing/range_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
struct Scan
{
    LadarFrame frame;
    AboveGround above;

    void add(double range, double bearing, float height, float z = 0.0F)
    {
        above.index.push_back(static_cast<std::uint32_t>(frame.points.size()));
        above.height.push_back(height);
        frame.points.x.push_back(
            static_cast<float>(frame.sensor.x() - frame.origin.x() + range * std::cos(bearing)));
        frame.points.y.push_back(
            static_cast<float>(frame.sensor.y() - frame.origin.y() + range * std::sin(bearing)));
        frame.points.z.push_back(z);
    }
};

Scan scanFrom(double x, double y)
{
    Scan scan;
    scan.frame.origin = {100.0, -50.0, 0.0};
    scan.frame.sensor = {100.0 + x, -50.0 + y, 1.8};
    return scan;
}

TEST(RangeProfile, HasTheNearestHitOfEachBearing)
{
    Scan scan = scanFrom(0.3, -0.4);
    std::mt19937 generator(3);
    const auto below = [&](int limit)
    { return static_cast<int>(generator() % static_cast<unsigned>(limit)); };
    std::vector<float> nearest(720, std::numeric_limits<float>::infinity());
    for (int k = 0; k < 5000; ++k)
    {
        const int sector = below(720);
        const double range = 60.0 + 0.1 * below(700);  // no gap is narrow
        // Well inside of a sector: its edges are good to a thousandth.
        const double part = 0.01 + 0.98 * below(1000) / 1000.0;
        scan.add(range, -kPi + 2.0 * kPi * (sector + part) / 720.0, 1.0F);
        float& least = nearest[static_cast<std::size_t>(sector)];
        least = std::min(least, static_cast<float>(range));
    }
    const RangeProfile profile = rangeProfile(scan.frame, scan.above);
    ASSERT_EQ(profile.nearest.size(), nearest.size());
    for (std::size_t k = 0; k < nearest.size(); ++k)
    {
        if (std::isinf(nearest[k]))
            EXPECT_TRUE(std::isinf(profile.nearest[k])) << k;
        else
            EXPECT_NEAR(profile.nearest[k], nearest[k], 2e-5F * nearest[k]) << k;
    }
}

// A sector is 0.35 m wide at 40 m, and 0.7 m at 80 m.
TEST(RangeProfile, TakesNarrowGapsForWhatReturnsNothing)
{
    constexpr double kSector = kPi / 360.0;
    const auto gapAt = [&](double bearing, int sectors, double before, double after)
    {
        Scan scan = scanFrom(0.3, -0.4);
        scan.add(before, bearing - kSector, 1.0F);
        scan.add(after, bearing + sectors * kSector, 1.0F);
        const RangeProfile profile = rangeProfile(scan.frame, scan.above);
        const double first = profile.at(bearing);
        for (int k = 1; k < sectors; ++k) EXPECT_EQ(profile.at(bearing + k * kSector), first) << k;
        return first;
    };
    const double middle = 0.5 * kSector;
    for (const double bearing : {0.2 + middle, -2.0 + middle})
    {
        EXPECT_NEAR(gapAt(bearing, 1, 40.0, 55.0), 55.0, 1e-3) << "the farther one";
        EXPECT_NEAR(gapAt(bearing, 1, 55.0, 40.0), 55.0, 1e-3);
        EXPECT_NEAR(gapAt(bearing, 5, 10.0, 12.0), 12.0, 1e-3);
        EXPECT_TRUE(std::isinf(gapAt(bearing, 1, 80.0, 80.0)));
        EXPECT_TRUE(std::isinf(gapAt(bearing, 6, 10.0, 12.0)));
        EXPECT_NEAR(gapAt(bearing, 1, 40.0, 90.0), 90.0, 1e-3)
            << "it is as wide where it is nearer";
    }
    EXPECT_NEAR(gapAt(-kPi + middle, 1, 20.0, 20.0), 20.0, 1e-3) << "from the last sector on";
    EXPECT_NEAR(gapAt(kPi - middle, 1, 20.0, 20.0), 20.0, 1e-3);
    EXPECT_NEAR(gapAt(kPi - middle, 3, 12.0, 13.0), 13.0, 1e-3);
    EXPECT_TRUE(std::isinf(gapAt(0.2 + middle, 5, 10.0, 30.0))) << "1.3 m at the farther one";
}

TEST(RangeProfile, LooksOverLowHitsAndPastTheAxes)
{
    Scan scan = scanFrom(0.0, 0.0);
    for (const double bearing : {0.0, 0.5 * kPi, -0.5 * kPi, -kPi + 1e-3, kPi - 1e-3})
    {
        scan.add(4.0, bearing, 0.5F);
        scan.add(9.0, bearing, 0.7F);
    }
    const RangeProfile profile = rangeProfile(scan.frame, scan.above);
    for (const double bearing :
         {1e-4, 0.5 * kPi + 1e-4, -0.5 * kPi + 1e-4, -kPi + 2e-3, kPi - 2e-3})
        EXPECT_NEAR(profile.at(bearing), 9.0, 1e-3) << bearing;
    EXPECT_TRUE(std::isinf(profile.at(0.25 * kPi)));
}

TEST(RangeProfile, LooksOverWhatIsLowerThanARay)
{
    Scan scan = scanFrom(0.0, 0.0);
    const double bearing = 0.4;
    scan.add(10.0, bearing, 1.5F, 1.5F);  // slope -0.03
    scan.add(20.0, bearing, 2.8F, 2.8F);  // 0.05
    scan.add(30.0, bearing, 4.2F, 4.2F);  // 0.08
    scan.add(5.0, -bearing, 5.0F, 5.0F);  // 0.64, above all layers
    const RangeProfile profile = rangeProfile(scan.frame, scan.above);
    const auto at = [&](double slope) { return profile.at(bearing, slope); };
    EXPECT_NEAR(profile.at(bearing), 10.0, 1e-3);
    EXPECT_NEAR(at(-1.0), 10.0, 1e-3);
    EXPECT_NEAR(at(-0.035), 10.0, 1e-3);
    EXPECT_NEAR(at(0.0), 20.0, 1e-3);
    EXPECT_NEAR(at(0.045), 20.0, 1e-3);
    EXPECT_NEAR(at(0.065), 30.0, 1e-3);
    EXPECT_TRUE(std::isinf(at(0.095)));
    EXPECT_NEAR(profile.at(-bearing, 0.5), 5.0, 1e-3);
    EXPECT_TRUE(std::isinf(RangeProfile{}.at(bearing, 0.0)));
    RangeProfile blind = profile;
    blind.nearest.assign(blind.nearest.size(), 0.0F);
    EXPECT_EQ(blind.at(bearing, 0.095), 0.0) << "the sensor does not look there";
    scan.frame.planar = true;
    EXPECT_NEAR(rangeProfile(scan.frame, scan.above).at(bearing, 0.065), 10.0, 1e-3)
        << "a level scan does not tell heights";
}

TEST(RangeProfile, HitsThatAreNotFiniteDoNotCount)
{
    Scan scan = scanFrom(0.0, 0.0);
    scan.add(std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0F);
    scan.add(std::numeric_limits<double>::infinity(), 1.0, 1.0F);
    for (const float nearest : rangeProfile(scan.frame, scan.above).nearest)
        EXPECT_TRUE(std::isinf(nearest));
    EXPECT_EQ(rangeProfile(LadarFrame{}, AboveGround{}).nearest.size(), 720U);
}

}  // namespace
}  // namespace vdamf
