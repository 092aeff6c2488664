// SPDX-License-Identifier: BSD-3-Clause
// Filters learned from simulated clusters.
#include "vdamf/learning/train_filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "vdamf/learning/clusters/simulated_clusters.h"
#include "vdamf/learning/filter_objective.h"

namespace vdamf
{
namespace
{
std::vector<LabelledClusters> conditions(const std::vector<std::string>& names, int clusters)
{
    std::vector<LabelledClusters> all;
    for (const SimulatedKind& kind : simulatedKinds())
        if (std::find(names.begin(), names.end(), kind.name) != names.end())
            all.push_back(simulatedCondition(kind, clusters, 3));
    return all;
}

FilterTrainingOptions fewEvaluations()
{
    FilterTrainingOptions options;
    options.globalEvaluations = 20;
    options.localEvaluations = 40;
    options.folds = 0;
    return options;
}

// Whoever is told how far it is may stop it, in the middle of a search as well.
TEST(TrainFilter, WhatStopsItIsWhatItThrows)
{
    for (const int last : {1, 5, 25})
    {
        int told = 0;
        const auto stop = [&](const std::string&, double)
        {
            if (++told == last) throw std::runtime_error("interrupted");
        };
        try
        {
            trainFilter(conditions({"car"}, 5), MeasureOptions(), fewEvaluations(), stop);
            ADD_FAILURE() << "it went on past the " << last << "th time";
        }
        catch (const std::runtime_error& error)
        {
            EXPECT_STREQ(error.what(), "interrupted");
        }
    }
}

TEST(TrainFilter, RepairsAFilterThatIsSetBadly)
{
    MeasureOptions bad;
    bad.filter = FilterKind::PaperInset;
    bad.parameters.insets.side *= 2.0;
    bad.parameters.insets.end *= 0.5;
    const FilterTraining training = trainFilter(conditions({"car"}, 20), bad, fewEvaluations(), {});
    EXPECT_LT(training.after, 0.8 * training.before);
    const InsetParameters& insets = training.bank.filters.front().parameters.insets;
    EXPECT_LT(insets.side, 0.4);
    // What this kind of filter does not use stays as it was.
    EXPECT_EQ(training.bank.filters.front().parameters.hull.farEnd, HullParameters().farEnd);
}

TEST(TrainFilter, IsDeterministicAndNeverWorseOnWhatItLearnedFrom)
{
    const auto clusters = conditions({"car"}, 10);
    const FilterTraining one = trainFilter(clusters, {}, fewEvaluations(), {});
    const FilterTraining same = trainFilter(clusters, {}, fewEvaluations(), {});
    EXPECT_LE(one.after, one.before);
    EXPECT_EQ(one.after, same.after);
    EXPECT_EQ(one.bank.filters.front().parameters.shape.endStrip,
              same.bank.filters.front().parameters.shape.endStrip);
}

TEST(TrainFilter, ComparesOnVehiclesThatItDidNotSee)
{
    FilterTrainingOptions options = fewEvaluations();
    options.globalEvaluations = 2;
    options.localEvaluations = 3;
    options.folds = 2;
    options.bank = true;
    options.leastOfType = 5;
    double last = 0.0;
    const FilterTraining training = trainFilter(conditions({"car", "truck"}, 10), {}, options,
                                                [&](const std::string&, double share)
                                                {
                                                    EXPECT_GE(share, last);
                                                    last = share;
                                                });
    EXPECT_GT(last, 0.5);
    ASSERT_EQ(training.heldOut.size(), 2U);
    for (const HeldOutCondition& condition : training.heldOut)
    {
        ASSERT_EQ(condition.methods.size(), 3U);
        for (const CaseSummary& summary : condition.methods) EXPECT_EQ(summary.cases, 10U);
    }
    ASSERT_EQ(training.bank.filters.size(), 3U);
    const TypeSizes& car = training.bank.filters[1].sizes;
    const TypeSizes& truck = training.bank.filters[2].sizes;
    EXPECT_NEAR(car.length, 4.4, 0.4);
    EXPECT_GT(truck.length, 7.0);
    EXPECT_GT(truck.height, 3.0);
    EXPECT_EQ(car.share, 0.5);
}

TEST(TrainFilter, CountsTheTypesThatABankLeavesOut)
{
    const auto clusters = conditions({"car", "truck"}, 10);
    ASSERT_EQ(rareTypes(clusters, 10).size(), 2U);
    const std::vector<TypeCount> rare = rareTypes(clusters, 11);
    ASSERT_EQ(rare.size(), 4U);
    EXPECT_EQ(rare[0].type, VehicleType::Car);
    EXPECT_EQ(rare[0].clusters, 10U);
    EXPECT_EQ(rare[1].type, VehicleType::Van);
    EXPECT_EQ(rare[1].clusters, 0U);
}

TEST(TrainFilter, NeedsClustersAndVehiclesForItsFolds)
{
    EXPECT_THROW(trainFilter({}, {}, fewEvaluations(), {}), std::runtime_error);
    FilterTrainingOptions folds = fewEvaluations();
    folds.folds = 5;
    EXPECT_THROW(trainFilter(conditions({"car"}, 3), {}, folds, {}), std::runtime_error);
}

TEST(TrainFilter, EndsWhereItsProgressThrows)
{
    const auto stop = [](const std::string&, double) { throw std::runtime_error("interrupted"); };
    EXPECT_THROW(trainFilter(conditions({"car"}, 5), {}, fewEvaluations(), stop),
                 std::runtime_error);
}

TEST(FilterObjective, RisesWithErrorsAndWithACovarianceThatIsTooLarge)
{
    const FilterObjective objective(conditions({"car", "van"}, 20), {});
    EXPECT_EQ(objective.clusters(), 40U);
    const double before = objective({});
    FilterParameters inward;
    inward.hull.side = 6.0;
    EXPECT_GT(objective(inward), before);
    FilterParameters unsure;
    unsure.errors.least = 0.2;
    unsure.errors.bodyTurn = 0.1;
    EXPECT_GT(objective(unsure), before);
}

}  // namespace
}  // namespace vdamf
