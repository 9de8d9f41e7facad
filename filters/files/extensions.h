#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Formats are known by the extensions of their files.
namespace medial::files
{

/// Extensions in lower case, with their dots, in the order in which texts name them.
using Extensions = std::vector<std::string>;

/// Whether a file has one of the extensions, in upper or lower case.
bool hasExtension(const std::filesystem::path& path, const Extensions& extensions);

/// The extensions, with a text between each two.
std::string joined(const Extensions& extensions, const std::string& between);

/// As in a sentence: ".stl, .obj or .ply".
std::string enumerated(const Extensions& extensions);

/// "unknown extension '.xyz', allowed: .stl .obj .ply".
std::string unknownExtension(const std::filesystem::path& path, const Extensions& allowed);

/// Checks that a path leads to a file with one of the extensions.
/// @throws Error CannotRead naming the file, also as requireRegularFile().
void requireExtension(const std::filesystem::path& path, const Extensions& allowed);

} // namespace medial::files
