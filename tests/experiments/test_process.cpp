// SPDX-License-Identifier: BSD-3-Clause
// Other programs, and their ends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "files/temporary_folder.h"
#include "vdamf/experiments/digest.h"
#include "vdamf/experiments/process.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;

class Process : public TemporaryFolder
{
};

TEST_F(Process, RunsWithoutAShell)
{
    const auto log = at("log.txt");
    EXPECT_EQ(runProgram({"/bin/echo", "$HOME;", "a b"}, log), 0);
    EXPECT_THAT(contentOf("log.txt"), HasSubstr("\n$HOME; a b\n"));
    EXPECT_EQ(runProgram({"/bin/sh", "-c", "echo no >&2; exit 3"}, log), 3);
    EXPECT_EQ(lastWords(log), "no");
    EXPECT_EQ(runProgram({"/bin/sh", "-c", "kill -9 $$"}, log), 137);
    EXPECT_THAT(errorOf([&] { runProgram({"/no/such/program"}, log); }),
                HasSubstr("/no/such/program"));
}

TEST_F(Process, EndsWithItsOwner)
{
    pid_t id = 0;
    {
        ChildProcess sleeper({"sleep", "100"}, at("log.txt"));
        id = sleeper.id();
        EXPECT_EQ(sleeper.poll(), std::nullopt);
        EXPECT_EQ(::kill(id, 0), 0);
    }
    EXPECT_EQ(::kill(id, 0), -1);
    ChildProcess sleeper({"sleep", "100"}, at("log.txt"));
    sleeper.signal(SIGTERM);
    EXPECT_EQ(exitInWords(sleeper.wait()), "was ended by signal 15 (Terminated)");
    EXPECT_EQ(exitInWords(2), "ended with code 2");
}

TEST_F(Process, LogsWithoutWords)
{
    EXPECT_EQ(lastWords(make("log.txt", "first\n second line \n\n  \n")), "second line");
    EXPECT_EQ(lastWords(make("log.txt", "one")), "one");
    EXPECT_EQ(lastWords(make("log.txt", "\n \n")), "");
}

class Digest : public TemporaryFolder
{
};

TEST_F(Digest, OfBytesAndOfFiles)
{
    // Known values of XXH3 with 128 bits.
    EXPECT_EQ(digestOf(""), "99aa06d3014798d86001c324468d497f");
    const std::string bytes(300000, 'x');
    EXPECT_EQ(digestOfFile(make("file", bytes)), digestOf(bytes));
    EXPECT_NE(digestOf(bytes), digestOf(bytes + "y"));
    EXPECT_THAT(errorOf([&] { digestOfFile(at("none")); }), HasSubstr("none: cannot read"));
    EXPECT_THAT(errorOf([&] { digestOfFile(at("")); }), HasSubstr("cannot read"));
}

}  // namespace
}  // namespace vdamf
