#pragma once

#include "support/files.h"

#include <gtest/gtest.h>

#include <string>

namespace medial::test
{

/// The message of the exception that reading a file must end in, without the folder's name. It is
/// one line that begins with the file.
/// @param read called with the file's path.
/// @param check called with the exception.
template <typename Exception, typename Read, typename Check>
std::string refusalOf(const std::string& name, const std::string& content, const Read& read,
  const Check& check)
{
  const TemporaryFolder folder;
  writeFile(folder.file(name), content);
  try
  {
    read(folder.file(name));
  }
  catch (const Exception& exception)
  {
    check(exception);
    const std::string message = exception.what();
    EXPECT_EQ(message.find(folder.path().string()), 0U) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message.substr(folder.path().string().size() + 1);
  }
  ADD_FAILURE() << name << " was accepted";
  return "";
}

} // namespace medial::test
