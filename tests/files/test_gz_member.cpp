// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/files/gz_member.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "temporary_folder.h"

namespace vdamf
{
namespace
{
class GzMemberTest : public TemporaryFolder
{
protected:
    std::string unpacked(const std::string& member) const
    {
        const gzFile file = gzopen(make("member.gz", member).c_str(), "rb");
        std::string content(4 << 20, '\0');
        const int size = gzread(file, content.data(), static_cast<unsigned>(content.size()));
        EXPECT_EQ(Z_OK, gzclose(file));
        content.resize(static_cast<std::size_t>(std::max(0, size)));
        return content;
    }
};

TEST_F(GzMemberTest, UnpacksToTheSameBytes)
{
    std::mt19937 random(7);
    for (const std::size_t size : {0U, 1U, 1000U, 3'000'000U})
    {
        std::string bytes(size, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random() % 50);
        for (const int level : {9, 6, 1})
        {
            const std::string member = gzMember(bytes, level);
            EXPECT_TRUE(bytes == unpacked(member)) << size << " bytes, level " << level;
            EXPECT_EQ(member, gzMember(bytes, level));
        }
    }
}

// RFC 1952: neither time nor name, so that the same bytes give the same file.
TEST_F(GzMemberTest, TellsNoTimeAndNoName)
{
    const std::string member = gzMember("bytes", 1);
    ASSERT_GE(member.size(), 18U);
    EXPECT_EQ(std::string("\x1f\x8b\x08\0\0\0\0\0", 8), member.substr(0, 8));
}

}  // namespace
}  // namespace vdamf
