// SPDX-License-Identifier: BSD-3-Clause
// Bytes as text that can stand in a page.
#pragma once

#include <string>
#include <string_view>

namespace vdamf
{
/// RFC 4648, section 4, with padding, in one line.
std::string base64(std::string_view bytes);

}  // namespace vdamf
