// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace vdamf
{
// Eigen's decompositions take a compiler seconds each: here once for all tests.

// Of a symmetric matrix.
double smallestEigenvalue(const Eigen::MatrixXd& matrix);

// Squared Mahalanobis distance e' P^-1 e.
double squaredMahalanobis(const Eigen::VectorXd& error, const Eigen::MatrixXd& covariance);

// A matrix R with R R' = P, of a covariance P that may be semi-definite.
Eigen::MatrixXd squareRoot(const Eigen::MatrixXd& covariance);

}  // namespace vdamf
