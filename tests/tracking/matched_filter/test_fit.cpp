// SPDX-License-Identifier: BSD-3-Clause
// The optimisation of section 4.3, its covariance (4.4), starts and faces.
#include "vdamf/tracking/matched_filter/fit.h"

#include <gtest/gtest.h>

#include "tracking/decompositions.h"
#include "tracking/matched_filter/example_hits.h"
#include "vdamf/tracking/matched_filter/covariance.h"
#include "vdamf/tracking/matched_filter/match_response.h"
#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
namespace
{
OrientedBox carAt(double heading)
{
    return {14.0, 4.0, heading, 4.5, 1.8};
}

double headingError(const OrientedBox& a, const OrientedBox& b)
{
    return std::abs(wrapAngle(2.0 * (a.heading - b.heading))) / 2.0;
}

Eigen::Vector2d nearestCorner(const OrientedBox& box)
{
    const auto all = corners(box);
    return *std::min_element(all.begin(), all.end(),
                             [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
                             { return a.norm() < b.norm(); });
}

TEST(FitMatchedFilter, FindsAMaximumFromDisturbedStarts)
{
    FitOptions options;
    options.tolerance = 1e-6;
    options.maxIterations = 100;
    int iterations = 0;
    int fits = 0;
    for (const double heading : {0.5, 0.9, 1.3, 2.0, -0.6, -2.4})
    {
        const OrientedBox car = carAt(heading);
        for (unsigned seed = 1; seed <= 10; ++seed)
        {
            const Hits hits = exampleHits(car, 150, 0.02, 0.1, seed);
            const OrientedBox start = disturbed(car, seed + 100);
            const Fit fit = fitMatchedFilter(hits, FilterShape::paper(), kSensor, start, options);
            ASSERT_TRUE(fit.converged) << "heading " << heading << ", seed " << seed;
            iterations += fit.iterations;
            ++fits;
            const MatchResponse m = matchResponse(hits, FilterShape::paper(), fit.box, fit.phi);
            EXPECT_NEAR(fit.match, m.value / hits.totalWeight, 1e-12);
            EXPECT_LT(m.gradient.norm(), 1e-4 * hits.totalWeight);
            EXPECT_GT(smallestEigenvalue(-m.hessian), 0.0) << "not a maximum";
            EXPECT_LT(headingError(fit.box, car), 3.0 * kPi / 180.0);
        }
    }
    EXPECT_LT(iterations, 20 * fits);
}

TEST(FitMatchedFilter, AgreesWithNlopt)
{
    const OrientedBox car = carAt(0.8);
    const Hits hits = exampleHits(car, 200, 0.03, 0.1, 3);
    const OrientedBox start = disturbed(car, 5);
    FitOptions options;
    options.tolerance = 1e-6;
    options.maxIterations = 200;
    const Fit reference = fitMatchedFilter(hits, FilterShape::paper(), kSensor, start, options);
    for (const Optimizer optimizer :
         {Optimizer::NloptSlsqp, Optimizer::NloptLbfgs, Optimizer::NloptBobyqa})
    {
        options.optimizer = optimizer;
        const Fit fit = fitMatchedFilter(hits, FilterShape::paper(), kSensor, start, options);
        EXPECT_TRUE(fit.converged) << static_cast<int>(optimizer);
        EXPECT_NEAR(fit.match, reference.match, 1e-6) << static_cast<int>(optimizer);
        EXPECT_NEAR(fit.box.x, reference.box.x, 5e-3);
        EXPECT_NEAR(fit.box.y, reference.box.y, 5e-3);
        EXPECT_NEAR(fit.box.heading, reference.box.heading, 2e-3);
        EXPECT_NEAR(fit.box.length, reference.box.length, 1e-2);
        EXPECT_NEAR(fit.box.width, reference.box.width, 1e-2);
    }
}

TEST(FitMatchedFilter, NoDenseGridPointIsBetter)
{
    const OrientedBox car = carAt(0.7);
    const Hits hits = exampleHits(car, 120, 0.03, 0.1, 9);
    const Fit fit = fitMatchedFilter(hits, FilterShape::paper(), kSensor, car, FitOptions());
    for (double dx = -0.6; dx <= 0.61; dx += 0.3)
        for (double dy = -0.6; dy <= 0.61; dy += 0.3)
            for (double turn = -0.2; turn <= 0.21; turn += 0.1)
                for (double dl = -0.6; dl <= 0.61; dl += 0.3)
                    for (double dw = -0.6; dw <= 0.61; dw += 0.3)
                    {
                        OrientedBox b = fit.box;
                        b.x += dx;
                        b.y += dy;
                        b.heading += turn;
                        b.length += dl;
                        b.width += dw;
                        EXPECT_LE(matchValue(hits, FilterShape::paper(), b, fit.phi),
                                  fit.match * hits.totalWeight + 1e-3);
                    }
}

TEST(FitMatchedFilter, SizePriorHoldsAHiddenLength)
{
    const OrientedBox behind{15.0, 0.0, 0.0, 4.5, 1.8};  // its rear alone is seen
    const Hits hits = exampleHits(behind, 100, 0.02, 0.0, 4);
    const Fit freeFit = fitMatchedFilter(hits, FilterShape::paper(), kSensor, behind, FitOptions());
    EXPECT_LT(freeFit.box.length, 3.0);
    const Fit held = fitMatchedFilter(hits, FilterShape::paper(), kSensor, behind, FitOptions(),
                                      SizePrior{4.5, 1.8, 0.1, 0.1});
    EXPECT_NEAR(held.box.length, 4.5, 0.3);
    const double rear = held.box.x - 0.5 * held.box.length;
    EXPECT_NEAR(rear, 15.0 - 2.25, 0.5);
}

TEST(FitMatchedFilter, WithoutHitsReturnsTheStart)
{
    const OrientedBox start = carAt(0.3);
    const Fit fit = fitMatchedFilter(Hits{}, FilterShape::paper(), kSensor, start, FitOptions());
    EXPECT_FALSE(fit.converged);
    EXPECT_EQ(fit.box.x, start.x);
    EXPECT_EQ(fit.box.length, start.length);
}

TEST(FitMatchedFilter, DegenerateHitsStayFinite)
{
    for (const int kind : {0, 1, 2, 3})
    {
        Hits hits;
        for (int k = 0; k < (kind == 0 ? 1 : 20); ++k)
        {
            hits.x.push_back(kind == 1 ? 10.0 : kind == 2 ? 10.0 + 0.2 * k : 1e6 + 0.1 * k);
            hits.y.push_back(kind == 3 ? 1e6 : 3.0);
            hits.weight.push_back(1.0);
            hits.totalWeight += 1.0;
        }
        const OrientedBox start = startBox(hits, kSensor, 2.2, FitOptions());
        const Measurement m = measureTarget(hits, kSensor, start, MeasureOptions());
        EXPECT_TRUE(std::isfinite(m.box.x) && std::isfinite(m.box.length)) << kind;
        EXPECT_TRUE(m.covariance.allFinite()) << kind;
        EXPECT_GE(m.box.length, FitOptions().minLength);
    }
}

// Eq. (14) against Monte Carlo of what it models: each hit of one scan moved by sigma_p.
TEST(FitCovariance, EqualsMonteCarloOfPerturbedHits)
{
    const OrientedBox car = carAt(0.9);
    const Hits hits = exampleHits(car, 150, 0.02, 0.1, 21);
    FitOptions options;
    options.tolerance = 1e-7;
    options.maxIterations = 100;
    const FilterShape shape = FilterShape::paper();
    const Fit fit = fitMatchedFilter(hits, shape, kSensor, car, options);
    const double sigma = 0.01;
    const Matrix5d covariance = fitCovariance(hits, shape, fit.box, fit.phi, sigma);
    std::mt19937 generator(1);
    std::normal_distribution<double> gauss;
    Matrix5d sum = Matrix5d::Zero();
    const int runs = 1500;
    for (int run = 0; run < runs; ++run)
    {
        Hits moved = hits;
        for (std::size_t i = 0; i < hits.size(); ++i)
        {
            moved.x[i] += sigma * gauss(generator);
            moved.y[i] += sigma * gauss(generator);
        }
        // The same frozen viewing angle: start where the first fit did.
        const Fit again = fitMatchedFilter(moved, shape, kSensor, car, options);
        Vector5d e;
        e << again.box.x - fit.box.x, again.box.y - fit.box.y,
            wrapAngle(again.box.heading - fit.box.heading), again.box.length - fit.box.length,
            again.box.width - fit.box.width;
        sum += e * e.transpose();
    }
    const Matrix5d sampled = sum / runs;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
            EXPECT_NEAR(sampled(i, j), covariance(i, j),
                        0.12 * std::sqrt(covariance(i, i) * covariance(j, j)))
                << i << ", " << j;
}

TEST(FacesSeen, NamesTheFacesTowardsTheSensor)
{
    const MeasureOptions options;
    const auto facesAt = [&](double heading)
    {
        const OrientedBox box{15.0, 0.0, heading, 4.5, 1.8};
        return toString(facesSeen(exampleHits(box, 200, 0.02, 0.0, 2), box, kSensor, options));
    };
    EXPECT_EQ(facesAt(0.0), "B");
    EXPECT_EQ(facesAt(kPi), "F");
    EXPECT_EQ(facesAt(0.5 * kPi), "L");
    EXPECT_EQ(facesAt(-0.5 * kPi), "R");
    EXPECT_EQ(facesAt(0.7), "BL");
    EXPECT_EQ(facesAt(-2.4), "FR");
    const OrientedBox box{15.0, 0.0, 0.7, 4.5, 1.8};
    EXPECT_EQ(toString(facesSeen(exampleHits(box, 4, 0.02, 0.0, 2), box, kSensor, options)), "");
}

TEST(StartBox, FollowsTheEdges)
{
    for (const double heading : {0.2, 0.7, 1.1, -0.5, -1.3})
    {
        const OrientedBox car{14.0, 4.0, heading, 4.5, 1.8};
        const OrientedBox start =
            startBox(exampleHits(car, 200, 0.02, 0.0, 8), kSensor, 2.2, FitOptions());
        EXPECT_LT(headingError(start, car), 4.0 * kPi / 180.0) << heading;
        EXPECT_LT((nearestCorner(start) - nearestCorner(car)).norm(), 0.4) << heading;
    }
    // A rear alone: too narrow for a side, so the heading is along the line of sight.
    const OrientedBox rear{15.0, 0.0, 0.0, 4.5, 1.8};
    const OrientedBox start =
        startBox(exampleHits(rear, 100, 0.02, 0.0, 8), kSensor, 2.2, FitOptions());
    EXPECT_LT(std::abs(start.heading), 0.1);
    EXPECT_NEAR(start.width, 1.8, 0.15);
}

TEST(MeasureTarget, NarrowerStripsTightenTheBox)
{
    // Table 1 as printed sits outside the faces; narrower strips take the bias out.
    MeasureOptions paper;
    paper.filter = FilterKind::Paper;
    paper.reachOverHits = false;
    MeasureOptions fine = paper;
    fine.filter = FilterKind::CoarseToFine;
    double paperLength = 0.0;
    double fineLength = 0.0;
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        const OrientedBox car = carAt(0.9);
        const Hits hits = exampleHits(car, 200, 0.02, 0.05, seed);
        paperLength += measureTarget(hits, kSensor, disturbed(car, seed), paper).box.length - 4.5;
        fineLength += measureTarget(hits, kSensor, disturbed(car, seed), fine).box.length - 4.5;
    }
    EXPECT_GT(paperLength / 10, 0.25);
    EXPECT_LT(std::abs(fineLength / 10), 0.15);
}

}  // namespace
}  // namespace vdamf
