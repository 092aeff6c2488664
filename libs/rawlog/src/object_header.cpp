// SPDX-License-Identifier: BSD-3-Clause
#include "object_header.h"

#include <mrpt/obs/CAction.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CSerializable.h>

#include <algorithm>
#include <cstdint>

namespace vdamf
{
namespace
{
using ClassId = mrpt::rtti::TRuntimeClassId;

constexpr std::size_t kShortestName = 2;
constexpr std::size_t kLongestName = 120;
// Versions of MRPT's classes are counted in ones; none has come to this in twenty years.
constexpr int kPlausibleVersion = 64;

bool isNameCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == ':' || c == '<' || c == '>' || c == ',';
}

bool isName(std::string_view name)
{
    const bool letterFirst = !name.empty() && (name.front() < '0' || name.front() > '9');
    return name.size() >= kShortestName && letterFirst &&
           std::all_of(name.begin(), name.end(), isNameCharacter);
}

std::uint8_t byteAt(std::string_view bytes, std::size_t i)
{
    return static_cast<std::uint8_t>(bytes[i]);
}

std::optional<ObjectHeader> parseNew(std::string_view bytes)
{
    const std::size_t length = byteAt(bytes, 0) & 0x7f;
    if (length > kLongestName || bytes.size() < 1 + length) return std::nullopt;
    const std::string_view name = bytes.substr(1, length);
    if (!isName(name)) return std::nullopt;
    ObjectHeader header{std::string(name), 0, 1 + length};
    if (header.isNull()) return header;
    if (bytes.size() < header.bytes + 1) return std::nullopt;
    header.version = byteAt(bytes, header.bytes);
    ++header.bytes;
    return header;
}

std::optional<ObjectHeader> parseOld(std::string_view bytes)
{
    constexpr std::size_t kLengthBytes = 4;
    constexpr std::size_t kVersionBytes = 4;
    const std::size_t length = byteAt(bytes, 0);
    if (length > kLongestName || bytes.size() < kLengthBytes + length + kVersionBytes ||
        bytes.substr(1, kLengthBytes - 1) != std::string_view("\0\0\0", kLengthBytes - 1))
    {
        return std::nullopt;
    }
    const std::string_view name = bytes.substr(kLengthBytes, length);
    const std::string_view version = bytes.substr(kLengthBytes + length, kVersionBytes);
    const bool small = version.substr(1) == std::string_view("\0\0\0", kVersionBytes - 1);
    if (!isName(name) || !small) return std::nullopt;
    return ObjectHeader{std::string(name), byteAt(version, 0),
                        kLengthBytes + length + kVersionBytes};
}

const ClassId* readableClass(const std::string& name)
{
    const bool mayBeShort = name.rfind("mrpt::", 0) == 0 || name.find("::") == std::string::npos;
    const ClassId* id = mrpt::rtti::findRegisteredClass(name, mayBeShort);
    const bool readable = id != nullptr && id->ptrCreateObject &&
                          id->derivedFrom(CLASS_ID(mrpt::serialization::CSerializable));
    return readable ? id : nullptr;
}

bool isEntryClass(const ClassId& id)
{
    return id.derivedFrom(CLASS_ID(mrpt::obs::CObservation)) ||
           id.derivedFrom(CLASS_ID(mrpt::obs::CSensoryFrame)) ||
           id.derivedFrom(CLASS_ID(mrpt::obs::CActionCollection)) ||
           id.derivedFrom(CLASS_ID(mrpt::obs::CRawlog));
}
}  // namespace

std::optional<ObjectHeader> parseObjectHeader(std::string_view bytes)
{
    if (bytes.empty()) return std::nullopt;
    return (byteAt(bytes, 0) & 0x80) != 0 ? parseNew(bytes) : parseOld(bytes);
}

bool isReadableClass(const std::string& className)
{
    return readableClass(className) != nullptr;
}

bool beginsEntry(std::string_view bytes)
{
    // Cheap first: nearly every byte fails here.
    constexpr std::size_t kOldNameAt = 4;
    if (bytes.size() <= kOldNameAt) return false;
    const char first = (byteAt(bytes, 0) & 0x80) != 0 ? bytes[1] : bytes[kOldNameAt];
    if (first != 'C' && first != 'm') return false;
    const std::optional<ObjectHeader> header = parseObjectHeader(bytes);
    if (!header || header->isNull() || header->version >= kPlausibleVersion) return false;
    const ClassId* id = readableClass(header->className);
    return id != nullptr && isEntryClass(*id);
}

bool mayFollowEntry(std::string_view bytes)
{
    if (beginsEntry(bytes)) return true;
    const std::optional<ObjectHeader> header = parseObjectHeader(bytes);
    if (!header) return false;
    if (header->isNull()) return true;
    // Names that chance does not make of numbers.
    constexpr std::size_t kShortestUnknown = 6;
    const std::string& name = header->className;
    const bool looksLikeClass = name.size() >= kShortestUnknown &&
                                (name.front() == 'C' || name.find("::") != std::string::npos);
    return looksLikeClass && header->version < kPlausibleVersion && !isReadableClass(name);
}

bool isAction(const std::string& className)
{
    const ClassId* id = readableClass(className);
    return id != nullptr && (id->derivedFrom(CLASS_ID(mrpt::obs::CAction)) ||
                             id->derivedFrom(CLASS_ID(mrpt::obs::CActionCollection)));
}

bool isRawlogObject(const std::string& className)
{
    const ClassId* id = readableClass(className);
    return id != nullptr && id->derivedFrom(CLASS_ID(mrpt::obs::CRawlog));
}

bool isActionCollection(const std::string& className)
{
    const ClassId* id = readableClass(className);
    return id != nullptr && id->derivedFrom(CLASS_ID(mrpt::obs::CActionCollection));
}

}  // namespace vdamf
