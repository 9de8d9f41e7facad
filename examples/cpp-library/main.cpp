// Distance field and medial axis of a box that is made by hand.
#include <medial/compute_distance_field.h>
#include <medial/compute_medial_axis.h>
#include <medial/error.h>

#include <algorithm>
#include <iostream>

int main()
{
  medial::MeshInput box;
  box.points = { { -1, -0.75, -0.5 }, { 1, -0.75, -0.5 }, { 1, 0.75, -0.5 }, { -1, 0.75, -0.5 },
    { -1, -0.75, 0.5 }, { 1, -0.75, 0.5 }, { 1, 0.75, 0.5 }, { -1, 0.75, 0.5 } };
  box.polygons.append({ 3, 2, 1, 0 }, 0);
  box.polygons.append({ 4, 5, 6, 7 }, 1);
  box.polygons.append({ 0, 1, 5, 4 }, 2);
  box.polygons.append({ 1, 2, 6, 5 }, 3);
  box.polygons.append({ 2, 3, 7, 6 }, 4);
  box.polygons.append({ 3, 0, 4, 7 }, 5);

  try
  {
    const medial::TriangleMesh mesh = medial::buildTriangleMesh(box);
    const medial::Grid grid = medial::makeGrid(mesh.bounds(), 64);

    const medial::DistanceField field = medial::computeDistanceField(mesh, grid);
    const auto [deepest, farthest] =
      std::minmax_element(field.distance.begin(), field.distance.end());
    std::cout << "distances from " << *deepest << " to " << *farthest << " at "
              << field.distance.size() << " points\n";

    medial::MedialAxisOptions options;
    options.angle = 60.0;
    const medial::MedialAxis axis = medial::computeMedialAxis(mesh, grid, options);
    std::cout << "medial axis of " << axis.points.size() << " points and " << axis.cellCount()
              << " cells, radius up to "
              << *std::max_element(axis.radius.begin(), axis.radius.end()) << "\n"
              << "computed in " << axis.statistics.seconds.medial << " s from the field\n";
  }
  catch (const medial::Error& error)
  {
    std::cerr << "error: " << error.what() << "\n";
    return 1;
  }
}
