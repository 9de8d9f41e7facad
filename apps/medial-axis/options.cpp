#include "options.h"

#include "failure.h"
#include "help_formatter.h"
#include "text_cursor.h"
#include "validators.h"

#include "medial/version.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace medial::app
{
namespace
{

constexpr int kMaxResolution = 8192;
constexpr int kMaxThreads = 1024;
constexpr int kMinMemoryMiB = 64;
constexpr double kMaxPadding = 10.0;

const Names<Side> kSides = { { "interior", Side::Interior }, { "exterior", Side::Exterior },
  { "both", Side::Both } };
const Names<Representation> kRepresentations = { { "surface", Representation::Surface },
  { "faces", Representation::Faces }, { "points", Representation::Points } };
const Names<Topology> kTopologies = { { "selected", Topology::Selected },
  { "preserve", Topology::Preserve } };
const Names<SignMethod> kSigns = { { "auto", SignMethod::Auto }, { "none", SignMethod::None },
  { "pseudonormal", SignMethod::Pseudonormal }, { "winding", SignMethod::Winding } };
const Names<Evaluator> kEvaluators = { { "auto", Evaluator::Auto },
  { "rasteriser", Evaluator::Rasteriser }, { "processor", Evaluator::Processor } };

template <typename T>
std::string nameIn(const Names<T>& names, T value)
{
  const auto found = std::find_if(names.begin(), names.end(),
    [value](const auto& name) { return name.second == value; });
  return found != names.end() ? found->first : "unknown";
}

const char* const kFooter =
  "Input formats: .stl .obj .ply .off .vtp .vtk. Without any output the medial axis goes to\n"
  "<INPUT's name>_medial.vtp in the current folder. Existing files are replaced, but only once "
  "the\n"
  "new ones are complete. Without -o and --image, --field and --thickness compute no medial axis.\n"
  "\n"
  "Exit codes: 0 done; 2 usage; 3 bad input; 4 no usable OpenGL; 5 out of memory or disk, or an\n"
  "output that cannot be written; 130 interrupted.";

// The words as typed, before they become values of Options.
struct Words
{
  std::string input, output, field, thickness, thicknessImage, image, report;
  std::string lambda = "0";
  std::string minRadius = "0";
  std::string side = "interior";
  std::string representation = "surface";
  std::string topology = "selected";
  std::string sign = "auto";
  std::string evaluator = "auto";
  double spacing = 0.0;
};

/// Nothing where the word is no length.
std::optional<Length> parseLength(const std::string& word)
{
  Length length;
  length.percent = !word.empty() && word.back() == '%';
  const std::string number = length.percent ? word.substr(0, word.size() - 1) : word;
  if (!CLI::detail::lexical_cast(number, length.value) || !std::isfinite(length.value) ||
    length.value < 0.0)
  {
    return std::nullopt;
  }
  return length;
}

Length toLength(const std::string& word)
{
  return parseLength(word).value_or(Length{});
}

CLI::Validator length()
{
  return CLI::Validator([](std::string& word)
    { return parseLength(word) ? std::string() : word + " is no length >= 0, such as 0.5 or 2%"; },
    "");
}

void addOutputOptions(CLI::App& app, Words& words)
{
  const std::string group = "Outputs";
  app.add_option("-o,--output", words.output, "medial axis: .vtp, .ply, .obj or .ma")
    ->option_text("FILE")
    ->group(group);
  app
    .add_option("--field", words.field,
      "distance field with all its arrays: .vti, one file, or .pvti, pieces of 64 slices as "
      "<FILE's name>_0.vti and so on; written while it is computed, so it may be larger than "
      "memory")
    ->option_text("FILE")
    ->group(group);
  app
    .add_option("--thickness", words.thickness,
      "input surface with point array Thickness: twice the radius of the medial ball that touches "
      "the point, in world units, float32; NaN where there is no ball, 0 on convex edges that bend "
      "by theta or more. Uses --angle and --side, but no grid: it is exact")
    ->option_text("FILE.vtp")
    ->group(group);
  app
    .add_option("--thickness-image", words.thicknessImage,
      "a rendered picture of the surface coloured by thickness in world units, grey where there is "
      "none; large triangles get values inside as well")
    ->option_text("FILE.png")
    ->group(group);
  app.add_option("--image", words.image, "a rendered picture of axis and translucent surface")
    ->option_text("FILE.png")
    ->group(group);
  app.add_option("--report", words.report, "machine-readable result")
    ->option_text("FILE.json")
    ->group(group);
}

void addGridOptions(CLI::App& app, Words& words, Options& options)
{
  const std::string group = "Grid";
  CLI::Option* resolution =
    app
      .add_option("--resolution", options.resolution,
        "number of grid points along the longest axis of the padded bounds, in [2, 8192]; "
        "default 256")
      ->option_text("N")
      ->check(within<int>("[2, 8192]", [](int n) { return n >= 2 && n <= kMaxResolution; }))
      ->group(group);
  app
    .add_option("--spacing", words.spacing,
      "distance of neighbouring grid points in world units, > 0; instead of --resolution")
    ->option_text("H")
    ->check(within<double>("(0, infinity)", [](double h) { return std::isfinite(h) && h > 0.0; }))
    ->excludes(resolution)
    ->group(group);
  app
    .add_option("--padding", options.padding,
      "margin on every side as a fraction of the diagonal of the mesh's bounds, in [0, 10]; "
      "default 0.05")
    ->option_text("F")
    ->check(within<double>("[0, 10]", [](double f) { return f >= 0.0 && f <= kMaxPadding; }))
    ->group(group);
}

void addAxisOptions(CLI::App& app, Words& words, Options& options)
{
  const std::string group = "Medial axis";
  app
    .add_option("--angle", options.angle,
      "least separation angle theta of the directions to the two closest points, in degrees, in "
      "(0, 180); small values keep more of the axis and more noise; default 60")
    ->option_text("DEG")
    ->check(within<double>("(0, 180)", [](double a) { return a > 0.0 && a < 180.0; }))
    ->group(group);
  app
    .add_option("--lambda", words.lambda,
      "least lambda, half the distance of the two closest points, in world units or as L% of the "
      "diagonal of the mesh's bounds, >= 0; takes away what noise of that size makes, and what "
      "lies "
      "behind thinner walls; default 0")
    ->option_text("L[%]")
    ->check(length())
    ->group(group);
  app
    .add_option("--min-radius", words.minRadius,
      "least radius of the medial balls, in world units or as R% of the diagonal, >= 0; default 0")
    ->option_text("R[%]")
    ->check(length())
    ->group(group);
  app
    .add_option("--side", words.side,
      "which side of the surface: interior, exterior or both; default interior (open mesh: both, "
      "unsigned)")
    ->option_text("SIDE")
    ->check(oneOf(kSides))
    ->group(group);
  app
    .add_option("--representation", words.representation,
      "surface (dual mesh), faces (voxel faces) or points; default surface")
    ->option_text("KIND")
    ->check(oneOf(kRepresentations))
    ->group(group);
  app
    .add_option("--max-spheres", options.maxSpheres,
      "compact connected axis: at most N balls, joined by lines and triangles, that describe the "
      "shape best, in [0, 2147483647]; not for --representation points; 0 for no limit; default 0")
    ->option_text("N")
    ->check(within<int>("[0, 2147483647]", [](int n) { return n >= 0; }))
    ->group(group);
  app
    .add_option("--topology", words.topology,
      "selected, in as many pieces as theta leaves, or preserve: as many pieces, tunnels and "
      "cavities as the solid has at this resolution; default selected")
    ->option_text("KIND")
    ->check(oneOf(kTopologies))
    ->group(group);
  app
    .add_option("--sign", words.sign,
      "how inside is told from outside: auto, none, pseudonormal (closed, consistently oriented "
      "meshes) or winding (not available yet); default auto")
    ->option_text("METHOD")
    ->check(oneOf(kSigns))
    ->group(group);
}

void addRunOptions(CLI::App& app, Words& words, Options& options)
{
  const std::string group = "Run";
  app
    .add_option("--threads", options.threads,
      "CPU threads to use, in [0, 1024]; 0 for all cores; default 0")
    ->option_text("N")
    ->check(within<int>("[0, 1024]", [](int n) { return n >= 0 && n <= kMaxThreads; }))
    ->group(group);
  app
    .add_option("--memory", options.memoryMiB,
      "upper bound of the memory for slabs, in MiB, >= 64; 0 chooses; default 0")
    ->option_text("MiB")
    ->check(
      within<int>("[64, 2147483647] and not 0", [](int m) { return m == 0 || m >= kMinMemoryMiB; }))
    ->group(group);
  app
    .add_option("--evaluator", words.evaluator,
      "what finds closest sites: rasteriser (OpenGL), processor (CPU) or auto, which is the "
      "processor where OpenGL is a software renderer; default auto")
    ->option_text("KIND")
    ->check(oneOf(kEvaluators))
    ->group(group);
  app.add_flag("--require-gpu", options.requireGpu, "fail on a software renderer")->group(group);
  app.add_flag("-q,--quiet", options.quiet, "print nothing but errors")->group(group);
}

void checkExtension(const char* option, const std::filesystem::path& path,
  const std::vector<std::string>& allowed)
{
  const std::string extension = lowerCase(path.extension().string());
  if (path.empty() || std::find(allowed.begin(), allowed.end(), extension) != allowed.end())
  {
    return;
  }
  std::string list;
  for (const std::string& one : allowed)
  {
    list += " " + one;
  }
  throw Failure(ExitCode::Usage,
    std::string(option) + " " + path.string() + ": unknown extension '" + extension +
      "', allowed:" + list);
}

void convertWords(const Words& words, bool spacingGiven, Options& options)
{
  options.signMethod = kSigns.at(words.sign);
  if (options.signMethod == SignMethod::Winding)
  {
    throw Failure(ExitCode::Usage,
      "--sign winding is not available yet; available: auto, none, pseudonormal");
  }
  options.evaluator = kEvaluators.at(words.evaluator);
  options.lambda = toLength(words.lambda);
  options.minRadius = toLength(words.minRadius);
  options.side = kSides.at(words.side);
  options.representation = kRepresentations.at(words.representation);
  options.topology = kTopologies.at(words.topology);
  if (options.maxSpheres > 0 && options.representation == Representation::Points)
  {
    throw Failure(ExitCode::Usage,
      "--max-spheres " + std::to_string(options.maxSpheres) +
        " needs --representation surface or faces: points have no cells to simplify");
  }
  if (options.topology == Topology::Preserve && options.representation == Representation::Points)
  {
    throw Failure(ExitCode::Usage,
      "--topology preserve needs --representation surface or faces, not points");
  }
  options.input = words.input;
  options.output = words.output;
  options.field = words.field;
  options.thickness = words.thickness;
  options.thicknessImage = words.thicknessImage;
  options.image = words.image;
  options.report = words.report;
  if (spacingGiven)
  {
    options.spacing = words.spacing;
  }
  if (options.output.empty() && options.field.empty() && options.image.empty() &&
    options.report.empty() && !options.wantsThickness())
  {
    options.output = options.input.stem().string() + "_medial.vtp";
  }
}

void checkNotTheInput(const char* option, const std::filesystem::path& path, const Options& options)
{
  std::error_code ignored;
  if (!path.empty() && std::filesystem::equivalent(options.input, path, ignored))
  {
    throw Failure(ExitCode::Usage,
      std::string(option) + " " + path.string() + " is the input file itself");
  }
}

// Two outputs of the same name would replace each other.
void checkDistinct(const char* option, const std::filesystem::path& path, const char* other,
  const std::filesystem::path& otherPath)
{
  std::error_code ignored;
  if (!path.empty() &&
    std::filesystem::weakly_canonical(path, ignored) ==
      std::filesystem::weakly_canonical(otherPath, ignored))
  {
    throw Failure(ExitCode::Usage,
      std::string(option) + " and " + other + " name the same file, " + path.string());
  }
}

void checkFiles(const Options& options)
{
  checkExtension("--output", options.output, { ".vtp", ".ply", ".obj", ".ma" });
  checkExtension("--field", options.field, { ".vti", ".pvti" });
  checkExtension("--thickness", options.thickness, { ".vtp" });
  checkExtension("--thickness-image", options.thicknessImage, { ".png" });
  checkExtension("--image", options.image, { ".png" });
  checkExtension("--report", options.report, { ".json" });
  checkNotTheInput("--output", options.output, options);
  checkNotTheInput("--thickness", options.thickness, options);
  checkDistinct("--output", options.output, "--thickness", options.thickness);
  checkDistinct("--image", options.image, "--thickness-image", options.thicknessImage);
}

} // namespace

std::optional<Options> parseOptions(int argc, char** argv)
{
  CLI::App app{ "Medial axis and distance field of a triangle mesh, computed on the GPU.\n" };
  app.footer(kFooter);
  app.name("medial-axis");
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", std::string("medial-axis ") + MEDIAL_VERSION,
    "print the version and leave");
  app.set_help_flag("-h,--help", "print this text and leave");

  Words words;
  Options options;
  app.add_option("INPUT", words.input, "mesh: .stl, .obj, .ply, .off, .vtp or .vtk")
    ->required()
    ->option_text(" ");
  addOutputOptions(app, words);
  addGridOptions(app, words, options);
  addAxisOptions(app, words, options);
  addRunOptions(app, words, options);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      app.exit(error);
      return std::nullopt;
    }
    throw Failure(ExitCode::Usage, std::string(error.what()) + " (see medial-axis --help)");
  }
  convertWords(words, app.count("--spacing") > 0, options);
  checkFiles(options);
  return options;
}

MedialAxisOptions libraryOptions(const Options& options, double diagonal)
{
  MedialAxisOptions result;
  result.angle = options.angle;
  result.lambda = options.lambda.inUnits(diagonal);
  result.radius = options.minRadius.inUnits(diagonal);
  result.side = options.side;
  result.representation = options.representation;
  result.maxSpheres = options.maxSpheres;
  result.topology = options.topology;
  result.field.sign = options.signMethod;
  result.field.evaluator = options.evaluator;
  result.field.threads = options.threads;
  result.field.memoryMiB = static_cast<std::size_t>(options.memoryMiB);
  result.field.requireHardware = options.requireGpu;
  return result;
}

ThicknessOptions thicknessOptions(const Options& options)
{
  ThicknessOptions result;
  result.angle = options.angle;
  result.side = options.side;
  result.threads = options.threads;
  return result;
}

std::string nameOf(Side side)
{
  return nameIn(kSides, side);
}

std::string nameOf(SignMethod method)
{
  return nameIn(kSigns, method);
}

std::string nameOf(Topology topology)
{
  return nameIn(kTopologies, topology);
}

std::string nameOf(Evaluator evaluator)
{
  return nameIn(kEvaluators, evaluator);
}

} // namespace medial::app
