// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/types/plane_motion.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
constexpr double kExactly = 1e-12;
const PlaneMotion kQuarterTurn{0.5 * kPi, {1.0, 0.0}};
const PlaneMotion kSlight{-0.2, {0.3, -0.7}};
const Eigen::Vector2d kSomewhere(3.0, 2.0);

TEST(PlaneMotion, TurnsAboutTheOriginThenShifts)
{
    EXPECT_TRUE(kQuarterTurn.of(kSomewhere).isApprox(Eigen::Vector2d(-1.0, 3.0), kExactly));
    const OrientedBox box = kQuarterTurn.of(OrientedBox{3.0, 2.0, 3.0, 4.4, 1.8});
    EXPECT_TRUE(box.centre().isApprox(Eigen::Vector2d(-1.0, 3.0), kExactly));
    EXPECT_NEAR(box.heading, 3.0 + 0.5 * kPi - 2.0 * kPi, kExactly);
    EXPECT_EQ(box.length, 4.4);
    EXPECT_EQ(box.width, 1.8);
}

TEST(PlaneMotion, OneAfterAnother)
{
    EXPECT_TRUE((kSlight * kQuarterTurn)
                    .of(kSomewhere)
                    .isApprox(kSlight.of(kQuarterTurn.of(kSomewhere)), kExactly));
}

TEST(PlaneMotion, InverseLeadsBack)
{
    EXPECT_TRUE(kSlight.inverse().of(kSlight.of(kSomewhere)).isApprox(kSomewhere, kExactly));
}

TEST(PlaneMotion, IsTheSameAboutAnyOrigin)
{
    const Eigen::Vector2d origin(-20.0, 7.0);
    const Eigen::Vector2d moved = kSlight.about(origin).of(kSomewhere - origin) + origin;
    EXPECT_TRUE(moved.isApprox(kSlight.of(kSomewhere), kExactly));
}

}  // namespace
}  // namespace vdamf
