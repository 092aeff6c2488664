// SPDX-License-Identifier: BSD-3-Clause
// What every motion model has to fulfil: docs/motion-models.md, requirement by requirement.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tracking/decompositions.h"
#include "vdamf/tracking/estimation/motion_model.h"

namespace vdamf
{
namespace
{
StateVector row(double heading, double r3, double r4, double r5, double length)
{
    StateVector x;
    x << 12.0, -7.0, heading, r3, r4, r5, length;
    return x;
}

// States of each model: at rest, straight on, turning, in reverse.
template <class Model>
std::vector<StateVector> exampleStates();

template <>
std::vector<StateVector> exampleStates<VariableAxisModel>()
{
    return {row(0.3, 0.0, 0.0, 1.2, 4.4), row(-2.9, 15.0, 0.0, 1.2, 4.4),
            row(3.1, 8.0, 0.05, 1.4, 4.4), row(1.0, -2.5, -0.15, 0.9, 4.4)};
}

template <>
std::vector<StateVector> exampleStates<IndependentModel>()
{
    return {row(0.3, 0.0, 0.0, 0.0, 4.4), row(-2.9, -14.5, -3.6, 0.0, 4.4),
            row(3.1, -8.0, 0.3, 0.4, 4.4), row(1.0, -1.4, -2.1, 0.375, 4.4)};
}

template <class Model>
class MotionModelRequirements : public testing::Test
{
protected:
    MotionOptions options;
    Model model{options};
    std::vector<StateVector> states = exampleStates<Model>();
};

using Models = testing::Types<VariableAxisModel, IndependentModel>;
TYPED_TEST_SUITE(MotionModelRequirements, Models);

StateVector difference(const StateVector& a, const StateVector& b)
{
    StateVector d = a - b;
    d(kHeading) = wrapAngle(d(kHeading));
    return d;
}

TYPED_TEST(MotionModelRequirements, JacobianIsTheDerivative)
{
    for (const StateVector& x : this->states)
        for (const double dt : {0.1, 0.04, 1.5, -0.1})
        {
            const StateMatrix f = this->model.jacobian(x, dt);
            for (int k = 0; k < 7; ++k)
            {
                const double h = 1e-6;
                const StateVector step = h * StateVector::Unit(k);
                const StateVector numeric = difference(this->model.predicted(x + step, dt),
                                                       this->model.predicted(x - step, dt)) /
                                            (2.0 * h);
                EXPECT_LT((f.col(k) - numeric).norm(), 1e-7 * (1.0 + numeric.norm()))
                    << "column " << k << ", dt " << dt;
            }
        }
}

TYPED_TEST(MotionModelRequirements, StepsAddUp)
{
    for (const StateVector& x : this->states)
    {
        StateVector y = x;
        for (int k = 0; k < 10; ++k) y = this->model.predicted(y, 0.05);
        // The axle returns to its prior while it moves: not to the last digit.
        EXPECT_LT(difference(y, this->model.predicted(x, 0.5)).norm(), 1e-3);
        const StateVector back = this->model.predicted(this->model.predicted(x, 0.3), -0.3);
        EXPECT_LT(difference(back, x).norm(), 1e-3);
    }
}

TYPED_TEST(MotionModelRequirements, NoiseIsPositiveAndAddsUpOverSteps)
{
    for (const StateVector& x : this->states)
    {
        const StateMatrix whole = this->model.noise(x, 0.2);
        EXPECT_EQ((whole - whole.transpose()).norm(), 0.0);
        EXPECT_GE(smallestEigenvalue(whole), -1e-12);
        EXPECT_GT(whole(kX, kX), 0.0);
        EXPECT_GT(whole(kHeading, kHeading), 0.0);

        StateMatrix sum = StateMatrix::Zero();
        StateVector y = x;
        for (int k = 0; k < 4; ++k)
        {
            const StateMatrix f = this->model.jacobian(y, 0.05);
            sum = f * sum * f.transpose() + this->model.noise(y, 0.05);
            y = this->model.predicted(y, 0.05);
        }
        for (int i = 0; i < 7; ++i)
            EXPECT_NEAR(sum(i, i), whole(i, i), 0.1 * whole(i, i) + 1e-12) << i;
    }
}

TYPED_TEST(MotionModelRequirements, StandstillStaysAndReverseGoesBackwards)
{
    const StateVector still = this->model.predicted(this->states[0], 5.0);
    EXPECT_LT((still - this->states[0]).template head<3>().norm(), 1e-12);
    const StateVector& reversing = this->states[3];
    const StateVector later = this->model.predicted(reversing, 0.2);
    const Eigen::Vector2d move = (later - reversing).template head<2>();
    EXPECT_LT(rotation(reversing(kHeading)).col(0).dot(move), -0.3);
}

TYPED_TEST(MotionModelRequirements, SizeIsNoMatterOfMotion)
{
    for (const StateVector& x : this->states)
        EXPECT_EQ(this->model.predicted(x, 0.7)(kLength), x(kLength));
}

TYPED_TEST(MotionModelRequirements, ExtremesStayFiniteAndWithinBounds)
{
    for (const double value : {-1e6, -50.0, 0.0, 1e-12, 50.0, 1e6})
        for (const double dt : {1e-9, 0.1, 10.0})
            for (int k = 2; k < 7; ++k)
            {
                StateVector x = this->states[2];
                x(k) = value;
                x = this->model.bounded(x);
                EXPECT_GT(x(kLength), 0.0);
                EXPECT_LE(std::abs(x(kHeading)), kPi);
                const StateVector y = this->model.bounded(this->model.predicted(x, dt));
                EXPECT_TRUE(y.allFinite()) << k << ' ' << value << ' ' << dt;
                EXPECT_TRUE(this->model.jacobian(x, dt).allFinite()) << k << ' ' << value;
                EXPECT_TRUE(this->model.noise(x, dt).allFinite()) << k << ' ' << value;
                EXPECT_LT(difference(this->model.bounded(y), y).norm(), 1e-12) << "not idempotent";
            }
}

VehicleState turning()
{
    VehicleState s;
    s.mean = exampleStates<VariableAxisModel>()[2];
    s.covariance.diagonal() << 0.01, 0.02, 1e-3, 0.1, 1e-4, 0.05, 0.04;
    return s;
}

TEST(MotionModels, FreeStateOfATurningVehicleGoesTheSameWayAtFirst)
{
    const MotionOptions options;
    const VehicleState wheels = turning();
    const VehicleState free = independentOf(wheels);
    const StateVector a = stateAt(wheels, 0.01, options).mean;
    const StateVector b = stateAt(free, 0.01, options).mean;
    EXPECT_LT(difference(a, b).head<3>().norm(), 1e-3);
}

TEST(MotionModels, ThereAndBackIsTheSameState)
{
    const VehicleState wheels = turning();
    const VehicleState back = variableAxisOf(independentOf(wheels), wheels, MotionOptions());
    EXPECT_LT((back.mean.head<4>() - wheels.mean.head<4>()).norm(), 1e-9);
    EXPECT_NEAR(back.mean(kCurvature), wheels.mean(kCurvature), 0.02 * wheels.mean(kCurvature));
    EXPECT_EQ(back.mean(kAxis), wheels.mean(kAxis));
    EXPECT_NEAR(back.covariance(kSpeed, kSpeed), wheels.covariance(kSpeed, kSpeed), 1e-3);
}

}  // namespace
}  // namespace vdamf
