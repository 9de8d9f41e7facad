#pragma once

#include "meshes.h"
#include "options.h"
#include "output/report.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace medial::benchmark
{

/// What suites share: they choose methods and meshes by the options, measure them, and write
/// reports.
class SuiteContext
{
public:
  using MakeGrid = std::function<Grid(const TriangleMesh&)>;
  using Publish = std::function<void(const SuiteReport&)>;

  SuiteContext(const Options& options, Publish publish);

  const Options& options() const { return options_; }
  MeasurementOptions measurement() const;
  /// As measurement(), but every method runs in all rounds, however slow it is.
  MeasurementOptions allRounds() const;

  /// Writes a report as far as it has come. Suites do so after every row, so that a run that ends
  /// early leaves what it has.
  void publish(const SuiteReport& report) const { publish_(report); }

  bool wantsMesh(const std::string& name) const;

  /// True for a row of the mesh and grid that targets were set for.
  bool targetsApply(const Row& row) const;

  /// The suite's own resolution, unless the options name one.
  int resolution(int own) const;

  /// Measures the methods of these ids, as far as they are built, and prints progress on stderr.
  /// Nothing if the options leave the mesh out.
  std::optional<Row> measure(const MeshRequest& request, const MakeGrid& makeGrid,
    const std::vector<std::string>& methodIds, const MeasurementOptions& options) const;
  std::optional<Row> measure(const MeshRequest& request, const MakeGrid& makeGrid,
    const std::vector<std::string>& methodIds) const;

  /// Appends a note on the methods of these ids that this build lacks.
  static void noteAbsent(const std::vector<std::string>& methodIds, SuiteReport& report);
  /// The same where other ids are those that are built.
  static void noteAbsent(const std::vector<std::string>& wanted,
    const std::vector<std::string>& built, SuiteReport& report);

private:
  std::vector<MethodEntry> choose(const std::vector<std::string>& methodIds) const;

  const Options& options_;
  Publish publish_;
};

/// A grid of so many points along the longest axis of the padded bounds.
SuiteContext::MakeGrid gridOfResolution(int resolution);

int longestAxis(const Grid& grid);

/// Rows in groups of neighbours that have the same text.
std::vector<std::vector<Row>> groupRows(const std::vector<Row>& rows,
  const std::function<std::string(const Row&)>& text);

/// A curve of the median seconds of one method over x, where it ran, with minimum and maximum.
CurvePlot::Curve secondsCurve(const std::vector<Row>& rows, const std::string& methodId,
  const std::string& name, const std::function<double(const Row&)>& x);

/// Exponent of a curve's y against x.
double exponentOf(const CurvePlot::Curve& curve);

/// Bars of the median seconds of all methods, by mesh and resolution; there must be rows.
BarPlot secondsBars(const std::vector<Row>& rows, const std::string& name,
  const std::string& title);

/// The paper's meshes and two larger ones, and their stand-ins where they are absent.
MeshRequest triceratops();
MeshRequest head();
MeshRequest gargoyle();
MeshRequest bunny();
MeshRequest shellCharge();
MeshRequest armadillo();
MeshRequest dragon();

struct SuiteEntry
{
  std::string name;
  void (*run)(const SuiteContext&);
};

const std::vector<SuiteEntry>& suites();

/// Medial and peers that exist as libraries, on meshes from 1,500 to 100,000 triangles.
void runPeers(const SuiteContext& context);
/// The meshes and grids of the paper's table 1, with Medial, the method as published, its
/// predecessor HAVOC, and Embree.
void runTable1(const SuiteContext& context);
/// Time against resolution.
void runFigure5(const SuiteContext& context);
/// Time against the number of triangles, up to two million, on two grids.
void runTriangles(const SuiteContext& context);
/// Real meshes of up to hundreds of thousands of triangles, and files of the user's, beside Embree.
void runModels(const SuiteContext& context);
/// Errors of distances and labels.
void runFigure6(const SuiteContext& context);
/// A deforming mesh: what frames share against a fresh computation of each.
void runFrames(const SuiteContext& context);
/// How two deforming meshes lie to each other.
void runProximity(const SuiteContext& context);
/// Distances of a million points.
void runPoints(const SuiteContext& context);
/// Networks of curves, beside CGAL's mean curvature skeleton.
void runSkeletons(const SuiteContext& context);

} // namespace medial::benchmark
