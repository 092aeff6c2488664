// SPDX-License-Identifier: BSD-3-Clause
#include "page.h"

#include <stdexcept>

namespace vdamf
{
namespace
{
bool endsWith(std::string_view text, std::string_view end)
{
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

std::string elements(std::string_view extension, const std::string& tag)
{
    std::string all;
    for (const PageFile& file : pageFiles())
    {
        if (!endsWith(file.name, extension)) continue;
        all += "<" + tag + ">\n";
        all += file.text;
        all += "</" + tag + ">\n";
    }
    return all;
}

std::string escaped(std::string_view text)
{
    std::string html;
    for (const char c : text)
    {
        if (c == '<')
            html += "&lt;";
        else if (c == '&')
            html += "&amp;";
        else
            html += c;
    }
    return html;
}

void appendUntil(std::string& page, std::string_view& rest, const std::string& mark)
{
    const std::size_t at = rest.find(mark);
    if (at == std::string_view::npos)
        throw std::logic_error("the page's index.html has no " + mark);
    page += rest.substr(0, at);
    rest.remove_prefix(at + mark.size());
}
}  // namespace

std::string pageWith(std::string_view title, std::string_view data)
{
    std::string_view rest = pageFiles().front().text;
    std::string page;
    page.reserve(data.size() + (std::size_t{1} << 18U));
    appendUntil(page, rest, "<!--title-->");
    page += escaped(title);
    appendUntil(page, rest, "<!--styles-->");
    page += elements(".css", "style");
    appendUntil(page, rest, "<!--data-->");
    page += data;
    appendUntil(page, rest, "<!--scripts-->");
    page += elements(".js", "script");
    page += rest;
    return page;
}

}  // namespace vdamf
