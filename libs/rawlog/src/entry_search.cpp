// SPDX-License-Identifier: BSD-3-Clause
#include "entry_search.h"

#include <algorithm>
#include <string_view>

#include "object_header.h"

namespace vdamf
{
namespace
{
// The next place from which the name of an entry's class, or one that begins with `initial`, may
// follow in one of the two forms of a header: all that is asked of most bytes of a hole. Near the
// end of the bytes every place may be one.
std::size_t nextNameAt(std::string_view bytes, std::size_t at, char initial)
{
    constexpr std::size_t kOldNameAt = 4;
    const auto beginsName = [initial](char c) { return c == 'C' || c == 'm' || c == initial; };
    while (at + kLongestHeader < bytes.size() && !beginsName(bytes[at + 1]) &&
           !beginsName(bytes[at + kOldNameAt]))
    {
        ++at;
    }
    return at;
}
}  // namespace

std::size_t findEntry(EntryWindow& window, std::size_t from, std::size_t limit,
                      const std::string& className)
{
    const std::string again =
        className.empty()
            ? std::string()
            : kEndFlag + std::string(1, static_cast<char>(0x80 | className.size())) + className;
    const char initial = className.empty() ? 'C' : className.front();
    for (std::size_t at = from; at < limit; ++at)
    {
        window.require(at + kLongestHeader);
        const std::string_view bytes = window.loaded();
        at = std::min(nextNameAt(bytes, at, initial), limit - 1);
        if (at >= bytes.size()) return bytes.size();
        if (beginsEntry(bytes.substr(at, kLongestHeader))) return at;
        const bool sameClass = !again.empty() && bytes.compare(at - 1, again.size(), again) == 0;
        if (sameClass) return at;
    }
    return limit;
}

}  // namespace vdamf
