// SPDX-License-Identifier: BSD-3-Clause
// The same scenario with other vehicles, seen from elsewhere.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "vdamf/files/ini.h"

namespace vdamf
{
/// Assignments (section.key=value) that make of a scenario one that differs as traffic does from
/// day to day: sizes of vehicles within their class (length 6 %, width and height 4 %, at most
/// twice that), and where the platform starts (up to 1 m in x, 0.3 m in y). What a tracker assumes
/// of vehicles can only be judged over many of them. Motions stay. Drawn from `seed`: the same one
/// gives the same assignments.
std::vector<std::string> variationOf(const IniDocument& scenario, std::uint64_t seed);

}  // namespace vdamf
