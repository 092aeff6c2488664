// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/inside_of.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vdamf
{
namespace
{
// 4.5 m long and 1.8 m wide, along x. Its length is uncertain, its rear is not.
VehicleState carOfUnsureLength()
{
    VehicleState s;
    s.mean << 12.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.5;
    s.width = 1.8;
    s.widthVariance = 0.2 * 0.2;
    s.covariance(kX, kX) = 0.3 * 0.3;
    s.covariance(kY, kY) = 0.1 * 0.1;
    s.covariance(kLength, kLength) = 0.6 * 0.6;
    s.covariance(kX, kLength) = s.covariance(kLength, kX) = 0.3 * 0.6;
    return s;
}

TEST(InsideOf, HowFarFacesLieInsideOfTheBoxForetold)
{
    const OrientedBox shorter{12.1, 0.1, 0.0, 3.9, 1.4};  // from 10.15 to 14.05, -0.6 to 0.8
    const Eigen::Vector2d hits(11.0, 0.5);
    const auto inside = [&](int axis, int end)
    { return insideOf(carOfUnsureLength(), shorter, axis, end, hits).metres; };
    EXPECT_NEAR(inside(0, 0), 0.4, 1e-12);
    EXPECT_NEAR(inside(0, 1), 0.2, 1e-12);
    EXPECT_NEAR(inside(1, 0), 0.3, 1e-12);
    EXPECT_NEAR(inside(1, 1), 0.1, 1e-12);
    const OrientedBox longer{12.0, 0.0, 0.0, 5.0, 1.8};
    EXPECT_NEAR(insideOf(carOfUnsureLength(), longer, 0, 1, hits).metres, -0.25, 1e-12)
        << "outside of it";
}

TEST(InsideOf, EachEndErrsAsItIsKnown)
{
    const auto sigma = [](int axis, int end) {
        return insideOf(carOfUnsureLength(), carOfUnsureLength().box(), axis, end, {11.0, 0.5})
            .sigma;
    };
    EXPECT_NEAR(sigma(0, 0), 0.0, 1e-9) << "the rear";
    EXPECT_NEAR(sigma(0, 1), 0.6, 1e-9) << "the front, by all of the length";
    EXPECT_NEAR(sigma(1, 0), std::hypot(0.1, 0.1), 1e-9);
    EXPECT_NEAR(sigma(1, 1), sigma(1, 0), 1e-12);
}

// Of a box that is turned the place beside the hits tells, not that of its middle.
TEST(InsideOf, BesideTheHits)
{
    OrientedBox turned = carOfUnsureLength().box();
    turned.heading = 0.1;
    const auto inside = [&](double x) {
        return insideOf(carOfUnsureLength(), turned, 1, 1, {x, 0.9}).metres;
    };
    EXPECT_LT(inside(14.0), -0.15);
    EXPECT_GT(inside(10.0), 0.15);
    EXPECT_NEAR(inside(14.0) + inside(10.0), 2.0 * inside(12.0), 1e-9);
}
}  // namespace
}  // namespace vdamf
