// SPDX-License-Identifier: BSD-3-Clause
#include "action_extent.h"

namespace vdamf
{
namespace
{
// Particles of a robot's pose take 32 bytes each.
constexpr std::size_t kLargestAction = 64 << 20;

/// How its end looks: a collection ends with its own flag behind that of its last action; objects
/// of MRPT before 0.5.5 have no flags.
struct EndFlags
{
    std::size_t flags = 1;
    std::size_t earliest = 0;  ///< first byte of the flags at the earliest
};

EndFlags endOf(EntryWindow& window, const ObjectHeader& header)
{
    constexpr std::size_t kCountBytes = 4;
    window.require(header.bytes + kCountBytes);
    const std::string_view bytes = window.loaded();
    if ((bytes[0] & 0x80) == 0) return {0, header.bytes};
    if (!isActionCollection(header.className)) return {1, header.bytes};
    const bool empty = bytes.substr(header.bytes, kCountBytes) == std::string_view("\0\0\0\0", 4);
    return {empty ? std::size_t{1} : std::size_t{2}, header.bytes + kCountBytes};
}
}  // namespace

ActionExtent actionExtent(EntryWindow& window, const ObjectHeader& header)
{
    const EndFlags end = endOf(window, header);
    const std::string flags(end.flags, kEndFlag);
    for (std::size_t at = end.earliest; at < kLargestAction; ++at)
    {
        const std::size_t behind = at + end.flags;
        window.require(behind + kLongestHeader);
        const std::string_view bytes = window.loaded();
        if (at >= bytes.size()) return {bytes.size(), end.flags == 0, true};
        const bool flagged = bytes.compare(at, end.flags, flags) == 0;
        if (flagged && behind == bytes.size()) return {behind, true, false};
        if (flagged && mayFollowEntry(bytes.substr(behind))) return {behind, true, false};
        if (beginsEntry(bytes.substr(at, kLongestHeader))) return {at, false, false};
    }
    return {kLargestAction, false, false};
}

}  // namespace vdamf
