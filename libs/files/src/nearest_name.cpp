// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/files/nearest_name.h"

#include <algorithm>

namespace vdamf
{
// Optimal string alignment: the last three rows of the table of prefix distances.
std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> beforeLast(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> current(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) current[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        beforeLast.swap(last);
        last.swap(current);
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({last[j] + 1, current[j - 1] + 1, replaced});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) current[j] = std::min(current[j], beforeLast[j - 2] + 1);
        }
    }
    return current[b.size()];
}

std::string nearestName(std::string_view name, const std::vector<std::string>& candidates)
{
    // Longer names are not tables' or options' names, and the table of distances is quadratic.
    constexpr std::size_t kLongest = 100;
    if (name.size() > kLongest) return {};
    std::string nearest;
    // A third of the characters wrong is still a misspelling; more is another name.
    std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string& candidate : candidates)
    {
        if (candidate.empty() || candidate.size() > kLongest) continue;
        // A forgotten unit ("gap" for "gap_m") is nearer than any misspelling of as many letters.
        const bool isStart = name.size() >= 3 && candidate.compare(0, name.size(), name) == 0;
        const std::size_t distance = isStart ? 1 : editDistance(name, candidate);
        if (distance >= least) continue;
        least = distance;
        nearest = candidate;
    }
    return nearest;
}

}  // namespace vdamf
