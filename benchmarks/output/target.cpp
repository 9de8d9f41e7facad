#include "output/target.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace medial::benchmark
{
namespace
{

/// Bounds are round figures.
std::string plain(double value)
{
  std::ostringstream text;
  text << std::setprecision(4) << value;
  return text.str();
}

} // namespace

std::string Target::verdict() const
{
  if (!applies || !std::isfinite(measured))
  {
    return "-";
  }
  const bool met = kind == Kind::AtLeast ? measured >= bound : measured <= bound;
  return met ? "met" : "missed";
}

Table targetTable(const std::vector<Target>& targets)
{
  Table table;
  table.title = "Targets:";
  table.columns = { "mesh", "what", "target", "measured", "" };
  for (const Target& target : targets)
  {
    const std::string sense = target.kind == Target::Kind::AtLeast ? "at least " : "at most ";
    table.rows.push_back({ target.mesh, target.what, sense + plain(target.bound),
      number(target.measured), target.verdict() });
  }
  return table;
}

nlohmann::json toJson(const Target& target)
{
  return { { "mesh", target.mesh }, { "what", target.what },
    { "kind", target.kind == Target::Kind::AtLeast ? "at least" : "at most" },
    { "bound", target.bound }, { "measured", target.measured }, { "verdict", target.verdict() } };
}

} // namespace medial::benchmark
