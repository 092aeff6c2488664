// SPDX-License-Identifier: BSD-3-Clause
#include "measurement/methods.h"

#include <algorithm>

#include "measurement/baselines.h"
#include "vdamf/tracking/matched_filter/type_choice.h"

namespace vdamf
{
namespace
{
enum class From
{
    Nothing,
    Start,
    StartAndSizes
};

double heightOf(const Cluster& cluster)
{
    return *std::max_element(cluster.height.begin(), cluster.height.end());
}

Method fitOf(const std::string& name, const MeasureOptions& options, From from)
{
    const auto estimate = [options, from](const LabelledCluster& sample)
    {
        const Hits hits = projectHits(sample.cluster, options.mergeCell);
        const OrientedBox start =
            from == From::Nothing
                ? startBox(hits, sample.sensor, widestEnd(heightOf(sample.cluster)), options.fit)
                : sample.start;
        std::optional<Eigen::Vector2d> known;
        if (from == From::StartAndSizes) known.emplace(start.length, start.width);
        const MeasureOptions own = toldOptions(options, sample);
        const Measurement m = own.bank ? measureWithBank(hits, heightOf(sample.cluster),
                                                         sample.sensor, start, own, known)
                                             .measurement
                                       : measureTarget(hits, sample.sensor, start, own, known);
        return Estimate{m.box, m};
    };
    return {name, false, estimate};
}

template <class Baseline>
Method baselineOf(const std::string& name, Baseline&& baseline)
{
    const auto estimate = [baseline](const LabelledCluster& sample)
    {
        const auto n = static_cast<Eigen::Index>(sample.cluster.size());
        PlanePoints points(2, n);
        points.row(0) =
            Eigen::Map<const Eigen::RowVectorXf>(sample.cluster.x.data(), n).cast<double>();
        points.row(1) =
            Eigen::Map<const Eigen::RowVectorXf>(sample.cluster.y.data(), n).cast<double>();
        return Estimate{baseline(points), std::nullopt};
    };
    return {name, true, estimate};
}
}  // namespace

std::vector<Method> allMethods(const MeasureOptions& options,
                               const std::shared_ptr<const FilterBank>& bank)
{
    std::vector<Method> methods;
    const auto add = [&methods](std::string name, const MeasureOptions& own, From from)
    {
        if (from == From::Start) name += "+start";
        if (from == From::StartAndSizes) name += "+sizes";
        methods.push_back(fitOf(name, own, from));
    };
    for (const From from : {From::Start, From::StartAndSizes, From::Nothing})
    {
        for (const auto& [filter, name] : EnumNames<FilterKind>::names())
        {
            MeasureOptions own = options;
            own.filter = filter;
            add(name, own, from);
        }
        if (bank)
        {
            MeasureOptions learned = withFilter(options, commonFilter(*bank).parameters);
            add("learned", learned, from);
            learned.bank = bank;
            if (bank->filters.size() > 1) add("bank", learned, from);
        }
        if (from == From::StartAndSizes) continue;
        MeasureOptions untold = options;
        untold.rangeNoise = 0.0;
        add("noise_untold", untold, from);
        for (const auto& [optimizer, name] : EnumNames<Optimizer>::names())
        {
            if (optimizer == options.fit.optimizer) continue;
            MeasureOptions own = options;
            own.filter = FilterKind::Paper;
            own.fit.optimizer = optimizer;
            add(name, own, from);
        }
    }
    methods.push_back(baselineOf("closeness", lShapeByCloseness));
    methods.push_back(baselineOf("variance", lShapeByVariance));
    methods.push_back(baselineOf("minimum_area", minimumAreaBox));
    methods.push_back(baselineOf("pca", principalAxisBox));
    return methods;
}

}  // namespace vdamf
