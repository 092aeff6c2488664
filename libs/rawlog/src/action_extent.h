// SPDX-License-Identifier: BSD-3-Clause
// Where an action ends, without MRPT's parser.
#pragma once

#include <cstddef>

#include "entry_window.h"
#include "object_header.h"

namespace vdamf
{
struct ActionExtent
{
    std::size_t bytes = 0;    ///< from the window's begin
    bool whole = false;       ///< ends as an action ends
    bool reachedEnd = false;  ///< the stream ended inside it
};

/// The extent of the action or collection of actions at the window's begin. Reading a corrupt
/// CActionRobotMovement2D makes MRPT run its motion models on whatever the bytes say, which may
/// end the program, and nothing here needs what an action says. So its end is searched for: the end
/// flags, and behind them the begin of an entry or the end of the stream.
ActionExtent actionExtent(EntryWindow& window, const ObjectHeader& header);

}  // namespace vdamf
