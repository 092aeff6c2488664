// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/files/gz_member.h"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>

namespace vdamf
{
namespace
{
// zlib counts in 32 bits; larger inputs go through in steps.
constexpr std::size_t kStep = std::size_t{1} << 30;
constexpr int kGzipWindowBits = 15 + 16;
constexpr int kMemoryLevel = 8;

class Deflater
{
public:
    explicit Deflater(int level)
    {
        if (deflateInit2(&stream_, level, Z_DEFLATED, kGzipWindowBits, kMemoryLevel,
                         Z_DEFAULT_STRATEGY) != Z_OK)
        {
            throw std::runtime_error("cannot start gz compression of level " +
                                     std::to_string(level));
        }
    }
    ~Deflater() { deflateEnd(&stream_); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    z_stream& stream() { return stream_; }

private:
    z_stream stream_ = {};
};
}  // namespace

std::string gzMember(std::string_view bytes, int level)
{
    Deflater deflater(level);
    z_stream& stream = deflater.stream();
    std::string member(deflateBound(&stream, bytes.size()), '\0');
    std::size_t written = 0;
    int status = Z_OK;
    while (status != Z_STREAM_END)
    {
        const std::size_t input = std::min(bytes.size(), kStep);
        const std::size_t room = std::min(member.size() - written, kStep);
        // zlib does not write through next_in; its type predates const.
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
        stream.avail_in = static_cast<uInt>(input);
        stream.next_out = reinterpret_cast<Bytef*>(member.data() + written);
        stream.avail_out = static_cast<uInt>(room);
        status = deflate(&stream, input == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
        if (status == Z_STREAM_ERROR) throw std::runtime_error("gz compression failed");
        bytes.remove_prefix(input - stream.avail_in);
        written += room - stream.avail_out;
        if (status != Z_STREAM_END && written == member.size()) member.resize(2 * member.size());
    }
    member.resize(written);
    return member;
}

}  // namespace vdamf
