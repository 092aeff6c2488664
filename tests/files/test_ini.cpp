// SPDX-License-Identifier: BSD-3-Clause
// Strict ini files: what is read, what is refused and in which words, and the round trip.
#include "vdamf/files/ini.h"

#include <gmock/gmock.h>

#include <random>

#include "temporary_folder.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
enum class Colour
{
    Red,
    DarkBlue
};

template <>
struct EnumNames<Colour>
{
    static std::vector<std::pair<Colour, const char*>> names()
    {
        return {{Colour::Red, "red"}, {Colour::DarkBlue, "dark_blue"}};
    }
};

namespace
{
using ::testing::HasSubstr;

struct PaintOptions
{
    double gap = 0.4;
    double angle = 10.0 * kPi / 180.0;
    int count = 3;
    bool glossy = true;
    std::string label;
    Colour colour = Colour::Red;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.gap, "gap_m", 0.05, 2.0, "largest gap");
        field(self.angle, "angle_deg", -180.0, 180.0, "angle of the brush");
        field(self.count, "count", 1, 10, "layers");
        field(self.glossy, "glossy", "shines");
        field(self.label, "label", "on the tin");
        field(self.colour, "colour", "of the paint");
    }
};

PaintOptions read(const IniDocument& document)
{
    PaintOptions options;
    IniReader reader(document);
    reader.read("paint", options);
    reader.finish();
    return options;
}

std::string problemsOf(const std::string& text)
{
    return errorOf([&] { read(IniDocument::parse(text, "c.ini")); });
}

std::string parseError(const std::string& text)
{
    return errorOf([&] { IniDocument::parse(text, "c.ini"); });
}

TEST(Ini, ReadsEveryKind)
{
    const PaintOptions options =
        read(IniDocument::parse("\xEF\xBB\xBF# paint\r\n"
                                "[paint]  // of the hall\r\n"
                                "gap_m = 1.25 # metres\r\n"
                                "angle_deg=-90\n"
                                "count = 7 ; layers\n"
                                "; a comment\n"
                                "// another\n"
                                "glossy = false\n"
                                "label = http://x#y = 1 // tin\n"
                                "colour = dark_blue",
                                "c.ini"));
    EXPECT_EQ(options.gap, 1.25);
    EXPECT_EQ(options.angle, -90.0 * kPi / 180.0);
    EXPECT_EQ(options.count, 7);
    EXPECT_FALSE(options.glossy);
    EXPECT_EQ(options.label, "http://x#y = 1");
    EXPECT_EQ(options.colour, Colour::DarkBlue);
}

TEST(Ini, MissingKeysKeepTheirDefaults)
{
    const PaintOptions options = read(IniDocument::parse("[paint]\ncount = 4\n", "c.ini"));
    EXPECT_EQ(options.count, 4);
    EXPECT_EQ(options.gap, 0.4);
    EXPECT_EQ(read(IniDocument::parse("", "c.ini")).count, 3);
}

TEST(Ini, RefusesBadLines)
{
    EXPECT_EQ(parseError("[paint]\ngap_m 3\n"),
              "c.ini:2: expected '[section]' or 'key = value', found 'gap_m 3'");
    EXPECT_THAT(parseError("[paint\n"), HasSubstr("c.ini:1: expected ']'"));
    EXPECT_THAT(parseError("[ ]\n"), HasSubstr("c.ini:1: the section has no name"));
    EXPECT_THAT(parseError("\n= 3\n"), HasSubstr("c.ini:2: there is no key before '='"));
    EXPECT_THAT(parseError("a = 3\n"), HasSubstr("c.ini:1: key 'a' stands before the first"));
    EXPECT_THAT(parseError("[a]\n[b]\n[a]\n"),
                HasSubstr("c.ini:3: section 'a' stands already in line 1"));
    EXPECT_THAT(parseError("[a]\nx = 1\nx = 1\n"),
                HasSubstr("c.ini:3: key 'a.x' stands already in line 2"));
    EXPECT_THAT(parseError(std::string("\x01\x02\0\x03", 4)), HasSubstr("found '?\?\?\?'"));
}

TEST(Ini, NamesEveryBadValueAtOnce)
{
    EXPECT_EQ(problemsOf("[paint]\n"
                         "gap_m = 0,4\n"
                         "angle_deg = 181\n"
                         "count = 3.0\n"
                         "glossy = yes\n"
                         "colour = blue\n"),
              "c.ini:2: paint.gap_m = '0,4': expected a number from 0.05 to 2\n"
              "c.ini:3: paint.angle_deg = '181': expected a number from -180 to 180\n"
              "c.ini:4: paint.count = '3.0': expected a whole number from 1 to 10\n"
              "c.ini:5: paint.glossy = 'yes': expected true or false\n"
              "c.ini:6: paint.colour = 'blue': expected one of red, dark_blue");
    EXPECT_THAT(problemsOf("[paint]\ngap_m =\n"), HasSubstr("paint.gap_m = ''"));
    EXPECT_THAT(problemsOf("[paint]\ngap_m = nan\n"), HasSubstr("expected a number"));
}

TEST(Ini, SuggestsTheNearestName)
{
    EXPECT_EQ(problemsOf("[paint]\ngpa_m = 1\n"),
              "c.ini:2: unknown key paint.gpa_m; did you mean 'gap_m'?");
    EXPECT_THAT(problemsOf("[paint]\ngap = 1\n"), HasSubstr("did you mean 'gap_m'?"));
    EXPECT_THAT(problemsOf("[paint]\nxyz = 1\n"),
                HasSubstr("unknown key paint.xyz; known: gap_m, angle_deg, count"));
    EXPECT_EQ(problemsOf("[pain]\ngap_m = 1\n"),
              "c.ini:1: unknown section [pain]; did you mean 'paint'?");
}

TEST(Ini, AssignmentsOfTheCommandLine)
{
    IniDocument document = IniDocument::parse("[paint]\ncount = 4\n", "c.ini");
    document.set("paint.count=5");
    document.set(" paint.label = a = b ");
    EXPECT_EQ(read(document).count, 5);
    EXPECT_EQ(read(document).label, "a = b");
    document.set("paint.count=50");
    document.set("pint.count=5");
    EXPECT_EQ(errorOf([&] { read(document); }),
              "--set: paint.count = '50': expected a whole number from 1 to 10\n"
              "--set: unknown section [pint]; did you mean 'paint'?");
    document.set("paint.count=5");
    document.set("paint.label=tin #1");
    EXPECT_THAT(errorOf([&] { read(document); }),
                HasSubstr("--set: paint.label = 'tin #1': expected a text without line break"));
    for (const char* bad : {"paint.count", "count=5", ".count=5", "paint.=5", ""})
    {
        EXPECT_THAT(errorOf([&] { document.set(bad); }),
                    HasSubstr("expected section.key=value, found '" + std::string(bad) + "'"));
    }
}

TEST(Ini, FilesAndPlacesOfKeysAreThoseOfTheirOrigin)
{
    IniDocument document = IniDocument::parse("[paint]\ncount = 4\nlabel = a\n", "in/c.ini");
    document.set("paint.label=b");
    EXPECT_EQ(document.fileOf("paint", "count", "x.txt"), "in/x.txt");
    EXPECT_EQ(document.fileOf("paint", "count", "/x.txt"), "/x.txt");
    EXPECT_EQ(document.fileOf("paint", "label", "x.txt"), "x.txt");
    IniReader reader(document);
    const auto notAbove = [&](const char* key, const char* other) {
        reader.require(false, "too high", {{"paint", key}, {"paint", other}});
    };
    PaintOptions options;
    reader.read("paint", options);
    notAbove("count", "label");
    notAbove("label", "label");
    notAbove("label", "gap_m");
    EXPECT_EQ(errorOf([&] { reader.finish(); }),
              "in/c.ini:2, --set: too high\n--set: too high\n--set, in/c.ini: too high");
}

TEST(Ini, WriterShowsKeysRangesAndComments)
{
    IniWriter writer;
    writer.write("paint", "the hall", PaintOptions{});
    EXPECT_EQ(writer.text(),
              "# the hall\n"
              "[paint]\n"
              "# largest gap (0.05 to 2)\n"
              "gap_m = 0.4\n"
              "# angle of the brush (-180 to 180)\n"
              "angle_deg = 10\n"
              "# layers (1 to 10)\n"
              "count = 3\n"
              "# shines (true | false)\n"
              "glossy = true\n"
              "# on the tin\n"
              "label =\n"
              "# of the paint (red | dark_blue)\n"
              "colour = red\n");
}

TEST(Ini, RoundTripIsExact)
{
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> degrees(-180.0, 180.0);
    std::uniform_real_distribution<double> gap(0.05, 2.0);
    for (int i = 0; i < 2000; ++i)
    {
        PaintOptions options;
        options.gap = gap(random);
        options.angle = degrees(random) * kPi / 180.0;
        options.count = 1 + i % 10;
        options.glossy = i % 2 == 0;
        options.label = "tin " + std::to_string(i);
        options.colour = i % 3 == 0 ? Colour::Red : Colour::DarkBlue;
        IniWriter writer;
        writer.write("paint", "", options);
        const PaintOptions back = read(IniDocument::parse(writer.text(), "c.ini"));
        EXPECT_EQ(back.gap, options.gap);
        EXPECT_EQ(back.angle, options.angle) << writer.text();
        EXPECT_EQ(back.count, options.count);
        EXPECT_EQ(back.glossy, options.glossy);
        EXPECT_EQ(back.label, options.label);
        EXPECT_EQ(back.colour, options.colour);
    }
}

TEST(Ini, WriterRefusesTextThatWouldReadOtherwise)
{
    for (const char* bad : {"a\nb", "a\r[b", " a", "a ", "a # b", "# a"})
    {
        PaintOptions options;
        options.label = bad;
        IniWriter writer;
        EXPECT_THAT(errorOf([&] { writer.write("paint", "", options); }), HasSubstr("'label'"))
            << bad;
    }
}

class IniFileTest : public TemporaryFolder
{
};

TEST_F(IniFileTest, LoadsAndNamesTheFile)
{
    const auto path = make("c.ini", "[paint]\ncount = x\n");
    EXPECT_THAT(errorOf([&] { read(IniDocument::load(path)); }),
                HasSubstr(path.string() + ":2: paint.count"));
    EXPECT_THAT(errorOf([&] { IniDocument::load(at("none.ini")); }),
                HasSubstr("none.ini: cannot read: No such file"));
    EXPECT_THAT(errorOf([&] { IniDocument::load(at("")); }), HasSubstr("this is a folder"));
}

TEST(Ini, LinesMayEndWithCarriageReturns)
{
    const std::string text = "[paint]\n# a remark\ngap_m = 0.5\n\ncount = 7\nglossy = no\n";
    for (const char* end : {"\n", "\r\n", "\r"})
    {
        std::string other;
        for (const char c : text) other += c == '\n' ? std::string(end) : std::string(1, c);
        EXPECT_THAT(errorOf([&] { read(IniDocument::parse(other, "a.ini")); }),
                    ::testing::StartsWith("a.ini:6: paint.glossy"));
        const std::string good = other.substr(0, other.find("glossy"));
        const PaintOptions options = read(IniDocument::parse(good, "a.ini"));
        EXPECT_EQ(options.gap, 0.5);
        EXPECT_EQ(options.count, 7);
    }
}

TEST(Ini, ChecksValuesAgainstEachOther)
{
    const IniDocument document = IniDocument::parse("[paint]\ngap_n = 1\n", "a.ini");
    IniReader reader(document);
    PaintOptions options;
    reader.read("paint", options);
    reader.require(options.gap < 1.0, "this holds");
    reader.require(options.gap > 1.0, "paint.gap_m = 0.4 must be above paint.room_m = 1");
    reader.require(false, "paint is wet", 1);
    const std::string error = errorOf([&] { reader.finish(); });
    EXPECT_THAT(error, HasSubstr("a.ini:1: paint is wet"));
    EXPECT_THAT(error, HasSubstr("a.ini: paint.gap_m = 0.4 must be above paint.room_m = 1"));
    EXPECT_THAT(error, HasSubstr("gap_n"));
    EXPECT_THAT(error, ::testing::Not(HasSubstr("this holds")));
}

}  // namespace
}  // namespace vdamf
