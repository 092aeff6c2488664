// SPDX-License-Identifier: BSD-3-Clause
// Damage as disks, networks and editors do it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>

namespace vdamf
{
class Mutations
{
public:
    explicit Mutations(unsigned seed) : random_(seed) {}

    std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

    /// With one to eight wounds.
    std::string of(std::string bytes)
    {
        for (std::size_t wounds = 1 + below(8); wounds > 0 && !bytes.empty(); --wounds)
            wound(bytes);
        return bytes;
    }

    /// As above, and with cells or values replaced that are numbers.
    std::string ofText(std::string text)
    {
        static const char* const kWords[] = {"",   "nan", "-inf",   "1e308", "-1", "0",
                                             "1e", "9e9", "1e-320", "0x1p4", "\"", "4294967296"};
        for (std::size_t cells = below(4); cells > 0 && !text.empty(); --cells)
        {
            const std::size_t from = text.find_first_of(",=", below(text.size()));
            if (from == std::string::npos) continue;
            const std::size_t to = std::min(text.find_first_of(",\n", from + 1), text.size());
            text.replace(from + 1, to - from - 1, kWords[below(std::size(kWords))]);
        }
        return below(2) == 0 ? of(std::move(text)) : text;
    }

private:
    void wound(std::string& bytes)
    {
        const std::size_t at = below(bytes.size());
        const std::size_t length = std::min(below(4096), bytes.size() - at);
        switch (below(7))
        {
            case 0:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
                break;
            case 1:
                bytes.insert(at, garbage(length));
                break;
            case 2:  // a size
                bytes.replace(at, std::min<std::size_t>(4, length),
                              below(2) == 0 ? std::string(4, '\xff') : garbage(4));
                break;
            case 3:
                std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), length, '\0');
                break;
            case 4:
                swapBlocks(bytes, at, length);
                break;
            case 5:
                bytes.erase(at, length);
                break;
            default:
                if (below(3) == 0) bytes.resize(at);
                break;
        }
    }

    void swapBlocks(std::string& bytes, std::size_t at, std::size_t length)
    {
        const std::size_t other = below(bytes.size() - length);
        if (other + length > at && at + length > other) return;
        std::swap_ranges(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                         bytes.begin() + static_cast<std::ptrdiff_t>(at + length),
                         bytes.begin() + static_cast<std::ptrdiff_t>(other));
    }

    std::string garbage(std::size_t length)
    {
        std::string bytes(length, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random_());
        return bytes;
    }

    std::mt19937 random_;
};

}  // namespace vdamf
