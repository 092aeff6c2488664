// SPDX-License-Identifier: BSD-3-Clause
// The four faces of a vehicle's box, and sets of them.
#pragma once

#include <cstdint>
#include <string>

namespace vdamf
{
enum class Face : std::uint8_t
{
    Front = 1,
    Back = 2,
    Left = 4,
    Right = 8
};

/// The faces by axis of the box (0: its length, 1: its width) and end of that axis (low, high).
inline constexpr Face kFaceAt[2][2] = {{Face::Back, Face::Front}, {Face::Right, Face::Left}};

/// Which way an end (0: low, 1: high) lies along its axis.
constexpr double signOfEnd(int end)
{
    return end == 0 ? -1.0 : 1.0;
}

/// A set of faces, for example those that a sensor sees.
struct FaceSet
{
    std::uint8_t bits = 0;

    bool has(Face face) const { return (bits & static_cast<std::uint8_t>(face)) != 0; }
    void add(Face face)
    {
        bits = static_cast<std::uint8_t>(bits | static_cast<std::uint8_t>(face));
    }
    void remove(Face face)
    {
        bits = static_cast<std::uint8_t>(bits & ~static_cast<std::uint8_t>(face));
    }
    bool empty() const { return bits == 0; }
    bool seesEnd() const { return has(Face::Front) || has(Face::Back); }
    bool seesSide() const { return has(Face::Left) || has(Face::Right); }
    /// Whether it has a face at an end of an axis.
    bool seesAcross(int axis) const { return axis == 0 ? seesEnd() : seesSide(); }
    /// Whether it has a face along an axis: the row of hits on it may tell the ends of that axis.
    bool seesAlong(int axis) const { return seesAcross(1 - axis); }
    bool operator==(const FaceSet& other) const { return bits == other.bits; }
};

/// The faces of either set.
inline FaceSet operator|(FaceSet one, FaceSet other)
{
    return {static_cast<std::uint8_t>(one.bits | other.bits)};
}

/// The faces of a box that is turned by quarters, counter-clockwise: the left side is the new
/// front.
inline FaceSet turnedBy(FaceSet faces, int quarters)
{
    constexpr Face kAround[4] = {Face::Front, Face::Left, Face::Back, Face::Right};
    FaceSet turned;
    for (int k = 0; k < 4; ++k)
        if (faces.has(kAround[(k + (quarters % 4) + 4) % 4])) turned.add(kAround[k]);
    return turned;
}

/// Letters of the faces in the order F, B, L, R: "FL" is front and left. Empty set: "".
inline std::string toString(FaceSet faces)
{
    std::string letters;
    if (faces.has(Face::Front)) letters += 'F';
    if (faces.has(Face::Back)) letters += 'B';
    if (faces.has(Face::Left)) letters += 'L';
    if (faces.has(Face::Right)) letters += 'R';
    return letters;
}

}  // namespace vdamf
