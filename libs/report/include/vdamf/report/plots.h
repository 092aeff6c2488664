// SPDX-License-Identifier: BSD-3-Clause
// Small charts as SVG: curves and points over two axes, with a legend.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vdamf
{
enum class AxisScale
{
    Linear,
    Log10,         ///< values above 0
    NormalDeviate  ///< Phi^-1 of values in (0, 1), marked in percent: the axes of DET curves
};

struct Axis
{
    std::string label;
    AxisScale scale = AxisScale::Linear;
    /// Ends of the axis. Where they are equal: from the curves, rounded to marks.
    double min = 0.0;
    double max = 0.0;
};

enum class CurveStyle
{
    Line,
    Dashed,  ///< what is expected, or a reference
    Points
};

struct Curve
{
    std::string name;  ///< in the legend; empty: not in it
    CurveStyle style = CurveStyle::Line;
    /// In the units of the axes. What an axis cannot show (not finite, zero on a logarithmic one)
    /// interrupts the line; what is outside of its ends is cut off.
    std::vector<Eigen::Vector2d> points;
    /// Number in the palette: curves of one number belong together. Nothing: the curve's own number
    /// in the chart.
    std::optional<std::size_t> colour = std::nullopt;
};

struct Chart
{
    std::string title;
    Axis x;
    Axis y;
    std::vector<Curve> curves;
    bool legendAtBottom = false;  ///< of the right side, where curves are high
};

/// Charts side by side, `columns` in a row, as one picture on white. A chart without anything to
/// show says so. Same input, same bytes.
std::string chartsSvg(const std::vector<Chart>& charts, std::size_t columns = 2);

/// The share of the values' sizes up to each size: a curve from (0, 0) to (max, 1).
Curve cumulativeCurve(const std::string& name, std::vector<double> values);

}  // namespace vdamf
