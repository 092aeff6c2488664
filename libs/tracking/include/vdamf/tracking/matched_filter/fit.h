// SPDX-License-Identifier: BSD-3-Clause
// Section 4.3: pose and size of a target by maximising the matched filter's response.
#pragma once

#include <optional>

#include "vdamf/tracking/matched_filter/filter_shape.h"
#include "vdamf/tracking/matched_filter/hits.h"
#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
enum class Optimizer
{
    LevenbergMarquardt,  ///< exact Hessian made definite (4.3)
    NloptSlsqp,
    NloptLbfgs,
    NloptBobyqa  ///< without derivatives
};

template <>
struct EnumNames<Optimizer>
{
    static std::vector<std::pair<Optimizer, const char*>> names()
    {
        return {{Optimizer::LevenbergMarquardt, "levenberg_marquardt"},
                {Optimizer::NloptSlsqp, "nlopt_slsqp"},
                {Optimizer::NloptLbfgs, "nlopt_lbfgs"},
                {Optimizer::NloptBobyqa, "nlopt_bobyqa"}};
    }
};

struct FitOptions
{
    Optimizer optimizer = Optimizer::LevenbergMarquardt;
    int maxIterations = 40;
    double tolerance = 1e-3;  ///< on the step, m and rad
    double minLength = 0.9;   ///< m; below the strips' 0.8 m the regions would overlap
    double maxLength = 30.0;  ///< m
    double minWidth = 0.7;    ///< m
    double maxWidth = 3.5;    ///< m

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.optimizer, "optimizer", "what maximises the response (paper, 4.3)");
        field(self.maxIterations, "max_iterations", 1, 1000,
              "most evaluations of the response in one optimisation");
        field(self.tolerance, "tolerance", 1e-9, 0.1, "step that ends an optimisation, m and rad");
        field(self.minLength, "min_length_m", 0.85, 5.0, "smallest length of a fitted box");
        field(self.maxLength, "max_length_m", 5.0, 60.0, "largest length of a fitted box");
        field(self.minWidth, "min_width_m", 0.65, 2.0, "smallest width of a fitted box");
        field(self.maxWidth, "max_width_m", 2.0, 20.0, "largest width of a fitted box");
    }
};

/// A pull towards a known size: adds -1/2 (lengthWeight (l - length)^2 + widthWeight (...)^2) to
/// the response per hit. Not in the paper.
struct SizePrior
{
    double length = 0.0;        ///< m
    double width = 0.0;         ///< m
    double lengthWeight = 0.0;  ///< response per hit / m^2: 1/m^3
    double widthWeight = 0.0;
};

/// Result of one optimisation.
struct Fit
{
    OrientedBox box;     ///< in the frame of the hits; heading within (-pi, pi]
    double match = 0.0;  ///< response M per hit, 1/m, without the prior
    double phi = 0.0;    ///< bearing to the sensor that the optimisation used, rad
    int iterations = 0;  ///< evaluations of the response
    bool converged = false;
};

/// Maximises the response from a start. phi is frozen at the start's centre. `sensor` is in the
/// frame of the hits. No hits: not converged, the box is the start.
Fit fitMatchedFilter(const Hits& hits, const FilterShape& shape, const Eigen::Vector2d& sensor,
                     const OrientedBox& start, const FitOptions& options,
                     const std::optional<SizePrior>& prior = std::nullopt);

}  // namespace vdamf
