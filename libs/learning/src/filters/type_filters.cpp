// SPDX-License-Identifier: BSD-3-Clause
#include "filters/type_filters.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vdamf
{
namespace
{
struct Moments
{
    double sum = 0.0, squares = 0.0, count = 0.0;

    void add(double value)
    {
        sum += value;
        squares += value * value;
        count += 1.0;
    }
    double mean() const { return sum / count; }
    double sigma() const
    {
        constexpr double kLeast = 0.05;  // m
        return std::max(kLeast, std::sqrt(std::max(0.0, squares / count - mean() * mean())));
    }
};
}  // namespace

std::string nameOf(VehicleType type)
{
    for (const auto& [value, name] : EnumNames<VehicleType>::names())
        if (value == type) return name;
    return {};
}

std::vector<LabelledClusters> ofType(const std::vector<LabelledClusters>& conditions,
                                     VehicleType type)
{
    std::vector<LabelledClusters> some;
    for (const LabelledClusters& condition : conditions)
    {
        LabelledClusters part{condition.name, condition.description, {}};
        for (const LabelledCluster& cluster : condition.samples)
            if (cluster.type == type) part.samples.push_back(cluster);
        if (!part.samples.empty()) some.push_back(std::move(part));
    }
    return some;
}

std::size_t clustersIn(const std::vector<LabelledClusters>& conditions)
{
    std::size_t count = 0;
    for (const LabelledClusters& condition : conditions) count += condition.samples.size();
    return count;
}

TypeSizes sizesOf(const std::vector<LabelledClusters>& conditions)
{
    std::map<std::string, const LabelledCluster*> vehicles;
    for (const LabelledClusters& condition : conditions)
        for (const LabelledCluster& cluster : condition.samples) vehicles[cluster.group] = &cluster;
    Moments length;
    Moments width;
    Moments height;
    for (const auto& [group, cluster] : vehicles)
    {
        length.add(cluster->truth.length);
        width.add(cluster->truth.width);
        if (cluster->height > 0.0) height.add(cluster->height);
    }
    TypeSizes sizes;
    if (length.count > 0.0)
    {
        sizes.length = length.mean();
        sizes.lengthSigma = length.sigma();
        sizes.width = width.mean();
        sizes.widthSigma = width.sigma();
    }
    if (height.count > 0.0)
    {
        sizes.height = height.mean();
        sizes.heightSigma = height.sigma();
    }
    return sizes;
}

std::vector<TypedFilter> typedFilters(const std::vector<LabelledClusters>& conditions, int least)
{
    std::vector<TypedFilter> filters;
    double all = 0.0;
    for (const auto& [type, name] : EnumNames<VehicleType>::names())
    {
        if (type == VehicleType::Any) continue;
        const std::vector<LabelledClusters> mine = ofType(conditions, type);
        const std::size_t count = clustersIn(mine);
        if (count < static_cast<std::size_t>(least)) continue;
        TypedFilter filter;
        filter.type = type;
        filter.sizes = sizesOf(mine);
        filter.sizes.share = static_cast<double>(count);
        all += filter.sizes.share;
        filters.push_back(filter);
    }
    for (TypedFilter& filter : filters) filter.sizes.share /= all;
    return filters;
}

}  // namespace vdamf
