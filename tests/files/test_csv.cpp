// SPDX-License-Identifier: BSD-3-Clause
// Tables by column name, and errors that name file, line and column.
#include "vdamf/files/csv.h"

#include <gmock/gmock.h>

#include "temporary_folder.h"

namespace vdamf
{
namespace
{
using ::testing::EndsWith;
using ::testing::HasSubstr;

class CsvTest : public TemporaryFolder
{
protected:
    // The error of reading all rows of a table whose column x_m is a number and n is whole.
    std::string errorFor(const std::string& content)
    {
        const auto path = make("t.csv", content);
        return errorOf(
            [&]
            {
                CsvReader reader(path, {"x_m", "n"});
                while (reader.next())
                {
                    reader.number("x_m");
                    reader.integer("n");
                }
            });
    }
};

TEST_F(CsvTest, ReadsColumnsByNameInAnyOrder)
{
    CsvReader reader(make("t.csv", "n,more,x_m,name\r\n3,?, 1.5 ,car\n\n-4,,-2e-3,\n"),
                     {"x_m", "n", "name"});
    EXPECT_TRUE(reader.hasColumn("more"));
    EXPECT_FALSE(reader.hasColumn("y_m"));
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(reader.line(), 2);
    EXPECT_EQ(reader.number("x_m"), 1.5);
    EXPECT_EQ(reader.integer("n"), 3);
    EXPECT_EQ(reader.text("name"), "car");
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(reader.line(), 4);
    EXPECT_EQ(reader.optionalNumber("x_m"), -0.002);
    EXPECT_EQ(reader.optionalNumber("more"), std::nullopt);
    EXPECT_EQ(reader.text("name"), "");
    EXPECT_FALSE(reader.next());
}

TEST_F(CsvTest, TakesAByteOrderMarkAndALastLineWithoutEnd)
{
    CsvReader reader(make("t.csv", "\xEF\xBB\xBFx_m,n\n1,2"), {"x_m"});
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(reader.integer("n"), 2);
    EXPECT_FALSE(reader.next());
}

TEST_F(CsvTest, HeaderAloneIsATableWithoutRows)
{
    CsvReader reader(make("t.csv", "x_m,n"), {"x_m"});
    EXPECT_FALSE(reader.next());
}

TEST_F(CsvTest, NamesFileLineAndColumn)
{
    EXPECT_THAT(errorFor(""), HasSubstr("t.csv:1: the file is empty"));
    EXPECT_THAT(errorFor("\n1,2\n"), HasSubstr("t.csv:1: the first line is empty"));
    EXPECT_THAT(errorFor("x_m,m\n"), HasSubstr("t.csv:1: the column 'n' is missing"));
    EXPECT_THAT(errorFor("x,n\n"), HasSubstr("'x_m' is missing (is it 'x'?)"));
    EXPECT_THAT(errorFor("x_m,n,n\n"), HasSubstr("t.csv:1: column 'n' twice"));
    EXPECT_THAT(errorFor("x_m,n\n1,2\n1,2,3\n"),
                HasSubstr("t.csv:3: expected 2 cells as in the header, found 3"));
    EXPECT_THAT(errorFor("x_m,n\n1.5m,2\n"),
                HasSubstr("t.csv:2: column 'x_m': expected a finite number, found '1.5m'"));
    EXPECT_THAT(errorFor("x_m,n\n,2\n"), EndsWith("found ''"));
    EXPECT_THAT(errorFor("x_m,n\nnan,2\n"), EndsWith("found 'nan'"));
    EXPECT_THAT(errorFor("x_m,n\n1e999,2\n"), EndsWith("found '1e999'"));
    EXPECT_THAT(errorFor("x_m,n\n1,2.0\n"),
                HasSubstr("t.csv:2: column 'n': expected a whole number, found '2.0'"));
}

TEST_F(CsvTest, RefusesWhatIsNoTable)
{
    EXPECT_THAT(errorFor(std::string(100000, 'x')), HasSubstr("t.csv:1: the line is too long"));
    EXPECT_THAT(errorOf([&] { CsvReader(at(""), {}); }), HasSubstr("this is a folder"));
    EXPECT_THAT(errorOf([&] { CsvReader(at("none.csv"), {}); }),
                HasSubstr("none.csv: cannot read: No such file"));
}

TEST_F(CsvTest, CallersErrorsNameTheRow)
{
    CsvReader reader(make("t.csv", "x_m\n-1\n"), {"x_m"});
    reader.next();
    EXPECT_EQ(errorOf([&] { reader.fail("x_m", "must be positive"); }),
              at("t.csv").string() + ":2: column 'x_m': must be positive");
}

TEST_F(CsvTest, WhatACellCannotHoldIsReplaced)
{
    EXPECT_EQ(cellText(""), "");
    EXPECT_EQ(cellText("a 1;'"), "a 1;'");
    EXPECT_EQ(cellText(" \"a,b\"\r\n c\t"), ";a;b;;; c");
}

TEST_F(CsvTest, TakesCellsInQuotes)
{
    CsvReader reader(make("t.csv",
                          "\"x_m\",\"n\", \"more\" ,name\r\n"
                          "\"1.5\", \"3\" ,\"said \"\"a, b\"\"\",\"car\"\r\n"
                          "2,\"4\",\"\",\n"),
                     {"x_m", "n", "name"});
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(reader.number("x_m"), 1.5);
    EXPECT_EQ(reader.integer("n"), 3);
    EXPECT_EQ(reader.text("name"), "car");
    // Names go from table to table, where they must stay one cell.
    EXPECT_THAT(errorOf([&] { reader.text("more"); }),
                HasSubstr("t.csv:2: column 'more': a comma or a quote inside of a cell"));
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(reader.integer("n"), 4);
    EXPECT_EQ(reader.text("more"), "");
    EXPECT_EQ(reader.text("name"), "");
    EXPECT_FALSE(reader.next());
    EXPECT_THAT(errorFor("x_m,n\n\"1,2\n"), HasSubstr("t.csv:2: a cell in quotes does not end"));
    EXPECT_THAT(errorFor("x_m,n\n\"1\"5,2\n"), HasSubstr("something stands behind its quotes"));
    EXPECT_THAT(errorFor("x_m,n\n\"\",2\n"), EndsWith("found ''"));
}

}  // namespace
}  // namespace vdamf
