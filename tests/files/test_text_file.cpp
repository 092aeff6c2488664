// SPDX-License-Identifier: BSD-3-Clause
// A byte order mark belongs to a file's bytes, not to its text.
#include "vdamf/files/text_file.h"

#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace vdamf
{
namespace
{
class TextFile : public TemporaryFolder
{
};

TEST_F(TextFile, IsReadWithoutItsByteOrderMark)
{
    const std::string marked =
        "\xEF\xBB\xBF"
        "1.5\n";
    EXPECT_EQ(readTextFile(make("marked.txt", marked)), "1.5\n");
    EXPECT_EQ(readBytes(at("marked.txt")), marked);
    for (const std::string text : {"", "1.5\n", "\xEF\xBB", "1\xEF\xBB\xBF"})
        EXPECT_EQ(readTextFile(make("plain.txt", text)), text);
    EXPECT_EQ(readTextFile(make("alone.txt", "\xEF\xBB\xBF")), "");
}

}  // namespace
}  // namespace vdamf
