// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/digest.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace vdamf
{
namespace
{
std::string inHex(const XXH128_hash_t& hash)
{
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, hash);
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : canonical.digest)
    {
        text += kDigits[byte / 16];
        text += kDigits[byte % 16];
    }
    return text;
}
}  // namespace

std::string digestOf(std::string_view bytes)
{
    return inHex(XXH3_128bits(bytes.data(), bytes.size()));
}

std::string digestOfFile(const std::filesystem::path& path)
{
    const auto fail = [&path](int error)
    {
        throw std::runtime_error(path.string() +
                                 ": cannot read: " + std::system_category().message(error));
    };
    if (std::filesystem::is_directory(path)) fail(EISDIR);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) fail(errno);
    const auto release = [](XXH3_state_t* state) { XXH3_freeState(state); };
    const std::unique_ptr<XXH3_state_t, decltype(release)> state(XXH3_createState(), release);
    if (!state) throw std::bad_alloc();
    XXH3_128bits_reset(state.get());
    std::array<char, 1 << 16> chunk = {};
    while (file.read(chunk.data(), chunk.size()), file.gcount() > 0)
        XXH3_128bits_update(state.get(), chunk.data(), static_cast<std::size_t>(file.gcount()));
    if (file.bad()) fail(errno);
    return inHex(XXH3_128bits_digest(state.get()));
}

}  // namespace vdamf
