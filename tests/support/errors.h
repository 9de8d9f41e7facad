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

/// Expects work() to end with an error whose message has these words.
template <typename Work>
void expectError(const Work& work, const std::string& words,
  ErrorCode code = ErrorCode::InvalidInput)
{
  const std::string message = messageOf(work, code);
  EXPECT_NE(message, "") << "no error about " << words;
  EXPECT_NE(message.find(words), std::string::npos) << message;
}

template <typename Work>
void expectCancelled(const Work& work)
{
  EXPECT_NE(messageOf(work, ErrorCode::Cancelled), "") << "it was not cancelled";
}

} // namespace medial::test
