#include "proximity_report.h"

#include "number_text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace medial::app
{
namespace
{

using Json = nlohmann::ordered_json;

// NaN and infinity become null.
Json describe(const ProximityContact& contact)
{
  return { { "point", contact.point }, { "normal", contact.normal }, { "depth", contact.depth },
    { "manifold", contact.manifold }, { "cell_a", contact.cellA }, { "cell_b", contact.cellB } };
}

Json describeDepths(const ProximityOptions& options, const Proximity& pair)
{
  const DepthBounds& bounds = pair.translationalDepth;
  const bool separable = std::isfinite(bounds.upper);
  return { { "depth", pair.depth }, { "depth_at_most", pair.depthAtMost },
    { "deepest_point", pair.depth > 0.0 ? Json(pair.deepestPoint) : Json() },
    { "translational_depth",
      options.translationalDepth ? Json({ bounds.lower, bounds.upper }) : Json() },
    { "separating_translation", separable ? Json(pair.separatingTranslation) : Json() } };
}

Json describe(const ProximityOptions& options, const Proximity& pair)
{
  const bool known = hasWitnesses(pair);
  Json json{ { "a", pair.meshA }, { "b", pair.meshB }, { "separation", pair.separation },
    { "witness_a", known ? Json(pair.witnessA) : Json() },
    { "witness_b", known ? Json(pair.witnessB) : Json() },
    { "cell_a", known ? Json(pair.cellA) : Json() },
    { "cell_b", known ? Json(pair.cellB) : Json() }, { "intersect", pair.intersect },
    { "collide", pair.collide }, { "inside_undefined", pair.insideUndefined } };
  json.update(describeDepths(options, pair));
  json["contacts"] = Json::array();
  for (const ProximityContact& contact : pair.contacts)
  {
    json["contacts"].push_back(describe(contact));
  }
  json["seconds"] = pair.seconds;
  return json;
}

Json describe(const Body& body)
{
  return { { "path", body.input.string() }, { "triangles", body.sequence.mesh.triangles.size() },
    { "vertices", body.sequence.mesh.points.size() }, { "closed", body.closed },
    { "frames", body.frames() } };
}

std::string shown(double number)
{
  return std::isfinite(number) ? roundedText(number) : "-";
}

const char* collisionOf(const Proximity& pair)
{
  return pair.collide ? "yes" : pair.insideUndefined ? "unknown" : "no";
}

void printRow(const ProximityOptions& options, std::size_t frame, const Proximity& pair)
{
  const DepthBounds& bounds = pair.translationalDepth;
  std::printf("%5zu %4d %4d %12s %8s %12s %12s %12s %9zu %9.3f\n", frame, pair.meshA, pair.meshB,
    shown(pair.separation).c_str(), collisionOf(pair), shown(pair.depth).c_str(),
    options.translationalDepth ? shown(bounds.lower).c_str() : "-", shown(bounds.upper).c_str(),
    pair.contacts.size(), 1000.0 * pair.seconds);
}

} // namespace

void printTable(const ProximityCommand& command, const ProximityResults& results)
{
  for (std::size_t i = 0; i < results.bodies.size(); ++i)
  {
    const Body& body = results.bodies[i];
    std::printf("mesh %zu  %s: %zu triangles, %zu vertices, %s\n", i, body.input.c_str(),
      body.sequence.mesh.triangles.size(), body.sequence.mesh.points.size(),
      body.closed ? "closed" : "not closed");
  }
  std::printf("\n%63s %12s\n", "translation", "translation");
  std::printf("%5s %4s %4s %12s %8s %12s %12s %12s %9s %9s\n", "frame", "a", "b", "separation",
    "collide", "depth", "at least", "at most", "contacts", "ms");
  for (std::size_t frame = 0; frame < results.frames.size(); ++frame)
  {
    for (const Proximity& pair : results.frames[frame].pairs)
    {
      printRow(command.options, frame, pair);
    }
  }
}

std::string makeJson(const ProximityCommand& command, const ProximityResults& results)
{
  Json json;
  json["meshes"] = Json::array();
  for (const Body& body : results.bodies)
  {
    json["meshes"].push_back(describe(body));
  }
  json["frames"] = Json::array();
  for (std::size_t frame = 0; frame < results.frames.size(); ++frame)
  {
    Json pairs = Json::array();
    for (const Proximity& pair : results.frames[frame].pairs)
    {
      pairs.push_back(describe(command.options, pair));
    }
    json["frames"].push_back({ { "frame", frame }, { "pairs", std::move(pairs) },
      { "seconds", results.frames[frame].seconds } });
  }
  json["seconds"] = { { "read", results.readSeconds }, { "compute", results.computeSeconds } };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace medial::app
