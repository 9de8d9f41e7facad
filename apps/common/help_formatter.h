#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace medial::app
{

/// CLI11's help text with descriptions broken into lines.
class HelpFormatter : public CLI::Formatter
{
public:
  HelpFormatter();

  std::string make_option_desc(const CLI::Option* option) const override;
};

} // namespace medial::app
