// SPDX-License-Identifier: BSD-3-Clause
// Reads a file that is plain or gz compressed.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

struct inflate_state;  // of ISA-L

namespace vdamf
{
/// The uncompressed bytes of a file. A gz file may have any number of members. Where one is
/// damaged, what was decompressed before the damage is delivered, and reading goes on with the next
/// member that can be found; problem() tells.
class GzInput
{
public:
    /// Throws std::runtime_error: missing, unreadable, a folder.
    explicit GzInput(const std::filesystem::path& path);
    ~GzInput();
    GzInput(const GzInput&) = delete;
    GzInput& operator=(const GzInput&) = delete;

    /// Fills the room; less only at the end of the file, or where the system cannot read on:
    /// readError() tells.
    std::size_t read(char* to, std::size_t room);

    /// Why the system could not read on, and where; empty: it could.
    const std::string& readError() const { return readError_; }

    /// What is wrong with the gz stream, so far; empty: nothing.
    const std::string& problem() const { return problem_; }
    /// The uncompressed size is at most this many bytes; the largest number for pipes.
    std::uint64_t largestContent() const;
    /// Part of the file read so far, 0..1; 0 where its size is not known (pipes).
    double progress() const;

private:
    struct Close
    {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    bool isGz();
    std::size_t available() const { return end_ - begin_; }
    bool require(std::size_t bytes);
    std::size_t readPlain(char* to, std::size_t room);
    std::size_t readInflated(char* to, std::size_t room);
    void inflateMore();
    void beginMember();
    void findNextMember();
    void report(const std::string& what);

    std::unique_ptr<std::FILE, Close> file_;
    std::unique_ptr<inflate_state> inflater_;  // null: the file is plain
    std::vector<unsigned char> input_;         // compressed; [begin_, end_) is ahead
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    std::vector<unsigned char> inflated_;  // [delivered_, ready_) is ahead
    std::size_t delivered_ = 0;
    std::size_t ready_ = 0;
    bool inMember_ = false;
    bool finished_ = false;
    std::uint64_t taken_ = 0;  // from the file
    std::uint64_t fileSize_ = 0;
    std::string problem_;
    std::string readError_;
};

}  // namespace vdamf
