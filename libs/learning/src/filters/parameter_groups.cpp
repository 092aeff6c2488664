// SPDX-License-Identifier: BSD-3-Clause
#include "filters/parameter_groups.h"

namespace vdamf
{
namespace
{
struct Collect
{
    std::vector<ParameterBound>& all;

    void operator()(double& value, const char*, double min, double max, const char*) const
    {
        all.push_back({&value, min, max});
    }
};

std::vector<ParameterBound> shapeOf(FilterParameters& p)
{
    std::vector<ParameterBound> all;
    FilterShape::visit(p.shape, Collect{all});
    return all;
}

std::vector<ParameterBound> shapeAndReachOf(FilterParameters& p)
{
    std::vector<ParameterBound> all = shapeOf(p);
    LineParameters::visit(p.lines, Collect{all});
    return all;
}

std::vector<ParameterBound> insetsOf(FilterParameters& p)
{
    std::vector<ParameterBound> all;
    InsetParameters::visit(p.insets, Collect{all});
    return all;
}

std::vector<ParameterBound> hullOf(FilterParameters& p)
{
    std::vector<ParameterBound> all;
    HullParameters::visit(p.hull, Collect{all});
    return all;
}

std::vector<ParameterBound> errorsOf(FilterParameters& p)
{
    std::vector<ParameterBound> all;
    ErrorParameters::visit(p.errors, Collect{all});
    return all;
}
}  // namespace

std::vector<ParameterGroup> parameterGroups(FilterKind kind)
{
    if (kind == FilterKind::FaceLines)
        return {{"filter and reach", true, shapeAndReachOf},
                {"hull", false, hullOf},
                {"errors", false, errorsOf}};
    std::vector<ParameterGroup> groups = {{"filter", true, shapeOf}};
    if (kind == FilterKind::PaperInset) groups.push_back({"insets", false, insetsOf});
    groups.push_back({"errors", false, errorsOf});
    return groups;
}

}  // namespace vdamf
