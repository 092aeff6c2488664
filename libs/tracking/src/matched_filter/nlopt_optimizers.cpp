// SPDX-License-Identifier: BSD-3-Clause
// The same objective for nlopt's optimizers: the reference for our own, and an option.
#include <cmath>
#include <nlopt.hpp>

#include "matched_filter/fit_objective.h"

namespace vdamf
{
namespace
{
// Parameters for nlopt: centre relative to the start, heading, length, width.
struct Problem
{
    const FitObjective& objective;
    OrientedBox start;
    int evaluations = 0;

    OrientedBox box(const std::vector<double>& p) const
    {
        return {start.x + p[0], start.y + p[1], p[2], p[3], p[4]};
    }
};

double costOf(const std::vector<double>& p, std::vector<double>& gradient, void* data)
{
    auto& problem = *static_cast<Problem*>(data);
    ++problem.evaluations;
    const OrientedBox box = problem.box(p);
    if (gradient.empty()) return problem.objective.value(box);
    const FitCost cost = problem.objective.derivatives(box);
    const Eigen::Vector2d inPlane = rotation(box.heading) * cost.gradient.head<2>();
    gradient = {inPlane.x(), inPlane.y(), cost.gradient(2), cost.gradient(3), cost.gradient(4)};
    return cost.value;
}

nlopt::algorithm algorithmOf(Optimizer optimizer)
{
    switch (optimizer)
    {
        case Optimizer::NloptLbfgs:
            return nlopt::LD_LBFGS;
        case Optimizer::NloptBobyqa:
            return nlopt::LN_BOBYQA;
        default:
            return nlopt::LD_SLSQP;
    }
}
}  // namespace

Optimum nloptOptimize(const FitObjective& objective, const OrientedBox& start,
                      const FitOptions& options)
{
    Problem problem{objective, start};
    nlopt::opt optimizer(algorithmOf(options.optimizer), 5);
    optimizer.set_min_objective(costOf, &problem);
    optimizer.set_lower_bounds(
        {-5.0, -5.0, start.heading - 0.5 * kPi, options.minLength, options.minWidth});
    optimizer.set_upper_bounds(
        {5.0, 5.0, start.heading + 0.5 * kPi, options.maxLength, options.maxWidth});
    optimizer.set_xtol_abs(0.1 * options.tolerance);
    optimizer.set_maxeval(25 * options.maxIterations);
    optimizer.set_initial_step({0.2, 0.2, 0.1, 0.2, 0.2});
    std::vector<double> p{0.0, 0.0, start.heading, start.length, start.width};
    double cost = 0.0;
    bool converged = false;
    try
    {
        const nlopt::result result = optimizer.optimize(p, cost);
        converged = result > 0 && result != nlopt::MAXEVAL_REACHED;
    }
    catch (const nlopt::roundoff_limited&)
    {
        converged = true;  // as far as rounding allows; p holds the best point
    }
    catch (const std::runtime_error&)
    {
        converged = false;  // nlopt gave up; p holds the best point
    }
    const OrientedBox box = problem.box(p);
    return {box, objective.value(box), problem.evaluations, converged};
}

}  // namespace vdamf
