// SPDX-License-Identifier: BSD-3-Clause
// Section 4.3: Newton steps with the exact Hessian, shifted until it is definite.
#include <Eigen/Cholesky>
#include <cmath>

#include "matched_filter/fit_objective.h"
#include "types/cholesky.h"

namespace vdamf
{
namespace
{
// Parameters are brought to like curvature: a quarter of a radian moves a vehicle's corner about
// as far as a metre moves its centre.
const Vector5d kStepScale = (Vector5d() << 1.0, 1.0, 0.25, 1.0, 1.0).finished();
// The response changes its shape over half a strip: longer steps than that are mostly lost.
constexpr double kMaxMove = 0.3;          // m, of the centre
constexpr double kMaxTurn = 0.15;         // rad
constexpr double kMaxGrowth = 0.5;        // m
constexpr double kLeastCurvature = 1e-3;  // of the largest one: the floor of all

// A size at a bound whose step would leave it takes no part in the step.
bool heldAtBound(int parameter, const OrientedBox& box, double gradient, const FitOptions& o)
{
    if (parameter < 3) return false;
    const double size = parameter == 3 ? box.length : box.width;
    const double min = parameter == 3 ? o.minLength : o.minWidth;
    const double max = parameter == 3 ? o.maxLength : o.maxWidth;
    return (size <= min && gradient > 0.0) || (size >= max && gradient < 0.0);
}

// The step to the bottom of gradient and Hessian, all curvatures made positive.
Vector5d newtonStep(const Vector5d& g, const Matrix5d& h, double damping)
{
    const double largest = h.norm();  // the largest curvature or up to sqrt(5) times that
    const double least = kLeastCurvature * largest;
    const Matrix5d one = Matrix5d::Identity();
    // Near the optimum nothing is to be made positive. Cholesky's decomposition tells that and
    // steps in a fraction of the time that eigenvalues take: a fifth off a whole fit.
    if (Cholesky<5>(h - least * one).isPositive())
        return -Cholesky<5>(h + damping * largest * one).solve(g);
    // Away from it the Hessian is indefinite. Turning negative pivots positive keeps the step
    // downhill, and at full length along the well-shaped axes.
    const Eigen::LDLT<Matrix5d> factors(h);
    const Vector5d pivots =
        (factors.vectorD().cwiseAbs().array().max(least) + damping * largest).matrix();
    Vector5d step = factors.transpositionsP() * g;
    factors.matrixL().solveInPlace(step);
    step = step.cwiseQuotient(pivots).eval();
    factors.matrixU().solveInPlace(step);
    return -(factors.transpositionsP().transpose() * step);
}

struct Step
{
    Vector5d move;      // in the parameters' own units
    double gain = 0.0;  // predicted decrease of the cost
};

Step dampedStep(const FitCost& cost, const OrientedBox& box, double damping, const FitOptions& o)
{
    Vector5d g = kStepScale.cwiseProduct(cost.gradient);
    Matrix5d h = kStepScale.asDiagonal() * cost.hessian * kStepScale.asDiagonal();
    for (int k = 3; k < 5; ++k)
    {
        if (!heldAtBound(k, box, cost.gradient(k), o)) continue;
        g(k) = 0.0;
        h.row(k).setZero();
        h.col(k).setZero();
        h(k, k) = 1.0;
    }
    Vector5d step = newtonStep(g, h, damping);
    const Vector5d move = kStepScale.cwiseProduct(step);
    const double excess = std::max({move.head<2>().norm() / kMaxMove, std::abs(move(2)) / kMaxTurn,
                                    move.tail<2>().cwiseAbs().maxCoeff() / kMaxGrowth, 1.0});
    step /= excess;
    return {move / excess, -(g.dot(step) + 0.5 * step.dot(h * step))};
}

// After a step that was taken: by how much of the predicted gain was had.
double nextDamping(double damping, double gainRatio)
{
    if (gainRatio > 0.75) return std::max(damping * 0.1, 1e-7);
    return gainRatio < 0.25 ? damping * 2.0 : damping;
}
}  // namespace

Optimum levenbergMarquardt(const FitObjective& objective, const OrientedBox& start,
                           const FitOptions& options)
{
    FitCost cost = objective.derivatives(start);
    Optimum best{start, cost.value, 1, false};
    double damping = 1e-2;
    bool isForetold = true;  // what the last step did
    while (best.iterations < options.maxIterations)
    {
        const Step step = dampedStep(cost, best.box, damping, options);
        if (!step.move.allFinite()) break;
        const OrientedBox trial = movedWithinBounds(best.box, step.move, options);
        if (step.move.cwiseAbs().maxCoeff() < options.tolerance)
        {
            // Within the tolerance a step does what it foretells, unless the last one did not:
            // another look at the hits would cost as much as the first one.
            if (isForetold)
            {
                best.box = trial;
                best.value -= step.gain;
            }
            best.converged = true;
            break;
        }
        const FitCost trialCost = objective.derivatives(trial);
        ++best.iterations;
        const double gain = cost.value - trialCost.value;
        // Gains below the resolution say nothing of the step: it is taken, the damping stays.
        const double resolution = objective.resolution(cost.value);
        isForetold = gain >= -resolution;
        if (isForetold)
        {
            best.box = trial;
            best.value = trialCost.value;
            cost = trialCost;
            if (step.gain > resolution) damping = nextDamping(damping, gain / step.gain);
        }
        else
        {
            damping = std::max(damping * 6.0, 1e-3);
        }
    }
    return best;
}

}  // namespace vdamf
