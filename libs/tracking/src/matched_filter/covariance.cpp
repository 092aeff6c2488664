// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/covariance.h"

#include <Eigen/Eigenvalues>

#include "vdamf/tracking/matched_filter/match_response.h"

namespace vdamf
{
namespace
{
// Curvature of a direction that the hits do not hold, in shares of the largest one.
constexpr double kUnheldShare = 1e-4;
}  // namespace

Matrix5d fitCovariance(const Hits& hits, const FilterShape& shape, const OrientedBox& box,
                       double phi, double hitSigma)
{
    // Sum of B_i B_i^T: a centre that stands for n hits moves by the mean of their perturbations
    // and weighs n times, so it counts n times.
    Matrix5d scatter = Matrix5d::Zero();
    const ResponseByHit response = responseByHit(hits, shape, box, phi);
    const auto& byHit = response.gradientByHit;
    for (std::size_t i = 0; i < byHit.size(); ++i)
        scatter += hits.weight[i] * byHit[i] * byHit[i].transpose();

    // At a maximum -H is positive definite.
    const Eigen::SelfAdjointEigenSolver<Matrix5d> eigen(-response.all.hessian);
    const double largest = eigen.eigenvalues().cwiseAbs().maxCoeff();
    const Vector5d curvature =
        eigen.eigenvalues().array().max(kUnheldShare * largest).max(1e-12).matrix();
    const Matrix5d inverse = eigen.eigenvectors() * curvature.cwiseInverse().asDiagonal() *
                             eigen.eigenvectors().transpose();

    // Where hits are exactly in a row, perturbing them moves nothing along it: not because it were
    // known, but because nothing depends on it.
    constexpr double kUnheld = 1.0;  // m and rad
    const Eigen::Array<bool, 5, 1> unheld = eigen.eigenvalues().array() <= kUnheldShare * largest;
    const Vector5d guess = unheld.select(Vector5d::Constant(kUnheld * kUnheld), 0.0);
    const Matrix5d unknown =
        eigen.eigenvectors() * guess.asDiagonal() * eigen.eigenvectors().transpose();

    // From offsets along the axes of the box to world axes; at t = 0 the turn adds nothing.
    Matrix5d toWorld = Matrix5d::Identity();
    toWorld.topLeftCorner<2, 2>() = rotation(box.heading);
    const Matrix5d gain = toWorld * inverse;
    const Matrix5d covariance = hitSigma * hitSigma * gain * scatter * gain.transpose() +
                                toWorld * unknown * toWorld.transpose();
    return 0.5 * (covariance + covariance.transpose());
}

}  // namespace vdamf
