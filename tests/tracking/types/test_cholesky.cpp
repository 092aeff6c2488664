// SPDX-License-Identifier: BSD-3-Clause
// Small symmetric systems against Eigen's solvers for matrices of any kind.
#include "types/cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

namespace vdamf
{
namespace
{
using Wide = Eigen::Matrix<double, 7, 4>;

// Positive definite, with scales as far apart as a heading's and a length's.
Eigen::Matrix4d covariance(std::mt19937& generator)
{
    std::normal_distribution<double> gauss;
    const Eigen::Vector4d scale(0.1, 0.1, 1e-3, 3.0);
    const Eigen::Matrix4d root = Eigen::Matrix4d::NullaryExpr([&] { return gauss(generator); });
    return scale.asDiagonal() * (root * root.transpose() + 0.1 * Eigen::Matrix4d::Identity()) *
           scale.asDiagonal();
}

TEST(Cholesky, SolvesAsTheInverseDoes)
{
    std::mt19937 generator(5);
    std::normal_distribution<double> gauss;
    for (int k = 0; k < 50; ++k)
    {
        const Eigen::Matrix4d a = covariance(generator);
        const Cholesky<4> factors(a);
        ASSERT_TRUE(factors.isPositive());
        const Eigen::Vector4d v = Eigen::Vector4d::NullaryExpr([&] { return gauss(generator); });
        const Wide b = Wide::NullaryExpr([&] { return gauss(generator); });
        EXPECT_LT((a * factors.solve(v) - v).norm(), 1e-9 * (1.0 + v.norm()));
        EXPECT_LT((factors.solveFromRight<7>(b) * a - b).norm(), 1e-9 * (1.0 + b.norm()));
        EXPECT_NEAR(factors.determinant() / a.determinant(), 1.0, 1e-9);
        EXPECT_NEAR(factors.squaredNorm(v) / v.dot(a.inverse() * v), 1.0, 1e-8);
    }
}

TEST(Cholesky, ReadsTheLowerHalfAlone)
{
    Eigen::Matrix3d a = Eigen::Vector3d(4.0, 9.0, 16.0).asDiagonal();
    a(2, 0) = 1.0;
    Eigen::Matrix3d whole = a;
    whole(0, 2) = 1.0;
    const Eigen::Vector3d v(1.0, 2.0, 3.0);
    EXPECT_EQ(Cholesky<3>(a).solve(v), Cholesky<3>(whole).solve(v));
}

TEST(Cholesky, TellsWhatIsNotPositive)
{
    EXPECT_FALSE(Cholesky<3>(Eigen::Vector3d(1.0, -1.0, 2.0).asDiagonal()).isPositive());
    Eigen::Matrix3d saddle = Eigen::Matrix3d::Identity();
    saddle(1, 0) = saddle(0, 1) = 2.0;
    EXPECT_FALSE(Cholesky<3>(saddle).isPositive());
}

}  // namespace
}  // namespace vdamf
