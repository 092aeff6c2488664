// SPDX-License-Identifier: BSD-3-Clause
// Logistic regression on few numbers: Platt scaling.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace vdamf
{
/// Rows of predictors with their outcome.
struct LogisticData
{
    Eigen::MatrixXd predictors;  ///< one row a sample; put a column of ones for an offset
    Eigen::VectorXd outcomes;    ///< 0 or 1
};

/// Coefficients of the most likely log-odds predictors * coefficients. A weak pull to zero keeps
/// them finite where the outcomes can be separated.
Eigen::VectorXd fitLogistic(const LogisticData& data);

/// Mean of -log(probability of the outcome).
double logLoss(const Eigen::VectorXd& logOdds, const Eigen::VectorXd& outcomes);

}  // namespace vdamf
