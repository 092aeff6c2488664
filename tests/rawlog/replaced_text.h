// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace vdamf
{
/// The text with another part at the first place of `what`, which it must have.
inline std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t at = text.find(what);
    if (at == std::string::npos) throw std::logic_error("the test's text has no " + what);
    return text.replace(at, what.size(), by);
}

}  // namespace vdamf
