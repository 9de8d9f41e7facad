#include "files/xml_elements.h"

#include "files/file_content.h"

#include <algorithm>
#include <utility>

namespace medial::files
{
namespace
{

constexpr std::string_view kBlank = " \t\r\n";

[[noreturn]] void refuse(const std::string& why)
{
  refuseContent("not a complete XML file: " + why);
}

std::string unescaped(std::string_view text)
{
  static const std::pair<std::string_view, char> kEntities[] = { { "&lt;", '<' }, { "&gt;", '>' },
    { "&quot;", '"' }, { "&apos;", '\'' }, { "&amp;", '&' } };
  std::string result;
  while (!text.empty())
  {
    const auto* const entity = std::find_if(std::begin(kEntities), std::end(kEntities),
      [&](const auto& one) { return text.substr(0, one.first.size()) == one.first; });
    const bool found = entity != std::end(kEntities);
    result += found ? entity->second : text.front();
    text.remove_prefix(found ? entity->first.size() : 1);
  }
  return result;
}

class XmlScanner
{
public:
  XmlScanner(std::string_view content, std::string_view last)
    : rest_(content)
    , last_(last)
  {
  }

  std::vector<XmlElement> scan()
  {
    skipTo("<");
    while (!rest_.empty() && !finished_)
    {
      scanMarkup();
    }
    if (elements_.empty())
    {
      refuse("it has no element");
    }
    if (!finished_ && !open_.empty())
    {
      refuse("its element '" + elements_[open_.back()].name + "' has no end");
    }
    return std::move(elements_);
  }

private:
  // Reads what begins with the '<' that was just passed, up to the next one.
  void scanMarkup()
  {
    if (rest_[0] == '?')
    {
      require("?>");
    }
    else if (rest_.substr(0, 3) == "!--")
    {
      require("-->");
    }
    else if (rest_[0] == '!')
    {
      require(">");
    }
    else if (rest_[0] == '/')
    {
      closeElement();
    }
    else
    {
      openElement();
      return;
    }
    skipTo("<");
  }

  void closeElement()
  {
    rest_.remove_prefix(1);
    const std::string_view name = word();
    if (open_.empty() || elements_[open_.back()].name != name)
    {
      refuse("the end of an element that is not open");
    }
    open_.pop_back();
    require(">");
  }

  void openElement()
  {
    const std::size_t index = elements_.size();
    if (open_.empty() && index > 0)
    {
      refuse("it has more than one root element");
    }
    elements_.emplace_back();
    elements_.back().name = word();
    if (!open_.empty())
    {
      elements_[open_.back()].children.push_back(index);
    }
    readAttributes(elements_.back());
    const bool empty = rest_[0] == '/';
    require(">");
    if (!empty)
    {
      open_.push_back(index);
      finished_ = elements_.back().name == last_;
    }
    elements_.back().text = rest_.substr(0, finished_ ? rest_.size() : rest_.find('<'));
    skipTo("<");
  }

  void readAttributes(XmlElement& element)
  {
    while (skipBlank(), rest_[0] != '>' && rest_[0] != '/')
    {
      const std::string name(word());
      skipBlank();
      if (name.empty() || rest_[0] != '=')
      {
        refuse("an attribute of element '" + element.name + "' has no value");
      }
      rest_.remove_prefix(1);
      skipBlank();
      const char quote = rest_[0];
      const std::size_t end = rest_.find(quote, 1);
      if ((quote != '"' && quote != '\'') || end == std::string_view::npos)
      {
        refuse("the value of attribute '" + name + "' is not quoted");
      }
      element.attributes[name] = unescaped(rest_.substr(1, end - 1));
      rest_.remove_prefix(end + 1);
    }
  }

  // Takes a name.
  std::string_view word()
  {
    const std::string_view result = rest_.substr(0, rest_.find_first_of(" \t\r\n=/>"));
    rest_.remove_prefix(result.size());
    return result;
  }

  // Leaves at least one character.
  void skipBlank()
  {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlank), rest_.size()));
    if (rest_.empty())
    {
      refuse("it ends within a tag");
    }
  }

  // Passes the next `mark`, or goes to the end.
  bool skipTo(std::string_view mark)
  {
    const std::size_t place = rest_.find(mark);
    const bool found = place != std::string_view::npos;
    rest_.remove_prefix(found ? place + mark.size() : rest_.size());
    return found;
  }

  void require(std::string_view mark)
  {
    if (!skipTo(mark))
    {
      refuse("it ends within a tag");
    }
  }

  std::string_view rest_;
  std::string_view last_;
  std::vector<XmlElement> elements_;
  std::vector<std::size_t> open_; // elements whose end has not come yet, innermost last
  bool finished_ = false;
};

} // namespace

std::string XmlElement::attribute(const std::string& key, const std::string& otherwise) const
{
  const auto found = attributes.find(key);
  return found == attributes.end() ? otherwise : found->second;
}

std::vector<XmlElement> scanXml(std::string_view content, std::string_view last)
{
  return XmlScanner(content, last).scan();
}

const XmlElement* childOf(const std::vector<XmlElement>& elements, const XmlElement& parent,
  const std::string& name)
{
  for (const std::size_t child : parent.children)
  {
    if (elements[child].name == name)
    {
      return &elements[child];
    }
  }
  return nullptr;
}

std::string escapedXml(const std::string& text)
{
  std::string result;
  for (const char character : text)
  {
    switch (character)
    {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += character;
    }
  }
  return result;
}

} // namespace medial::files
