// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/types/direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
void expectAsTheLibraryHasIt(double angle)
{
    const Direction d = directionOf(angle);
    EXPECT_NEAR(d.cos, std::cos(angle), 3e-16) << "cosine of " << angle;
    EXPECT_NEAR(d.sin, std::sin(angle), 3e-16) << "sine of " << angle;
}
}  // namespace

TEST(Direction, IsThatOfTheLibraryInAllQuadrants)
{
    std::mt19937_64 random(1);
    for (const double most : {0.8, 3.2, 100.0, 9e4, 1e9})
    {
        std::uniform_real_distribution<double> angles(-most, most);
        for (int k = 0; k < 20000; ++k) expectAsTheLibraryHasIt(angles(random));
    }
}

TEST(Direction, IsThatOfTheLibraryWhereQuadrantsMeet)
{
    for (int eighth = -16; eighth <= 16; ++eighth)
        for (const double beside : {-1e-9, 0.0, 1e-9})
            expectAsTheLibraryHasIt(0.25 * kPi * eighth + beside);
}

TEST(Direction, OfNoNumberIsNone)
{
    const Direction d = directionOf(std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(std::isnan(d.cos));
    EXPECT_TRUE(std::isnan(d.sin));
}
}  // namespace vdamf
