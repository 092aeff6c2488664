// SPDX-License-Identifier: BSD-3-Clause
// How options describe themselves, so that the check of their ranges, the configuration file's
// reader and its writer share one list.
//
// An options struct is plain: members with defaults, in SI units (angles in radians). It lists
// its members once:
//
//     template <class Self, class Visitor>
//     static void visit(Self& self, Visitor&& field)
//     {
//         field(self.gap, "gap_m", 0.05, 2.0, "largest gap inside a cluster");
//     }
//
// Kinds of members: double, int, bool (no range), std::string (no range), and enums that specialise
// EnumNames. Keys carry the unit; a key that ends in `_deg` shows degrees of a member in radians.
#pragma once

#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace vdamf
{
/// Specialise with `static std::vector<std::pair<Enum, const char*>> names()`.
template <class Enum>
struct EnumNames;

inline bool keyIsInDegrees(std::string_view key)
{
    return key.size() > 4 && key.substr(key.size() - 4) == "_deg";
}

/// Visitor that notes every value out of range, in the key's unit.
struct RangeCheck
{
    std::vector<std::string>& problems;

    void range(double value, const char* key, double min, double max) const
    {
        const double shown = keyIsInDegrees(key) ? value * 57.29577951308232 : value;
        // Slack of an ulp or so for values that came through a conversion from degrees.
        const double slack = 1e-12 * (max - min);
        if (shown >= min - slack && shown <= max + slack) return;
        std::ostringstream text;
        text << key << " = " << shown << " is out of range: expected " << min << " to " << max;
        problems.push_back(text.str());
    }
    void operator()(const double& v, const char* key, double min, double max, const char*) const
    {
        range(v, key, min, max);
    }
    void operator()(const int& v, const char* key, int min, int max, const char*) const
    {
        range(v, key, min, max);
    }
    template <class T>
    void operator()(const T&, const char*, const char*) const
    {
    }
};

/// What is wrong with an options struct: one line a problem, naming the key. Empty: valid.
template <class Options>
std::vector<std::string> problemsOf(const Options& options)
{
    std::vector<std::string> problems;
    Options::visit(options, RangeCheck{problems});
    return problems;
}

}  // namespace vdamf
