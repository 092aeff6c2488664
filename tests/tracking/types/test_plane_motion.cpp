// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/types/plane_motion.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
constexpr double kExact = 1e-12;
const PlaneMotion kQuarter{0.5 * kPi, {1.0, 0.0}};
const PlaneMotion kSmall{-0.2, {0.3, -0.7}};
const Eigen::Vector2d kPoint(3.0, 2.0);

TEST(PlaneMotion, TurnsAboutTheOriginThenShifts)
{
    EXPECT_TRUE(kQuarter.of(kPoint).isApprox(Eigen::Vector2d(-1.0, 3.0), kExact));
    const OrientedBox box = kQuarter.of(OrientedBox{3.0, 2.0, 3.0, 4.4, 1.8});
    EXPECT_TRUE(box.centre().isApprox(Eigen::Vector2d(-1.0, 3.0), kExact));
    EXPECT_NEAR(box.heading, 3.0 + 0.5 * kPi - 2.0 * kPi, kExact);
    EXPECT_EQ(box.length, 4.4);
    EXPECT_EQ(box.width, 1.8);
}

TEST(PlaneMotion, OneAfterAnother)
{
    EXPECT_TRUE((kSmall * kQuarter).of(kPoint).isApprox(kSmall.of(kQuarter.of(kPoint)), kExact));
}

TEST(PlaneMotion, InverseLeadsBack)
{
    EXPECT_TRUE(kSmall.inverse().of(kSmall.of(kPoint)).isApprox(kPoint, kExact));
}

TEST(PlaneMotion, IsTheSameAboutAnyOrigin)
{
    const Eigen::Vector2d origin(-20.0, 7.0);
    const Eigen::Vector2d moved = kSmall.about(origin).of(kPoint - origin) + origin;
    EXPECT_TRUE(moved.isApprox(kSmall.of(kPoint), kExact));
}

}  // namespace
}  // namespace vdamf
