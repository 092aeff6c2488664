// SPDX-License-Identifier: BSD-3-Clause
#include "axis_marks.h"

#include <algorithm>
#include <cmath>

#include "vdamf/evaluation/chi_square.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
// Percent; the customary range of DET curves.
constexpr double kDeviateMarks[] = {0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 40.0, 60.0, 80.0};

std::optional<double> onScale(AxisScale scale, double value)
{
    if (!std::isfinite(value)) return std::nullopt;
    switch (scale)
    {
        case AxisScale::Linear:
            return value;
        case AxisScale::Log10:
            return value > 0.0 ? std::optional(std::log10(value)) : std::nullopt;
        case AxisScale::NormalDeviate:
            return value > 0.0 && value < 1.0 ? std::optional(normalQuantile(value)) : std::nullopt;
    }
    return std::nullopt;
}

/// 1, 2 or 5 times a power of ten: the least step that makes at most six intervals of the span.
double stepOf(double span)
{
    const double least = span / 6.0;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
    {
        if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
    }
    return 10.0 * power;
}

int decimalsOf(double step)
{
    return std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
}
}  // namespace

ScaledAxis::ScaledAxis(const Axis& axis, const std::vector<double>& values)
    : scale_(axis.scale),
      min_(onScale(axis.scale, axis.min).value_or(0.0)),
      max_(onScale(axis.scale, axis.max).value_or(0.0))
{
    const bool open = !(axis.min < axis.max);
    std::vector<double> shown;
    for (const double value : values)
    {
        if (const auto v = onScale(scale_, value)) shown.push_back(*v);
    }
    if (open && !shown.empty())
    {
        min_ = *std::min_element(shown.begin(), shown.end());
        max_ = *std::max_element(shown.begin(), shown.end());
    }
    if (scale_ == AxisScale::NormalDeviate && (open || !(min_ < max_)))
    {
        min_ = normalQuantile(1e-3);
        max_ = normalQuantile(0.6);
    }
    if (scale_ == AxisScale::Linear && open) chooseLinearEnds();
    if (scale_ == AxisScale::Log10 && open) chooseLogEnds();
    if (scale_ == AxisScale::Linear)
    {
        const double step = stepOf(max_ - min_);
        for (double k = std::ceil(min_ / step - 1e-6); k * step <= max_ + 1e-6 * step; ++k)
            addMark(k * step, toFixedText(k * step, decimalsOf(step)));
    }
    else if (scale_ == AxisScale::Log10)
    {
        for (double k = std::ceil(min_ - 1e-6); k <= max_ + 1e-6; ++k)
            addMark(std::pow(10.0, k), toText(std::pow(10.0, k)));
    }
    else
    {
        for (const double percent : kDeviateMarks) addMark(0.01 * percent, toText(percent));
    }
}

void ScaledAxis::chooseLinearEnds()
{
    if (!(max_ > min_))  // a single value lies in the middle
    {
        const double half = min_ != 0.0 ? 0.5 * std::abs(min_) : 0.5;
        max_ = min_ + half;
        min_ -= half;
    }
    const double step = stepOf(max_ - min_);
    min_ = step * std::floor(min_ / step + 1e-9);
    max_ = step * std::ceil(max_ / step - 1e-9);
}

void ScaledAxis::chooseLogEnds()
{
    min_ = std::floor(min_ + 1e-9);
    max_ = std::max(min_ + 1.0, std::ceil(max_ - 1e-9));
}

std::optional<double> ScaledAxis::place(double value) const
{
    const std::optional<double> v = onScale(scale_, value);
    if (!v) return std::nullopt;
    return (*v - min_) / (max_ - min_);
}

void ScaledAxis::addMark(double value, const std::string& text)
{
    const std::optional<double> at = place(value);
    if (at && *at >= -1e-6 && *at <= 1.0 + 1e-6) marks_.push_back({*at, text});
}

}  // namespace vdamf
