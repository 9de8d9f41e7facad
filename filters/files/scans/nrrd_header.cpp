#include "files/scans/scan_header.h"

#include "files/file_content.h"
#include "files/scans/header_text.h"

#include <vtkType.h>

#include <cmath>
#include <map>
#include <utility>

// http://teem.sourceforge.net/nrrd/format.html
namespace medial::files
{
namespace
{

int typeOf(const std::string& name)
{
  static const std::map<std::string, int> kTypes = { { "signed char", VTK_SIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR }, { "int8_t", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR },
    { "unsigned char", VTK_UNSIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "uint8_t", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT }, { "short int", VTK_SHORT },
    { "signed short", VTK_SHORT }, { "signed short int", VTK_SHORT }, { "int16", VTK_SHORT },
    { "int16_t", VTK_SHORT }, { "ushort", VTK_UNSIGNED_SHORT },
    { "unsigned short", VTK_UNSIGNED_SHORT }, { "unsigned short int", VTK_UNSIGNED_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT }, { "uint16_t", VTK_UNSIGNED_SHORT }, { "int", VTK_INT },
    { "signed int", VTK_INT }, { "int32", VTK_INT }, { "int32_t", VTK_INT },
    { "uint", VTK_UNSIGNED_INT }, { "unsigned int", VTK_UNSIGNED_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "uint32_t", VTK_UNSIGNED_INT },
    { "longlong", VTK_TYPE_INT64 }, { "long long", VTK_TYPE_INT64 },
    { "long long int", VTK_TYPE_INT64 }, { "signed long long", VTK_TYPE_INT64 },
    { "signed long long int", VTK_TYPE_INT64 }, { "int64", VTK_TYPE_INT64 },
    { "int64_t", VTK_TYPE_INT64 }, { "ulonglong", VTK_TYPE_UINT64 },
    { "unsigned long long", VTK_TYPE_UINT64 }, { "unsigned long long int", VTK_TYPE_UINT64 },
    { "uint64", VTK_TYPE_UINT64 }, { "uint64_t", VTK_TYPE_UINT64 }, { "float", VTK_FLOAT },
    { "double", VTK_DOUBLE } };
  const auto found = kTypes.find(name);
  if (found == kTypes.end())
  {
    refuseContent("its type is '" + name + "', which is not a type of numbers");
  }
  return found->second;
}

ScanEncoding encodingOf(const std::string& name)
{
  if (name == "raw")
  {
    return ScanEncoding::Raw;
  }
  if (name == "gzip" || name == "gz")
  {
    return ScanEncoding::Deflated;
  }
  if (name == "txt" || name == "text" || name == "ascii")
  {
    return ScanEncoding::Text;
  }
  refuseContent("its encoding is '" + name + "', allowed: raw, gzip, ascii");
}

// The numbers of a field that has one for each axis; NaN where an axis has none.
std::vector<double> perAxis(const HeaderFields& fields, const std::string& key, std::size_t axes)
{
  std::vector<double> numbers(axes, std::nan(""));
  const std::vector<std::string> words = wordsOf(fieldOf(fields, key));
  for (std::size_t axis = 0; axis < words.size() && axis < axes; ++axis)
  {
    if (lowerCase(words[axis]) != "nan")
    {
      numbers[axis] = numbersOf({ { key, words[axis] } }, key).front();
    }
  }
  return numbers;
}

// The samples along an axis without a direction: where the first one lies, and the step to the
// next.
struct Samples
{
  double first = std::nan(""); // where the header does not say it
  double step = 1.0;
};

// By 'spacings', 'axis mins' and 'axis maxs'. Samples are in the middles of cells, and the least
// and the greatest position at the ends of cells, unless 'centers' says that these are samples.
std::vector<Samples> samplesOf(const HeaderFields& fields, const std::vector<std::int64_t>& sizes)
{
  const std::vector<double> spacings = perAxis(fields, "spacings", sizes.size());
  const std::vector<double> mins = perAxis(fields, "axis mins", sizes.size());
  const std::vector<double> maxs = perAxis(fields, "axis maxs", sizes.size());
  const std::vector<std::string> centers = wordsOf(lowerCase(fieldOf(fields, "centers")));
  std::vector<Samples> samples(sizes.size());
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
  {
    const bool atNodes = axis < centers.size() && centers[axis] == "node";
    const auto steps = static_cast<double>(sizes[axis] - (atNodes ? 1 : 0));
    if (std::isnan(mins[axis]) && !std::isnan(maxs[axis]))
    {
      refuseContent(
        "'axis maxs' has a number for axis " + std::to_string(axis) + ", but 'axis mins' has none");
    }
    if (!std::isnan(spacings[axis]))
    {
      samples[axis].step = spacings[axis];
    }
    else if (!std::isnan(maxs[axis]) && steps > 0.0)
    {
      samples[axis].step = (maxs[axis] - mins[axis]) / steps;
    }
    samples[axis].first = mins[axis] + (atNodes ? 0.0 : 0.5 * samples[axis].step);
  }
  return samples;
}

// The steps along each axis that is one of space; empty where the axis is none.
using Steps = std::vector<std::vector<double>>;

Steps directionsOf(const HeaderFields& fields, const std::vector<Samples>& samples)
{
  Steps steps;
  if (fields.count("space directions") > 0)
  {
    std::vector<double> vector;
    for (const std::string& word : wordsOf(fields.at("space directions")))
    {
      if (word == "none")
      {
        steps.emplace_back();
        continue;
      }
      vector.push_back(numbersOf({ { "space directions", word } }, "space directions").front());
      if (vector.size() == 3)
      {
        steps.push_back(std::exchange(vector, {}));
      }
    }
    if (!vector.empty())
    {
      refuseContent("'space directions' has a vector that has not three numbers");
    }
  }
  else
  {
    for (std::size_t axis = 0; axis < samples.size(); ++axis)
    {
      std::vector<double> step(3, 0.0);
      step[axis % 3] = samples[axis].step;
      steps.push_back(std::move(step));
    }
  }
  return steps;
}

// Some fields have two names.
std::string nameOf(const std::string& field)
{
  static const std::map<std::string, std::string> kNames = { { "axismins", "axis mins" },
    { "axismaxs", "axis maxs" }, { "centerings", "centers" }, { "datafile", "data file" },
    { "lineskip", "line skip" }, { "byteskip", "byte skip" } };
  const auto found = kNames.find(field);
  return found == kNames.end() ? field : found->second;
}

HeaderFields readFields(HeaderLines& lines)
{
  HeaderFields fields;
  for (std::string_view line = lines.next(); !line.empty(); line = lines.next())
  {
    const std::size_t colon = line.find(':');
    if (line.front() == '#' || colon == std::string_view::npos ||
      line.substr(colon, 2) == ":=") // a comment, or a key of the user's
    {
      continue;
    }
    fields[nameOf(lowerCase(line.substr(0, colon)))] = trimmed(line.substr(colon + 1));
  }
  return fields;
}

// Where the first sample lies: in space, or else along each axis.
std::array<double, 3> originOf(const HeaderFields& fields, const std::vector<Samples>& samples)
{
  const std::vector<double> origin = numbersOf(fields, "space origin");
  if (!origin.empty() && origin.size() != 3)
  {
    refuseContent("'space origin' has " + std::to_string(origin.size()) + " numbers, not three");
  }
  const bool inSpace = !origin.empty() || fields.count("space directions") > 0;
  std::array<double, 3> first{};
  for (std::size_t axis = 0; axis < samples.size() && axis < 3; ++axis)
  {
    const bool hasFirst = !std::isnan(samples[axis].first);
    if (inSpace && hasFirst)
    {
      refuseContent("'axis mins' and 'space " +
        std::string(origin.empty() ? "directions" : "origin") + "' exclude each other");
    }
    first[axis] = hasFirst ? samples[axis].first : 0.0;
  }
  return origin.empty() ? first : std::array<double, 3>{ origin[0], origin[1], origin[2] };
}

// Sets sizes and the frame, of three axes.
void setSpace(const HeaderFields& fields, ScanHeader& header)
{
  const std::vector<std::int64_t> sizes = countsOf(fields, "sizes");
  if (std::to_string(sizes.size()) != fieldOf(fields, "dimension"))
  {
    refuseContent("'dimension' is '" + fieldOf(fields, "dimension") + "', but there are " +
      std::to_string(sizes.size()) + " sizes");
  }
  const std::vector<Samples> samples = samplesOf(fields, sizes);
  const Steps steps = directionsOf(fields, samples);
  if (steps.size() != sizes.size())
  {
    refuseContent("'space directions' has " + std::to_string(steps.size()) + " vectors for " +
      std::to_string(sizes.size()) + " axes");
  }
  std::array<std::array<double, 3>, 3> frame{};
  std::size_t used = 0;
  // An axis that is none of space, or a fourth one, may have one value only.
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
  {
    if (steps[axis].empty() || used == 3)
    {
      if (sizes[axis] != 1)
      {
        refuseContent("has " + std::to_string(sizes[axis]) + " values a voxel or moments (axis " +
          std::to_string(axis) + "); one is needed");
      }
      continue;
    }
    header.dimensions[used] = sizes[axis];
    frame[used++] = { steps[axis][0], steps[axis][1], steps[axis][2] };
  }
  if (used != 3)
  {
    refuseContent("has " + std::to_string(used) + " axes of space; three are needed");
  }
  header.frame = makeFrame(originOf(fields, samples), frame);
}

} // namespace

ScanHeader parseNrrdHeader(std::string_view content)
{
  HeaderLines lines(content);
  if (content.substr(0, 7) != "NRRD000")
  {
    refuseContent("is not an NRRD file: it does not start with NRRD000");
  }
  lines.next();
  const HeaderFields fields = readFields(lines);
  ScanHeader header;
  setSpace(fields, header);
  header.scalarType = typeOf(lowerCase(fieldOf(fields, "type")));
  header.encoding = encodingOf(lowerCase(fieldOf(fields, "encoding", "raw")));
  header.bigEndian = lowerCase(fieldOf(fields, "endian")) == "big";
  header.file = fieldOf(fields, "data file");
  for (const char* skip : { "line skip", "byte skip" })
  {
    const std::string bytes = fieldOf(fields, skip, "0");
    if (bytes == "-1" && std::string_view(skip).substr(0, 4) == "byte")
    {
      header.atEnd = true;
    }
    else if (bytes != "0")
    {
      refuseContent("'" + std::string(skip) + ": " + bytes + "' is not supported");
    }
  }
  header.offset = header.file.empty() ? lines.position() : 0;
  return header;
}

} // namespace medial::files
