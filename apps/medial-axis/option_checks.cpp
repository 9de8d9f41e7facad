#include "option_checks.h"

#include "command_line.h"
#include "failure.h"
#include "input/input_file.h"
#include "option_names.h"
#include "output/json_output.h"
#include "output/output_names.h"
#include "ranks/mesh_pieces.h"
#include "scan_options.h"
#include "volumes/vdb_file.h"
#include "web/web_files.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace medial::app
{
namespace
{

FieldSelection parseFieldArrays(const std::string& list)
{
  FieldSelection selection{ true }; // the distance
  std::istringstream words(list + ",");
  for (std::string word; std::getline(words, word, ',');)
  {
    const auto* array = std::find_if(kFieldArrays.begin(), kFieldArrays.end(),
      [&word](const FieldArrayFormat& format) { return word == format.word; });
    if (array == kFieldArrays.end())
    {
      throw Failure(ExitCode::Usage,
        "--field-arrays: '" + word +
          "' is none of distance, closest_point, closest_cell, closest_feature, closest_site");
    }
    selection[static_cast<std::size_t>(array - kFieldArrays.begin())] = true;
  }
  return selection;
}

void checkVdb(const Options& options)
{
  const bool isVdb = fieldFormatOf(options.field) == FieldFormat::Vdb;
  if (isVdb)
  {
    loadVdb(options.field);
  }
  if (options.band && !isVdb)
  {
    throw Failure(ExitCode::Usage, "--band needs --field FILE.vdb");
  }
}

// Volumes hold the distance alone.
FieldSelection fieldArraysOf(const std::filesystem::path& field, const std::string& list)
{
  const bool isVolume = fieldFormatOf(field) != FieldFormat::Vti;
  if (list.empty())
  {
    return isVolume ? FieldSelection{ true } : kAllFieldArrays;
  }
  const FieldSelection selection = parseFieldArrays(list);
  if (isVolume && selection != FieldSelection{ true })
  {
    throw Failure(ExitCode::Usage,
      "--field-arrays " + list + ": " + field.string() +
        " holds the distance alone; .vti and .pvti hold the others as well");
  }
  return selection;
}

std::optional<Length> lengthOf(const std::string& text)
{
  return text.empty() ? std::nullopt : parseLength(text);
}

void convertThickness(const OptionTexts& texts, Options& options)
{
  options.thickness = texts.thickness;
  options.thicknessImage = texts.thicknessImage;
  options.thinRegions = texts.thinRegions;
  if (!texts.thicknessMethod.empty())
  {
    options.thicknessMethod = thicknessMethodNames().at(texts.thicknessMethod);
  }
  options.minThickness = lengthOf(texts.minThickness);
  options.maxThickness = lengthOf(texts.maxThickness);
  options.maxEdge = lengthOf(texts.maxEdge);
  const auto needs = [](const char* option, const std::string& value, bool given, const char* what)
  {
    if (!value.empty() && !given)
    {
      throw Failure(ExitCode::Usage, std::string(option) + " " + value + " needs " + what);
    }
  };
  const char* const kAny = "--thickness, --thickness-image, --min-thickness or --max-thickness";
  needs("--thickness-method", texts.thicknessMethod, options.wantsThickness(), kAny);
  needs("--max-edge", texts.maxEdge, options.wantsThickness(), kAny);
  needs("--thin-regions", texts.thinRegions, options.hasThicknessLimits(),
    "--min-thickness or --max-thickness");
}

/// The input with all files that are read because of it.
NamedInput inputOf(const Options& options)
{
  NamedInput input{ options.input, filesOfScan(options.input) };
  const std::vector<std::filesystem::path> pieces = filesOfPieces(options.input);
  input.files.insert(input.files.end(), pieces.begin(), pieces.end());
  return input;
}

} // namespace

void convertTexts(const OptionTexts& texts, bool spacingGiven, Options& options)
{
  options.signMethod = signNames().at(texts.sign);
  options.engine = engineNames().at(texts.engine);
  options.lambda = parseLength(texts.lambda).value_or(Length{});
  options.minRadius = parseLength(texts.minRadius).value_or(Length{});
  options.side = sideNames().at(texts.side);
  options.representation = representationNames().at(texts.representation);
  options.topology = topologyNames().at(texts.topology);
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
  if (!texts.curves.empty() && options.representation == Representation::Points)
  {
    throw Failure(ExitCode::Usage,
      "--curves needs --representation surface or faces: points have no cells that meet");
  }
  options.input = texts.input;
  options.output = texts.output;
  options.curves = texts.curves;
  options.skeleton = texts.skeleton;
  options.skeletonTable = texts.skeletonTable;
  options.field = texts.field;
  options.fieldArrays = fieldArraysOf(options.field, texts.fieldArrays);
  options.localThickness = texts.localThickness;
  options.histogram = texts.histogram;
  convertThickness(texts, options);
  options.image = texts.image;
  options.html = texts.html;
  options.report = texts.report;
  if (texts.resolution == kAutoResolution)
  {
    options.resolution = std::nullopt;
  }
  else if (!texts.resolution.empty())
  {
    int resolution = kDefaultResolution;
    CLI::detail::lexical_cast(texts.resolution, resolution); // checked by the option
    options.resolution = resolution;
  }
  if (spacingGiven)
  {
    options.spacing = texts.spacing;
  }
  if (options.output.empty() && options.curves.empty() && options.field.empty() &&
    options.localThickness.empty() && options.image.empty() && options.html.empty() &&
    options.report.empty() && !options.coverage && !options.wantsThickness() &&
    !options.wantsSkeleton())
  {
    options.output = stemOf(options.input) + "_medial.vtp";
  }
}

void convertSkeleton(const OptionTexts& texts, const GivenOptions& given, Options& options)
{
  if (!options.wantsSkeleton())
  {
    for (const auto& [name, isGiven] :
      { std::pair("--min-branch", given.minBranch), std::pair("--no-smooth", !options.smooth) })
    {
      if (isGiven)
      {
        throw Failure(ExitCode::Usage, std::string(name) + " needs --skeleton or --skeleton-table");
      }
    }
    if (!options.resolution)
    {
      throw Failure(ExitCode::Usage,
        "--resolution auto is what a skeleton needs: it needs --skeleton or --skeleton-table");
    }
    return;
  }
  const auto refuse = [](const std::string& what) { throw Failure(ExitCode::Usage, what); };
  if (given.topology && options.topology != Topology::Preserve)
  {
    refuse("--skeleton needs --topology preserve, not " + texts.topology);
  }
  if (options.side != Side::Interior)
  {
    refuse("--skeleton needs --side interior, not " + texts.side);
  }
  if (options.representation != Representation::Surface)
  {
    refuse("--skeleton needs --representation surface, not " + texts.representation);
  }
  if (options.maxSpheres > 0)
  {
    refuse("--skeleton needs the whole axis: --max-spheres " + std::to_string(options.maxSpheres) +
      " leaves balls out");
  }
  if (options.signMethod == SignMethod::None)
  {
    refuse("--skeleton needs to know inside from outside, which --sign none does not tell");
  }
  options.topology = Topology::Preserve;
}

void checkFiles(const Options& options)
{
  checkExtension("--output", options.output, { ".vtp", ".pvtp", ".ply", ".obj", ".ma" });
  checkExtension("--curves", options.curves, { ".vtp" });
  checkExtension("--skeleton", options.skeleton, { ".vtp" });
  checkExtension("--skeleton-table", options.skeletonTable, { ".csv" });
  checkScanOptions(options.input, options.scan);
  checkExtension("--field", options.field, { ".vti", ".pvti", ".nrrd", ".mha", ".nii.gz", ".vdb" });
  checkVdb(options);
  checkExtension("--local-thickness", options.localThickness,
    { ".vti", ".pvti", ".nrrd", ".mha", ".nii.gz" });
  checkExtension("--histogram", options.histogram, { ".png" });
  checkExtension("--thickness", options.thickness, { ".vtp", ".pvtp" });
  checkExtension("--thickness-image", options.thicknessImage, { ".png" });
  checkExtension("--thin-regions", options.thinRegions, { ".vtp" });
  checkExtension("--image", options.image, { ".png" });
  checkExtension("--html", options.html, { ".html" });
  checkJsonName("--report", options.report);
  checkNames({ { "--output", options.output }, { "--curves", options.curves },
               { "--skeleton", options.skeleton }, { "--skeleton-table", options.skeletonTable },
               { "--thickness", options.thickness }, { "--thin-regions", options.thinRegions },
               { "--field", options.field }, { "--local-thickness", options.localThickness },
               { "--histogram", options.histogram }, { "--image", options.image },
               { "--thickness-image", options.thicknessImage }, { "--html", options.html },
               { "--report", options.report } },
    { inputOf(options) });
  if (!options.html.empty() && webFile("vtk.js").empty())
  {
    throw Failure(ExitCode::Usage,
      "--html " + options.html.string() +
        ": this build is without vtk.js, which pages need; `./check --web` makes one with it, or "
        "scripts/fetch-vtkjs and cmake -DMEDIAL_VTKJS=FILE");
  }
}

} // namespace medial::app
