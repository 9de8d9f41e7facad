#include "captions.h"

#include "number_text.h"

#include <algorithm>
#include <cmath>

namespace medial::app
{
namespace
{

constexpr std::size_t kMaxLines = 6;
constexpr int kDigits = 4;

std::string translationOf(const DepthBounds& bounds)
{
  const std::string lower = roundedText(bounds.lower, kDigits);
  const std::string upper = roundedText(bounds.upper, kDigits);
  return ", translation " + (lower == upper ? upper : lower + " to " + upper);
}

std::string figuresOf(const Proximity& pair)
{
  if (!pair.collide)
  {
    return hasWitnesses(pair) ? "separation " + roundedText(pair.separation, kDigits)
                              : "no collision";
  }
  std::string text = "collide";
  if (std::isfinite(pair.depth))
  {
    text = "depth " + roundedText(pair.depth, kDigits);
  }
  if (std::isfinite(pair.translationalDepth.upper))
  {
    text += translationOf(pair.translationalDepth);
  }
  if (!pair.contacts.empty())
  {
    const std::size_t count = pair.contacts.size();
    text += ", " + std::to_string(count) + (count == 1 ? " contact" : " contacts");
  }
  return text;
}

// Those that collide first, the deepest before the others; then the nearest. NaN counts as 0.
std::vector<const Proximity*> byImportance(const std::vector<Proximity>& pairs)
{
  std::vector<const Proximity*> sorted;
  for (const Proximity& pair : pairs)
  {
    sorted.push_back(&pair);
  }
  const auto rank = [](const Proximity* pair)
  {
    const double depth = pair->depth > 0.0 ? pair->depth : 0.0;
    return pair->collide ? -1.0 - depth : hasWitnesses(*pair) ? pair->separation : 0.0;
  };
  std::stable_sort(sorted.begin(), sorted.end(),
    [&](const Proximity* a, const Proximity* b) { return rank(a) < rank(b); });
  return sorted;
}

} // namespace

std::vector<std::string> legend(const std::vector<Body>& bodies)
{
  std::vector<std::string> lines;
  const bool all = bodies.size() <= kMaxLines + 1;
  const std::size_t count = all ? bodies.size() : kMaxLines;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::filesystem::path& input = bodies[i].input;
    const std::filesystem::path name =
      input.has_filename() ? input.filename() : input.parent_path().filename();
    lines.push_back(std::to_string(i) + "  " + name.string());
  }
  if (!all)
  {
    lines.push_back("and " + std::to_string(bodies.size() - count) + " more meshes");
  }
  return lines;
}

std::vector<std::string> caption(const ProximityResults& results, std::size_t frame)
{
  std::vector<std::string> lines;
  if (results.frames.size() > 1)
  {
    lines.push_back("frame " + std::to_string(frame));
  }
  const std::vector<const Proximity*> pairs = byImportance(results.frames[frame].pairs);
  const bool all = pairs.size() <= kMaxLines + 1;
  const std::size_t count = all ? pairs.size() : kMaxLines;
  for (std::size_t i = 0; i < count; ++i)
  {
    lines.push_back(std::to_string(pairs[i]->meshA) + " and " + std::to_string(pairs[i]->meshB) +
      ":  " + figuresOf(*pairs[i]));
  }
  if (!all)
  {
    lines.push_back("and " + std::to_string(pairs.size() - count) + " more pairs");
  }
  return lines;
}

} // namespace medial::app
