// SPDX-License-Identifier: BSD-3-Clause
// MRPT's Kalman template with our model against a textbook filter, and its consistency.
#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <random>

namespace vdamf
{
namespace
{
constexpr double kLength = 4.5;

VehicleState startState()
{
    VehicleState s;
    s.mean << 10.0, 5.0, 3.1, 8.0, 0.03, 1.26;
    Vector6d sigma;
    sigma << 0.3, 0.4, 0.1, 2.0, 0.02, 0.4;
    s.covariance = sigma.cwiseAbs2().asDiagonal();
    return s;
}

PoseMeasurement measurementNear(const VehicleState& s)
{
    PoseMeasurement m;
    m.pose = s.mean.head<3>() + Eigen::Vector3d(0.2, -0.1, 0.05);
    m.pose(2) = wrapAngle(m.pose(2));
    m.covariance << 0.02, 0.005, 0.001, 0.005, 0.03, 0.0, 0.001, 0.0, 0.001;
    return m;
}

TEST(VehicleKalmanFilter, EqualsTextbookFilter)
{
    const MotionOptions options;
    VehicleKalmanFilter filter(options);
    VehicleState s = startState();
    VehicleState reference = s;
    for (int k = 0; k < 30; ++k)
    {
        s = filter.predict(s, 0.1, kLength);
        const Matrix6d f = transitionJacobian(reference.mean, 0.1, options);
        const Matrix6d q = processNoise(reference.mean, 0.1, options);
        reference.mean =
            withinBounds(predictState(reference.mean, 0.1, kLength, options), kLength, options);
        reference.covariance = f * reference.covariance * f.transpose() + q;
        ASSERT_LT((s.mean - reference.mean).norm(), 1e-10) << k;
        ASSERT_LT((s.covariance - reference.covariance).norm(), 1e-10) << k;

        const PoseMeasurement m = measurementNear(reference);
        const UpdatedState updated = filter.update(s, m, kLength);
        Eigen::Matrix<double, 3, 6> h = Eigen::Matrix<double, 3, 6>::Zero();
        h.leftCols<3>().setIdentity();
        const Eigen::Matrix3d innovationCovariance =
            h * reference.covariance * h.transpose() + m.covariance;
        Eigen::Vector3d innovation = m.pose - reference.mean.head<3>();
        innovation(2) = wrapAngle(innovation(2));
        const Eigen::Matrix<double, 6, 3> gain =
            reference.covariance * h.transpose() * innovationCovariance.inverse();
        EXPECT_NEAR(updated.nis, innovation.dot(innovationCovariance.inverse() * innovation), 1e-9);
        // Joseph form.
        const Matrix6d keep = Matrix6d::Identity() - gain * h;
        reference.mean = withinBounds(reference.mean + gain * innovation, kLength, options);
        reference.covariance =
            keep * reference.covariance * keep.transpose() + gain * m.covariance * gain.transpose();
        s = updated.state;
        ASSERT_LT((s.mean - reference.mean).norm(), 1e-9) << k;
        ASSERT_LT((s.covariance - reference.covariance).norm(), 1e-9) << k;
        ASSERT_EQ((s.covariance - s.covariance.transpose()).norm(), 0.0);
    }
}

TEST(VehicleKalmanFilter, HeadingInnovationWraps)
{
    VehicleKalmanFilter filter{MotionOptions()};
    VehicleState s = startState();
    PoseMeasurement m = measurementNear(s);
    m.pose(2) = -3.1;  // 0.083 rad ahead of 3.1 over the wrap
    const UpdatedState updated = filter.update(s, m, kLength);
    EXPECT_NEAR(updated.innovation(2), 2.0 * kPi - 6.2, 1e-12);
    EXPECT_GT(std::abs(updated.state.mean(kHeading)), 3.1);
}

TEST(VehicleKalmanFilter, ZeroTimeChangesNothing)
{
    VehicleKalmanFilter filter{MotionOptions()};
    const VehicleState s = startState();
    EXPECT_EQ(filter.predict(s, 0.0, kLength).mean, s.mean);
}

// Vehicles that follow the model with its own noise: NEES and NIS must fit their distributions.
TEST(VehicleKalmanFilter, IsConsistent)
{
    // Bounds that the random vehicles never meet: clipping is not part of the filter's model.
    MotionOptions options;
    options.maxLateralAcceleration = 30.0;
    VehicleKalmanFilter filter(options);
    std::mt19937_64 generator(11);
    std::normal_distribution<double> gauss;
    const auto sample = [&](const Matrix6d& covariance)
    {
        // Semi-definite: through the robust Cholesky decomposition.
        const Eigen::LDLT<Matrix6d> ldlt(covariance);
        Vector6d u;
        for (int i = 0; i < 6; ++i)
            u(i) = gauss(generator) * std::sqrt(std::max(0.0, ldlt.vectorD()(i)));
        return Vector6d(ldlt.transpositionsP().transpose() * (Matrix6d(ldlt.matrixL()) * u));
    };
    const int runs = 100;
    const int steps = 40;
    double nees = 0.0;
    double nis = 0.0;
    for (int run = 0; run < runs; ++run)
    {
        VehicleState s = startState();
        s.mean(kSpeed) = 10.0;
        s.covariance(kSpeed, kSpeed) = 1.0;
        s.covariance(kAxis, kAxis) = 0.04;
        Vector6d truth = s.mean + sample(s.covariance);
        for (int k = 0; k < steps; ++k)
        {
            truth = predictState(truth, 0.1, kLength, options) +
                    sample(processNoise(truth, 0.1, options));
            s = filter.predict(s, 0.1, kLength);
            PoseMeasurement m;
            m.covariance = Eigen::Vector3d(0.01, 0.005, 0.0007).asDiagonal();
            m.pose = truth.head<3>();
            for (int i = 0; i < 3; ++i)
                m.pose(i) += std::sqrt(m.covariance(i, i)) * gauss(generator);
            const UpdatedState updated = filter.update(s, m, kLength);
            s = updated.state;
            nis += updated.nis;
        }
        Vector6d error = s.mean - truth;
        error(kHeading) = wrapAngle(error(kHeading));
        nees += error.dot(s.covariance.ldlt().solve(error));
    }
    // 95 % bounds: chi-square of 600 degrees of freedom over 100 runs; NIS over 12000 with slack
    // for the linearisation.
    EXPECT_GT(nees / runs, 5.34);
    EXPECT_LT(nees / runs, 6.70);
    EXPECT_NEAR(nis / (runs * steps), 3.0, 0.15);
}

}  // namespace
}  // namespace vdamf
