#include "scan_files.h"

#include <zlib.h>

#include <cmath>
#include <cstring>
#include <sstream>

namespace medial::test
{
namespace
{

using Matrix = std::array<std::array<double, 3>, 3>;

// A turn about z, then one about x.
Matrix someRotation()
{
  constexpr double kAboutZ = 0.5;
  constexpr double kAboutX = -0.4;
  const double c = std::cos(kAboutZ);
  const double s = std::sin(kAboutZ);
  const double d = std::cos(kAboutX);
  const double t = std::sin(kAboutX);
  return { { { c, -s * d, s * t }, { s, c * d, -c * t }, { 0.0, t, d } } };
}

std::string replacedIn(std::string text, const Replacement& replaced)
{
  if (!replaced.first.empty())
  {
    text.replace(text.find(replaced.first), replaced.first.size(), replaced.second);
  }
  return text;
}

std::string column(const files::ScanFrame& frame, std::size_t axis, double scale, char between)
{
  std::ostringstream text;
  text.precision(17);
  text << frame[0][axis] * scale << between << frame[1][axis] * scale << between
       << frame[2][axis] * scale;
  return text.str();
}

template <typename T>
void put(std::string& bytes, std::size_t offset, T value, bool bigEndian)
{
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i)
  {
    bytes[offset + i] = raw[bigEndian ? sizeof(T) - 1 - i : i];
  }
}

} // namespace

LabelImage::LabelImage(const std::function<int(double)>& labelAt, bool mirrored)
{
  const Matrix rotation = someRotation();
  std::array<std::array<double, 3>, 3> steps{};
  std::array<double, 3> origin = kImageCentre;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      steps[axis][row] =
        rotation[row][axis] * kImageSteps[axis] * (mirrored && axis == 0 ? -1.0 : 1.0);
      origin[row] -= steps[axis][row] * (size[axis] - 1) / 2.0;
    }
  }
  frame = medial::files::makeFrame(origin, steps);
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        const double i = kImageSteps[0] * (x - (size[0] - 1) / 2.0);
        const double j = kImageSteps[1] * (y - (size[1] - 1) / 2.0);
        const double k = kImageSteps[2] * (z - (size[2] - 1) / 2.0);
        values.push_back(static_cast<std::int16_t>(labelAt(std::hypot(i, j, k))));
      }
    }
  }
}

std::string LabelImage::bytes() const
{
  return { reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]) };
}

std::string LabelImage::swappedBytes() const
{
  std::string swapped = this->bytes();
  for (std::size_t i = 0; i + 1 < swapped.size(); i += 2)
  {
    std::swap(swapped[i], swapped[i + 1]);
  }
  return swapped;
}

std::string deflated(const std::string& bytes, bool gzip)
{
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, gzip ? 15 + 16 : 15, 8, Z_DEFAULT_STRATEGY);
  std::string result(deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

std::string nrrdFile(const LabelImage& image, const std::string& encoding,
  const Replacement& replaced)
{
  std::ostringstream header;
  header << "NRRD0005\n# a ball\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: "
         << image.size[0] << ' ' << image.size[1] << ' ' << image.size[2] << "\nspace directions:";
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    header << " (" << column(image.frame, axis, 1.0, ',') << ')';
  }
  header << "\nkinds: domain domain domain\nendian: little\nencoding: " << encoding
         << "\nspace origin: (" << column(image.frame, 3, 1.0, ',') << ")\nSegment0_ID:=ball\n\n";
  std::string values = image.bytes();
  if (encoding == "gzip")
  {
    values = deflated(values, true);
  }
  else if (encoding == "ascii")
  {
    std::ostringstream words;
    for (const std::int16_t value : image.values)
    {
      words << value << '\n';
    }
    values = words.str();
  }
  return replacedIn(header.str(), replaced) + values;
}

std::string metaImageFile(const LabelImage& image, bool compressed, const std::string& data,
  const Replacement& replaced)
{
  std::ostringstream header;
  header.precision(17);
  header << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         << "CompressedData = " << (compressed ? "True" : "False") << "\nTransformMatrix =";
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    header << ' ' << column(image.frame, axis, 1.0 / kImageSteps[axis], ' ');
  }
  header << "\nOffset = " << column(image.frame, 3, 1.0, ' ') << "\nCenterOfRotation = 0 0 0\n"
         << "ElementSpacing = " << kImageSteps[0] << ' ' << kImageSteps[1] << ' ' << kImageSteps[2]
         << "\nDimSize = " << image.size[0] << ' ' << image.size[1] << ' ' << image.size[2]
         << "\nElementType = MET_SHORT\nElementDataFile = " << data << '\n';
  std::string values;
  if (data == "LOCAL")
  {
    values = compressed ? deflated(image.bytes(), false) : image.bytes();
  }
  return replacedIn(header.str(), replaced) + values;
}

std::string niftiFile(const LabelImage& image, NiftiSpace space, bool bigEndian)
{
  std::string bytes(352, '\0');
  const auto number = [&](std::size_t offset, auto value) { put(bytes, offset, value, bigEndian); };
  number(0, std::int32_t{ 348 });
  number(40, std::int16_t{ 3 });
  for (std::size_t axis = 0; axis < 7; ++axis)
  {
    number(42 + 2 * axis, static_cast<std::int16_t>(axis < 3 ? image.size[axis] : 1));
    number(80 + 4 * axis, axis < 3 ? static_cast<float>(kImageSteps[axis]) : 1.0F);
  }
  number(70, std::int16_t{ 4 });
  number(72, std::int16_t{ 16 });
  number(76, 1.0F);
  number(108, 352.0F);
  if (space == NiftiSpace::Sform)
  {
    number(254, std::int16_t{ 1 });
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t k = 0; k < 4; ++k)
      {
        number(280 + 16 * row + 4 * k, static_cast<float>(image.frame[row][k]));
      }
    }
  }
  else
  {
    // The quaternion of a rotation matrix with a positive trace.
    const auto at = [&](std::size_t row, std::size_t axis)
    { return image.frame[row][axis] / kImageSteps[axis]; };
    const double a = 0.5 * std::sqrt(1.0 + at(0, 0) + at(1, 1) + at(2, 2));
    number(252, std::int16_t{ 1 });
    number(256, static_cast<float>(0.25 * (at(2, 1) - at(1, 2)) / a));
    number(260, static_cast<float>(0.25 * (at(0, 2) - at(2, 0)) / a));
    number(264, static_cast<float>(0.25 * (at(1, 0) - at(0, 1)) / a));
    for (std::size_t row = 0; row < 3; ++row)
    {
      number(268 + 4 * row, static_cast<float>(image.frame[row][3]));
    }
  }
  bytes.replace(344, 3, "n+1");
  return bytes + (bigEndian ? image.swappedBytes() : image.bytes());
}

} // namespace medial::test
