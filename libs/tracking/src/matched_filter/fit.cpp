// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/fit.h"

#include "matched_filter/fit_objective.h"

namespace vdamf
{
Fit fitMatchedFilter(const Hits& hits, const FilterShape& shape, const Eigen::Vector2d& sensor,
                     const OrientedBox& start, const FitOptions& options,
                     const std::optional<SizePrior>& prior)
{
    Fit fit;
    fit.phi = bearingToSensor(start, sensor);
    fit.box = movedWithinBounds(start, Vector5d::Zero(), options);
    if (hits.totalWeight <= 0.0) return fit;
    // Below this tolerance the rounding of single precision would show. The optimizers of nlopt are
    // the reference for ours and get the reference's sums.
    constexpr double kFinestSingle = 1e-4;
    const bool single =
        options.optimizer == Optimizer::LevenbergMarquardt && options.tolerance >= kFinestSingle;
    const FitObjective objective(hits, shape, fit.box, fit.phi, prior,
                                 single ? Precision::Single : Precision::Double);
    const Optimum optimum = options.optimizer == Optimizer::LevenbergMarquardt
                                ? levenbergMarquardt(objective, fit.box, options)
                                : nloptOptimize(objective, fit.box, options);
    fit.box = optimum.box;
    fit.box.heading = wrapAngle(fit.box.heading);
    fit.match = objective.matchPerHit(optimum.box, optimum.value);
    fit.iterations = optimum.iterations;
    fit.converged = optimum.converged;
    return fit;
}

}  // namespace vdamf
