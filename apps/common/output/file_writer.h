#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace medial::app
{

///@{
/// Creates a file with what `write` sends to the stream, or with the given bytes.
/// @throws Failure NoSpace unless everything reached the file. The message does not name the file.
void writeFile(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
void writeFile(const std::filesystem::path& file, std::string_view bytes);
///@}

} // namespace medial::app
