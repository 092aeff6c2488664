// SPDX-License-Identifier: BSD-3-Clause
// Makes MRPT read one object from a window, and finds out what went wrong where it cannot.
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <string>

#include "entry_window.h"

namespace vdamf
{
struct ParsedObject
{
    mrpt::serialization::CSerializable::Ptr object;  ///< null: could not be read
    std::size_t bytes = 0;                           ///< of the object, where it was read
    std::string problem;                             ///< why not
    bool reachedEnd = false;                         ///< the stream ended inside the object
};

/// Reads the object of a registered class at the window's begin. The window does not move.
ParsedObject parseObject(EntryWindow& window);

/// The innermost message of an MRPT exception, without its call stacks.
std::string shortMessage(const std::string& what);

/// The newest version of a class that this MRPT writes and so can read; -1 where it does not tell.
int newestVersion(const std::string& className);

}  // namespace vdamf
