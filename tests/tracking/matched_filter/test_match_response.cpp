// SPDX-License-Identifier: BSD-3-Clause
// The analytic response against quadrature of Eq. (4), its derivatives against differences.
#include "vdamf/tracking/matched_filter/match_response.h"

#include <gtest/gtest.h>

#include "tracking/matched_filter/example_hits.h"

namespace vdamf
{
namespace
{
// Views from all sides, with the end heavier and the side heavier.
const double kHeadings[] = {0.1, 0.6, 0.9, 1.5, 2.2, 3.0, -0.4, -1.0, -1.7, -2.6};

Hits awkwardHits()
{
    Hits hits = exampleHits({12.0, 3.0, 0.6, 4.4, 1.8}, 25, 0.05, 0.2, 7);
    for (std::size_t i = 0; i < hits.size(); ++i)
        hits.weight[i] = 1.0 + 0.5 * static_cast<double>(i % 3);
    return hits;
}

// Box moved by parameters (t_x, t_y, theta, l, w) in the paper's coordinates, Eq. (9): the offset
// is along the axes of the turned box.
OrientedBox moved(const OrientedBox& box, const Vector5d& t)
{
    OrientedBox b = box;
    b.heading += t(2);
    const Eigen::Vector2d centre = box.centre() + rotation(b.heading) * t.head<2>();
    b.x = centre.x();
    b.y = centre.y();
    b.length += t(3);
    b.width += t(4);
    return b;
}

TEST(FilterShape, PaperIsTable1)
{
    const FilterShape shape = FilterShape::paper();
    const OrientedBox box{0.0, 0.0, 0.0, 4.5, 1.8};
    // Sensor ahead and to the left: phi = 0.4, beta = -0.4. The end is the heavier edge.
    const double end = std::cos(0.4);
    const double side = std::sin(0.4);
    const auto height = [&](double x, double y)
    { return filterHeight(shape, box, 0.4, Eigen::Vector2d(x, y)); };
    EXPECT_DOUBLE_EQ(height(3.1, 0.0), 0.0);    // beyond (l + 1.5) / 2 = 3.0
    EXPECT_DOUBLE_EQ(height(2.9, 0.0), -0.25);  // surround
    EXPECT_DOUBLE_EQ(height(0.0, 1.3), -0.25);  // (w + 1) / 2 = 1.4
    EXPECT_DOUBLE_EQ(height(0.0, 1.5), 0.0);
    EXPECT_DOUBLE_EQ(height(0.0, 0.0), 0.1);         // interior
    EXPECT_DOUBLE_EQ(height(2.0, -0.8), 0.1 + end);  // end edge, whole width
    EXPECT_DOUBLE_EQ(height(2.0, 0.8), 0.1 + end);   // ... and the shared corner
    EXPECT_DOUBLE_EQ(height(1.4, 0.0), 0.1);         // 0.8 m deep
    EXPECT_DOUBLE_EQ(height(1.4, 0.8), 0.1 + side);  // side edge, (l - 0.8) long
    EXPECT_DOUBLE_EQ(height(0.0, 0.25), 0.1);        // 0.6 m deep
    EXPECT_DOUBLE_EQ(height(0.0, -0.8), 0.1);        // hidden side
    EXPECT_DOUBLE_EQ(height(-2.2, 0.0), 0.1);        // hidden end
}

TEST(MatchResponse, EqualsQuadratureOfEq4)
{
    const FilterShape shape = FilterShape::paper();
    const Hits hits = awkwardHits();
    for (const double heading : kHeadings)
    {
        const OrientedBox box{12.1, 2.9, heading, 4.2, 1.9};
        const double phi = bearingToSensor(box, Eigen::Vector2d::Zero());
        // Midpoint rule over the surround; cells of 5 mm end on the edges of all regions.
        const double step = 0.005;
        const double reachX = 0.5 * box.length + 0.75;
        const double reachY = 0.5 * box.width + 0.5;
        std::vector<Eigen::Vector2d> local;
        for (std::size_t i = 0; i < hits.size(); ++i)
            local.push_back(toBoxFrame(box, {hits.x[i], hits.y[i]}));
        const auto nx = static_cast<int>(std::lround(2.0 * reachX / step));
        const auto ny = static_cast<int>(std::lround(2.0 * reachY / step));
        // exp(-(dx^2 + dy^2) / 2 sigma^2) is a product: tabulate the factors.
        const auto table = [&](int n, double reach, int axis)
        {
            std::vector<double> g(static_cast<std::size_t>(n) * hits.size());
            for (int k = 0; k < n; ++k)
                for (std::size_t i = 0; i < hits.size(); ++i)
                {
                    const double u = (-reach + (k + 0.5) * step - local[i](axis)) / shape.sigma;
                    g[static_cast<std::size_t>(k) * hits.size() + i] =
                        std::exp(-0.5 * u * u) / (shape.sigma * std::sqrt(2.0 * kPi));
                }
            return g;
        };
        const std::vector<double> gx = table(nx, reachX, 0);
        const std::vector<double> gy = table(ny, reachY, 1);
        double integral = 0.0;
        double energy = 0.0;
        for (int a = 0; a < nx; ++a)
            for (int b = 0; b < ny; ++b)
            {
                const Eigen::Vector2d p(-reachX + (a + 0.5) * step, -reachY + (b + 0.5) * step);
                const double s = filterHeight(shape, box, phi, p);
                double density = 0.0;
                for (std::size_t i = 0; i < hits.size(); ++i)
                    density += hits.weight[i] * gx[static_cast<std::size_t>(a) * hits.size() + i] *
                               gy[static_cast<std::size_t>(b) * hits.size() + i];
                integral += s * density;
                energy += s * s;
            }
        const double quadrature = integral * step * step / std::sqrt(energy * step * step);
        const double analytic = matchValue(hits, shape, box, phi);
        EXPECT_NEAR(analytic, quadrature, 1e-4 * std::abs(quadrature)) << "heading " << heading;
        EXPECT_NEAR(filterEnergy(shape, box, phi), energy * step * step, 1e-6);
    }
}

TEST(MatchResponse, DerivativesEqualDifferences)
{
    const FilterShape shape = FilterShape::paper();
    const Hits hits = awkwardHits();
    for (const double heading : kHeadings)
    {
        const OrientedBox box{12.2, 2.8, heading, 4.0, 1.7};
        const double phi = bearingToSensor(box, Eigen::Vector2d::Zero());
        const MatchResponse m = matchResponse(hits, shape, box, phi);
        EXPECT_DOUBLE_EQ(m.value, matchValue(hits, shape, box, phi));
        const auto value = [&](const Vector5d& t)
        { return matchValue(hits, shape, moved(box, t), phi); };
        for (int j = 0; j < 5; ++j)
        {
            // Central differences of fourth order.
            const double h = 1e-3;
            const Vector5d e = Vector5d::Unit(j) * h;
            const double difference =
                (8.0 * (value(e) - value(-e)) - (value(2.0 * e) - value(-2.0 * e))) / (12.0 * h);
            EXPECT_NEAR(m.gradient(j), difference, 1e-7 * m.gradient.norm() + 1e-8)
                << "heading " << heading << ", parameter " << j;
            for (int i = 0; i < 5; ++i)
            {
                const Vector5d d = Vector5d::Unit(i) * h;
                const auto slope = [&](const Vector5d& t)
                {
                    return (8.0 * (value(t + e) - value(t - e)) -
                            (value(t + 2.0 * e) - value(t - 2.0 * e))) /
                           (12.0 * h);
                };
                const double curvature =
                    (8.0 * (slope(d) - slope(-d)) - (slope(2.0 * d) - slope(-2.0 * d))) /
                    (12.0 * h);
                EXPECT_NEAR(m.hessian(i, j), curvature, 1e-5 * m.hessian.norm())
                    << "heading " << heading << ", parameters " << i << ", " << j;
            }
        }
    }
}

TEST(MatchResponse, GradientByHitEqualsDifferences)
{
    const FilterShape shape = FilterShape::paper();
    const OrientedBox box{12.2, 2.8, 0.7, 4.0, 1.7};
    const double phi = bearingToSensor(box, Eigen::Vector2d::Zero());
    const Hits hits = awkwardHits();
    const auto analytic = responseByHit(hits, shape, box, phi).gradientByHit;
    ASSERT_EQ(analytic.size(), hits.size());
    for (std::size_t i = 0; i < hits.size(); i += 4)
    {
        for (int axis = 0; axis < 2; ++axis)
        {
            const double h = 1e-5;
            const Eigen::Vector2d step = rotation(box.heading) * Eigen::Vector2d::Unit(axis) * h;
            const auto gradient = [&](double sign)
            {
                Hits one;
                one.x = {hits.x[i] + sign * step.x()};
                one.y = {hits.y[i] + sign * step.y()};
                one.weight = {1.0};
                return matchResponse(one, shape, box, phi).gradient;
            };
            const Vector5d difference = (gradient(1.0) - gradient(-1.0)) / (2.0 * h);
            EXPECT_LT((analytic[i].col(axis) - difference).norm(),
                      1e-6 * (1.0 + difference.norm()));
        }
    }
}

TEST(MatchResponse, MovesWithTheScene)
{
    const FilterShape shape = FilterShape::paper();
    Hits hits = awkwardHits();
    const OrientedBox box{12.2, 2.8, 0.7, 4.0, 1.7};
    const double phi = bearingToSensor(box, Eigen::Vector2d::Zero());
    const double before = matchValue(hits, shape, box, phi);
    const double turn = 1.1;
    const Eigen::Vector2d shift(-5.0, 30.0);
    const auto map = [&](double x, double y) -> Eigen::Vector2d
    { return rotation(turn) * Eigen::Vector2d(x, y) + shift; };
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const Eigen::Vector2d p = map(hits.x[i], hits.y[i]);
        hits.x[i] = p.x();
        hits.y[i] = p.y();
    }
    const Eigen::Vector2d c = map(box.x, box.y);
    const OrientedBox turned{c.x(), c.y(), box.heading + turn, box.length, box.width};
    EXPECT_NEAR(matchValue(hits, shape, turned, phi + turn), before, 1e-10 * std::abs(before));
    // Front and rear exchanged: the filter is the same.
    OrientedBox reversed = turned;
    reversed.heading += kPi;
    EXPECT_NEAR(matchValue(hits, shape, reversed, phi + turn), before, 1e-10 * std::abs(before));
}

TEST(ProjectHits, MergesCellsAndDropsNonFinite)
{
    Cluster a;
    a.x = {0.01F, 0.03F, 5.0F, std::nanf("")};
    a.y = {0.02F, 0.04F, 1.0F, 0.0F};
    a.z = {0.0F, 0.0F, 0.0F, 0.0F};
    a.height = {0.5F, 0.9F, 1.5F, 0.0F};
    const Hits merged = projectHits(a, 0.1);
    ASSERT_EQ(merged.size(), 2U);
    EXPECT_DOUBLE_EQ(merged.totalWeight, 3.0);
    EXPECT_DOUBLE_EQ(merged.weight[0], 2.0);
    EXPECT_NEAR(merged.x[0], 0.02, 1e-7);
    EXPECT_NEAR(merged.y[0], 0.03, 1e-7);
    EXPECT_NEAR(merged.height[0], 0.7, 1e-6);
    EXPECT_NEAR(merged.height[1], 1.5, 1e-6);
    EXPECT_EQ(projectHits(a, 0.0).size(), 3U);
    EXPECT_EQ(projectHits(Cluster{}, 0.1).size(), 0U);
    const Hits both = joined(merged, merged);
    EXPECT_EQ(both.size(), 4U);
    EXPECT_DOUBLE_EQ(both.totalWeight, 6.0);
    EXPECT_NEAR(both.height[3], 1.5, 1e-6);
}

}  // namespace
}  // namespace vdamf
