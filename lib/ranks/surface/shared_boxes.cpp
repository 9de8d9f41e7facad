#include "ranks/surface/shared_boxes.h"

namespace medial
{

SharedBoxes::SharedBoxes(Communicator& communicator, const std::vector<Box>& own)
{
  const RankLists<Box> lists = gathered(communicator, own);
  std::vector<glm::dvec3> corners;
  std::vector<glm::ivec3> ends;
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    for (const Box& box : lists[rank])
    {
      if (static_cast<int>(rank) != communicator.rank())
      {
        const auto first = static_cast<int>(corners.size());
        corners.insert(corners.end(), { box.min, box.max });
        ends.emplace_back(first, first + 1, first + 1);
        boxes_.push_back(box);
        ranks_.push_back(static_cast<int>(rank));
      }
    }
  }
  if (!boxes_.empty())
  {
    tree_.build(corners, ends);
  }
}

} // namespace medial
