// SPDX-License-Identifier: BSD-3-Clause
// Tracks as objects of MRPT's 3D scenes.
#pragma once

#include <mrpt/img/TColor.h>
#include <mrpt/opengl/CRenderizable.h>

#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// A colour that a track keeps: hues a golden angle apart; paler where it is coasting.
mrpt::img::TColor colourOf(const TrackReport& track);

mrpt::opengl::CRenderizable::Ptr boxOf(const TrackReport& track);

/// From the roof's middle to beyond the front: which way the vehicle faces.
mrpt::opengl::CRenderizable::Ptr headingLine(const TrackReport& track);

/// Its identity, over the roof.
mrpt::opengl::CRenderizable::Ptr nameOf(const TrackReport& track);

}  // namespace vdamf
