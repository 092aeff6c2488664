// SPDX-License-Identifier: BSD-3-Clause
// Where an axis of a chart begins and ends, where its marks stand, and where values fall on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vdamf/report/plots.h"

namespace vdamf
{
struct AxisMark
{
    double place = 0.0;  ///< 0..1 along the axis
    std::string text;
};

/// An axis that knows its ends.
class ScaledAxis
{
public:
    /// `values` that the axis is to show where its ends are left open.
    ScaledAxis(const Axis& axis, const std::vector<double>& values);

    /// 0 at the axis' begin, 1 at its end; nothing for what the scale cannot show.
    std::optional<double> place(double value) const;
    const std::vector<AxisMark>& marks() const { return marks_; }

private:
    void chooseLinearEnds();
    void chooseLogEnds();
    void addMark(double value, const std::string& text);

    AxisScale scale_;
    double min_;  ///< on the scale: of the logarithm, or the normal deviate
    double max_;
    std::vector<AxisMark> marks_;
};

}  // namespace vdamf
