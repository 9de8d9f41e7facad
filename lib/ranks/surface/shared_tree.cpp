#include "ranks/surface/shared_tree.h"

#include "base/sorted_set.h"
#include "ranks/surface/point_rings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace medial
{
namespace
{

float slackOf(Communicator& communicator, const DistributedSurface& surface, const GridFrame& frame)
{
  double squared = 0.0;
  for (const FaceRecord& face : surface.faces())
  {
    for (const Point3& point : face.points)
    {
      const glm::dvec3 local = frame.toLocal(point);
      squared = std::max(squared, glm::dot(local, local));
    }
  }
  return roundingNear(frame.reach(), std::sqrt(maximum(communicator, squared)));
}

float reachWithin(float nearest, const FrameBox& box, float slack)
{
  return nearest + 2.0f * (glm::length(box.half) + slack);
}

} // namespace

SharedTree::Own::Own(SurfacePart surface, const GridFrame& frame)
  : part(std::move(surface))
  , sites(part.mesh(), part.connectivity(), frame)
{
}

SharedTree::SharedTree(Communicator& communicator, const DistributedSurface& surface,
  const GridFrame& frame)
  : surface_(surface)
  , frame_(frame)
  , ranks_(communicator.size())
  , slack_(slackOf(communicator, surface, frame))
  , elements_(shareElements(communicator, surface, frame))
{
  std::vector<int> points;
  points.reserve(3 * elements_.elements.size());
  for (const SharedElement& element : elements_.elements)
  {
    points.insert(points.end(), element.corners.begin(), element.corners.end());
  }
  own_ = this->fetchOwn(communicator, std::move(points));
  this->buildBlocks(communicator);
  std::vector<SharedElement>().swap(elements_.elements);
  this->buildOwnTree();
}

std::unique_ptr<SharedTree::Own> SharedTree::fetchOwn(Communicator& communicator,
  std::vector<int> points) const
{
  return std::make_unique<Own>(
    SurfacePart(communicator, surface_, facesAround(communicator, surface_, std::move(points))),
    frame_);
}

std::vector<int> SharedTree::cornersOfOwn(Communicator& communicator) const
{
  std::vector<int> faces;
  for (const GroupRecord& record : groups_)
  {
    faces.insert(faces.end(), record.group.elements.begin(),
      record.group.elements.begin() + record.group.count);
  }
  std::sort(faces.begin(), faces.end());
  std::vector<int> points;
  for (const FaceRecord& face : surface_.fetch(communicator, faces))
  {
    points.insert(points.end(), face.corners.begin(), face.corners.end());
  }
  return points;
}

void SharedTree::buildBlocks(Communicator& communicator)
{
  const SharedSites shared(own_->sites, own_->part.connectivity());
  std::map<int, int> treeOf;
  for (std::size_t i = 0; i < elements_.trees.size(); ++i)
  {
    treeOf[elements_.trees[i].sizeClass] = static_cast<int>(i);
  }
  std::vector<Block> own;
  const SharedElement* const last = elements_.elements.data() + elements_.elements.size();
  for (const SharedElement* begin = elements_.elements.data(); begin != last;)
  {
    const SharedElement* end = begin;
    while (end != last && end->sizeClass == begin->sizeClass && end->first == begin->first)
    {
      ++end;
    }
    own.push_back(this->buildBlock(shared, begin, end, treeOf[begin->sizeClass]));
    begin = end;
  }
  for (const std::vector<Block>& list : gathered(communicator, own))
  {
    blocks_.insert(blocks_.end(), list.begin(), list.end());
  }
  this->buildTop(blocks_);
}

int SharedTree::levelsOfBlock(int tree) const
{
  int levels = 0;
  for (int size = elements_.trees[tree].blockSize; size > SiteGroup::kSize; size /= kLanes)
  {
    ++levels;
  }
  return levels;
}

SharedTree::Block SharedTree::buildBlock(const SharedSites& shared, const SharedElement* begin,
  const SharedElement* end, int tree)
{
  std::vector<ElementPlace> places;
  for (const SharedElement* element = begin; element != end; ++element)
  {
    places.push_back(element->place);
  }
  sortByHalves(places.data(), places.data() + places.size());
  std::vector<NodeDisc> discs;
  int number = begin->first / SiteGroup::kSize;
  for (std::size_t first = 0; first < places.size(); first += SiteGroup::kSize)
  {
    GroupRecord record{ tree, { number++, 0, {} } };
    std::array<int, SiteGroup::kSize> local{};
    for (std::size_t i = first; i < std::min(first + SiteGroup::kSize, places.size()); ++i)
    {
      record.group.elements[record.group.count++] = places[i].site;
    }
    std::sort(record.group.elements.begin(), record.group.elements.begin() + record.group.count);
    for (int i = 0; i < record.group.count; ++i)
    {
      local[i] = own_->part.faceOf(record.group.elements[i]);
    }
    discs.push_back(discOf(own_->sites, shared,
      makeSiteGroup(own_->sites, shared, local.data(), record.group.count)));
    groups_.push_back(record);
  }
  int size = SiteGroup::kSize * kLanes;
  for (int level = 0; level < this->levelsOfBlock(tree); ++level, size *= kLanes)
  {
    int pack = begin->first / size;
    for (const Discs& eight : packed(discs, slack_))
    {
      packs_.push_back({ tree, level, { pack++, eight } });
    }
  }
  return { discs.front(),
    own_->sites.points()[own_->sites.faces()[own_->part.faceOf(places.front().site)][0]] };
}

void SharedTree::buildTop(const std::vector<Block>& blocks)
{
  auto block = blocks.begin();
  for (std::size_t tree = 0; tree < elements_.trees.size(); ++tree)
  {
    std::vector<NodeDisc> discs;
    for (int i = 0; i < elements_.trees[tree].blocks(); ++i)
    {
      discs.push_back((block++)->disc);
    }
    int level = this->levelsOfBlock(static_cast<int>(tree));
    do
    {
      int number = 0;
      for (const Discs& eight : packed(discs, slack_))
      {
        top_.push_back({ static_cast<int>(tree), level, { number++, eight } });
      }
      ++level;
    } while (discs.size() > 1);
  }
}

void SharedTree::buildOwnTree()
{
  std::vector<PackRecord> packs = packs_;
  packs.insert(packs.end(), top_.begin(), top_.end());
  std::vector<SparseTree> trees = treesOf(groups_, packs, elements_.trees.size());
  if (trees.empty())
  {
    return;
  }
  nameByPart(own_->part, trees);
  own_->tree.emplace(own_->sites, own_->part.connectivity(), slack_, trees);
}

std::vector<float> SharedTree::bounds(const std::vector<FrameBox>& boxes) const
{
  std::vector<float> result;
  for (const FrameBox& box : boxes)
  {
    double squared = std::numeric_limits<double>::infinity();
    for (const Block& block : blocks_)
    {
      const glm::dvec3 offset = block.point - glm::dvec3(box.centre);
      squared = std::min(squared, glm::dot(offset, offset));
    }
    // Rounded up, and by what the search rounds.
    result.push_back(static_cast<float>(std::sqrt(squared) * (1.0 + 1e-4)) + slack_);
  }
  return result;
}

RankLists<int> SharedTree::ranksOf(const std::vector<Search>& searches) const
{
  std::vector<NodeDisc> discs;
  for (const Block& block : blocks_)
  {
    discs.push_back(block.disc);
  }
  const std::vector<Discs> packs = packed(discs, slack_);
  RankLists<int> result(static_cast<std::size_t>(ranks_));
  for (std::size_t search = 0; search < searches.size(); ++search)
  {
    const BoxReach reach = searches[search].reach();
    for (std::size_t pack = 0; pack < packs.size(); ++pack)
    {
      for (unsigned met = reach.meets(packs[pack]); met != 0; met &= met - 1)
      {
        const int block = static_cast<int>(pack) * kLanes + __builtin_ctz(met);
        std::vector<int>& list = result[elements_.home(block, ranks_)];
        if (list.empty() || list.back() != static_cast<int>(search))
        {
          list.push_back(static_cast<int>(search));
        }
      }
    }
  }
  return result;
}

BoxReach SharedTree::Search::reach() const
{
  BoxReach reach(box, distance);
  for (int i = 0; i < pointCount; ++i)
  {
    reach.add(points[i]);
  }
  return reach;
}

SharedTree::Nearest SharedTree::nearestTo(const FrameBox& box) const
{
  const GroupTree& tree = *own_->tree;
  Nearest result{};
  NearestElement start;
  for (std::size_t i = 0; i < result.squared.size(); ++i)
  {
    const glm::dvec3 x = glm::dvec3(box.centre) +
      (i > 0 ? glm::dvec3(box.corner(static_cast<int>(i) - 1)) : glm::dvec3(0.0));
    NearestElement found;
    if (i > 0)
    {
      found.tryGroup(tree.groups(), start.group, x);
    }
    found = tree.nearest(x, found);
    start = found;
    const int element = tree.groups()[found.group].elements[found.lane];
    result.squared[i] = found.squared;
    result.face[i] = own_->part.faces()[element];
    result.point[i] = glm::vec3(closestPoint(tree.sites(), element, x).point);
  }
  return result;
}

void SharedTree::sharpen(Communicator& communicator, std::vector<Search>& searches) const
{
  const RankLists<int> asked = this->ranksOf(searches);
  RankLists<FrameBox> boxes(asked.size());
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    for (const int search : asked[rank])
    {
      boxes[rank].push_back(searches[search].box);
    }
  }
  boxes = exchanged(communicator, std::move(boxes));
  RankLists<Nearest> answers(asked.size());
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    for (const FrameBox& box : boxes[rank])
    {
      answers[rank].push_back(this->nearestTo(box));
    }
  }
  answers = exchanged(communicator, std::move(answers));
  Nearest none{};
  none.squared.fill(std::numeric_limits<float>::infinity());
  std::vector<Nearest> nearest(searches.size(), none);
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    for (std::size_t i = 0; i < asked[rank].size(); ++i)
    {
      Nearest& best = nearest[asked[rank][i]];
      const Nearest& found = answers[rank][i];
      for (std::size_t k = 0; k < best.squared.size(); ++k)
      {
        // Of elements at the same distance the lowest, as in one process.
        if (std::tie(found.squared[k], found.face[k]) < std::tie(best.squared[k], best.face[k]))
        {
          best.squared[k] = found.squared[k];
          best.face[k] = found.face[k];
          best.point[k] = found.point[k];
        }
      }
    }
  }
  for (std::size_t i = 0; i < searches.size(); ++i)
  {
    Search& search = searches[i];
    search.distance = reachWithin(std::sqrt(nearest[i].squared[0]), search.box, slack_);
    search.pointCount = FrameBox::kCorners;
    std::copy_n(nearest[i].point.begin() + 1, FrameBox::kCorners, search.points.begin());
  }
}

void SharedTree::answer(const std::vector<Search>& searches, std::vector<GroupRecord>& groups,
  std::vector<PackRecord>& packs, std::vector<int>& faces) const
{
  std::set<int> found; // indices in groups_, which are those of the tree's groups
  GroupList list;
  for (const Search& search : searches)
  {
    own_->tree->collect(search.reach(), list);
    found.insert(list.groups().begin(), list.groups().end());
  }
  std::set<std::array<int, 3>> nodes; // tree, level, number of packs above the groups
  for (const int index : found)
  {
    const GroupRecord& record = groups_[index];
    groups.push_back(record);
    int number = record.group.number / kLanes;
    for (int level = 0; level < this->levelsOfBlock(record.tree); ++level, number /= kLanes)
    {
      nodes.insert({ record.tree, level, number });
    }
    for (int i = 0; i < record.group.count; ++i)
    {
      faces.push_back(own_->part.faceOf(record.group.elements[i]));
    }
  }
  for (const PackRecord& record : packs_)
  {
    if (nodes.count({ record.tree, record.level, record.pack.number }) > 0)
    {
      packs.push_back(record);
    }
  }
  addNeighbours(own_->part, faces);
  std::transform(faces.begin(), faces.end(), faces.begin(),
    [&](int face) { return own_->part.faces()[face]; });
}

NearSurface SharedTree::near(Communicator& communicator, const std::vector<FrameBox>& boxes)
{
  if (!own_)
  {
    own_ = this->fetchOwn(communicator, this->cornersOfOwn(communicator));
    this->buildOwnTree();
  }
  std::vector<Search> searches;
  const std::vector<float> bounds = this->bounds(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    searches.push_back({ boxes[i], reachWithin(bounds[i], boxes[i], slack_), 0, {} });
  }
  this->sharpen(communicator, searches);
  const RankLists<int> asked = this->ranksOf(searches);
  RankLists<Search> questions(asked.size());
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    for (const int search : asked[rank])
    {
      questions[rank].push_back(searches[search]);
    }
  }
  questions = exchanged(communicator, std::move(questions));
  RankLists<GroupRecord> groups(asked.size());
  RankLists<PackRecord> packs(asked.size());
  RankLists<int> faces(asked.size());
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    if (!questions[rank].empty())
    {
      this->answer(questions[rank], groups[rank], packs[rank], faces[rank]);
    }
  }
  own_.reset();
  const std::vector<GroupRecord> allGroups = flattened(exchanged(communicator, std::move(groups)));
  std::vector<PackRecord> allPacks = flattened(exchanged(communicator, std::move(packs)));
  allPacks.insert(allPacks.end(), top_.begin(), top_.end());
  std::vector<int> allFaces = flattened(exchanged(communicator, std::move(faces)));
  makeSet(allFaces);
  NearSurface result{ SurfacePart(communicator, surface_, std::move(allFaces)), slack_,
    treesOf(allGroups, allPacks, elements_.trees.size()) };
  nameByPart(result.part, result.trees);
  return result;
}

} // namespace medial
