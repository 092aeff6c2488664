// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/rawlog_reader.h"

#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/registerAllClasses.h>

#include <stdexcept>

#include "action_extent.h"
#include "action_movement.h"
#include "entry_search.h"
#include "entry_window.h"
#include "object_header.h"
#include "object_parser.h"
#include "timed_points_map.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
// A file that has no object this near to its start is not a rawlog.
constexpr std::size_t kNearStart = 1 << 20;
// Bytes that belong to nothing are handed on in pieces, so that memory stays bounded: the first one
// may be an unknown object; those behind it are small enough for their memory to be used again.
constexpr std::size_t kLargestGap = 64 << 20;
constexpr std::size_t kPieceOfGap = 16 << 20;
// Where so many bytes hold no object, none follows: a sparse file may claim to have any size.
constexpr std::uint64_t kEndlessGap = std::uint64_t{1} << 30;
constexpr std::size_t kProblemsKept = 20;

/// Once: it takes longer than reading a small rawlog.
void registerClasses()
{
    static const bool done = []
    {
        // The linker leaves a library out that nobody calls, and its classes with it.
        mrpt::obs::registerAllClasses_mrpt_obs();
        mrpt::maps::registerAllClasses_mrpt_maps();
        TimedPointsMap::registerClass();
        return true;
    }();
    static_cast<void>(done);
}

/// Bytes at the end of a stream that begin like a header and stop before its end.
bool isCutHeader(std::string_view bytes)
{
    if (bytes.empty() || (bytes[0] & 0x80) == 0) return false;
    const std::size_t whole = std::size_t{1} + (static_cast<unsigned char>(bytes[0]) & 0x7f) + 1;
    return bytes.size() < whole && bytes.find('\0') == std::string_view::npos;
}

std::string kindOfForeignFile(std::string_view bytes)
{
    if (bytes.substr(0, 4) == "\x28\xb5\x2f\xfd") return ": it is zstd compressed, unpack it first";
    if (bytes.substr(0, 2) == "PK") return ": it is a zip file, unpack it first";
    if (bytes.substr(0, 6) == std::string_view("\xfd"
                                               "7zXZ\0",
                                               6))
        return ": it is xz compressed, unpack it first";
    for (const char* const capture : {"\xd4\xc3\xb2\xa1", "\xa1\xb2\xc3\xd4", "\x4d\x3c\xb2\xa1",
                                      "\xa1\xb2\x3c\x4d", "\x0a\x0d\x0d\x0a"})
        if (bytes.substr(0, 4) == capture)
            return ": it is a network capture, import it with vdamf-import velodyne-pcap";
    if (bytes.substr(0, 6) == "# .PCD" || bytes.substr(0, 3) == "ply")
        return ": it is a point cloud, import its folder with vdamf-import clouds";
    if (bytes.substr(0, 7) == "#ROSBAG" || bytes.substr(0, 15) == "SQLite format 3" ||
        bytes.substr(0, 5) == "\x89MCAP")
        return ": it is a ROS bag, export it to MRPT or to point clouds first";
    return ": expected MRPT observations";
}
}  // namespace

struct RawlogReader::Impl
{
    explicit Impl(const std::filesystem::path& file) : path(file), window(file) {}

    std::filesystem::path path;
    EntryWindow window;
    RawlogSummary summary;
    int openWrappers = 0;  // rawlog objects whose end has not been met
    bool inGap = false;    // the last entry ended where the bytes of nothing go on
    std::uint64_t gapBytes = 0;
    std::string endsInside;  // what the stream ended in, if the last entry is no object

    void checkIsRawlog()
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
        const std::size_t entry = findEntry(window, 1, kNearStart);
        if (entry < kNearStart && entry < window.loaded().size()) return;
        const bool unknownClass = header && header->className.find("::") != std::string::npos;
        if (unknownClass) return;
        throw std::runtime_error(path.string() + ": not a rawlog" +
                                 kindOfForeignFile(window.loaded()));
    }

    RawlogEntry take(RawlogEntry::Kind kind, std::size_t bytes, const std::string& problem = {})
    {
        RawlogEntry entry;
        entry.kind = kind;
        entry.offset = window.offset();
        entry.bytes = window.take(bytes);
        entry.problem = printable(problem);
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
        const std::size_t most = inGap ? kPieceOfGap : kLargestGap;
        const std::size_t bytes = findEntry(window, 1, most, className);
        RawlogEntry entry = take(kind, bytes, std::move(problem));
        inGap = bytes == most && window.require(1) && !beginsHere();
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
        const bool ended = window.input().readError().empty() && !window.require(1);
        if (isInEndlessGap())
            why += std::string(why.empty() ? "" : "; ") + "no object in 1 GB of bytes";
        if (why.empty() && lost && !endsInside.empty() && ended)
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
    impl_->checkIsRawlog();
}

RawlogReader::~RawlogReader() = default;

std::optional<RawlogEntry> RawlogReader::next()
{
    std::optional<RawlogEntry> entry;
    if (!impl_->isInEndlessGap() && impl_->window.require(1)) entry = impl_->readEntry();
    impl_->noteTruncation(entry);
    const std::string& error = impl_->window.input().readError();
    if (!entry && !error.empty()) throw ReadError(impl_->path.string() + ": read error: " + error);
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
