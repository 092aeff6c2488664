// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/files/gz_member.h"

#include <libdeflate.h>

#include <memory>
#include <stdexcept>

namespace vdamf
{
namespace
{
struct FreeCompressor
{
    void operator()(libdeflate_compressor* compressor) const
    {
        libdeflate_free_compressor(compressor);
    }
};
}  // namespace

std::string gzMember(std::string_view bytes, int level)
{
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(level));
    if (!compressor)
    {
        throw std::runtime_error("cannot start gz compression of level " + std::to_string(level));
    }
    std::string member(libdeflate_gzip_compress_bound(compressor.get(), bytes.size()), '\0');
    member.resize(libdeflate_gzip_compress(compressor.get(), bytes.data(), bytes.size(),
                                           member.data(), member.size()));
    return member;
}

}  // namespace vdamf
