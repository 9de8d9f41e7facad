#pragma once

#include "field/field_engine.h"
#include "medial/engine.h"

#include <memory>
#include <string>

namespace medial
{

/// Makes an engine.
///
/// Auto is the device on graphics hardware, and the processor where there is none or where the
/// device fails, or one that was asked for is missing: the statistics then have a note.
/// @param device as DistanceFieldOptions::device; the processor needs none.
/// @throws Error NoGpu for the rasteriser and the device without OpenGL.
std::unique_ptr<FieldEngine> makeEngine(Engine wanted, const std::string& device = {});

/// Returns the engine of an earlier job over the same mesh if it is of the wanted kind, otherwise
/// replaces it by a new one.
/// @param device as for makeEngine().
/// @param kept null before the first job.
/// @throws Error as makeEngine().
FieldEngine& obtainEngine(Engine wanted, const std::string& device,
  std::unique_ptr<FieldEngine>& kept);

} // namespace medial
