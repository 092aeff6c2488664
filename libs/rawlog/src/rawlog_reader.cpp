// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/rawlog_reader.h"

#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/registerAllClasses.h>

#include <stdexcept>

#include "action_extent.h"
#include "action_movement.h"
#include "entry_window.h"
#include "object_header.h"
#include "object_parser.h"
#include "timed_points_map.h"

namespace vdamf
{
namespace
{
// A file that has no object this near to its start is not a rawlog.
constexpr std::size_t kNearStart = 1 << 20;
// Bytes that belong to nothing are handed on in pieces, so that memory stays bounded.
constexpr std::size_t kLargestGap = 64 << 20;
// Where so many bytes hold no object, none follows: a sparse file may claim to have any size.
constexpr std::uint64_t kEndlessGap = std::uint64_t{1} << 30;
constexpr std::size_t kProblemsKept = 20;
constexpr char kEndFlag = '\x88';

void registerClasses()
{
    // The linker leaves a library out that nobody calls, and its classes with it.
    mrpt::obs::registerAllClasses_mrpt_obs();
    mrpt::maps::registerAllClasses_mrpt_maps();
    TimedPointsMap::registerClass();
}

/// Bytes at the end of a stream that begin like a header and stop before its end.
bool isCutHeader(std::string_view bytes)
{
    if (bytes.empty() || (bytes[0] & 0x80) == 0) return false;
    const std::size_t whole = std::size_t{1} + (static_cast<unsigned char>(bytes[0]) & 0x7f) + 1;
    return bytes.size() < whole && bytes.find('\0') == std::string_view::npos;
}

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

std::string kindOfForeignFile(std::string_view bytes)
{
    if (bytes.substr(0, 4) == "\x28\xb5\x2f\xfd") return ": it is zstd compressed, unpack it first";
    if (bytes.substr(0, 2) == "PK") return ": it is a zip file, unpack it first";
    if (bytes.substr(0, 6) == std::string_view("\xfd"
                                               "7zXZ\0",
                                               6))
        return ": it is xz compressed, unpack it first";
    return ": expected MRPT observations";
}
}  // namespace

struct RawlogReader::Impl
{
    explicit Impl(const std::filesystem::path& path) : window(path) {}

    EntryWindow window;
    RawlogSummary summary;
    int openWrappers = 0;  // rawlog objects whose end has not been met
    bool inGap = false;    // the last entry ended where the bytes of nothing go on
    std::uint64_t gapBytes = 0;
    std::string endsInside;  // what the stream ended in, if the last entry is no object

    void checkIsRawlog(const std::filesystem::path& path)
    {
        if (!window.require(1))
        {
            const std::string problem = window.input().problem();
            throw std::runtime_error(path.string() + ": not a rawlog: the file is empty" +
                                     (problem.empty() ? "" : " (" + problem + ")"));
        }
        window.require(kLongestHeader);
        const auto header = parseObjectHeader(window.loaded());
        const bool object = header && (header->isNull() || isReadableClass(header->className));
        // Of an unknown class, or damaged in its first bytes: then others follow.
        if (object) return;
        const std::size_t entry = findEntry(1, kNearStart);
        if (entry < kNearStart && entry < window.loaded().size()) return;
        const bool unknownClass = header && header->className.find("::") != std::string::npos;
        if (unknownClass) return;
        throw std::runtime_error(path.string() + ": not a rawlog" +
                                 kindOfForeignFile(window.loaded()));
    }

    /// Position in the window of the first begin of an entry from `from` on, below `limit`; the end
    /// of the stream, or `limit`, where there is none. `className`: begins also an entry where it
    /// stands behind an end flag.
    std::size_t findEntry(std::size_t from, std::size_t limit, const std::string& className = {})
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
            const bool sameClass =
                !again.empty() && bytes.compare(at - 1, again.size(), again) == 0;
            if (sameClass) return at;
        }
        return limit;
    }

    RawlogEntry take(RawlogEntry::Kind kind, std::size_t bytes, std::string problem = {})
    {
        RawlogEntry entry;
        entry.kind = kind;
        entry.offset = window.offset();
        entry.bytes = window.take(bytes);
        entry.problem = std::move(problem);
        count(entry);
        return entry;
    }

    void count(const RawlogEntry& entry)
    {
        summary.bytes += entry.bytes.size();
        switch (entry.kind)
        {
            case RawlogEntry::Kind::Object:
            case RawlogEntry::Kind::Action:
                ++summary.objects;
                return;
            case RawlogEntry::Kind::Wrapper:
                return;
            case RawlogEntry::Kind::Null:
                ++summary.nulls;
                return;
            case RawlogEntry::Kind::Unknown:
                ++summary.unknown;
                break;
            case RawlogEntry::Kind::Damaged:
                ++summary.damaged;
                break;
        }
        if (summary.problems.size() >= kProblemsKept) return;
        summary.problems.push_back("byte " + std::to_string(entry.offset) + ": " + entry.problem +
                                   " (" + std::to_string(entry.bytes.size()) + " bytes)");
    }

    RawlogEntry readEntry()
    {
        window.require(kLongestHeader);
        const auto header = parseObjectHeader(window.loaded());
        if (!header && openWrappers > 0 && window.loaded().front() == kEndFlag)
        {
            --openWrappers;
            return take(RawlogEntry::Kind::Wrapper, 1);
        }
        if (!header && isCutHeader(window.loaded())) endsInside = "the header of an object";
        if (inGap || !header) return skip(RawlogEntry::Kind::Damaged, "not the begin of an object");
        if (header->isNull()) return readNull(*header);
        if (!isReadableClass(header->className)) return readUnknown(*header);
        if (isAction(header->className)) return readAction(*header);
        if (isRawlogObject(header->className)) return readWrapper(*header);
        const ParsedObject parsed = parseObject(window);
        if (!parsed.object) return skipUnreadable(*header, parsed);
        RawlogEntry entry = take(RawlogEntry::Kind::Object, parsed.bytes);
        entry.object = parsed.object;
        return entry;
    }

    RawlogEntry readAction(const ObjectHeader& header)
    {
        const ActionExtent extent = actionExtent(window, header);
        if (extent.whole)
        {
            RawlogEntry entry = take(RawlogEntry::Kind::Action, extent.bytes);
            entry.movement = movementOf(entry.bytes);
            return entry;
        }
        if (extent.reachedEnd) endsInside = header.className;
        return skip(RawlogEntry::Kind::Damaged, header.className + ": without its end");
    }

    /// The objects inside are read as if they stood alone: MRPT would read them all at once, and
    /// the actions among them by its own parser.
    RawlogEntry readWrapper(const ObjectHeader& header)
    {
        constexpr std::size_t kCountBytes = 4;
        const std::size_t bytes = header.bytes + kCountBytes;
        if (!window.require(bytes))
        {
            endsInside = header.className;
            return skip(RawlogEntry::Kind::Damaged, header.className + ": without its end");
        }
        ++openWrappers;
        return take(RawlogEntry::Kind::Wrapper, bytes);
    }

    RawlogEntry readUnknown(const ObjectHeader& header)
    {
        RawlogEntry entry =
            skip(RawlogEntry::Kind::Unknown, "unknown class " + header.className, header.className);
        if (entry.bytes.back() != kEndFlag) endsInside = header.className;
        return entry;
    }

    RawlogEntry readNull(const ObjectHeader& header)
    {
        const bool whole =
            window.loaded().size() > header.bytes && window.loaded()[header.bytes] == kEndFlag;
        if (whole) return take(RawlogEntry::Kind::Null, header.bytes + 1);
        if (window.loaded().size() == header.bytes) endsInside = "a null object";
        return skip(RawlogEntry::Kind::Damaged, "a null object without its end");
    }

    RawlogEntry skipUnreadable(const ObjectHeader& header, const ParsedObject& parsed)
    {
        const int newest = newestVersion(header.className);
        if (newest >= 0 && header.version > newest)
        {
            return skip(RawlogEntry::Kind::Unknown,
                        header.className + " of version " + std::to_string(header.version) +
                            ", this MRPT knows it up to " + std::to_string(newest),
                        header.className);
        }
        if (parsed.reachedEnd) endsInside = header.className;
        return skip(RawlogEntry::Kind::Damaged, header.className + ": " + parsed.problem);
    }

    /// What cannot be read, up to where reading can go on.
    RawlogEntry skip(RawlogEntry::Kind kind, std::string problem, const std::string& className = {})
    {
        const std::size_t bytes = findEntry(1, kLargestGap, className);
        RawlogEntry entry = take(kind, bytes, std::move(problem));
        inGap = bytes == kLargestGap && window.require(1) && !beginsHere();
        gapBytes = inGap ? gapBytes + bytes : 0;
        return entry;
    }

    bool isInEndlessGap() const { return gapBytes >= kEndlessGap; }

    bool beginsHere()
    {
        window.require(kLongestHeader);
        return beginsEntry(window.loaded().substr(0, kLongestHeader));
    }

    void noteTruncation(const std::optional<RawlogEntry>& last)
    {
        const bool lost = last && (last->kind == RawlogEntry::Kind::Unknown ||
                                   last->kind == RawlogEntry::Kind::Damaged);
        std::string why = window.input().problem();
        if (isInEndlessGap())
            why += std::string(why.empty() ? "" : "; ") + "no object in 1 GB of bytes";
        if (why.empty() && lost && !endsInside.empty() && !window.require(1))
        {
            why = "the file ends inside " + endsInside;
        }
        if (why.empty()) return;
        summary.truncated = true;
        if (summary.truncation.empty()) summary.truncation = why;
    }
};

RawlogReader::RawlogReader(const std::filesystem::path& path)
{
    registerClasses();
    impl_ = std::make_unique<Impl>(path);
    impl_->checkIsRawlog(path);
}

RawlogReader::~RawlogReader() = default;

std::optional<RawlogEntry> RawlogReader::next()
{
    std::optional<RawlogEntry> entry;
    if (!impl_->isInEndlessGap() && impl_->window.require(1)) entry = impl_->readEntry();
    impl_->noteTruncation(entry);
    return entry;
}

const RawlogSummary& RawlogReader::summary() const
{
    return impl_->summary;
}

double RawlogReader::progress() const
{
    return impl_->window.input().progress();
}

}  // namespace vdamf
