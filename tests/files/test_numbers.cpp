// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text: strict reading, exact round trip, no locale.
#include "vdamf/files/numbers.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace vdamf
{
namespace
{
TEST(Numbers, ReadsToTheLastCharacter)
{
    EXPECT_EQ(parseNumber("1.5"), 1.5);
    EXPECT_EQ(parseNumber("+1.5"), 1.5);
    EXPECT_EQ(parseNumber("-.5e1"), -5.0);
    for (const char* bad : {"", " 1", "1 ", "1,5", "1.5m", "0x10", "nan", "inf", "1e999", "+-1",
                            "++1", "+", "-", "1e", "."})
    {
        EXPECT_EQ(parseNumber(bad), std::nullopt) << bad;
    }
}

TEST(Numbers, WholeNumbersHaveNoPoint)
{
    EXPECT_EQ(parseInteger("-12"), -12);
    EXPECT_EQ(parseInteger("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
    for (const char* bad : {"", "1.0", "1e3", "9223372036854775808", "12x"})
    {
        EXPECT_EQ(parseInteger(bad), std::nullopt) << bad;
    }
}

TEST(Numbers, ShortestTextReadsBackExactly)
{
    EXPECT_EQ(toText(0.1), "0.1");
    EXPECT_EQ(toText(4.0), "4");
    std::mt19937_64 random(7);
    for (int i = 0; i < 10000; ++i)
    {
        const std::uint64_t bits = random();
        double value = 0.0;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) continue;
        // Subnormal numbers may be read back as out of range.
        if (std::abs(value) < std::numeric_limits<double>::min()) continue;
        EXPECT_EQ(parseNumber(toText(value)), value) << toText(value);
    }
}

TEST(Numbers, FixedTextHasItsDecimals)
{
    EXPECT_EQ(toFixedText(1317042145.9639999, 6), "1317042145.964000");
    EXPECT_EQ(toFixedText(-0.00001, 3), "0.000");
    EXPECT_EQ(toFixedText(-0.5, 1), "-0.5");
    EXPECT_EQ(toFixedText(-3.0, 0), "-3");
}

TEST(Numbers, DoNotFollowTheLocale)
{
    const std::string before = std::setlocale(LC_NUMERIC, nullptr);
    const bool changed = std::setlocale(LC_NUMERIC, "de_DE.UTF-8") != nullptr;
    EXPECT_EQ(parseNumber("1.5"), 1.5);
    EXPECT_EQ(toText(1.5), "1.5");
    std::setlocale(LC_NUMERIC, before.c_str());
    if (!changed) GTEST_SKIP() << "no locale with a decimal comma is installed";
}

TEST(Numbers, TrimmedHasNoBlanksAtItsEnds)
{
    EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
    EXPECT_EQ(trimmed(" \t"), "");
}

}  // namespace
}  // namespace vdamf
