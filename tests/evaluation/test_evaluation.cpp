// SPDX-License-Identifier: BSD-3-Clause
// The whole evaluation, and its JSON.
#include "vdamf/evaluation/evaluation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "example_pairs.h"
#include "vdamf/evaluation/evaluation_json.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;
using ::testing::Not;

struct Tables
{
    std::vector<TruthRow> truth;
    std::vector<TrackRow> tracks;
};

/// A track whose errors are `ratio` times as large as its covariance says.
Tables noisyTables(double ratio, int frames)
{
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal(0.0, ratio);
    Tables tables;
    for (int k = 0; k < frames; ++k)
    {
        tables.truth.push_back(exampleCar(100.0 + 0.1 * k));
        TrackRow row = trackOn(tables.truth.back());
        OrientedBox& box = row.report.box;
        // x and y together, so that the covariance between them matters.
        const double common = normal(random);
        box.x += 0.1 * common;
        box.y += 0.08 * common + 0.06 * normal(random);
        box.heading += 0.05 * normal(random);
        row.report.covariance(0, 1) = row.report.covariance(1, 0) = 0.008;
        row.report.speed += 0.5 * normal(random);
        box.length += 0.2 * normal(random);
        box.width += 0.2 * normal(random);
        row.report.nis =
            std::pow(normal(random), 2) + std::pow(normal(random), 2) + std::pow(normal(random), 2);
        tables.tracks.push_back(row);
    }
    return tables;
}

TEST(Evaluation, ErrorsDrawnFromTheCovarianceAreConsistent)
{
    const Tables tables = noisyTables(1.0, 4000);
    const ConsistencyReport c = evaluate(tables.truth, tables.tracks).consistency;
    for (const Consistency& of : {c.neesPose, c.neesSpeed, c.neesSize, c.nisMatched, c.nisAll})
    {
        EXPECT_EQ(of.count, 4000U);
        EXPECT_NEAR(of.mean, 1.0, 0.06);
        EXPECT_NEAR(of.within95, 0.95, 0.012);
        EXPECT_EQ(verdictOf(of), Verdict::Consistent) << inWords(of);
    }
}

TEST(Evaluation, ErrorsTwiceAsLargeAreNot)
{
    const Tables tables = noisyTables(2.0, 4000);
    const ConsistencyReport c = evaluate(tables.truth, tables.tracks).consistency;
    for (const Consistency& of : {c.neesPose, c.neesSpeed, c.neesSize, c.nisAll})
    {
        EXPECT_NEAR(of.covarianceScale, 4.0, 0.3);
        EXPECT_EQ(verdictOf(of), Verdict::Overconfident) << inWords(of);
    }
}

TEST(Evaluation, CoastingTracksAreNotAskedForConsistency)
{
    Tables tables = noisyTables(1.0, 100);
    for (std::size_t k = 0; k < 40; ++k)
    {
        tables.tracks[k].report.status = TrackStatus::Coasting;
        tables.tracks[k].report.nis.reset();
    }
    const Evaluation e = evaluate(tables.truth, tables.tracks);
    EXPECT_EQ(e.errors.pairs, 100U);
    EXPECT_EQ(e.consistency.neesPose.count, 60U);
    EXPECT_EQ(e.consistency.nisMatched.count, 60U);
}

TEST(Evaluation, BadPosesAreStillPairs)
{
    // An overlap of 0.4: not found, but its error is told.
    Tables tables = noisyTables(0.0, 10);
    for (TrackRow& row : tables.tracks) row = moved(row, 1.7, 0.0);
    const Evaluation e = evaluate(tables.truth, tables.tracks);
    EXPECT_EQ(e.clearMot.truePositives, 0U);
    EXPECT_EQ(e.errors.pairs, 10U);
    EXPECT_NEAR(e.errors.longitudinal.bias, 1.7, 1e-9);
    EXPECT_EQ(e.coverage.everTracked, 0.0);
    EvaluationOptions strict;
    strict.pairOverlap = 0.5;
    EXPECT_EQ(evaluate(tables.truth, tables.tracks, strict).errors.pairs, 0U);
}

TEST(EvaluationJson, HasNoWordThatIsNotJson)
{
    Tables tables = noisyTables(1.0, 3);
    for (TruthRow& row : tables.truth) row.objectId = "a \"\xff\" id";
    for (TrackRow& row : tables.tracks) row.report.covariance.setZero();
    const std::string json = toJson(evaluate(tables.truth, tables.tracks));
    EXPECT_THAT(json, HasSubstr("\"a \\\"\xEF\xBF\xBD\\\" id\""));
    EXPECT_THAT(json, HasSubstr("\"discriminator\": null"));
    EXPECT_THAT(json, Not(HasSubstr("nan")));
    EXPECT_THAT(json, Not(HasSubstr("inf")));
    EXPECT_THAT(toJson(evaluate(tables.truth, {})), HasSubstr("\"precision\": null"));
}

}  // namespace
}  // namespace vdamf
