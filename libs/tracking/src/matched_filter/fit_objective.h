// SPDX-License-Identifier: BSD-3-Clause
// What the optimizers minimise: minus the response per hit, plus the pull of a size prior.
#pragma once

#include <algorithm>
#include <cmath>

#include "matched_filter/match_kernel.h"
#include "vdamf/tracking/matched_filter/fit.h"
#include "vdamf/tracking/matched_filter/match_response.h"

namespace vdamf
{
/// Cost with derivatives in (t_x, t_y, theta, l, w) as in MatchResponse.
struct FitCost
{
    double value = 0.0;
    Vector5d gradient;
    Matrix5d hessian;
};

/// How the hits are summed: by the kernel, or by matchResponse() to the last digit at some twenty
/// times the cost.
enum class Precision
{
    Single,
    Double
};

class FitObjective
{
public:
    /// The boxes to evaluate lie within some metres of `start`.
    FitObjective(const Hits& hits, const FilterShape& shape, const OrientedBox& start, double phi,
                 const std::optional<SizePrior>& prior, Precision precision)
        : hits_(hits), shape_(shape), phi_(phi), prior_(prior.value_or(SizePrior{}))
    {
        if (precision == Precision::Single) kernel_ = kernelHits(hits, start.centre());
    }

    FitCost derivatives(const OrientedBox& box) const
    {
        const double scale = -1.0 / hits_.totalWeight;
        const MatchResponse m = response(box);
        FitCost cost{scale * m.value + priorCost(box), scale * m.gradient, scale * m.hessian};
        cost.gradient(3) += prior_.lengthWeight * (box.length - prior_.length);
        cost.gradient(4) += prior_.widthWeight * (box.width - prior_.width);
        cost.hessian(3, 3) += prior_.lengthWeight;
        cost.hessian(4, 4) += prior_.widthWeight;
        return cost;
    }

    double value(const OrientedBox& box) const
    {
        const double match = kernel_ ? response(box).value : matchValue(hits_, shape_, box, phi_);
        return priorCost(box) - match / hits_.totalWeight;
    }

    /// The response per hit of a box whose cost is known.
    double matchPerHit(const OrientedBox& box, double cost) const { return priorCost(box) - cost; }

    /// Differences of values smaller than this are rounding, for values about `value`. Single
    /// precision places an edge to 1e-7 m, where the response per hit changes by up to 3 / m^2.
    double resolution(double value) const { return kernel_ ? 3e-7 : 1e-12 * std::abs(value); }

private:
    MatchResponse response(const OrientedBox& box) const
    {
        return kernel_ ? kernelResponse(*kernel_, shape_, box, phi_)
                       : matchResponse(hits_, shape_, box, phi_);
    }

    double priorCost(const OrientedBox& box) const
    {
        const double l = box.length - prior_.length;
        const double w = box.width - prior_.width;
        return 0.5 * (prior_.lengthWeight * l * l + prior_.widthWeight * w * w);
    }

    const Hits& hits_;
    const FilterShape& shape_;
    double phi_;
    SizePrior prior_;
    std::optional<KernelHits> kernel_;  // for single precision
};

/// The box moved by a step in (t_x, t_y, theta, l, w), with its size kept within bounds.
inline OrientedBox movedWithinBounds(const OrientedBox& box, const Vector5d& step,
                                     const FitOptions& options)
{
    OrientedBox b = box;
    b.heading += step(2);
    const Eigen::Vector2d centre = box.centre() + rotation(b.heading) * step.head<2>();
    b.x = centre.x();
    b.y = centre.y();
    b.length = std::clamp(box.length + step(3), options.minLength, options.maxLength);
    b.width = std::clamp(box.width + step(4), options.minWidth, options.maxWidth);
    return b;
}

/// The optimizers: from `start` (within bounds) to a box, its cost, the evaluations used, and
/// whether the tolerance was met.
struct Optimum
{
    OrientedBox box;
    double value = 0.0;
    int iterations = 0;
    bool converged = false;
};
Optimum levenbergMarquardt(const FitObjective& objective, const OrientedBox& start,
                           const FitOptions& options);
Optimum nloptOptimize(const FitObjective& objective, const OrientedBox& start,
                      const FitOptions& options);

}  // namespace vdamf
