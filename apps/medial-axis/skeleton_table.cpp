#include "skeleton_table.h"

#include "output/csv_line.h"

#include <array>
#include <ostream>

namespace medial::app
{
namespace
{

const char* nameOf(BranchKind kind)
{
  constexpr std::array<const char*, 4> kNames{ "end-junction", "junction-junction", "closed",
    "isolated" };
  return kNames[static_cast<std::size_t>(kind)];
}

} // namespace

void writeSkeletonTable(const Skeleton& skeleton, std::ostream& stream)
{
  stream << "branch,kind,length,mean_radius,min_radius,max_radius,start_x,start_y,start_z,end_x,"
            "end_y,end_z\n";
  for (std::size_t b = 0; b < skeleton.branches.size(); ++b)
  {
    const SkeletonBranch& branch = skeleton.branches[b];
    CsvLine line;
    line << b << nameOf(branch.kind) << branch.length << branch.meanRadius << branch.minRadius
         << branch.maxRadius << skeleton.points[branch.points.front()]
         << skeleton.points[branch.points.back()];
    stream << line.end();
  }
}

} // namespace medial::app
