#include "medial/axis_curves.h"
#include "base/huge_pages.h"

#include "axis/edge_table.h"
#include "medial/medial_axis.h"

#include <algorithm>

namespace medial
{
namespace
{

using Edge = AxisEdges::Edge;

struct FeatureEdge
{
  Edge edge;
  AxisFeature kind; ///< Rim, Seam or Curve
};

/// Returns all edges except those inside sheets, ascending.
std::vector<FeatureEdge> featureEdges(const AxisEdges& edges, std::size_t pointCount)
{
  std::vector<FeatureEdge> result;
  EdgeTable(edges.polygonEdges, pointCount)
    .forEach(
      [&](const Edge& edge, std::size_t count)
      {
        if (count != 2)
        {
          result.push_back({ edge, count == 1 ? AxisFeature::Rim : AxisFeature::Seam });
        }
      });
  for (const Edge& line : edges.lines)
  {
    result.push_back(
      { { std::min(line[0], line[1]), std::max(line[0], line[1]) }, AxisFeature::Curve });
  }
  return result;
}

/// Numbers of edges of each kind that meet at a point.
struct Valence
{
  bool inSheet = false;
  int rims = 0;
  int seams = 0;
  int curves = 0;

  AxisFeature feature() const
  {
    const bool curveEnds = curves > 0 && (inSheet || curves > 2);
    const bool seamEnds = seams > 0 && (seams != 2 || rims > 0);
    if (curveEnds || seamEnds)
    {
      return AxisFeature::Junction;
    }
    if (curves > 0)
    {
      return AxisFeature::Curve;
    }
    if (seams > 0)
    {
      return AxisFeature::Seam;
    }
    if (rims > 0)
    {
      return AxisFeature::Rim;
    }
    return inSheet ? AxisFeature::Sheet : AxisFeature::Point;
  }
};

std::vector<AxisFeature> featuresOf(const AxisEdges& edges,
  const std::vector<FeatureEdge>& featureEdges, std::size_t pointCount)
{
  std::vector<Valence> valences(pointCount);
  for (const Edge& edge : edges.polygonEdges)
  {
    valences[edge[0]].inSheet = true;
    valences[edge[1]].inSheet = true;
  }
  for (const FeatureEdge& edge : featureEdges)
  {
    for (const std::int64_t point : edge.edge)
    {
      Valence& valence = valences[point];
      ++(edge.kind == AxisFeature::Rim     ? valence.rims
          : edge.kind == AxisFeature::Seam ? valence.seams
                                           : valence.curves);
    }
  }
  std::vector<AxisFeature> features(pointCount);
  std::transform(valences.begin(), valences.end(), features.begin(),
    [](const Valence& valence) { return valence.feature(); });
  return features;
}

/// Chains the edges of one kind.
class Chains
{
public:
  Chains(std::vector<Edge> edges, const std::vector<AxisFeature>& features, AxisFeature kind)
    : edges_(std::move(edges))
    , used_(edges_.size(), 0)
    , features_(features)
    , kind_(kind)
  {
    for (std::size_t e = 0; e < edges_.size(); ++e)
    {
      ends_.push_back({ edges_[e][0], e });
      ends_.push_back({ edges_[e][1], e });
    }
    std::sort(ends_.begin(), ends_.end());
  }

  void append(std::vector<AxisCurve>& curves)
  {
    // Curves with ends come first, so that only loops remain.
    for (std::size_t i = 0; i < ends_.size(); ++i)
    {
      if (this->isEnd(ends_[i].point) && used_[ends_[i].edge] == 0)
      {
        curves.push_back(this->follow(ends_[i]));
      }
    }
    for (const End& end : ends_)
    {
      if (used_[end.edge] == 0)
      {
        curves.push_back(this->follow(end));
      }
    }
  }

private:
  struct End
  {
    std::int64_t point;
    std::size_t edge;

    bool operator<(const End& other) const
    {
      return point != other.point ? point < other.point : edge < other.edge;
    }
  };

  auto endsAt(std::int64_t point) const
  {
    return std::equal_range(ends_.begin(), ends_.end(), End{ point, 0 },
      [](const End& a, const End& b) { return a.point < b.point; });
  }

  bool isEnd(std::int64_t point) const
  {
    const auto range = this->endsAt(point);
    return range.second - range.first != 2 || features_[point] == AxisFeature::Junction;
  }

  AxisCurve follow(End end)
  {
    AxisCurve curve{ kind_, { end.point } };
    while (true)
    {
      used_[end.edge] = 1;
      const Edge& edge = edges_[end.edge];
      const std::int64_t next = edge[0] == end.point ? edge[1] : edge[0];
      curve.points.push_back(next);
      const auto range = this->endsAt(next);
      const auto onward = std::find_if(range.first, range.second,
        [this](const End& candidate) { return used_[candidate.edge] == 0; });
      if (this->isEnd(next) || onward == range.second)
      {
        return curve;
      }
      end = *onward;
    }
  }

  std::vector<Edge> edges_;
  std::vector<std::uint8_t> used_;
  std::vector<End> ends_; ///< of all edges, by point
  const std::vector<AxisFeature>& features_;
  AxisFeature kind_;
};

} // namespace

AxisEdges edgesOf(const MedialAxis& axis)
{
  AxisEdges edges;
  reserveLarge(edges.polygonEdges, 4 * axis.quads.size() + 3 * axis.triangles.size());
  const auto add = [&](const auto& polygon) { addEdges(polygon, edges.polygonEdges); };
  std::for_each(axis.quads.begin(), axis.quads.end(), add);
  std::for_each(axis.triangles.begin(), axis.triangles.end(), add);
  edges.lines = axis.lines;
  return edges;
}

std::vector<AxisFeature> axisFeatures(const AxisEdges& edges, std::size_t pointCount)
{
  return featuresOf(edges, featureEdges(edges, pointCount), pointCount);
}

std::vector<AxisCurve> axisCurves(const AxisEdges& edges, std::size_t pointCount)
{
  const std::vector<FeatureEdge> all = featureEdges(edges, pointCount);
  const std::vector<AxisFeature> features = featuresOf(edges, all, pointCount);
  std::vector<AxisCurve> curves;
  for (const AxisFeature kind : { AxisFeature::Rim, AxisFeature::Seam, AxisFeature::Curve })
  {
    std::vector<Edge> ofKind;
    for (const FeatureEdge& edge : all)
    {
      if (edge.kind == kind)
      {
        ofKind.push_back(edge.edge);
      }
    }
    Chains(std::move(ofKind), features, kind).append(curves);
  }
  return curves;
}

} // namespace medial
