// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/logistic.h"

#include <Eigen/Cholesky>

namespace vdamf
{
namespace
{
Eigen::VectorXd probabilities(const Eigen::VectorXd& logOdds)
{
    return (1.0 + (-logOdds.array()).exp()).inverse();
}
}  // namespace

double logLoss(const Eigen::VectorXd& logOdds, const Eigen::VectorXd& outcomes)
{
    // log(1 + exp(-s)) of the log-odds s towards the outcome, without overflow.
    const Eigen::ArrayXd towards = (2.0 * outcomes.array() - 1.0) * logOdds.array();
    const Eigen::ArrayXd loss = (-towards.abs()).exp().log1p() - towards.min(0.0);
    return loss.size() > 0 ? loss.mean() : 0.0;
}

Eigen::VectorXd fitLogistic(const LogisticData& data)
{
    constexpr double kPull = 1e-3;
    constexpr int kMostSteps = 50;
    const Eigen::MatrixXd& x = data.predictors;
    const auto loss = [&](const Eigen::VectorXd& c)
    {
        return logLoss(x * c, data.outcomes) * static_cast<double>(x.rows()) +
               0.5 * kPull * c.squaredNorm();
    };
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(x.cols());
    double best = loss(coefficients);
    for (int step = 0; step < kMostSteps; ++step)
    {
        const Eigen::VectorXd p = probabilities(x * coefficients);
        const Eigen::VectorXd gradient = x.transpose() * (p - data.outcomes) + kPull * coefficients;
        const Eigen::VectorXd weight = p.array() * (1.0 - p.array());
        Eigen::MatrixXd hessian = x.transpose() * weight.asDiagonal() * x;
        hessian.diagonal().array() += kPull;
        Eigen::VectorXd change = -hessian.ldlt().solve(gradient);
        // The full Newton step may overshoot where probabilities are close to 0 and 1.
        double next = loss(coefficients + change);
        for (int halving = 0; halving < 20 && !(next <= best); ++halving)
        {
            change *= 0.5;
            next = loss(coefficients + change);
        }
        if (!(next <= best)) break;
        coefficients += change;
        const bool isDone = best - next < 1e-10 * (1.0 + best);
        best = next;
        if (isDone) break;
    }
    return coefficients;
}

}  // namespace vdamf
