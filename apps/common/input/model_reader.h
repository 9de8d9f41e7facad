#pragma once

#include "medial/medial_model.h"

#include <filesystem>

namespace medial::app
{

/// Reads a medial axis by the extension of its file: .ply, .obj and .ma as readAxis() does; .vtp
/// with polygons, lines and vertices, and a point data array Radius of one component. Radii have
/// single precision.
///
/// @return a model that checkMedialModel() accepts.
/// @throws Failure BadInput naming the file and what is wrong, with the line or point: a file that
///   ends early or contradicts its header, an index out of range, radii that are missing, no
///   points at all, what checkMedialModel() refuses.
MedialModel readModel(const std::filesystem::path& path);

} // namespace medial::app
