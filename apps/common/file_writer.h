#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace medial::app
{

///@{
/// Makes a file of what `write` passes to the stream, or of bytes.
/// @throws Failure NoSpace unless everything reached the file. The message names no file.
void writeFile(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
void writeFile(const std::filesystem::path& file, std::string_view bytes);
///@}

} // namespace medial::app
