// SPDX-License-Identifier: BSD-3-Clause
#include "gz_input.h"

#include <isa-l/igzip_lib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <system_error>

#include "fail_at.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

constexpr std::uintmax_t kInputBytes = 256 * 1024;
constexpr std::uintmax_t kLeastInputBytes = 4 * 1024;
constexpr std::size_t kHeaderBytes = 10;
// Takes all that ISA-L holds back: what comes before a damage is delivered.
constexpr std::size_t kInflatedBytes = 128 * 1024;
static_assert(kInflatedBytes > sizeof(inflate_state::tmp_out_buffer));

/// The fixed part of a member's header (RFC 1952): magic, deflate, no reserved flag, and an extra
/// flag and operating system that exist, so that chance hardly ever looks like one.
bool looksLikeMember(const unsigned char* bytes)
{
    const bool magic = bytes[0] == 0x1f && bytes[1] == 0x8b && bytes[2] == 8;
    const bool flags = (bytes[3] & 0xe0) == 0 && (bytes[8] == 0 || bytes[8] == 2 || bytes[8] == 4);
    return magic && flags && (bytes[9] <= 13 || bytes[9] == 255);
}
void restart(inflate_state& inflater)
{
    isal_inflate_init(&inflater);
    inflater.crc_flag = ISAL_GZIP;
}

const char* reasonOf(int status)
{
    switch (status)
    {
        case ISAL_INVALID_BLOCK:
            return "invalid block";
        case ISAL_INVALID_SYMBOL:
            return "invalid symbol";
        case ISAL_INVALID_LOOKBACK:
            return "reference to bytes before its begin";
        case ISAL_INVALID_WRAPPER:
            return "invalid header";
        case ISAL_UNSUPPORTED_METHOD:
            return "unknown compression method";
        case ISAL_INCORRECT_CHECKSUM:
            return "wrong checksum";
        default:
            return "no reason given";
    }
}
}  // namespace

GzInput::GzInput(const fs::path& path)
{
    std::error_code error;
    if (fs::is_directory(path, error)) failAt(path, "cannot read: this is a folder; name a rawlog");
    file_.reset(std::fopen(path.c_str(), "rb"));
    if (!file_) failAt(path, "cannot read: " + std::system_category().message(errno));
    const std::uintmax_t size = fs::file_size(path, error);
    fileSize_ = error ? 0 : size;
    // Small files are read faster into little memory.
    input_.resize(fileSize_ == 0 ? kInputBytes
                                 : std::clamp(fileSize_ + 1, kLeastInputBytes, kInputBytes));
    const bool gz = isGz();
    if (!readError_.empty()) failAt(path, "cannot read: " + readError_);
    if (!gz) return;
    inflater_.reset(new inflate_state);
    inflated_.resize(kInflatedBytes);
}

GzInput::~GzInput() = default;

bool GzInput::isGz()
{
    constexpr std::size_t kMagicBytes = 3;
    return require(kMagicBytes) && input_[0] == 0x1f && input_[1] == 0x8b && input_[2] == 8;
}

/// Makes at least so many compressed bytes available, if the file has them.
bool GzInput::require(std::size_t bytes)
{
    if (available() >= bytes) return true;
    if (!readError_.empty()) return false;
    std::memmove(input_.data(), input_.data() + begin_, available());
    end_ -= begin_;
    begin_ = 0;
    while (end_ < bytes)
    {
        // Not by stdio, which would wait for all of the block on a pipe.
        const ssize_t got =
            ::read(::fileno(file_.get()), input_.data() + end_, input_.size() - end_);
        if (got < 0 && errno == EINTR)
        {
            // Whoever lets a signal end the waiting for a pipe wants no more.
            report("reading was interrupted");
            return false;
        }
        if (got < 0)
        {
            readError_ = std::system_category().message(errno) + " at byte " +
                         std::to_string(taken_) + " of the file";
            return false;
        }
        if (got == 0) return false;
        end_ += static_cast<std::size_t>(got);
        taken_ += static_cast<std::uint64_t>(got);
    }
    return true;
}

std::size_t GzInput::read(char* to, std::size_t room)
{
    std::size_t done = 0;
    while (done < room && (delivered_ < ready_ || !finished_))
    {
        done +=
            inflater_ ? readInflated(to + done, room - done) : readPlain(to + done, room - done);
    }
    return done;
}

std::size_t GzInput::readPlain(char* to, std::size_t room)
{
    finished_ = !require(1);
    const std::size_t size = std::min(room, available());
    std::memcpy(to, input_.data() + begin_, size);
    begin_ += size;
    return size;
}

std::size_t GzInput::readInflated(char* to, std::size_t room)
{
    if (delivered_ == ready_) inflateMore();
    const std::size_t size = std::min(room, ready_ - delivered_);
    std::memcpy(to, inflated_.data() + delivered_, size);
    delivered_ += size;
    return size;
}

void GzInput::inflateMore()
{
    if (!inMember_) beginMember();
    // What filled all the room may not have been all.
    const bool mayHoldMore = ready_ == inflated_.size();
    delivered_ = ready_ = 0;
    if (finished_) return;
    if (!mayHoldMore && !require(1))
    {
        if (readError_.empty()) report("the gz stream ends early");
        finished_ = true;
        return;
    }
    inflate_state& inflater = *inflater_;
    inflater.next_in = input_.data() + begin_;
    inflater.avail_in = static_cast<std::uint32_t>(available());
    inflater.next_out = inflated_.data();
    inflater.avail_out = static_cast<std::uint32_t>(inflated_.size());
    const int status = isal_inflate(&inflater);
    begin_ = end_ - inflater.avail_in;
    ready_ = inflated_.size() - inflater.avail_out;
    if (inflater.block_state == ISAL_BLOCK_FINISH) inMember_ = false;
    if (status >= 0) return;
    report(std::string("the gz stream is damaged (") + reasonOf(status) + ")");
    findNextMember();
}

/// At the begin of the file or behind a member: another one, or the end.
void GzInput::beginMember()
{
    if (!require(1))
    {
        finished_ = true;
        return;
    }
    const bool isMember = require(2) && input_[begin_] == 0x1f && input_[begin_ + 1] == 0x8b;
    if (isMember)
    {
        restart(*inflater_);
        inMember_ = true;
        return;
    }
    report("there are bytes behind the gz stream that are none of it");
    findNextMember();
}

void GzInput::findNextMember()
{
    inMember_ = false;
    while (require(kHeaderBytes))
    {
        for (; available() >= kHeaderBytes; ++begin_)
        {
            if (!looksLikeMember(input_.data() + begin_)) continue;
            report("reading goes on");
            restart(*inflater_);
            inMember_ = true;
            return;
        }
    }
    finished_ = true;
}

void GzInput::report(const std::string& what)
{
    constexpr std::size_t kEnough = 500;
    if (problem_.size() > kEnough) return;
    if (!problem_.empty()) problem_ += "; ";
    problem_ += what + " at byte " + std::to_string(taken_ - available()) + " of the file";
}

std::uint64_t GzInput::largestContent() const
{
    constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();
    constexpr std::uint64_t kDeflateAtBest = 1032;  // zlib's technical details
    const std::uint64_t factor = inflater_ ? kDeflateAtBest : 1;
    return fileSize_ == 0 || fileSize_ > kUnknown / factor ? kUnknown : fileSize_ * factor;
}

double GzInput::progress() const
{
    if (fileSize_ == 0) return 0.0;
    const auto ahead = static_cast<double>(available());
    return std::min(1.0, (static_cast<double>(taken_) - ahead) / static_cast<double>(fileSize_));
}

}  // namespace vdamf
