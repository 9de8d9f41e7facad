#pragma once

#include "files/xml_elements.h"

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace medial::files
{

/// How the arrays of a file of VTK's XML formats are kept.
struct VtpEncoding
{
  bool bigEndian = false;
  std::size_t headerWord = 4; ///< bytes of a number in the header of an array: 4 or 8
  std::string compressor;     ///< VTK's class; empty without
  std::string_view appended;  ///< what offsets count from; empty if all arrays are inline
  bool appendedBase64 = false;
};

/// The encoding that the root of a file states, and where its appended data begin.
/// @param elements of the file, as scanXml() makes them; its texts point into the same content.
/// @throws Error InvalidInput, without the name of the file.
VtpEncoding encodingOf(const std::vector<XmlElement>& elements);

/// Reads the arrays of a file. What a header asks for is compared with the bytes that are there
/// before memory is allocated, and no byte is read for two arrays: what all arrays take together is
/// limited, too. Decompressed they are at most 64 MiB and `ratio` times as large as the file.
///
/// Errors are InvalidInput, without the name of the file.
class VtpArrays
{
public:
  /// @param encoding its texts must outlive this object.
  /// @param fileSize in bytes.
  VtpArrays(VtpEncoding encoding, std::size_t fileSize, std::size_t ratio = 64);

  /// Reads the numbers of an element DataArray.
  /// @param tuples how many it must have.
  /// @return an array of its type and with its name; null if it holds no numbers.
  vtkSmartPointer<vtkDataArray> read(const XmlElement& element, std::int64_t tuples);

  /// Reads the numbers of an element DataArray as integers, however many there are.
  std::vector<std::int64_t> readIntegers(const XmlElement& element);

private:
  std::string readBytes(const XmlElement& element);
  std::string readBinary(std::string_view text, bool base64);
  std::string readCompressed(std::string_view text, bool base64);
  void spend(std::size_t bytes);
  void expand(std::size_t bytes);

  VtpEncoding encoding_;
  std::size_t unread_;     // bytes of the file that no array has taken
  std::size_t expandable_; // bytes that arrays may still become in memory
};

} // namespace medial::files
