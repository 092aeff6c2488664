// SPDX-License-Identifier: BSD-3-Clause
// The part of an uncompressed rawlog that is being looked at.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "gz_input.h"

namespace vdamf
{
/// A window into the stream that begins at the current entry and grows on demand.
class EntryWindow
{
public:
    explicit EntryWindow(const std::filesystem::path& path) : input_(path) {}

    /// Loads so many bytes from the window's begin, if the stream has them.
    bool require(std::size_t bytes);

    /// What is loaded. Valid until the next call of require() or take().
    std::string_view loaded() const { return std::string_view(data_).substr(begin_); }

    /// Moves the window's begin forward and returns what it passes (which is loaded).
    std::string take(std::size_t bytes);

    /// Of the window's begin in the uncompressed stream.
    std::uint64_t offset() const { return offset_; }
    const GzInput& input() const { return input_; }

private:
    GzInput input_;
    std::string data_;
    std::size_t begin_ = 0;
    std::uint64_t offset_ = 0;
    bool ended_ = false;
};

}  // namespace vdamf
