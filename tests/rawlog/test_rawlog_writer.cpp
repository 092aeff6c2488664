// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/rawlog_writer.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "../files/temporary_folder.h"
#include "example_objects.h"

namespace vdamf
{
namespace
{
using test::bytesOf;
using test::odometry;

class RawlogWriterTest : public TemporaryFolder
{
};

constexpr int kObjects = 400;

RawlogWriter::Options withThreads(int threads)
{
    RawlogWriter::Options options;
    options.threads = threads;
    options.memberBytes = 4096;
    return options;
}

std::string expectedBytes()
{
    std::string bytes;
    for (int i = 0; i < kObjects; ++i) bytes += serialized(odometry(i));
    return bytes;
}

void writeObjects(RawlogWriter& writer)
{
    for (int i = 0; i < kObjects; ++i) writer.write(odometry(i));
}

std::string unpacked(const std::filesystem::path& path)
{
    gzFile file = gzopen(path.c_str(), "rb");
    std::string bytes(1 << 22, '\0');
    const int size = gzread(file, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(file);
    bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return bytes;
}

TEST_F(RawlogWriterTest, TheSameBytesWithAnyNumberOfThreads)
{
    std::string first;
    for (const int threads : {0, 1, 2, 5})
    {
        const auto path = at("out" + std::to_string(threads) + ".rawlog");
        RawlogWriter writer(path, withThreads(threads));
        writeObjects(writer);
        writer.commit();
        if (first.empty()) first = bytesOf(path);
        EXPECT_EQ(first, bytesOf(path)) << threads << " threads";
        EXPECT_EQ(expectedBytes(), unpacked(path));
    }
}

TEST_F(RawlogWriterTest, LevelZeroIsPlain)
{
    RawlogWriter::Options options = withThreads(2);
    options.gzLevel = 0;
    RawlogWriter writer(at("plain.rawlog"), options);
    writeObjects(writer);
    writer.commit();
    EXPECT_EQ(expectedBytes(), bytesOf(at("plain.rawlog")));
}

TEST_F(RawlogWriterTest, MembersHoldWholeObjects)
{
    const auto path = at("out.rawlog");
    RawlogWriter writer(path, withThreads(2));
    writeObjects(writer);
    writer.commit();
    const std::string bytes = bytesOf(path);
    // Behind its fixed header the second member begins; the file cut there is a whole rawlog.
    const std::size_t second = bytes.find(std::string("\x1f\x8b\x08\0", 4), 1);
    ASSERT_NE(std::string::npos, second);
    test::writeBytes(at("cut.rawlog"), bytes.substr(0, second));
    RawlogReader reader(at("cut.rawlog"));
    const auto entries = test::entriesOf(reader);
    EXPECT_GE(entries.size(), 20u);
    EXPECT_EQ(entries.size(), reader.summary().objects);
    EXPECT_FALSE(reader.summary().truncated) << reader.summary().truncation;
}

TEST_F(RawlogWriterTest, FlushMakesTheUnfinishedFileReadable)
{
    RawlogWriter writer(at("out.rawlog"), withThreads(3));
    writeObjects(writer);
    writer.flush();
    EXPECT_EQ(expectedBytes(), unpacked(writer.partialPath()));
    EXPECT_FALSE(std::filesystem::exists(at("out.rawlog")));
}

TEST_F(RawlogWriterTest, KeepsWhatWasWrittenWhereAsked)
{
    std::filesystem::path partial;
    for (const auto unfinished : {OutputFile::Unfinished::Keep, OutputFile::Unfinished::Discard})
    {
        RawlogWriter::Options options = withThreads(2);
        options.unfinished = unfinished;
        options.existing = OutputFile::Existing::Overwrite;
        {
            RawlogWriter writer(at("out.rawlog"), options);
            writeObjects(writer);
            partial = writer.partialPath();
        }
        if (unfinished == OutputFile::Unfinished::Keep)
            EXPECT_EQ(expectedBytes(), unpacked(partial));
        else
            EXPECT_FALSE(std::filesystem::exists(partial));
    }
}

TEST_F(RawlogWriterTest, AnEmptyRawlogIsAnEmptyGzFile)
{
    RawlogWriter writer(at("empty.rawlog"), withThreads(2));
    writer.commit();
    EXPECT_EQ("\x1f\x8b", bytesOf(at("empty.rawlog")).substr(0, 2));
    EXPECT_EQ("", unpacked(at("empty.rawlog")));
}

TEST_F(RawlogWriterTest, AFullDiskIsAnErrorAndStaysOne)
{
    RawlogWriter::Options options = withThreads(2);
    options.existing = OutputFile::Existing::Overwrite;
    RawlogWriter writer("/dev/full", options);
    EXPECT_THROW(
        {
            writeObjects(writer);
            writer.commit();
        },
        std::runtime_error);
    EXPECT_THROW(writer.write(odometry(0)), std::runtime_error);
    EXPECT_THROW(writer.commit(), std::runtime_error);
}

TEST_F(RawlogWriterTest, RefusesImpossibleOptions)
{
    RawlogWriter::Options options;
    options.gzLevel = 10;
    EXPECT_THROW(RawlogWriter(at("a.rawlog"), options), std::runtime_error);
    options.gzLevel = 1;
    options.threads = -1;
    EXPECT_THROW(RawlogWriter(at("a.rawlog"), options), std::runtime_error);
    EXPECT_EQ(0u, filesInFolder());
}

}  // namespace
}  // namespace vdamf
