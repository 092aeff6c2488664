// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/train_filter.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "filters/compare_filters.h"
#include "filters/optimise_group.h"
#include "filters/type_filters.h"
#include "vdamf/learning/filter_objective.h"

namespace vdamf
{
namespace
{
/// Counts what was done of all evaluations, and tells it.
class Steps
{
public:
    Steps(double all, const FilterProgress& progress) : all_(all), progress_(progress) {}

    void enter(const std::string& step, double ends)
    {
        step_ = step;
        done_ = begins_;
        begins_ += ends;
    }
    void count()
    {
        done_ += 1.0;
        if (progress_) progress_(step_, std::min(1.0, done_ / all_));
    }

private:
    double all_;
    const FilterProgress& progress_;
    std::string step_;
    double done_ = 0.0;
    double begins_ = 0.0;  // of the next step
};

class Trainer
{
public:
    Trainer(const MeasureOptions& handSet, const FilterTrainingOptions& options,
            const FilterProgress& progress)
        : handSet_(handSet),
          options_(options),
          groups_(parameterGroups(handSet.filter)),
          steps_(evaluationsOfAll(), progress)
    {
    }

    FilterBank bankOf(const std::vector<LabelledClusters>& conditions, const std::string& name)
    {
        FilterBank bank;
        TypedFilter common;
        common.sizes = sizesOf(conditions);
        common.parameters = learned(conditions, handSet_.parameters, name, true);
        bank.filters.push_back(common);
        if (!options_.bank) return bank;
        for (TypedFilter& typed : typedFilters(conditions, options_.leastOfType))
        {
            typed.parameters = learned(ofType(conditions, typed.type), common.parameters,
                                       name + ", type " + nameOf(typed.type), false);
            bank.filters.push_back(typed);
        }
        return bank;
    }

private:
    static constexpr double kTypes = 4.0;

    double evaluationsOfOne(bool common) const
    {
        double all = 0.0;
        for (const ParameterGroup& group : groups_)
        {
            if (!common && group.global) continue;
            if (group.global) all += options_.globalEvaluations;
            all += options_.localEvaluations;
        }
        return all;
    }

    double evaluationsOfAll() const
    {
        const double bank = options_.bank ? kTypes * evaluationsOfOne(false) : 0.0;
        return (evaluationsOfOne(true) + bank) * (1.0 + options_.folds);
    }

    // Groups that a type has in common with all vehicles stay as they are.
    FilterParameters learned(const std::vector<LabelledClusters>& conditions,
                             const FilterParameters& start, const std::string& name, bool common)
    {
        const FilterObjective objective(conditions, handSet_);
        const auto cost = [&](const FilterParameters& parameters)
        {
            steps_.count();
            return objective(parameters);
        };
        FilterParameters best = start;
        for (const ParameterGroup& group : groups_)
        {
            if (!common && group.global) continue;
            const std::string step = name + ", " + group.name;
            if (group.global)
            {
                steps_.enter(step + " (global)", options_.globalEvaluations);
                best = optimiseGroup(best, group, {true, options_.globalEvaluations}, cost);
            }
            steps_.enter(step, options_.localEvaluations);
            best = optimiseGroup(best, group, {false, options_.localEvaluations}, cost);
        }
        return best;
    }

    MeasureOptions handSet_;
    FilterTrainingOptions options_;
    std::vector<ParameterGroup> groups_;
    Steps steps_;
};

/// The fold of each group of clusters.
std::map<std::string, int> foldsOf(const std::vector<LabelledClusters>& conditions,
                                   const FilterTrainingOptions& options)
{
    std::set<std::string> names;
    for (const LabelledClusters& condition : conditions)
        for (const LabelledCluster& cluster : condition.samples) names.insert(cluster.group);
    if (names.size() < static_cast<std::size_t>(options.folds))
        throw std::runtime_error("too few vehicles for " + std::to_string(options.folds) +
                                 " folds: there are " + std::to_string(names.size()));
    std::vector<std::string> order(names.begin(), names.end());
    std::mt19937_64 random(options.seed);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    std::map<std::string, int> folds;
    for (std::size_t i = 0; i < order.size(); ++i)
        folds[order[i]] = static_cast<int>(i % static_cast<std::size_t>(options.folds));
    return folds;
}

std::vector<LabelledClusters> partOf(const std::vector<LabelledClusters>& conditions,
                                     const std::map<std::string, int>& folds, int fold,
                                     bool isHeldOut)
{
    std::vector<LabelledClusters> part;
    for (const LabelledClusters& condition : conditions)
    {
        LabelledClusters some{condition.name, condition.description, {}};
        for (const LabelledCluster& cluster : condition.samples)
            if ((folds.at(cluster.group) == fold) == isHeldOut) some.samples.push_back(cluster);
        part.push_back(std::move(some));
    }
    return part;
}
}  // namespace

FilterTraining trainFilter(const std::vector<LabelledClusters>& conditions,
                           const MeasureOptions& handSet, const FilterTrainingOptions& options,
                           const FilterProgress& progress)
{
    const FilterObjective objective(conditions, handSet);
    Trainer trainer(handSet, options, progress);
    FilterTraining training;
    if (options.folds > 1)
    {
        const auto folds = foldsOf(conditions, options);
        FilterComparison comparison;
        for (int fold = 0; fold < options.folds; ++fold)
        {
            const FilterBank bank = trainer.bankOf(
                partOf(conditions, folds, fold, false),
                "fold " + std::to_string(fold + 1) + " of " + std::to_string(options.folds));
            comparison.add(partOf(conditions, folds, fold, true), handSet, bank);
        }
        training.heldOut = comparison.summaries();
    }
    training.bank = trainer.bankOf(conditions, "all");
    training.before = objective(handSet.parameters);
    training.after = objective(training.bank.filters.front().parameters);
    return training;
}

std::vector<TypeCount> rareTypes(const std::vector<LabelledClusters>& conditions, int least)
{
    std::vector<TypeCount> rare;
    for (const auto& [type, name] : EnumNames<VehicleType>::names())
    {
        if (type == VehicleType::Any) continue;
        const std::size_t count = clustersIn(ofType(conditions, type));
        if (count < static_cast<std::size_t>(least)) rare.push_back({type, count});
    }
    return rare;
}

}  // namespace vdamf
