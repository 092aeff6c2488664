// SPDX-License-Identifier: BSD-3-Clause
// The page's source, from libs/report/page, as the build embeds it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vdamf
{
struct PageFile
{
    std::string_view name;  ///< "index.html"
    std::string_view text;
};

/// index.html, then styles and scripts in the order of their names.
const std::vector<PageFile>& pageFiles();

/// The page around its data: index.html with the styles, the scripts and `data` (HTML elements) in
/// the places it has for them. The title is plain text.
std::string pageWith(std::string_view title, std::string_view data);

}  // namespace vdamf
