// SPDX-License-Identifier: BSD-3-Clause
#include "hit_encoding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base64.h"
#include "report/page_data.h"

namespace vdamf
{
namespace
{
HitPositions randomHits(std::size_t count, std::mt19937& random)
{
    std::uniform_real_distribution<float> place(-120.0F, 120.0F);
    HitPositions hits;
    for (std::size_t i = 0; i < count; ++i)
        hits.emplace_back(place(random), place(random), 0.05F * place(random));
    return hits;
}

bool isBefore(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// Both in whole centimetres, in one order.
void expectSame(const HitPositions& hits, std::vector<Eigen::Vector3d> read)
{
    std::vector<Eigen::Vector3d> expected;
    for (const Eigen::Vector3f& p : hits)
        expected.push_back((100.0F * p).array().round().cast<double>() / 100.0);
    std::sort(expected.begin(), expected.end(), isBefore);
    std::sort(read.begin(), read.end(), isBefore);
    ASSERT_EQ(read.size(), expected.size());
    for (std::size_t i = 0; i < read.size(); ++i)
        EXPECT_LT((read[i] - expected[i]).cwiseAbs().maxCoeff(), 1e-9) << i;
}

TEST(HitEncoding, KeepsEveryHitToTheCentimetre)
{
    std::mt19937 random(1);
    ShownHits shown;
    shown.ground = randomHits(500, random);
    shown.overhead = randomHits(7, random);
    shown.structure = {};
    shown.clusters = {{12, randomHits(200, random)}, {0, randomHits(1, random)}, {70000, {}}};
    const auto groups = test::decoded(encoded(shown));
    ASSERT_EQ(groups.size(), 6U);
    expectSame(shown.ground, groups[0].hits);
    expectSame(shown.overhead, groups[1].hits);
    expectSame(shown.structure, groups[2].hits);
    for (std::size_t k = 0; k < 3; ++k)
    {
        expectSame(shown.clusters[k].hits, groups[3 + k].hits);
        EXPECT_EQ(groups[3 + k].track, shown.clusters[k].track);
    }
}

TEST(HitEncoding, HoldsAnEmptyFrame)
{
    const auto groups = test::decoded(encoded({}));
    EXPECT_EQ(groups.size(), 3U);
    for (const auto& group : groups) EXPECT_TRUE(group.hits.empty());
}

TEST(HitEncoding, CutsOffWhatIsTooFar)
{
    ShownHits shown;
    shown.ground = {{1000.0F, -1000.0F, 0.0F}};
    const auto groups = test::decoded(encoded(shown));
    EXPECT_NEAR(groups[0].hits[0].x(), 327.67, 1e-9);
    EXPECT_NEAR(groups[0].hits[0].y(), -327.67, 1e-9);
}

TEST(Base64, IsThatOfTheStandard)
{
    // RFC 4648, section 10.
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    std::string all;
    for (int c = 0; c < 256; ++c) all += static_cast<char>(c);
    EXPECT_EQ(test::fromBase64(base64(all)), all);
}

}  // namespace
}  // namespace vdamf
