#include "command_line.h"

#include "failure.h"
#include "files/extensions.h"
#include "help_formatter.h"
#include "input/input_file.h"
#include "option_names.h"
#include "output/standard_output.h"
#include "similar_word.h"
#include "validators.h"

#include "medial/version.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace medial::app
{
namespace
{

constexpr int kMaxThreads = 1024;

/// The option that somebody most likely meant, with its dashes; empty if none looks like it.
std::string meantOption(const CLI::App& app, const std::string& word)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
  {
    const std::vector<std::string>& ofOption = option->get_lnames();
    names.insert(names.end(), ofOption.begin(), ofOption.end());
  }
  const std::string name = word.substr(0, word.find('='));
  const std::size_t letters = std::min(name.find_first_not_of('-'), name.size());
  const std::string meant = similarWord(name.substr(letters), names);
  return meant.empty() ? "" : "--" + meant;
}

/// An option as the user gave it: its name and its value, if it has one.
std::string asGiven(const CLI::App& app, const std::string& name)
{
  const CLI::Option* const option = app.get_option_no_throw(name);
  const bool hasValue = option != nullptr && option->get_items_expected_max() > 0;
  return hasValue && !option->results().empty() ? name + " " + option->results().front() : name;
}

/// The message of an error whose text is two options with a word between.
std::string messageOfTwo(const CLI::App& app, const std::string& text, const std::string& word,
  const std::string& better)
{
  const std::size_t place = text.find(word);
  return place == std::string::npos
    ? text
    : asGiven(app, text.substr(0, place)) + better + asGiven(app, text.substr(place + word.size()));
}

/// What is wrong with a command line. The parser's words are for those who know the parser.
std::string messageOf(const CLI::App& app, const CLI::ParseError& error)
{
  std::string message = error.what();
  const std::vector<std::string> unknown = app.remaining();
  const auto option = std::find_if(unknown.begin(), unknown.end(),
    [](const std::string& word) { return word.size() > 1 && word[0] == '-'; });
  if (option != unknown.end())
  {
    const std::string meant = meantOption(app, *option);
    return "unknown option " + *option + (meant.empty() ? "" : ", did you mean " + meant + "?");
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
  {
    return "unexpected argument '" + unknown.front() + "'";
  }
  if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr)
  {
    return messageOfTwo(app, message, " excludes ", " cannot be given together with ");
  }
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr)
  {
    return messageOfTwo(app, message, " requires ", " needs ");
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
  {
    const std::string name = message.substr(0, message.find(':'));
    const bool missing = message.find("missing") != std::string::npos;
    return name + (missing ? " needs a value" : " may be given only once");
  }
  return message;
}

/// An empty value is most likely that of a variable of a shell that is not set.
[[noreturn]] void refuseEmptyValue(const CLI::App& app, const std::string& option)
{
  throw Failure(ExitCode::Usage,
    option + " needs a value, not an empty one (see " + app.get_name() + " --help)");
}

/// Words such as --output=, for which the parser would take the next word.
void requireValues(const CLI::App& app, int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word.size() > 3 && word.compare(0, 2, "--") == 0 && word.find('=') == word.size() - 1)
    {
      refuseEmptyValue(app, word.substr(0, word.size() - 1));
    }
  }
}

void requireValues(const CLI::App& app)
{
  for (const CLI::Option* option : app.get_options())
  {
    const std::vector<std::string>& values = option->results();
    if (std::find(values.begin(), values.end(), "") != values.end())
    {
      refuseEmptyValue(app, option->get_name());
    }
  }
}

} // namespace

void setUpCommandLine(CLI::App& app, const std::string& name, const std::string& footer)
{
  app.footer(footer);
  app.name(name);
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", name + " " + MEDIAL_VERSION, "print the version and exit");
  app.set_help_flag("-h,--help", "print this text and exit");
}

bool parseCommandLine(CLI::App& app, int argc, char** argv)
{
  requireValues(app, argc, argv);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      std::ostringstream answer;
      app.exit(error, answer, answer);
      printText(answer.str());
      return false;
    }
    throw Failure(ExitCode::Usage, messageOf(app, error) + " (see " + app.get_name() + " --help)");
  }
  requireValues(app);
  return true;
}

void addSignOption(CLI::App& app, std::string& word, const std::string& group)
{
  app
    .add_option("--sign", word,
      "how inside is told from outside: winding (winding numbers, for any mesh of triangles), "
      "pseudonormal (closed, consistently oriented meshes only), none, or auto (winding, or none "
      "where the mesh does not define an inside); default auto")
    ->option_text("METHOD")
    ->check(oneOf(signNames()))
    ->group(group);
}

void addSideOption(CLI::App& app, std::string& word, const std::string& group)
{
  app
    .add_option("--side", word,
      "which side of the surface: interior, exterior or both; default interior (open mesh: both, "
      "unsigned)")
    ->option_text("SIDE")
    ->check(oneOf(sideNames()))
    ->group(group);
}

void addEngineOption(CLI::App& app, std::string& word, const std::string& group)
{
  app
    .add_option("--engine", word,
      "what finds the closest sites: processor (CPU, without OpenGL), device (compute shaders of "
      "OpenGL), rasteriser (OpenGL) or auto, the processor, and the device for large work on "
      "graphics hardware that works; default auto")
    ->option_text("KIND")
    ->check(oneOf(engineNames()))
    ->group(group);
}

void addThreadsOption(CLI::App& app, int& threads, const std::string& group)
{
  app
    .add_option("--threads", threads,
      "CPU threads to use, in [0, 1024]; 0 for all cores; default 0")
    ->option_text("N")
    ->check(within<int>("[0, 1024]", [](int n) { return n >= 0 && n <= kMaxThreads; }))
    ->group(group);
}

void addDeviceOptions(CLI::App& app, DeviceOptions& options, const std::string& group)
{
  app
    .add_option("--device", options.name,
      "what OpenGL computes on: a number or part of a name from the list that medial-axis prints; "
      "default: the first GPU, else a software renderer; if it is missing or fails, the engine "
      "auto uses the processor, with a note")
    ->option_text("DEVICE")
    ->group(group);
  app.add_flag("--require-gpu", options.require, "fail unless there is OpenGL 4.5 on a GPU")
    ->group(group);
  app
    .add_flag("--verify", options.verify,
      "check the engine device against exact distances at 1000 grid points; on a GPU this is done "
      "once in any case")
    ->group(group);
}

void addQuietOption(CLI::App& app, bool& quiet, const std::string& group)
{
  app.add_flag("-q,--quiet", quiet, "print errors only")->group(group);
}

void checkExtension(const char* option, const std::filesystem::path& path,
  const std::vector<std::string>& allowed)
{
  if (!path.empty() && !files::hasExtension(path, allowed))
  {
    throw Failure(ExitCode::Usage,
      std::string(option) + " " + path.string() + ": " + files::unknownExtension(path, allowed));
  }
}

} // namespace medial::app
