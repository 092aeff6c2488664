// SPDX-License-Identifier: BSD-3-Clause
// The header of an object in a rawlog, and how to find one in the midst of other bytes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace vdamf
{
/// `(0x80|length) name version`, or that of MRPT before 0.5.5: `length 0 0 0 name version32`. A
/// null object has the name "nullptr" and no version.
struct ObjectHeader
{
    std::string className;
    int version = 0;
    std::size_t bytes = 0;  ///< of the header

    bool isNull() const { return className == "nullptr"; }
};

constexpr std::size_t kLongestHeader = 4 + 127 + 4;

/// Behind each object, but those of MRPT before 0.5.5.
constexpr char kEndFlag = '\x88';

/// The header at the begin of the bytes, where there is one that can be: a name made of a C++
/// name's characters and a version below 255.
std::optional<ObjectHeader> parseObjectHeader(std::string_view bytes);

/// True where this MRPT can make an object of the class from a rawlog. Old names without a
/// namespace count; names of another namespace than mrpt's only if they are registered as such.
bool isReadableClass(const std::string& className);

/// True where a header begins here that may well be that of an entry: an observation, sensory
/// frame, action collection or rawlog, not a part of one.
bool beginsEntry(std::string_view bytes);

/// True where what stands here may follow an entry: beginsEntry(), a null object, or one of a class
/// that this MRPT does not know.
bool mayFollowEntry(std::string_view bytes);

/// An action or a collection of them.
bool isAction(const std::string& className);
bool isActionCollection(const std::string& className);
/// A rawlog as one object.
bool isRawlogObject(const std::string& className);

}  // namespace vdamf
