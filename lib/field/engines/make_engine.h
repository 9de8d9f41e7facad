#pragma once

#include "field/field_engine.h"
#include "medial/engine.h"

#include <memory>

namespace medial
{

/// Makes the engine that is wanted.
///
/// Auto is the processor, also where there is a GPU: to feed the rasteriser, the host culls and
/// clips polygons for longer than the processor takes for the whole field.
/// @throws Error NoGpu where it draws and there is no OpenGL.
std::unique_ptr<FieldEngine> makeEngine(Engine wanted);

/// The engine of an earlier job over the same mesh if that is the wanted one, else a new one in its
/// place.
/// @param kept null before the first job.
/// @throws Error as makeEngine().
FieldEngine& obtainEngine(Engine wanted, std::unique_ptr<FieldEngine>& kept);

} // namespace medial
