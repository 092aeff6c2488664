// SPDX-License-Identifier: BSD-3-Clause
// Files of learned filters: written, read back, and what their reader refuses.
#include "vdamf/rawlog/filter_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "files/temporary_folder.h"
#include "rawlog/replaced_text.h"
#include "vdamf/rawlog/configuration.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;

FilterBank exampleBank()
{
    FilterBank bank;
    bank.record = {"vdamf-train 1.0", "40 clusters", "seed 1", "better in 3, worse in 1"};
    bank.filters.emplace_back();
    bank.filters.back().parameters.shape.endStrip = 0.1 + 0.2;
    TypedFilter truck;
    truck.type = VehicleType::Truck;
    truck.sizes.length = 10.0 / 3.0;
    truck.parameters.shape.sigma = 0.15;
    truck.parameters.errors.hitSigma = 0.25;
    truck.parameters.hull.farEnd = 3.3;
    bank.filters.push_back(truck);
    return bank;
}

std::string refusal(const std::function<void()>& reading)
{
    try
    {
        reading();
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return "not refused";
}

std::string refusalOf(const std::string& text)
{
    return refusal([&] { parseFilterBank(text, "f.txt"); });
}

TEST(FilterFile, IsNamedOnceInWhatIsWrongWithIt)
{
    const std::string text = toText(exampleBank());
    const std::string missing = refusalOf(replaced(text, "end_strip_m", "# end_strip_m"));
    EXPECT_THAT(missing, testing::MatchesRegex("f\\.txt:[0-9]+: \\[filter [a-z]+\\] has no "
                                               "'end_strip_m': is the file whole\\?"));
    EXPECT_EQ(refusalOf(replaced(text, "whole = true", "whole = false")),
              "f.txt: [end] says that the file is not whole");
}

TEST(FilterFile, IsReadAsItWasWritten)
{
    const std::string text = toText(exampleBank());
    const FilterBank read = parseFilterBank(text, "f.txt");
    EXPECT_EQ(toText(read), text);
    ASSERT_EQ(read.filters.size(), 2U);
    EXPECT_EQ(read.record.heldOut, "better in 3, worse in 1");
    EXPECT_EQ(read.filters[0].parameters.shape.endStrip, 0.1 + 0.2);
    EXPECT_EQ(read.filters[1].type, VehicleType::Truck);
    EXPECT_EQ(read.filters[1].sizes.length, 10.0 / 3.0);
    EXPECT_EQ(read.filters[1].parameters.hull.farEnd, 3.3);
}

TEST(FilterFile, CutShortAnywhereIsRefused)
{
    const std::string text = toText(exampleBank());
    const std::size_t whole = text.find_last_not_of('\n');
    for (std::size_t size = 0; size < whole; size += 7)
        EXPECT_NE(refusalOf(text.substr(0, size)), "not refused") << "after " << size;
    EXPECT_THAT(refusalOf(text.substr(0, text.size() / 2)), HasSubstr("is the file whole?"));
}

TEST(FilterFile, NamesLineAndKeyOfWhatItRefuses)
{
    const std::string text = toText(exampleBank());
    const std::string other = refusalOf(replaced(text, "version = 1", "version = 2"));
    EXPECT_THAT(other, HasSubstr("f.txt:4: version = 2: expected 1"));
    EXPECT_THAT(refusalOf(replaced(text, "sigma_m = 0.2", "sigma_m = nan")), HasSubstr("sigma_m"));
    EXPECT_THAT(refusalOf(replaced(text, "sigma_m = 0.2", "sigma_m = 7")), HasSubstr("sigma_m"));
    EXPECT_THAT(refusalOf(replaced(text, "far_side =", "far_site =")), HasSubstr("far_side"));
    EXPECT_THAT(refusalOf(replaced(text, "[filter any]", "[filter bike]")), HasSubstr("bike"));
    EXPECT_THAT(refusalOf(replaced(text, "[filter truck]", "[filter any]")), HasSubstr("any"));
    EXPECT_THAT(refusalOf("vdamf discriminator 3\n"), HasSubstr("f.txt"));
    EXPECT_THAT(refusalOf(""), HasSubstr("these are no filters"));
}

class FilterOfConfiguration : public TemporaryFolder
{
};

TEST_F(FilterOfConfiguration, ReplacesTheHandSetOne)
{
    make("filters.txt", toText(exampleBank()));
    make("config.ini", "[measurement]\nfilter_file = filters.txt\nsigma_m = 0.3\n");
    const Configuration c = readConfiguration(IniDocument::load(at("config.ini")));
    const MeasureOptions& options = c.tracker.measurement;
    ASSERT_TRUE(options.bank);
    EXPECT_EQ(options.bank->filters.size(), 2U);
    EXPECT_EQ(options.parameters.shape.endStrip, 0.1 + 0.2);
    // The learned one comes with its own.
    EXPECT_EQ(options.sigma, 0.2);
    EXPECT_FALSE(readConfiguration(IniDocument::parse("", "empty")).tracker.measurement.bank);
}

TEST_F(FilterOfConfiguration, ThatIsMissingOrDamagedIsAnError)
{
    make("config.ini", "[measurement]\nfilter_file = filters.txt\n");
    const auto read = [&] { readConfiguration(IniDocument::load(at("config.ini"))); };
    EXPECT_THAT(refusal(read), HasSubstr("measurement.filter_file"));
    make("filters.txt", "[filters]\nversion = 1\n");
    EXPECT_THAT(refusal(read), HasSubstr("is the file whole?"));
}

}  // namespace
}  // namespace vdamf
