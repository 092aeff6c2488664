// SPDX-License-Identifier: BSD-3-Clause
#include "gz_input.h"

#include <unistd.h>
#include <zlib.h>

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
constexpr int kGzipWindowBits = 15 + 16;

/// The fixed part of a member's header (RFC 1952): magic, deflate, no reserved flag, and an extra
/// flag and operating system that exist, so that chance hardly ever looks like one.
bool looksLikeMember(const unsigned char* bytes)
{
    const bool magic = bytes[0] == 0x1f && bytes[1] == 0x8b && bytes[2] == 8;
    const bool flags = (bytes[3] & 0xe0) == 0 && (bytes[8] == 0 || bytes[8] == 2 || bytes[8] == 4);
    return magic && flags && (bytes[9] <= 13 || bytes[9] == 255);
}
}  // namespace

void GzInput::EndInflate::operator()(z_stream_s* stream) const
{
    inflateEnd(stream);
    delete stream;
}

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
    inflater_.reset(new z_stream_s{});
    if (inflateInit2(inflater_.get(), kGzipWindowBits) != Z_OK)
    {
        failAt(path, "cannot start gz decompression");
    }
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
    while (done < room && !finished_)
    {
        done += inflater_ ? inflateSome(to + done, room - done) : readPlain(to + done, room - done);
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

std::size_t GzInput::inflateSome(char* to, std::size_t room)
{
    if (!inMember_) beginMember();
    if (finished_) return 0;
    if (!require(1))
    {
        if (readError_.empty()) report("the gz stream ends early");
        finished_ = true;
        return 0;
    }
    z_stream_s& stream = *inflater_;
    const std::size_t limited = std::min<std::size_t>(room, 1u << 30);
    stream.next_in = input_.data() + begin_;
    stream.avail_in = static_cast<uInt>(available());
    stream.next_out = reinterpret_cast<Bytef*>(to);
    stream.avail_out = static_cast<uInt>(limited);
    const int status = inflate(&stream, Z_NO_FLUSH);
    begin_ = end_ - stream.avail_in;
    if (status == Z_STREAM_END) inMember_ = false;
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
    {
        report(std::string("the gz stream is damaged (") +
               (stream.msg != nullptr ? stream.msg : "no reason given") + ")");
        findNextMember();
    }
    return limited - stream.avail_out;
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
        inflateReset(inflater_.get());
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
            inflateReset(inflater_.get());
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
