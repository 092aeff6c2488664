// SPDX-License-Identifier: BSD-3-Clause
#include "gz_input.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <random>

#include "../files/temporary_folder.h"
#include "vdamf/files/gz_member.h"

namespace vdamf
{
namespace
{
class GzInputTest : public TemporaryFolder
{
protected:
    // As others write it: one member, by zlib.
    std::string packed(const std::string& content) const
    {
        const gzFile file = gzopen(at("packed.gz").c_str(), "wb");
        EXPECT_EQ(static_cast<int>(content.size()),
                  gzwrite(file, content.data(), static_cast<unsigned>(content.size())));
        gzclose(file);
        return contentOf("packed.gz");
    }

    struct Read
    {
        std::string content;
        std::string problem;
    };

    Read read(const std::string& bytes, std::size_t step) const
    {
        GzInput input(make("in.gz", bytes));
        Read all;
        std::string some(step, '\0');
        while (const std::size_t size = input.read(some.data(), step))
            all.content.append(some, 0, size);
        EXPECT_EQ("", input.readError());
        all.problem = input.problem();
        return all;
    }
};

std::string noise(std::size_t size)
{
    std::mt19937_64 random(size);
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() % 23);
    return bytes;
}

// Of what repeats, a few compressed bytes stand for more than is decompressed at a time.
TEST_F(GzInputTest, GivesWhatWasCompressed)
{
    constexpr std::size_t kBlock = 128 * 1024;
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{1}, kBlock - 1, kBlock, kBlock + 1, 3 * kBlock, 40 * kBlock})
        for (const std::string& content : {noise(size), std::string(size, 'a')})
            for (const std::string& file : {packed(content), gzMember(content, 1)})
                for (const std::size_t step : {std::size_t{4096}, kBlock, 41 * kBlock})
                {
                    const Read result = read(file, step);
                    EXPECT_TRUE(content == result.content) << size << " in steps of " << step;
                    EXPECT_EQ("", result.problem) << size << " in steps of " << step;
                }
}

TEST_F(GzInputTest, GivesAllBeforeADamage)
{
    constexpr std::size_t kSize = 300'000;
    const std::string content = noise(kSize);
    const std::string file = packed(content);
    for (int part = 1; part < 8; ++part)
    {
        const std::size_t at = part * file.size() / 8;
        std::string cut = file.substr(0, at);
        std::string damaged = file;
        std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(at), 300, '\xff');
        for (const std::size_t step : {std::size_t{100}, kSize})
        {
            const Read ofCut = read(cut, step);
            const Read ofDamaged = read(damaged, step);
            // The bytes of noise are alike: so many of them stand before that place.
            const std::size_t least = part * kSize / 8 - kSize / 50;
            EXPECT_GE(ofCut.content.size(), least);
            EXPECT_TRUE(content.compare(0, ofCut.content.size(), ofCut.content) == 0);
            EXPECT_NE(std::string::npos, ofCut.problem.find("ends early")) << ofCut.problem;
            EXPECT_GE(ofDamaged.content.size(), least);
            EXPECT_TRUE(content.compare(0, least, ofDamaged.content, 0, least) == 0);
            EXPECT_NE(std::string::npos, ofDamaged.problem.find("damaged (")) << ofDamaged.problem;
        }
    }
}

TEST_F(GzInputTest, TellsAWrongChecksum)
{
    const std::string content = noise(1000);
    std::string file = packed(content);
    file[file.size() - 8] ^= 1;
    const Read result = read(file, 4096);
    EXPECT_EQ(content, result.content);
    EXPECT_NE(std::string::npos, result.problem.find("damaged (wrong checksum)")) << result.problem;
}

TEST_F(GzInputTest, GoesOnWithTheNextMember)
{
    const std::string first = noise(200'000);
    const std::string second = noise(300'000);
    EXPECT_TRUE(first + second == read(packed(first) + gzMember(second, 6), 5000).content);
    std::string damaged = packed(first);
    std::fill_n(damaged.begin() + 1000, 300, '\xff');
    const Read result = read(damaged + gzMember(second, 6), 5000);
    ASSERT_GT(result.content.size(), second.size());
    EXPECT_TRUE(second == result.content.substr(result.content.size() - second.size()));
    EXPECT_NE(std::string::npos, result.problem.find("reading goes on")) << result.problem;
}

}  // namespace
}  // namespace vdamf
