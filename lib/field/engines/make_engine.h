#pragma once

#include "field/field_engine.h"
#include "medial/distance_field.h"

#include <memory>

namespace medial
{

/// Makes an engine.
///
/// Auto is the device on graphics hardware, once there is work enough for it or where the options
/// ask for hardware or a device, and the processor where there is none or where the device fails,
/// or one that was asked for is missing: the statistics then have a note.
/// @throws Error NoGpu for the rasteriser and the device without OpenGL.
std::unique_ptr<FieldEngine> makeEngine(const DistanceFieldOptions& options);

/// Returns the engine of an earlier job over the same mesh if it is of the wanted kind, otherwise
/// replaces it by a new one.
/// @param kept null before the first job.
/// @throws Error as makeEngine().
FieldEngine& obtainEngine(const DistanceFieldOptions& options, std::unique_ptr<FieldEngine>& kept);

} // namespace medial
