#pragma once

#include "files/scans/scan_reader.h"

#include <string>

namespace medial::files
{

/// Reads an image of VTK's XML format: the active scalars of its points, or else their first array
/// with one component.
/// @param content of the file.
/// @throws Error InvalidInput, without the name of the file: several pieces, no such array, an
///   array that is damaged.
Scan parseVti(const std::string& content);

} // namespace medial::files
