#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace medial::files
{

/// One element of an XML text.
struct XmlElement
{
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string_view text;             ///< from its start tag to the next tag
  std::vector<std::size_t> children; ///< indices of its child elements

  /// The value of an attribute, or `otherwise` where it has none of that name.
  std::string attribute(const std::string& key, const std::string& otherwise) const;
};

/// The elements of a text in the order of their start tags; the first is the root. It reads what
/// VTK's files have: no name spaces, no CDATA, of entities only those of XML itself.
/// @param content must outlive the result, whose texts point into it.
/// @param last an element that ends the reading: its text is all that follows, and need not be XML.
/// @throws Error InvalidInput, without the name of the file.
std::vector<XmlElement> scanXml(std::string_view content, std::string_view last);

/// The first child of an element with a name; null if it has none.
const XmlElement* childOf(const std::vector<XmlElement>& elements, const XmlElement& parent,
  const std::string& name);

/// A text as it stands in an attribute of XML.
std::string escapedXml(const std::string& text);

} // namespace medial::files
