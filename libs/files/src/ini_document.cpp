// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "vdamf/files/ini.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
template <class Sections>
auto* findSection(Sections& sections, std::string_view name)
{
    const auto found = std::find_if(sections.begin(), sections.end(),
                                    [&](const IniSection& s) { return s.name == name; });
    return found == sections.end() ? nullptr : &*found;
}

template <class Entries>
auto* findEntry(Entries& entries, std::string_view key)
{
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const IniEntry& e) { return e.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

bool startsWithMark(std::string_view text)
{
    return !text.empty() && (text[0] == '#' || text[0] == ';' || text.substr(0, 2) == "//");
}

// Everything up to a comment mark at the start or behind a blank.
std::string_view withoutComment(std::string_view text)
{
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const bool mayStart = i == 0 || text[i - 1] == ' ' || text[i - 1] == '\t';
        if (mayStart && startsWithMark(text.substr(i))) return text.substr(0, i);
    }
    return text;
}

class Parser
{
public:
    explicit Parser(const std::string& fileName) : fileName_(fileName) {}

    void take(std::string_view rawLine)
    {
        ++line_;
        const std::string_view text = trimmed(withoutComment(rawLine));
        if (text.empty()) return;
        const std::size_t equals = text.find('=');
        if (text.front() == '[')
        {
            takeSection(text);
        }
        else if (equals != std::string_view::npos)
        {
            takeEntry(trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1)));
        }
        else
        {
            fail("expected '[section]' or 'key = value', found " + inQuotes(text));
        }
    }

    std::vector<IniSection> sections() && { return std::move(sections_); }

private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw std::runtime_error(fileName_ + ":" + std::to_string(line_) + ": " + what);
    }

    void takeSection(std::string_view text)
    {
        if (text.back() != ']') fail("expected ']' at the end of " + inQuotes(text));
        const std::string name(trimmed(text.substr(1, text.size() - 2)));
        if (name.empty()) fail("the section has no name");
        if (const IniSection* first = findSection(sections_, name))
        {
            fail("section " + inQuotes(name) + " stands already in line " +
                 std::to_string(first->line) + "; join the two");
        }
        sections_.push_back({name, line_, {}});
    }

    void takeEntry(std::string_view key, std::string_view value)
    {
        if (key.empty()) fail("there is no key before '='");
        if (sections_.empty()) fail("key " + inQuotes(key) + " stands before the first [section]");
        IniSection& section = sections_.back();
        if (const IniEntry* first = findEntry(section.entries, key))
        {
            fail("key " + inQuotes(section.name + "." + std::string(key)) +
                 " stands already in line " + std::to_string(first->line) + "; remove one");
        }
        section.entries.push_back({std::string(key), std::string(value), line_});
    }

    const std::string& fileName_;
    int line_ = 0;
    std::vector<IniSection> sections_;
};
}  // namespace

bool standsInIni(std::string_view value)
{
    return value.find_first_of("\r\n") == std::string_view::npos &&
           trimmed(withoutComment(value)) == value;
}

IniDocument IniDocument::parse(std::string_view text, std::string fileName)
{
    text = withoutByteOrderMark(text);
    Parser parser(fileName);
    while (!text.empty())
    {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        parser.take(text.substr(0, end));
        const std::size_t mark = text.substr(end, 2) == "\r\n" ? 2 : 1;
        text.remove_prefix(std::min(end + mark, text.size()));
    }
    IniDocument document;
    document.sections_ = std::move(parser).sections();
    document.fileName_ = std::move(fileName);
    return document;
}

IniDocument IniDocument::load(const std::filesystem::path& path)
{
    constexpr std::size_t kLargest = 4 << 20;
    return parse(readTextFile(path, kLargest), path.string());
}

void IniDocument::set(std::string_view assignment)
{
    const std::size_t equals = assignment.find('=');
    const std::string_view name = trimmed(assignment.substr(0, equals));
    const std::size_t dot = name.rfind('.');
    if (equals == std::string_view::npos || dot == std::string_view::npos || dot == 0 ||
        dot + 1 == name.size())
    {
        throw std::runtime_error("expected section.key=value, found " + inQuotes(assignment));
    }
    const std::string sectionName(trimmed(name.substr(0, dot)));
    const std::string key(trimmed(name.substr(dot + 1)));
    IniSection* section = findSection(sections_, sectionName);
    if (section == nullptr) section = &sections_.emplace_back(IniSection{sectionName, 0, {}});
    IniEntry* entry = findEntry(section->entries, key);
    if (entry == nullptr) entry = &section->entries.emplace_back(IniEntry{key, {}, 0});
    entry->value = std::string(trimmed(assignment.substr(equals + 1)));
    entry->line = 0;
}

const IniSection* IniDocument::find(std::string_view section) const
{
    return findSection(sections_, section);
}

const IniEntry* IniDocument::find(std::string_view section, std::string_view key) const
{
    const IniSection* const found = find(section);
    return found == nullptr ? nullptr : findEntry(found->entries, key);
}

std::string IniDocument::placeOf(std::string_view section, std::string_view key) const
{
    const IniEntry* const entry = find(section, key);
    if (entry == nullptr) return fileName_;
    return entry->line > 0 ? fileName_ + ":" + std::to_string(entry->line) : "--set";
}

std::filesystem::path IniDocument::fileOf(std::string_view section, std::string_view key,
                                          const std::filesystem::path& name) const
{
    const IniEntry* const entry = find(section, key);
    if (entry != nullptr && entry->line == 0) return name;
    return std::filesystem::path(fileName_).parent_path() / name;
}

}  // namespace vdamf
