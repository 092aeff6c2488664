// SPDX-License-Identifier: BSD-3-Clause
#include "filters/optimise_group.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlopt.hpp>

namespace vdamf
{
namespace
{
// Logarithm of the largest factor on a parameter.
const double kWidest = std::log(2.5);
// Cost of the square of a logarithm: a factor of 2.5 on one parameter has to gain a thousandth.
constexpr double kPull = 0.001;

struct GroupProblem
{
    const FilterParameters& start;
    const ParameterGroup& group;
    const std::function<double(const FilterParameters&)>& cost;
    double bestCost = std::numeric_limits<double>::infinity();
    FilterParameters best;
    std::exception_ptr failure = nullptr;  // of the cost

    FilterParameters at(const std::vector<double>& x) const
    {
        FilterParameters parameters = start;
        const std::vector<ParameterBound> members = group.of(parameters);
        for (std::size_t i = 0; i < members.size(); ++i)
            *members[i].value =
                std::clamp(*members[i].value * std::exp(x[i]), members[i].min, members[i].max);
        return parameters;
    }

    double evaluate(const std::vector<double>& x)
    {
        const FilterParameters parameters = at(x);
        double value = cost(parameters);
        for (const double one : x) value += kPull * one * one;
        if (value < bestCost)
        {
            bestCost = value;
            best = parameters;
        }
        return value;
    }
};

// nlopt's own functions would make "nlopt failure" of what the cost throws.
double costOf(const std::vector<double>& x, std::vector<double>&, void* data)
{
    GroupProblem& problem = *static_cast<GroupProblem*>(data);
    try
    {
        return problem.evaluate(x);
    }
    catch (...)
    {
        problem.failure = std::current_exception();
        throw nlopt::forced_stop();
    }
}
}  // namespace

FilterParameters optimiseGroup(const FilterParameters& start, const ParameterGroup& group,
                               const GroupSearch& search,
                               const std::function<double(const FilterParameters&)>& cost)
{
    if (search.evaluations <= 0) return start;
    GroupProblem problem{start, group, cost, std::numeric_limits<double>::infinity(), start};
    FilterParameters counted = start;
    const std::size_t size = group.of(counted).size();
    std::vector<double> x(size, 0.0);
    // The local search may begin where its start is best.
    problem.evaluate(x);
    nlopt::opt optimizer(search.global ? nlopt::GN_DIRECT_L : nlopt::LN_SBPLX,
                         static_cast<unsigned>(size));
    optimizer.set_min_objective(costOf, &problem);
    optimizer.set_lower_bounds(std::vector<double>(size, -kWidest));
    optimizer.set_upper_bounds(std::vector<double>(size, kWidest));
    optimizer.set_maxeval(std::max(1, search.evaluations - 1));
    optimizer.set_initial_step(0.2);
    optimizer.set_ftol_abs(1e-5);
    double value = 0.0;
    try
    {
        optimizer.optimize(x, value);
    }
    catch (const nlopt::forced_stop&)
    {
        std::rethrow_exception(problem.failure);
    }
    return problem.best;
}

}  // namespace vdamf
