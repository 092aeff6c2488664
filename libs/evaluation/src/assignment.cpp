// SPDX-License-Identifier: BSD-3-Clause
// Optimal assignment by shortest augmenting paths with potentials (Jonker and Volgenant 1987).
#include <algorithm>
#include <cassert>
#include <limits>

#include "vdamf/evaluation/matching.h"

namespace vdamf
{
namespace
{
using Scores = std::vector<std::vector<double>>;

/// Assigns every line (the shorter side of the table) to a place of the longer side. Costs are
/// scores turned round; what is not worth a pair costs 0, so that a line without a partner can
/// stand anywhere for nothing.
class Assignment
{
public:
    explicit Assignment(const Scores& scores)
        : scores_(scores),
          linesAreRows_(scores.size() <= scores.front().size()),
          lines_(std::min(scores.size(), scores.front().size())),
          places_(std::max(scores.size(), scores.front().size())),
          linePrice_(lines_ + 1, 0.0),
          placePrice_(places_ + 1, 0.0),
          lineAt_(places_ + 1, kNone)
    {
        for (std::size_t line = 0; line < lines_; ++line) add(line);
    }

    std::vector<int> columnOfRow() const
    {
        std::vector<int> columns(scores_.size(), -1);
        for (std::size_t place = 0; place < places_; ++place)
        {
            const std::size_t line = lineAt_[place];
            if (line == kNone || cost(line, place) >= 0.0) continue;
            columns[linesAreRows_ ? line : place] = static_cast<int>(linesAreRows_ ? place : line);
        }
        return columns;
    }

private:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    double cost(std::size_t line, std::size_t place) const
    {
        const double score = linesAreRows_ ? scores_[line][place] : scores_[place][line];
        return score > 0.0 ? -score : 0.0;
    }

    /// The cheapest path from the new line to a free place, moving lines that stand on it.
    void add(std::size_t newLine)
    {
        const std::size_t start = places_;  // a place of its own, where the path begins
        lineAt_[start] = newLine;
        std::vector<double> distance(places_, std::numeric_limits<double>::infinity());
        std::vector<std::size_t> from(places_, start);
        std::vector<char> visited(places_ + 1, 0);
        std::size_t place = start;
        while (lineAt_[place] != kNone)
        {
            visited[place] = 1;
            place = step(place, distance, from, visited);
        }
        while (place != start)
        {
            lineAt_[place] = lineAt_[from[place]];
            place = from[place];
        }
    }

    /// Looks on from a visited place; returns the nearest one that is not visited.
    std::size_t step(std::size_t at, std::vector<double>& distance, std::vector<std::size_t>& from,
                     const std::vector<char>& visited)
    {
        const std::size_t line = lineAt_[at];
        std::size_t nearest = kNone;
        for (std::size_t place = 0; place < places_; ++place)
        {
            if (visited[place] != 0) continue;
            const double reduced = cost(line, place) - linePrice_[line] - placePrice_[place];
            if (reduced < distance[place])
            {
                distance[place] = reduced;
                from[place] = at;
            }
            if (nearest == kNone || distance[place] < distance[nearest]) nearest = place;
        }
        raisePrices(distance[nearest], distance, visited);
        return nearest;
    }

    void raisePrices(double by, std::vector<double>& distance, const std::vector<char>& visited)
    {
        for (std::size_t place = 0; place < places_; ++place)
        {
            if (visited[place] == 0)
            {
                distance[place] -= by;
                continue;
            }
            linePrice_[lineAt_[place]] += by;
            placePrice_[place] -= by;
        }
        linePrice_[lineAt_[places_]] += by;
    }

    const Scores& scores_;
    bool linesAreRows_;
    std::size_t lines_;
    std::size_t places_;
    std::vector<double> linePrice_;
    std::vector<double> placePrice_;
    std::vector<std::size_t> lineAt_;  // by place; the last one is where paths begin
};
}  // namespace

std::vector<int> bestAssignment(const std::vector<std::vector<double>>& scores)
{
    if (scores.empty()) return {};
    for (const std::vector<double>& row : scores)
    {
        assert(row.size() == scores.front().size());
        static_cast<void>(row);
    }
    if (scores.front().empty()) return std::vector<int>(scores.size(), -1);
    return Assignment(scores).columnOfRow();
}

}  // namespace vdamf
