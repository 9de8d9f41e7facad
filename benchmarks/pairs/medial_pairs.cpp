#include "pairs/pair_method.h"

#include "medial/proximity.h"

#include <algorithm>

namespace medial::benchmark
{
namespace
{

ProximityOptions optionsFor(PairQuestion question)
{
  ProximityOptions options;
  if (question == PairQuestion::Collision)
  {
    options.separation = false;
    options.depths = false;
    options.translationalDepth = false;
    options.maxContacts = 0;
  }
  else if (question == PairQuestion::SeparationOrDepth)
  {
    options.translationalDepth = false;
    options.maxContacts = 0;
    // Depths of points are exact in any case; this saves the search between them.
    options.depthTolerance = 0.9;
  }
  return options;
}

double deepest(const std::vector<PointDepth>& depths)
{
  double depth = 0.0;
  for (const PointDepth& point : depths)
  {
    depth = std::max(depth, point.depth);
  }
  return depth;
}

class MedialPairs final : public PairMethod
{
public:
  explicit MedialPairs(PairQuestion question)
    : question_(question)
    , options_(optionsFor(question))
  {
  }

  std::string name() const override
  {
    switch (question_)
    {
      case PairQuestion::Collision:
        return "Medial, collision";
      case PairQuestion::SeparationOrDepth:
        return "Medial, separation or depths";
      default:
        return "Medial, all answers";
    }
  }

  void start(const TriangleMesh& a, const TriangleMesh& b) override
  {
    solver_ = std::make_unique<ProximitySolver>(std::vector<TriangleMesh>{ a, b });
  }

  void update(const std::vector<Point3>& a, const std::vector<Point3>& b) override
  {
    solver_->setPoints(0, a);
    solver_->setPoints(1, b);
  }

  PairAnswer answer() override
  {
    const Proximity& proximity = solver_->compute(options_).front();
    PairAnswer answer;
    answer.collide = proximity.collide;
    if (question_ == PairQuestion::Collision)
    {
      return answer;
    }
    answer.separation = proximity.separation;
    answer.pointDepth = std::max(deepest(proximity.depthsOfA), deepest(proximity.depthsOfB));
    answer.depth = proximity.depth;
    if (question_ == PairQuestion::Contacts)
    {
      answer.contacts = static_cast<int>(proximity.contacts.size());
    }
    return answer;
  }

private:
  PairQuestion question_;
  ProximityOptions options_;
  std::unique_ptr<ProximitySolver> solver_;
};

} // namespace

std::unique_ptr<PairMethod> makeMedialPairs(PairQuestion question)
{
  return std::make_unique<MedialPairs>(question);
}

} // namespace medial::benchmark
