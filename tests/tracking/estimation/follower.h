// SPDX-License-Identifier: BSD-3-Clause
// Motion hypotheses of a vehicle that is measured again and again.
#pragma once

#include <random>

#include "vdamf/tracking/estimation/motion_hypotheses.h"

namespace vdamf::test
{
inline VehicleState unknownSpeed()
{
    VehicleState s;
    s.mean << 0.0, 0.0, 0.0, 0.0, 0.0, 1.2, 4.5;
    s.covariance.diagonal() << 0.01, 0.01, 1e-3, 64.0, 2.5e-3, 0.2, 0.05;
    s.width = 1.8;
    s.widthVariance = 0.01;
    return s;
}

// Follows a vehicle along x, measured every tenth of a second (or `interval`) with 6 cm of noise,
// or a part of it.
class Follower
{
public:
    explicit Follower(double noise = 1.0, double interval = 0.1)
        : noise_(noise), interval_(interval)
    {
    }

    MotionHypotheses later() { return predicted(hypotheses, interval_, filter_, options_); }

    void wait(double time) { hypotheses = predicted(hypotheses, time, filter_, options_); }

    void see(double x)
    {
        wait(interval_);
        seeNow(x);
    }

    void seeNow(double x)
    {
        BoxMeasurement m;
        const auto noise = [&](double sigma) { return noise_ * sigma * gauss_(generator_); };
        m.box << x + noise(0.06), noise(0.03), noise(0.01), 4.5 + noise(0.1), 1.8;
        m.covariance.diagonal() << 0.0036, 0.0009, 1e-4, 0.01, 0.01;
        hypotheses = updated(hypotheses, m, JitterShares(), filter_, 11.34);
    }

    VehicleState state() const { return hypotheses.combined(options_); }

    MotionHypotheses hypotheses = hypothesesFrom(unknownSpeed(), MotionOptions());

private:
    double noise_;
    double interval_;  // s
    MotionOptions options_;
    VehicleKalmanFilter filter_{MotionOptions()};
    std::mt19937_64 generator_{4};
    std::normal_distribution<double> gauss_;
};

}  // namespace vdamf::test
