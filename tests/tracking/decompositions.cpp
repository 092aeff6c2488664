// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace vdamf
{
double smallestEigenvalue(const Eigen::MatrixXd& matrix)
{
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().minCoeff();
}

double squaredMahalanobis(const Eigen::VectorXd& error, const Eigen::MatrixXd& covariance)
{
    return error.dot(covariance.ldlt().solve(error));
}

Eigen::MatrixXd squareRoot(const Eigen::MatrixXd& covariance)
{
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(covariance);
    const Eigen::MatrixXd lower = ldlt.matrixL();
    const Eigen::VectorXd sigmas = ldlt.vectorD().cwiseMax(0.0).cwiseSqrt();
    return ldlt.transpositionsP().transpose() * (lower * sigmas.asDiagonal());
}

}  // namespace vdamf
