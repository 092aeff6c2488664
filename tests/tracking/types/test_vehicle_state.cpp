// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/types/vehicle_state.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>

namespace vdamf
{
namespace
{
// Whose centre errs with its length, as where its rear alone is measured.
VehicleState rearMeasured()
{
    VehicleState s;
    s.mean << 12.0, 5.0, 0.6, 8.0, 0.0, 1.5, 4.5;
    s.width = 1.8;
    s.widthVariance = 0.08 * 0.08;
    const Eigen::Vector2d along = rotation(s.mean(kHeading)).col(0);
    s.covariance.topLeftCorner<2, 2>() =
        0.05 * 0.05 * Eigen::Matrix2d::Identity() + 0.3 * 0.3 * along * along.transpose();
    s.covariance(kLength, kLength) = 0.6 * 0.6;
    s.covariance.block<2, 1>(kX, kLength) = 0.3 * 0.6 * along;
    s.covariance.block<1, 2>(kLength, kX) = 0.3 * 0.6 * along.transpose();
    return s;
}

TEST(VehicleState, ItsFacesErrAsSamplesOfItDo)
{
    const VehicleState s = rearMeasured();
    const Eigen::Matrix2d axes = rotation(s.mean(kHeading));
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  // x, y, length, width
    covariance.topLeftCorner<2, 2>() = s.covariance.topLeftCorner<2, 2>();
    covariance.block<2, 1>(0, 2) = s.covariance.block<2, 1>(kX, kLength);
    covariance.block<1, 2>(2, 0) = s.covariance.block<1, 2>(kLength, kX);
    covariance(2, 2) = s.covariance(kLength, kLength);
    covariance(3, 3) = s.widthVariance;
    const Eigen::Matrix4d root = covariance.llt().matrixL();
    std::mt19937 random(3);
    std::normal_distribution<> normal;
    constexpr int kSamples = 40000;
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (int k = 0; k < kSamples; ++k)
    {
        const Eigen::Vector4d error =
            root * Eigen::Vector4d::NullaryExpr([&] { return normal(random); });
        for (const int axis : {0, 1})
            for (const int end : {0, 1})
            {
                const double place =
                    axes.col(axis).dot(error.head<2>()) + 0.5 * signOfEnd(end) * error(2 + axis);
                squares(axis, end) += place * place;
            }
    }
    for (const int axis : {0, 1})
        for (const int end : {0, 1})
            EXPECT_NEAR(s.faceSigma(axis, end) / std::sqrt(squares(axis, end) / kSamples), 1.0,
                        0.02)
                << axis << ' ' << end;
    EXPECT_NEAR(s.faceSigma(0, 0), 0.05, 1e-9) << "it was measured";
    EXPECT_NEAR(s.faceSigma(0, 1), std::hypot(0.05, 0.6), 1e-9);
}
}  // namespace
}  // namespace vdamf
