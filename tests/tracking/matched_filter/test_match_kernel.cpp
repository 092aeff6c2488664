// SPDX-License-Identifier: BSD-3-Clause
// Every path of the single-precision kernel against the reference in double precision.
#include "matched_filter/match_kernel.h"

#include <gtest/gtest.h>

#include "matched_filter/gaussian_lanes.h"
#include "tracking/matched_filter/example_hits.h"
#include "vdamf/tracking/matched_filter/fit.h"

namespace vdamf
{
namespace
{
std::string nameOf(KernelPath path)
{
    switch (path)
    {
        case KernelPath::Avx2:
            return "AVX2";
        case KernelPath::Avx512:
            return "AVX-512";
        default:
            return "baseline";
    }
}

// What an error is measured against: the hits' contributions without their signs.
struct Scale
{
    double value = 0.0, gradient = 0.0, hessian = 0.0;
};

Scale scaleOf(const Hits& hits, const FilterShape& shape, const OrientedBox& box, double phi)
{
    Scale scale;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const Hits one{{hits.x[i]}, {hits.y[i]}, {hits.weight[i]}, hits.weight[i], {}, {}, {}, {}};
        const MatchResponse m = matchResponse(one, shape, box, phi);
        scale.value += std::abs(m.value);
        scale.gradient += m.gradient.norm();
        scale.hessian += m.hessian.norm();
    }
    return scale;
}

// All paths within `tolerance` of the scale; the origin of the floats is `offset` from the box.
void expectAgreement(const Hits& hits, const FilterShape& shape, const OrientedBox& box, double phi,
                     double tolerance, const Eigen::Vector2d& offset = {0.4, -0.3})
{
    const MatchResponse exact = matchResponse(hits, shape, box, phi);
    const Scale scale = scaleOf(hits, shape, box, phi);
    const KernelHits kernel = kernelHits(hits, box.centre() + offset);
    for (const KernelPath path : kernelPaths())
    {
        SCOPED_TRACE(nameOf(path));
        const MatchResponse m = kernelResponse(kernel, shape, box, phi, path);
        EXPECT_NEAR(m.value, exact.value, tolerance * scale.value + 1e-15);
        EXPECT_LE((m.gradient - exact.gradient).norm(), tolerance * scale.gradient + 1e-15);
        EXPECT_LE((m.hessian - exact.hessian).norm(), tolerance * scale.hessian + 1e-15);
        EXPECT_LE((m.hessian - m.hessian.transpose()).norm(), 1e-12 * scale.hessian);
    }
}

Hits uniformHits(const OrientedBox& box, double reach, int count, unsigned seed)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-reach, reach);
    Hits hits;
    for (int k = 0; k < count; ++k)
    {
        hits.x.push_back(box.x + uniform(generator));
        hits.y.push_back(box.y + uniform(generator));
        hits.weight.push_back(1.0 + k % 4);
        hits.totalWeight += hits.weight.back();
    }
    return hits;
}

TEST(MatchKernel, EqualsTheReferenceFromAllViews)
{
    // Every order of edges, with the end heavier and the side heavier, near the kink between.
    for (int k = 0; k < 72; ++k)
    {
        const double heading = (k + 0.3) * kPi / 36.0;
        SCOPED_TRACE(heading);
        const OrientedBox car{14.0, 4.0, heading, 4.5, 1.8};
        const Hits hits = exampleHits(car, 150, 0.05, 0.1, static_cast<unsigned>(k));
        const OrientedBox box{14.1, 3.9, heading + 0.05, 4.3, 1.9};
        expectAgreement(hits, FilterShape::paper(), box,
                        bearingToSensor(box, Eigen::Vector2d::Zero()), 1e-5);
    }
}

TEST(MatchKernel, EqualsTheReferenceOnRandomHits)
{
    for (unsigned seed = 1; seed <= 40; ++seed)
    {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        std::uniform_real_distribution<double> uniform;
        const OrientedBox box{-60.0 + 120.0 * uniform(generator), 90.0 * uniform(generator),
                              7.0 * uniform(generator), 1.0 + 6.0 * uniform(generator),
                              0.7 + 2.5 * uniform(generator)};
        FilterShape shape = FilterShape::paper();
        shape.sigma = 0.05 + 0.3 * uniform(generator);
        shape.endStrip = shape.sideStrip = 0.15 + 0.4 * uniform(generator);
        // Counts around whole blocks and whole runs of blocks.
        const int count = 1 + static_cast<int>(seed * 13 % 70) + (seed % 5 == 0 ? 500 : 0);
        const Hits hits = uniformHits(box, 0.6 * box.length, count, seed);
        expectAgreement(hits, shape, box, 7.0 * uniform(generator), 1e-5);
    }
}

// Where a coordinate is many sigma long, single precision has fewer digits of its edge.
TEST(MatchKernel, LongBoxesUnderANarrowFilter)
{
    FilterShape shape = FilterShape::paper();
    shape.sigma = 0.05;
    const OrientedBox truck{14.0, 4.0, 0.6, 18.0, 2.5};
    expectAgreement(exampleHits(truck, 200, 0.02, 0.1, 5), shape, truck, 2.0, 5e-5);
}

TEST(MatchKernel, ManyHitsKeepTheirPrecision)
{
    const OrientedBox box{14.0, 4.0, 0.6, 4.5, 1.8};
    const Hits hits = exampleHits(box, 20000, 0.05, 0.1, 3);
    expectAgreement(hits, FilterShape::paper(), box, 2.0, 1e-5);
}

TEST(MatchKernel, HitsFarAwayAddNothing)
{
    const OrientedBox box{14.0, 4.0, 0.6, 4.5, 1.8};
    Hits hits = exampleHits(box, 50, 0.05, 0.1, 3);
    for (const double far : {8.0, 30.0, 100.0, 1e4, 1e7, -8.0, -100.0, -1e7})
    {
        for (const double along : {0.0, 1.0})
        {
            hits.x.push_back(box.x + along * far);
            hits.y.push_back(box.y + (1.0 - 0.5 * along) * far);
            hits.weight.push_back(1.0);
        }
    }
    expectAgreement(hits, FilterShape::paper(), box, 2.0, 1e-5);
    Hits all{{100.0, -100.0}, {0.0, 100.0}, {1.0, 5.0}, 6.0, {}, {}, {}, {}};
    const KernelHits kernel = kernelHits(all, box.centre());
    for (const KernelPath path : kernelPaths())
    {
        const MatchResponse m = kernelResponse(kernel, FilterShape::paper(), box, 2.0, path);
        EXPECT_EQ(m.value, 0.0) << nameOf(path);
        EXPECT_EQ(m.hessian.norm(), 0.0) << nameOf(path);
    }
}

TEST(MatchKernel, AwkwardBoxes)
{
    const OrientedBox car{14.0, 4.0, 0.6, 4.5, 1.8};
    const Hits hits = exampleHits(car, 80, 0.05, 0.1, 3);
    for (const auto& [length, width] :
         {std::pair{60.0, 20.0}, {0.9, 0.7}, {25.0, 0.7}, {0.9, 20.0}, {200.0, 200.0}})
    {
        SCOPED_TRACE(length);
        expectAgreement(hits, FilterShape::paper(), {14.0, 4.0, 0.6, length, width}, 2.0, 1e-5);
    }
    // The sensor straight ahead, straight at a side, and at the kink.
    for (const double phi : {0.6, 0.6 + 0.25 * kPi, 0.6 + 0.5 * kPi, 0.6 + kPi, 0.6 - 0.5 * kPi})
        expectAgreement(hits, FilterShape::paper(), car, phi, 1e-5);
}

TEST(MatchKernel, TheOriginMayLieAtADistance)
{
    const OrientedBox car{14.0, 4.0, 0.6, 4.5, 1.8};
    const Hits hits = exampleHits(car, 80, 0.05, 0.1, 3);
    expectAgreement(hits, FilterShape::paper(), car, 2.0, 1e-5, {20.0, -10.0});
}

TEST(MatchKernel, NoHitsNoResponse)
{
    const OrientedBox car{14.0, 4.0, 0.6, 4.5, 1.8};
    const MatchResponse m =
        kernelResponse(kernelHits(Hits{}, car.centre()), FilterShape::paper(), car, 2.0);
    EXPECT_EQ(m.value, 0.0);
    EXPECT_EQ(m.gradient.norm(), 0.0);
}

TEST(EdgeLanes, EqualTheErrorFunction)
{
    for (int k = -12000; k <= 12000; ++k)
    {
        const float x = 1e-3F * static_cast<float>(k);
        const auto edge = edgeLanes<4>(Lanes<4>::Real{x, -x, 0.0F, 1e9F});
        const double u = x * kHalvingLength;
        const double density = kHalvingLength * std::exp(-0.5 * u * u) / std::sqrt(2.0 * kPi);
        ASSERT_NEAR(edge.step[0], 0.5 * std::erf(u / std::sqrt(2.0)), 2e-7) << x;
        ASSERT_NEAR(edge.density[0], density, 2e-7) << x;
        ASSERT_NEAR(edge.curve[0], -u * kHalvingLength * density, 3e-7) << x;
        ASSERT_EQ(edge.step[1], -edge.step[0]);
        ASSERT_EQ(edge.density[1], edge.density[0]);
        ASSERT_EQ(edge.curve[1], -edge.curve[0]);
        ASSERT_NEAR(edge.step[2], 0.0F, 1e-7);
        ASSERT_EQ(edge.step[3], 0.5F);
    }
}

// The default tolerance uses the kernel, one below 1e-4 the reference.
TEST(FitMatchedFilter, KernelAndReferenceFindTheSameBox)
{
    int kernelIterations = 0;
    int exactIterations = 0;
    for (unsigned seed = 1; seed <= 30; ++seed)
    {
        SCOPED_TRACE(seed);
        const OrientedBox car{14.0, 4.0, 0.2 * seed, 4.5, 1.8};
        const Hits hits = exampleHits(car, 20 + 10 * static_cast<int>(seed), 0.02, 0.1, seed);
        OrientedBox start = car;
        start.x += 0.2;
        start.y -= 0.2;
        start.heading += 8.0 * kPi / 180.0;
        FitOptions options;
        options.tolerance = 1e-4;
        const Fit kernel = fitMatchedFilter(hits, FilterShape::paper(), {0.0, 0.0}, start, options);
        options.tolerance = 0.999e-4;
        const Fit exact = fitMatchedFilter(hits, FilterShape::paper(), {0.0, 0.0}, start, options);
        EXPECT_EQ(kernel.converged, exact.converged);
        EXPECT_NEAR(kernel.match, exact.match, 1e-5);
        EXPECT_LT((kernel.box.centre() - exact.box.centre()).norm(), 1e-3);
        EXPECT_NEAR(wrapAngle(kernel.box.heading - exact.box.heading), 0.0, 5e-4);
        EXPECT_NEAR(kernel.box.length, exact.box.length, 2e-3);
        EXPECT_NEAR(kernel.box.width, exact.box.width, 2e-3);
        kernelIterations += kernel.iterations;
        exactIterations += exact.iterations;
    }
    EXPECT_LE(kernelIterations, exactIterations * 1.05);
}

}  // namespace
}  // namespace vdamf
