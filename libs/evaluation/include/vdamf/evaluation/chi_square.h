// SPDX-License-Identifier: BSD-3-Clause
// The chi-square and the normal distribution, for bands of consistency.
#pragma once

namespace vdamf
{
/// P(X <= x) for chi-square with `freedom` > 0 degrees of freedom.
double chiSquareProbability(double x, double freedom);

/// Its inverse; `probability` in (0, 1). Relative error below 1e-9.
double chiSquareQuantile(double probability, double freedom);

/// Phi^-1; `probability` in (0, 1).
double normalQuantile(double probability);

}  // namespace vdamf
