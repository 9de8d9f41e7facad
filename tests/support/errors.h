#pragma once

#include "medial/error.h"

#include <gtest/gtest.h>

#include <string>

namespace medial::test
{

/// What the medial::Error says that work() ends with, nothing where it ends well.
/// @param code that of the error.
template <typename Work>
std::string messageOf(const Work& work, ErrorCode code = ErrorCode::InvalidInput)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), code) << error.what();
    return error.what();
  }
  return "";
}

/// Expects work() to end with an error of this code whose message has some words.
template <typename Work>
void expectError(const Work& work, ErrorCode code, const std::string& words = "")
{
  const std::string message = messageOf(work, code);
  EXPECT_NE(message, "") << "no error " << words;
  EXPECT_NE(message.find(words), std::string::npos) << message;
}

} // namespace medial::test
