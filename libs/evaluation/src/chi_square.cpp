// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/chi_square.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

namespace vdamf
{
namespace
{
// From here on the series of the incomplete gamma function gets long, and the expansion for many
// degrees of freedom is exact to rounding.
constexpr double kManyFreedoms = 1e4;

double upperTail(double x, double freedom)
{
    return Eigen::numext::igammac(0.5 * freedom, 0.5 * x);
}

double density(double x, double freedom)
{
    const double a = 0.5 * freedom;
    return 0.5 * std::exp((a - 1.0) * std::log(0.5 * x) - 0.5 * x - std::lgamma(a));
}

/// Cornish and Fisher's expansion (Abramowitz and Stegun 26.4.15 ff. with more terms).
double quantileOfManyFreedoms(double probability, double k)
{
    const double z = normalQuantile(probability);
    const double z2 = z * z;
    const double root = std::sqrt(2.0 * k);
    return k + root * z + 2.0 / 3.0 * (z2 - 1.0) + z * (z2 - 7.0) / (9.0 * root) -
           (6.0 * z2 * z2 + 14.0 * z2 - 32.0) / (405.0 * k) +
           z * (9.0 * z2 * z2 + 256.0 * z2 - 433.0) / (4860.0 * root * k);
}

/// Wilson and Hilferty's cube; near zero the first term of the series.
double quantileNear(double probability, double k)
{
    const double c = 2.0 / (9.0 * k);
    const double root = 1.0 - c + normalQuantile(probability) * std::sqrt(c);
    if (root > 0.3) return k * root * root * root;
    const double a = 0.5 * k;
    return 2.0 * std::exp((std::log(probability) + std::lgamma(a + 1.0)) / a);
}
}  // namespace

double chiSquareProbability(double x, double freedom)
{
    assert(freedom > 0.0);
    if (!(x > 0.0)) return 0.0;
    if (std::isinf(x)) return 1.0;
    if (freedom <= kManyFreedoms) return Eigen::numext::igamma(0.5 * freedom, 0.5 * x);
    const double c = 2.0 / (9.0 * freedom);
    const double z = (std::cbrt(x / freedom) - 1.0 + c) / std::sqrt(c);
    return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

double chiSquareQuantile(double probability, double freedom)
{
    assert(probability > 0.0 && probability < 1.0 && freedom > 0.0);
    if (freedom > kManyFreedoms) return quantileOfManyFreedoms(probability, freedom);
    // Newton's steps in log x, on the tail that is the smaller one, so that no digits cancel.
    const bool upper = probability > 0.5;
    double x = quantileNear(probability, freedom);
    for (int i = 0; i < 50; ++i)
    {
        const double excess = upper ? (1.0 - probability) - upperTail(x, freedom)
                                    : chiSquareProbability(x, freedom) - probability;
        const double step = std::clamp(excess / (x * density(x, freedom)), -1.0, 1.0);
        x *= std::exp(-step);
        if (std::abs(step) < 1e-12) break;
    }
    return x;
}

double normalQuantile(double probability)
{
    assert(probability > 0.0 && probability < 1.0);
    return Eigen::numext::ndtri(probability);
}

}  // namespace vdamf
