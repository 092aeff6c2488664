// SPDX-License-Identifier: BSD-3-Clause
// One member of a gz file.
#pragma once

#include <string>
#include <string_view>

namespace vdamf
{
/// The bytes as a gz member, header and checksum included (RFC 1952), with no time and no name in
/// it: the same bytes give the same member. `level` 1..9.
std::string gzMember(std::string_view bytes, int level);

}  // namespace vdamf
