// SPDX-License-Identifier: BSD-3-Clause
// Union-find over numbered elements; the root of a set is its smallest element.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace vdamf
{
class DisjointSets
{
public:
    /// Entries of parents() behind the last element's, for loops over several at once.
    static constexpr std::size_t kPadding = 8;

    explicit DisjointSets(std::size_t elements) : parent_(elements + kPadding)
    {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    std::uint32_t root(std::uint32_t element)
    {
        while (parent_[element] != element)
        {
            parent_[element] = parent_[parent_[element]];
            element = parent_[element];
        }
        return element;
    }

    /// Returns the root of the united set.
    std::uint32_t unite(std::uint32_t a, std::uint32_t b)
    {
        a = root(a);
        b = root(b);
        if (a < b) return parent_[b] = a;
        return parent_[a] = b;
    }

    /// For each element one of its set that is not greater, mostly the root.
    const std::uint32_t* parents() const { return parent_.data(); }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace vdamf
