// SPDX-License-Identifier: BSD-3-Clause
#include "measurement/case_table.h"

#include <cmath>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
std::string cellOf(const std::optional<double>& value)
{
    return "," + (value && std::isfinite(*value) ? toFixedText(*value, 4) : std::string());
}
}  // namespace

std::string casesHeader()
{
    return "condition,method,case,hits,range_m,aspect_deg,in_view,heading90_deg,heading180_deg,"
           "corner_m,end_m,side_m,length_m,width_m,iou,nees,nees_dimension,iterations,failed\n";
}

std::string caseLine(const std::string& condition, const std::string& method, std::size_t index,
                     const LabelledCluster& sample, const CaseErrors& errors)
{
    const Eigen::Vector2d view = toBoxFrame(sample.truth, sample.sensor);
    std::string line = condition + "," + method + "," + std::to_string(index) + "," +
                       std::to_string(sample.cluster.size());
    line += cellOf(view.norm()) + cellOf(std::atan2(view.y(), view.x()) * 180.0 / kPi);
    line += "," + toString(sample.inView);
    for (const std::optional<double>& value :
         {std::optional<double>(errors.heading90), std::optional<double>(errors.heading180),
          std::optional<double>(errors.corner), errors.end, errors.side, errors.length,
          errors.width, std::optional<double>(errors.iou), errors.nees})
        line += cellOf(value);
    return line + "," + std::to_string(errors.neesDimension) + "," +
           std::to_string(errors.iterations) + "," + (errors.failed ? "1" : "0") + "\n";
}

}  // namespace vdamf
