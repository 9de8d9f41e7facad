#pragma once

#include "field/field_engine.h"
#include "medial/engine.h"

#include <memory>

namespace medial
{

/// Makes an engine.
///
/// Auto is the device on graphics hardware, and the processor where there is none or where the
/// device fails.
/// @throws Error NoGpu for the rasteriser and the device without OpenGL.
std::unique_ptr<FieldEngine> makeEngine(Engine wanted);

/// Returns the engine of an earlier job over the same mesh if it is of the wanted kind, otherwise
/// replaces it by a new one.
/// @param kept null before the first job.
/// @throws Error as makeEngine().
FieldEngine& obtainEngine(Engine wanted, std::unique_ptr<FieldEngine>& kept);

} // namespace medial
