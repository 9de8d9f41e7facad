#include "ranks/axis/corner_cells.h"

#include "base/extents.h"
#include "ranks/collective.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace medial
{

std::vector<CornerCells> sentCells(Communicator& communicator, const CornerNumbers& corners,
  const std::vector<CornerCells>& cells, const std::function<Extent(int rank)>& boxOf)
{
  RankLists<CornerCells> lists = listsFor<CornerCells>(communicator);
  for (std::size_t rank = 0; rank < lists.size() && !cells.empty(); ++rank)
  {
    const Extent box = boxOf(static_cast<int>(rank));
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(lists[rank]),
      [&](CornerCells cell) { return hasPoint(box, corners.position(cell.position())); });
  }
  return exchanged(communicator, std::move(lists)).front();
}

void insertCells(const CornerNumbers& corners, const std::vector<CornerCells>& cells,
  CubicalComplex& complex)
{
  for (const CornerCells cell : cells)
  {
    const glm::ivec3 position = corners.position(cell.position());
    complex.insert(CubicalComplex::index(complex.cell(position, kVertexKind)), cell.bits());
  }
}

} // namespace medial
