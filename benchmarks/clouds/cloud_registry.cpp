#include "clouds/cloud_registry.h"

namespace medial::benchmark
{

const std::vector<CloudMethodEntry>& availableCloudMethods()
{
  static const std::vector<CloudMethodEntry> methods = {
    { kMedialCloudId, [] { return makeMedialCloud(true); } },
    { "medial-unsigned", [] { return makeMedialCloud(false); } },
#ifdef MEDIAL_HAVE_EMBREE_CLOUD
    { "embree", [] { return makeEmbreeCloud(false); } },
    { "embree-sorted", [] { return makeEmbreeCloud(true); } },
#endif
#ifdef MEDIAL_HAVE_CGAL_CLOUD
    { "cgal", makeCgalCloud },
#endif
#ifdef MEDIAL_HAVE_VTK_CLOUD
    { "vtk", makeVtkCloud },
#endif
  };
  return methods;
}

const std::vector<std::string>& knownCloudMethodIds()
{
  static const std::vector<std::string> ids = { kMedialCloudId, "medial-unsigned", "embree",
    "embree-sorted", "cgal", "vtk" };
  return ids;
}

} // namespace medial::benchmark
