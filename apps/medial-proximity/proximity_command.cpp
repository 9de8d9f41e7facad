#include "proximity_command.h"

#include "bodies.h"
#include "command_line.h"
#include "failure.h"
#include "files/surface_reader.h"
#include "output/json_output.h"
#include "output/output_names.h"
#include "validators.h"

#include "medial/error.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <string>

namespace medial::app
{
namespace
{

const char* const kFooter =
  "Meshes are numbered from 0, in the order in which they are given; every pair of them is a row\n"
  "of the table. The solid of a closed mesh is what it encloses; an open mesh has a solid where\n"
  "its generalised winding number tells inside from outside. The separation is the smallest\n"
  "distance between two surfaces, 0 if they intersect. The depth is the largest distance of a\n"
  "surface point of one mesh inside the other to the other's surface. The translation is the\n"
  "length of the shortest that separates two solids, as certified bounds. Lengths are world\n"
  "units. Existing files are replaced, but only once the new ones are complete.\n"
  "\n"
  "Exit codes: 0 done, whether meshes collide or not; 2 usage; 3 bad input; 4 no usable OpenGL\n"
  "for a picture; 5 out of memory or disk, or an output that cannot be written; 70 a fault of the\n"
  "program; 130 interrupted.";

// What the user typed, before it becomes values of ProximityCommand.
struct ProximityTexts
{
  std::vector<std::string> inputs;
  std::vector<std::string> transforms;
  std::string json, contacts, image, animation;
  bool noSeparation = false;
  bool noContacts = false;
  bool noDepths = false;
  bool noTranslation = false;
};

void addOutputOptions(CLI::App& app, ProximityTexts& texts)
{
  const std::string group = "Outputs";
  app
    .add_option("--json", texts.json,
      "machine-readable result: the meshes, and of every frame the pairs with separation, closest "
      "points, depths and contacts; - for standard output, instead of the table")
    ->option_text("FILE.json")
    ->group(group);
  app
    .add_option("--contacts", texts.contacts,
      "contacts as points and closest points as lines: .vtp with all frames, or .pvd, which lists "
      "the files <FILE's name>_0.vtp and so on, one for each frame")
    ->option_text("FILE")
    ->group(group);
  app
    .add_option("--image", texts.image,
      "picture of the first frame: translucent meshes, arrows at contacts along their normals, a "
      "line between closest points; needs no display")
    ->option_text("FILE.png")
    ->group(group);
  app
    .add_option("--animation", texts.animation,
      "the same picture of every frame, in files frame_0000.png and so on; creates the folder if "
      "needed, and deletes from it what is left of a longer animation")
    ->option_text("FOLDER")
    ->group(group);
}

void addMotionOptions(CLI::App& app, ProximityTexts& texts, ProximityCommand& command)
{
  const std::string group = "Motion";
  app
    .add_flag("--sequence", command.sequence,
      "each MESH is a folder, or a quoted pattern such as 'b_*.obj': its meshes are frames, in the "
      "order of their names, with the same cells in other positions; a single file stands still")
    ->group(group);
  app
    .add_option("--transform", texts.transforms,
      "transform mesh number INDEX by a matrix of 12 or 16 numbers, row by row, separated by "
      "commas; or by a file with one such matrix, or with one per line for each frame; may be "
      "given once per mesh")
    ->option_text("INDEX=M")
    ->allow_extra_args(false)
    ->group(group);
}

void addComputeOptions(CLI::App& app, ProximityTexts& texts, ProximityOptions& options)
{
  const std::string group = "Computation";
  app
    .add_option("--max-contacts", options.maxContacts,
      "largest number of contacts where meshes overlap, for each connected "
      "overlap, in [1, 2147483647]; default 4")
    ->option_text("K")
    ->check(within<int>("[1, 2147483647]", [](int k) { return k >= 1; }))
    ->group(group);
  app
    .add_flag("--no-separation", texts.noSeparation,
      "do not compute the separation and closest points of meshes that do not intersect")
    ->group(group);
  app.add_flag("--no-contacts", texts.noContacts, "do not compute contacts")->group(group);
  app
    .add_flag("--no-depths", texts.noDepths,
      "do not compute depths, and so neither contacts nor bounds on the separating translation")
    ->group(group);
  app
    .add_flag("--no-translation", texts.noTranslation,
      "do not compute bounds on the separating translation")
    ->group(group);
  app
    .add_option("--max-separation", options.maxSeparation,
      "leave out pairs whose boxes are farther apart, in world units, >= 0; default none")
    ->option_text("D")
    ->check(within<double>("[0, infinity)", [](double d) { return std::isfinite(d) && d >= 0.0; }))
    ->group(group);
  app
    .add_option("--depth-tolerance", options.depthTolerance,
      "how far the depth may be below the true one, as a fraction of it, in (0, 1); default 0.001")
    ->option_text("F")
    ->check(within<double>("(0, 1)", [](double f) { return f > 0.0 && f < 1.0; }))
    ->group(group);
}

void addRunOptions(CLI::App& app, ProximityCommand& command)
{
  const std::string group = "Run";
  addThreadsOption(app, command.options.execution.threads, group);
  addQuietOption(app, command.quiet, group);
}

[[noreturn]] void refuseTransform(const std::string& text, const std::string& why)
{
  throw Failure(ExitCode::Usage, "--transform " + text + ": " + why);
}

// The index before the equals sign.
int meshOf(const std::string& text, std::size_t meshes)
{
  int mesh = -1;
  const std::string word = text.substr(0, text.find('='));
  if (word == text || !CLI::detail::lexical_cast(word, mesh) || mesh < 0 ||
    static_cast<std::size_t>(mesh) >= meshes)
  {
    refuseTransform(text,
      "does not begin with the number of a mesh, in [0, " + std::to_string(meshes - 1) +
        "], and =");
  }
  return mesh;
}

// Numbers have commas between them, and names of files seldom.
Motion toMotion(const std::string& text)
{
  const std::string value = text.substr(text.find('=') + 1);
  std::error_code ignored;
  Motion motion;
  if (value.find(',') == std::string::npos || std::filesystem::exists(value, ignored))
  {
    motion.file = value;
    return motion;
  }
  try
  {
    motion.transform = toTransform(toNumbers(value));
  }
  catch (const Error& error)
  {
    refuseTransform(text, error.what());
  }
  return motion;
}

void convertInputs(const ProximityTexts& texts, ProximityCommand& command)
{
  command.inputs.assign(texts.inputs.begin(), texts.inputs.end());
  if (command.inputs.size() < 2)
  {
    throw Failure(ExitCode::Usage,
      "only one mesh, " + command.inputs.front().string() +
        ", is given; allowed: two or more (see medial-proximity --help)");
  }
  for (const std::string& text : texts.transforms)
  {
    const int mesh = meshOf(text, command.inputs.size());
    if (!command.motions.emplace(mesh, toMotion(text)).second)
    {
      refuseTransform(text, "mesh " + std::to_string(mesh) + " has a transform already");
    }
  }
}

/// The meshes and the files of their transforms.
std::vector<NamedInput> inputsOf(const ProximityCommand& command)
{
  std::vector<NamedInput> inputs;
  for (const std::filesystem::path& input : command.inputs)
  {
    inputs.push_back({ input, framesOf(input, command.sequence) });
  }
  for (const auto& [mesh, motion] : command.motions)
  {
    if (!motion.transform)
    {
      inputs.push_back({ motion.file, { motion.file } });
    }
  }
  return inputs;
}

void convertOutputs(const ProximityTexts& texts, ProximityCommand& command)
{
  command.json = texts.json;
  command.contacts = texts.contacts;
  command.image = texts.image;
  command.animation = texts.animation;
  checkJsonName("--json", command.json);
  checkExtension("--contacts", command.contacts, { ".vtp", ".pvd" });
  checkExtension("--image", command.image, { ".png" });
  checkNames({ { "--json", command.json }, { "--contacts", command.contacts },
               { "--image", command.image },
               { "--animation", command.animation, picturesIn(command.animation) } },
    inputsOf(command));
}

} // namespace

std::optional<ProximityCommand> parseProximityCommand(int argc, char** argv)
{
  CLI::App app{
    "Computes the proximity of meshes that move or deform: separation, depth, contacts.\n"
  };
  setUpCommandLine(app, "medial-proximity", kFooter);

  ProximityTexts texts;
  ProximityCommand command;
  app
    .add_option("MESH", texts.inputs,
      "two meshes or more: " + files::enumerated(files::surfaceExtensions()))
    ->required()
    ->option_text(" ");
  addOutputOptions(app, texts);
  addMotionOptions(app, texts, command);
  addComputeOptions(app, texts, command.options);
  addRunOptions(app, command);
  if (!parseCommandLine(app, argc, argv))
  {
    return std::nullopt;
  }
  convertInputs(texts, command);
  convertOutputs(texts, command);
  command.options.separation = !texts.noSeparation;
  command.options.depths = !texts.noDepths;
  command.options.translationalDepth = !texts.noTranslation;
  if (texts.noContacts || texts.noDepths)
  {
    command.options.maxContacts = 0;
  }
  return command;
}

} // namespace medial::app
