// SPDX-License-Identifier: BSD-3-Clause
// Which cells of a plane grid are occupied, one bit each, and the occupied cells numbered in
// order: a sparse grid without a hash, small enough for the cache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vdamf
{
class CellBitmap
{
public:
    static constexpr int kMargin = 32;  ///< empty columns that a window may reach into, each side

    CellBitmap(int columns, int rows)
        : rows_(rows),
          wordsPerRow_(static_cast<std::size_t>((columns + 2 * kMargin + 63) / 64 + 1)),
          words_(wordsPerRow_ * static_cast<std::size_t>(rows)),
          before_(words_.size())
    {
    }

    void occupy(int column, int row)
    {
        const std::size_t bit = bitOf(column);
        words_[wordOf(bit, row)] |= std::uint64_t{1} << (bit % 64);
    }

    /// To be called once, between the last occupy() and the first number(). Returns the number of
    /// occupied cells.
    std::uint32_t enumerate()
    {
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < words_.size(); ++i)
        {
            before_[i] = count;
            if (words_[i] != 0) count += population(words_[i]);
        }
        return count;
    }

    /// Of an occupied cell: row by row, from the first column on.
    std::uint32_t number(int column, int row) const
    {
        const std::size_t bit = bitOf(column);
        const std::size_t word = wordOf(bit, row);
        const std::uint64_t lower = (std::uint64_t{1} << (bit % 64)) - 1;
        return before_[word] + population(words_[word] & lower);
    }

    /// Bits of `width` <= 32 cells of a row from a column on, which may be in the margin.
    std::uint64_t window(int firstColumn, int row, int width) const
    {
        const std::size_t bit = bitOf(firstColumn);
        const std::size_t word = wordOf(bit, row);
        const std::size_t shift = bit % 64;
        std::uint64_t bits = words_[word] >> shift;
        if (shift != 0) bits |= words_[word + 1] << (64 - shift);
        return bits & ((std::uint64_t{1} << width) - 1);
    }

    int rows() const { return rows_; }

    /// Number of bits that are set. Inline arithmetic: the baseline x86-64 has no instruction for
    /// it, and the compiler's own function is a call for every hit.
    static std::uint32_t population(std::uint64_t v)
    {
        v -= (v >> 1) & 0x5555555555555555U;
        v = (v & 0x3333333333333333U) + ((v >> 2) & 0x3333333333333333U);
        v = (v + (v >> 4)) & 0x0F0F0F0F0F0F0F0FU;
        return static_cast<std::uint32_t>((v * 0x0101010101010101U) >> 56);
    }

private:
    static std::size_t bitOf(int column) { return static_cast<std::size_t>(column + kMargin); }
    std::size_t wordOf(std::size_t bit, int row) const
    {
        return static_cast<std::size_t>(row) * wordsPerRow_ + bit / 64;
    }

    int rows_;
    std::size_t wordsPerRow_;
    std::vector<std::uint64_t> words_;
    std::vector<std::uint32_t> before_;  // occupied cells before each word
};

}  // namespace vdamf
