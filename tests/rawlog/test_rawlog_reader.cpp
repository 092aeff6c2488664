// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/rawlog_reader.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <random>

#include "../files/temporary_folder.h"
#include "example_objects.h"

namespace vdamf
{
namespace
{
using Kind = RawlogEntry::Kind;
using test::concatenated;
using test::entriesOf;
using test::nullObject;
using test::odometry;
using test::pointCloud;
using test::unknownObject;

class RawlogReaderTest : public TemporaryFolder
{
protected:
    struct Read
    {
        std::vector<RawlogEntry> entries;
        RawlogSummary summary;
        double progress = 0.0;

        std::string kinds() const
        {
            std::string letters;
            for (const RawlogEntry& entry : entries)
            {
                letters += "ONUDA"[static_cast<int>(entry.kind)];
            }
            return letters;
        }
    };

    Read read(const std::string& bytes) const
    {
        RawlogReader reader(make("in.rawlog", bytes));
        Read result;
        result.entries = entriesOf(reader);
        result.summary = reader.summary();
        result.progress = reader.progress();
        return result;
    }

    std::string errorFor(const std::string& bytes) const
    {
        return errorOf([&] { read(bytes); });
    }

    std::string gz(const std::string& bytes, std::size_t memberBytes = 1 << 20) const
    {
        RawlogWriter::Options options;
        options.memberBytes = memberBytes;
        options.existing = OutputFile::Existing::Overwrite;
        RawlogWriter writer(at("packed.gz"), options);
        writer.writeBytes(bytes);
        writer.commit();
        return contentOf("packed.gz");
    }
};

int numberOf(const RawlogEntry& entry)
{
    const auto object = std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(entry.object);
    return object ? static_cast<int>(std::lround(object->odometry.x())) : -1;
}

std::string odometries(int from, int to)
{
    std::string bytes;
    for (int i = from; i < to; ++i) bytes += serialized(odometry(i));
    return bytes;
}

TEST_F(RawlogReaderTest, PlainAndGzGiveTheSameEntries)
{
    const std::string bytes = odometries(0, 5) + serialized(pointCloud(1000)) + odometries(5, 9);
    const Read plain = read(bytes);
    const Read packed = read(gz(bytes));
    for (const Read* one : {&plain, &packed})
    {
        EXPECT_EQ("OOOOOOOOOO", one->kinds());
        EXPECT_EQ(bytes, concatenated(one->entries));
        EXPECT_EQ(10u, one->summary.objects);
        EXPECT_EQ(bytes.size(), one->summary.bytes);
        EXPECT_FALSE(one->summary.truncated);
        EXPECT_EQ(8, numberOf(one->entries[9]));
        EXPECT_EQ(serialized(odometry(0)).size(), one->entries[1].offset);
        EXPECT_EQ(1.0, one->progress);
    }
}

TEST_F(RawlogReaderTest, NullObjectsAreEntries)
{
    const std::string bytes = nullObject() + odometries(0, 1) + nullObject() + nullObject();
    const Read result = read(bytes);
    EXPECT_EQ("NONN", result.kinds());
    EXPECT_EQ(3u, result.summary.nulls);
    EXPECT_EQ(bytes, concatenated(result.entries));
}

TEST_F(RawlogReaderTest, GoesOnBehindUnknownClasses)
{
    const std::string unknown = unknownObject("me::CMine", std::string(500, 'x'));
    const std::string bytes = unknown + odometries(0, 2) + unknown + unknown + odometries(2, 3);
    const Read result = read(bytes);
    EXPECT_EQ("UOOUUO", result.kinds());
    EXPECT_EQ(bytes, concatenated(result.entries));
    EXPECT_EQ(unknown, result.entries[3].bytes);
    EXPECT_EQ(2, numberOf(result.entries[5]));
    EXPECT_EQ(3u, result.summary.unknown);
    ASSERT_EQ(3u, result.summary.problems.size());
    EXPECT_NE(std::string::npos, result.summary.problems[1].find("me::CMine"));
    EXPECT_NE(std::string::npos,
              result.summary.problems[1].find(std::to_string(result.entries[3].offset)));
}

TEST_F(RawlogReaderTest, AClassOfAnotherNamespaceIsNotMrpts)
{
    const Read result = read(unknownObject("my::CObservationOdometry", "x") + odometries(0, 1));
    EXPECT_EQ("UO", result.kinds());
}

TEST_F(RawlogReaderTest, ANewerVersionIsUnknownNotDamaged)
{
    std::string newer = serialized(odometry(1));
    newer[std::string("\xaemrpt::obs::CObservationOdometry").size()] = 40;
    const Read result = read(odometries(0, 1) + newer + odometries(2, 3));
    ASSERT_EQ("OUO", result.kinds());
    EXPECT_EQ(newer, result.entries[1].bytes);
    EXPECT_NE(std::string::npos, result.entries[1].problem.find("version 40"));
}

TEST_F(RawlogReaderTest, DamagedObjectsCostOnlyThemselves)
{
    std::string damaged = serialized(pointCloud(100));
    // A number of points beyond all reason.
    const std::size_t inner = damaged.find("CPointsMapXYZI") + 15;
    for (std::size_t i = 0; i < 4; ++i) damaged[inner + i] = '\x7f';
    const Read result = read(odometries(0, 3) + damaged + odometries(3, 6));
    EXPECT_EQ("OOODOOO", result.kinds());
    EXPECT_EQ(damaged, result.entries[3].bytes);
    EXPECT_EQ(5, numberOf(result.entries[6]));
    EXPECT_FALSE(result.summary.truncated);
}

TEST_F(RawlogReaderTest, BytesOfNothingAreHandedOn)
{
    const std::string bytes = odometries(0, 1) + std::string(3000, '\x91') + odometries(1, 2);
    const Read result = read(bytes);
    EXPECT_EQ("ODO", result.kinds());
    EXPECT_EQ(bytes, concatenated(result.entries));
}

TEST_F(RawlogReaderTest, ACutFileGivesAllWholeObjectsAndTheRest)
{
    const std::string bytes = odometries(0, 4);
    const std::size_t one = bytes.size() / 4;
    for (std::size_t cut = one; cut < 2 * one; cut += 3)
    {
        for (const std::string& file : {bytes.substr(0, cut), gz(bytes.substr(0, cut))})
        {
            const Read result = read(file);
            EXPECT_EQ(cut == one ? "O" : "OD", result.kinds()) << cut;
            EXPECT_EQ(bytes.substr(0, cut), concatenated(result.entries)) << cut;
            EXPECT_EQ(cut > one, result.summary.truncated) << cut;
            EXPECT_EQ(cut > one, !result.summary.truncation.empty()) << cut;
        }
    }
}

TEST_F(RawlogReaderTest, ACutGzStreamGivesWhatItHolds)
{
    std::string bytes;
    for (int i = 0; i < 200; ++i) bytes += serialized(pointCloud(100 + i, 1.5e9 + i));
    const std::string packed = gz(bytes, 1 << 16);
    for (const std::size_t part : {3u, 5u, 9u})
    {
        const Read result = read(packed.substr(0, packed.size() * part / 10));
        const std::string got = concatenated(result.entries);
        EXPECT_EQ(bytes.substr(0, got.size()), got);
        EXPECT_GT(got.size(), bytes.size() * (part - 2) / 10);
        EXPECT_TRUE(result.summary.truncated);
        EXPECT_NE(std::string::npos, result.summary.truncation.find("ends early"));
    }
    // A missing checksum does not show in the objects.
    const Read whole = read(packed.substr(0, packed.size() - 8));
    EXPECT_EQ(200u, whole.summary.objects);
    EXPECT_TRUE(whole.summary.truncated);
}

TEST_F(RawlogReaderTest, GoesOnInTheNextGzMember)
{
    const std::string packed = gz(odometries(0, 100)) + gz(odometries(100, 200));
    std::string damaged = packed;
    for (std::size_t i = 200; i < 260; ++i) damaged[i] = '\x55';
    const Read result = read(damaged);
    EXPECT_TRUE(result.summary.truncated);
    EXPECT_GE(result.summary.objects, 100u);
    EXPECT_EQ(199, numberOf(result.entries.back()));
}

TEST_F(RawlogReaderTest, TellsOfBytesBehindTheGzStream)
{
    const Read result = read(gz(odometries(0, 3)) + "something else");
    EXPECT_EQ("OOO", result.kinds());
    EXPECT_NE(std::string::npos, result.summary.truncation.find("none of it"));
}

TEST_F(RawlogReaderTest, ReadsTheOldFormatOfHeaders)
{
    // Length as 32 bits, no namespace, version as 32 bits, no end flag.
    const std::string now = serialized(odometry(7));
    const std::string header = "\xaemrpt::obs::CObservationOdometry";
    ASSERT_EQ(0u, now.find(std::string(1, static_cast<char>(0x80 | (header.size() - 1))) +
                           header.substr(1)));
    const std::string name = "CObservationOdometry";
    const std::string old = std::string(1, static_cast<char>(name.size())) + std::string(3, '\0') +
                            name + now.substr(header.size(), 1) + std::string(3, '\0') +
                            now.substr(header.size() + 1, now.size() - header.size() - 2);
    const Read result = read(old + unknownObject("a::B", "?") + old);
    EXPECT_EQ("OUO", result.kinds());
    EXPECT_EQ(7, numberOf(result.entries[2]));
    EXPECT_EQ(old, result.entries[2].bytes);
}

TEST_F(RawlogReaderTest, SaysWhyAFileIsNoRawlog)
{
    const auto has = [](const std::string& text, const char* part)
    { return text.find(part) != std::string::npos; };
    std::mt19937 random(3);
    std::string noise(100000, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    const std::string elf = std::string(
                                "\x7f"
                                "ELF\x02\x01\x01",
                                7) +
                            std::string(100, '\0');
    for (const std::string& foreign :
         {std::string("time,x,y\n1,2,3\n"), std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), elf,
          std::string(5000, '\0'), noise, gz("a packed text\n")})
    {
        const std::string error = errorFor(foreign);
        EXPECT_TRUE(has(error, "not a rawlog") && has(error, "in.rawlog")) << error;
    }
    EXPECT_TRUE(has(errorFor(""), "empty"));
    EXPECT_TRUE(has(errorFor("\x28\xb5\x2f\xfd and so on"), "zstd"));
    EXPECT_TRUE(has(errorFor(std::string("\x1f\x8b\x08\0garbage garbage", 19)), "damaged"));
    EXPECT_TRUE(has(errorOf([&] { RawlogReader reader(at("none")); }), "No such file"));
    EXPECT_TRUE(has(errorOf([&] { RawlogReader reader(at("")); }), "folder"));
}

TEST_F(RawlogReaderTest, KeepsTheFirstProblemsOnly)
{
    std::string bytes;
    for (int i = 0; i < 50; ++i) bytes += unknownObject("a::B", "?") + odometries(i, i + 1);
    const Read result = read(bytes);
    EXPECT_EQ(50u, result.summary.unknown);
    EXPECT_EQ(20u, result.summary.problems.size());
}

TEST_F(RawlogReaderTest, ObservationsOfABrokenFrameAreSaved)
{
    mrpt::obs::CSensoryFrame frame;
    frame.insert(mrpt::obs::CObservationOdometry::Create(odometry(1)));
    frame.insert(mrpt::obs::CObservationOdometry::Create(odometry(2)));
    const std::string whole = serialized(frame);
    const Read result = read(odometries(0, 1) + whole.substr(0, whole.size() - 10));
    EXPECT_EQ("ODOD", result.kinds());
    EXPECT_EQ(1, numberOf(result.entries[2]));
    EXPECT_TRUE(result.summary.truncated);
}

}  // namespace
}  // namespace vdamf
