// SPDX-License-Identifier: BSD-3-Clause
#include "entry_window.h"

#include <algorithm>

namespace vdamf
{
namespace
{
constexpr std::uint64_t kBlock = 256 * 1024;
constexpr std::uint64_t kLeastBlock = 4 * 1024;
}  // namespace

bool EntryWindow::require(std::size_t bytes)
{
    if (data_.size() - begin_ >= bytes) return true;
    if (ended_) return false;
    data_.erase(0, begin_);
    begin_ = 0;
    const auto block = std::clamp(std::min(kBlock, input_.largestContent()), kLeastBlock, kBlock);
    while (data_.size() < bytes && !ended_)
    {
        // Block by block: a size from a corrupt file must not make the window larger than the file.
        const std::size_t before = data_.size();
        data_.resize(before + block);
        const std::size_t got = input_.read(data_.data() + before, block);
        data_.resize(before + got);
        ended_ = got < block;
    }
    return data_.size() >= bytes;
}

std::string EntryWindow::take(std::size_t bytes)
{
    std::string taken = data_.substr(begin_, bytes);
    begin_ += taken.size();
    offset_ += taken.size();
    return taken;
}

}  // namespace vdamf
