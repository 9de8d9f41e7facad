#include "methods/registry.h"

namespace medial::benchmark
{

const std::vector<MethodEntry>& availableMethods()
{
  static const std::vector<MethodEntry> methods = {
    { kMedialId, [] { return makeMedialMethod(Engine::Auto); } },
    { kRasterId, [] { return makeMedialMethod(Engine::Rasteriser); } },
    { "published", makePublishedMethod },
    { "havoc", makeHavocMethod },
#ifdef MEDIAL_HAVE_EMBREE
    { "embree", makeEmbreeMethod },
#endif
#ifdef MEDIAL_HAVE_CGAL
    { "cgal", makeCgalMethod },
#endif
#ifdef MEDIAL_HAVE_OPENVDB
    { "openvdb", [] { return makeOpenVdbMethod(0); } },
    { "openvdb-band", [] { return makeOpenVdbMethod(3); } },
#endif
#ifdef MEDIAL_HAVE_VTK
    { "vtk", makeVtkMethod },
#endif
  };
  return methods;
}

const std::vector<std::string>& knownMethodIds()
{
  static const std::vector<std::string> ids = { kMedialId, kRasterId, "published", "havoc",
    "embree", "cgal", "openvdb", "openvdb-band", "vtk" };
  return ids;
}

} // namespace medial::benchmark
