// SPDX-License-Identifier: BSD-3-Clause
// The text form of models: what is written reads back the same, what is bad is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "vdamf/tracking/discrimination/features.h"
#include "vdamf/tracking/discrimination/model.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

DiscriminatorModel exampleModel()
{
    DiscriminationGrid grid;
    grid.x = {-0.5, 5.5, 4};
    grid.y = {0.0, 2.0, 3};
    grid.z = {0.1, 2.1, 2};
    DiscriminatorModel model = untrainedModel(grid);
    std::mt19937 random(7);
    std::normal_distribution<double> any(0.0, 1.0);
    for (double& w : model.weights) w = any(random);
    model.bias = -1.25;
    model.frame = {1.5, -0.25, 0.125, 0.5, -0.75};
    model.track = {0.95, 0.25, 1.25, -0.5, 6.0};
    model.record = {"trained on nothing", "seed 7"};
    return model;
}

std::string errorOf(const std::string& text)
{
    try
    {
        parseDiscriminatorModel(text, "m.txt");
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(ModelText, ReadsBackTheSame)
{
    const DiscriminatorModel model = exampleModel();
    const DiscriminatorModel read = parseDiscriminatorModel(toText(model), "m.txt");
    EXPECT_TRUE(read.grid == model.grid);
    EXPECT_EQ(read.weights, model.weights);
    EXPECT_EQ(read.bias, model.bias);
    EXPECT_EQ(read.record, model.record);
    EXPECT_EQ(read.frame.slopePerDecade, model.frame.slopePerDecade);
    EXPECT_EQ(read.frame.prior, model.frame.prior);
    EXPECT_EQ(read.track.memory, model.track.memory);
    EXPECT_EQ(toText(read), toText(model));
}

TEST(ModelText, MayHaveCarriageReturns)
{
    std::string text;
    for (const char c : toText(exampleModel())) text += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(errorOf(text), "");
}

TEST(ModelText, CutAnywhereIsRefused)
{
    const std::string text = toText(exampleModel());
    // Without the last line feed it is whole. Behind the head all lines are alike.
    constexpr std::size_t kHead = 600;
    for (std::size_t length = 0; length + 1 < text.size(); length += length < kHead ? 7 : 4001)
        EXPECT_THAT(errorOf(text.substr(0, length)), HasSubstr("m.txt:")) << length;
    EXPECT_THAT(errorOf(text.substr(0, text.size() / 2)), HasSubstr("m.txt:"));
    EXPECT_THAT(errorOf(""), HasSubstr("m.txt:1: the model ends here"));
}

TEST(ModelText, OfAnotherVersionIsRefused)
{
    const std::string text = toText(exampleModel());
    for (const char* other : {"discriminator 2", "discriminator 4", "discriminator 33"})
        EXPECT_THAT(errorOf(replaced(text, "discriminator 3", other)),
                    AllOf(HasSubstr("m.txt:1:"), HasSubstr(other), HasSubstr("another version"),
                          HasSubstr("expected 'vdamf discriminator 3'"),
                          HasSubstr("train the model again")));
    EXPECT_THAT(errorOf("[ground]\n" + text), HasSubstr("no discriminator"));
}

TEST(ModelText, OfAnotherGridIsRefused)
{
    const std::string text = toText(exampleModel());
    EXPECT_THAT(errorOf(replaced(text, "x -0.5 5.5 4", "x -0.5 5.5 5")),
                HasSubstr("'cells' has 4 numbers, expected 5"));
    EXPECT_THAT(errorOf(replaced(text, "z 0.1 2.1 2", "z 0.1 2.1 3")),
                HasSubstr("expected 'cells'"));
    EXPECT_THAT(errorOf(replaced(text, "y 0 2 3", "y 2 0 3")), HasSubstr("'y': expected begin"));
    EXPECT_THAT(errorOf(replaced(text, "y 0 2 3", "y 0 2 999")), HasSubstr("'y': expected begin"));
}

TEST(ModelText, WithNumbersThatAreNotFiniteIsRefused)
{
    const std::string text = toText(exampleModel());
    for (const char* bad : {"nan", "inf", "-inf", "1e300", "1,5", "0x1", "1.5.2", "--1"})
        EXPECT_THAT(errorOf(replaced(text, "bias -1.25", std::string("bias ") + bad)),
                    HasSubstr("is no finite number"))
            << bad;
    EXPECT_THAT(errorOf(replaced(text, "bias -1.25", "bias")), HasSubstr("has 0 numbers"));
    EXPECT_THAT(errorOf(replaced(text, "0.95 0.25", "1.5 0.25")), HasSubstr("memory = 1.5"));
}

TEST(ModelText, WithMoreBehindItsEndIsRefused)
{
    EXPECT_EQ(errorOf(toText(exampleModel()) + "\n \n"), "");
    EXPECT_THAT(errorOf(toText(exampleModel()) + "end\n"), HasSubstr("nothing behind 'end'"));
}

TEST(DefaultModel, IsBuiltInAndTrained)
{
    const DiscriminatorModel& model = defaultDiscriminatorModel();
    EXPECT_EQ(model.weights.size(), featureCount(model.grid));
    EXPECT_FALSE(model.record.empty());
    EXPECT_GT(model.frame.slope, 0.0);
    EXPECT_GT(model.track.slope, 0.0);
}
}  // namespace
}  // namespace vdamf
