#include "suites/suite.h"

#include "animation.h"
#include "pairs/field_pairs.h"
#include "pairs/pair_race.h"
#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace medial::benchmark
{
namespace
{

/// There are many frames, so a few rounds suffice.
constexpr int kMaxRounds = 3;
constexpr int kFrames = 60;
constexpr int kQuickFrames = 8;
constexpr int kQuickTriangles = 600;
constexpr int kAnimationFrames = 30; ///< that are there
constexpr char kFigure4Pair[] = "bunny 2K";

struct Question
{
  PairQuestion question;
  std::string name;  ///< in rows
  std::string title; ///< of its table
};

const std::vector<Question>& questions()
{
  static const std::vector<Question> all = {
    { PairQuestion::SeparationOrDepth, "separation or depths",
      "Separation, or where the meshes collide the depth of every point inside (Medial). FCL tells "
      "the distance of the surfaces and no depths; CGAL the depths and no separation." },
    { PairQuestion::Contacts, "all answers",
      "All answers: collision, separation and its points, the depth of the surface and of every "
      "point, bounds of the translational depth, at most four contacts an overlap (Medial). The "
      "others tell contacts only, one or more for every pair of triangles that cross." },
    { PairQuestion::Collision, "collision",
      "Collision, yes or no. A mesh inside another collides for Medial and CGAL, not for the "
      "others." }
  };
  return all;
}

std::vector<MeshRequest> requests()
{
  return { { kFigure4Pair, "paper/derived/bunny_2000.off", 2000 },
    { "hand 12K", "ma_ref/camila_hand.off", 12400 },
    { "horse 40K", "organic/horse_40k.off", 40000 } };
}

/// A pair, and whether a shape of our own replaces its mesh.
struct ProvidedPair
{
  MovingPair pair;
  bool generated = false;
};

ProvidedPair provideDeforming(const MeshRequest& request, bool quick)
{
  MeshRequest small = request;
  if (quick)
  {
    small.triangles = std::min(request.triangles, kQuickTriangles);
  }
  const BenchmarkMesh input = provideMesh(small, quick);
  return { deformingPair(request.name, input.mesh, quick ? kQuickFrames : kFrames),
    input.generated };
}

ProvidedPair provideAnimated(bool quick)
{
  const Animation animation = quick ? provideAnimation(4, kQuickTriangles, true)
                                    : provideAnimation(kAnimationFrames, 5800, false);
  return { animatedPair(animation.name, animation.mesh, animation.frames,
             quick ? kQuickFrames : kFrames),
    animation.generated };
}

/// The methods that the options choose; Medial's with all answers is always among them.
std::vector<PairMethodEntry> chosenMethods(const Options& options)
{
  std::vector<PairMethodEntry> chosen;
  for (const PairMethodEntry& entry : availablePairMethods())
  {
    const auto& wanted = options.methods;
    if (wanted.empty() || entry.id == kMedialAllId ||
      std::find(wanted.begin(), wanted.end(), entry.id) != wanted.end())
    {
      chosen.push_back(entry);
    }
  }
  return chosen;
}

bool answers(const PairRun& run, PairQuestion question)
{
  return std::find(run.questions.begin(), run.questions.end(), question) != run.questions.end();
}

const PairRun& runOf(const std::vector<PairRun>& runs, const std::string& id)
{
  return *std::find_if(runs.begin(), runs.end(), [&](const PairRun& run) { return run.id == id; });
}

double medianRatio(const std::vector<double>& seconds, const std::vector<double>& ours)
{
  std::vector<double> ratios;
  for (std::size_t frame = 0; frame < seconds.size(); ++frame)
  {
    ratios.push_back(seconds[frame] / ours[frame]);
  }
  return median(ratios);
}

int collidingFrames(const PairRun& truth)
{
  return static_cast<int>(std::count_if(truth.answers.begin(), truth.answers.end(),
    [](const PairAnswer& answer) { return *answer.collide; }));
}

/// A sample a round: medians over all frames.
MethodRun methodRun(const PairRun& run, const PairRun& ours, const PairRun& truth)
{
  MethodRun result;
  result.id = run.id;
  result.name = run.name;
  for (std::size_t round = 0; round < run.update.size(); ++round)
  {
    result.samples.push_back(
      { { "update", median(run.update[round]) }, { "query", median(run.query[round]) } });
  }
  const std::vector<double> seconds = run.frameSeconds();
  result.ratios = { medianRatio(seconds, ours.frameSeconds()) };
  const PairDifference difference = compareAnswers(run, truth);
  result.figures = { { "apart", medianWhere(seconds, truth, false) },
    { "colliding", medianWhere(seconds, truth, true) }, { "frame", median(seconds) } };
  const auto tell = [&](bool told, const std::string& name, double value)
  {
    if (told)
    {
      result.figures.emplace_back(name, value);
    }
  };
  tell(difference.hasCollisions, "wrong_collisions", difference.wrongCollisions);
  tell(difference.hasSeparation, "separation_difference", difference.separation);
  tell(difference.hasPointDepth, "point_depth_difference", difference.pointDepth);
  tell(std::isfinite(difference.depthRatio), "depth_ratio", difference.depthRatio);
  std::vector<double> contacts;
  for (const PairAnswer& answer : run.answers)
  {
    if (answer.contacts.value_or(0) > 0)
    {
      contacts.push_back(*answer.contacts);
    }
  }
  tell(!contacts.empty(), "contacts", median(contacts));
  return result;
}

Row rowOf(const ProvidedPair& input, const Question& question, const std::vector<PairRun>& runs)
{
  const PairRun& truth = runOf(runs, kMedialAllId);
  Row row;
  row.mesh = input.pair.name + ", " + question.name;
  row.note = input.generated ? "generated torus in its place" : "";
  row.triangles = static_cast<std::int64_t>(input.pair.a.triangles.size());
  row.hasGrid = false;
  row.rounds = static_cast<int>(truth.update.size());
  const PairRun* ours = nullptr;
  for (const PairRun& run : runs)
  {
    if (answers(run, question.question))
    {
      ours = ours ? ours : &run;
      row.runs.push_back(methodRun(run, *ours, truth));
    }
  }
  return row;
}

std::string milliseconds(double seconds)
{
  return number(1e3 * seconds);
}

/// Answers that a table compares: the name in figures, and the column's title.
using Column = std::pair<std::string, std::string>;

std::vector<Column> answerColumns(PairQuestion question)
{
  std::vector<Column> columns = { { "wrong_collisions", "wrong collisions" } };
  if (question == PairQuestion::SeparationOrDepth)
  {
    columns.push_back({ "separation_difference", "separation off" });
    columns.push_back({ "point_depth_difference", "points' depth off" });
  }
  else if (question == PairQuestion::Contacts)
  {
    columns.push_back({ "depth_ratio", "depth over Medial's" });
    columns.push_back({ "contacts", "contacts" });
  }
  return columns;
}

std::string pairText(const ProvidedPair& input)
{
  return input.pair.name + (input.generated ? " (generated torus in its place)" : "");
}

std::vector<std::string> cells(const ProvidedPair& input, PairQuestion question,
  const MethodRun& run)
{
  std::vector<std::string> cells = { pairText(input), run.name,
    milliseconds(run.medianPhase("update")), milliseconds(run.medianPhase("query")),
    milliseconds(run.figure("apart")), milliseconds(run.figure("colliding")),
    milliseconds(run.figure("frame")), number(median(run.ratios)) };
  for (const Column& column : answerColumns(question))
  {
    const double value = run.figure(column.first);
    cells.push_back(value == 0.0 ? "0" : number(value, 2));
  }
  return cells;
}

Table emptyTable(const Question& question)
{
  Table table;
  table.title = question.title;
  table.columns = { "pair", "method", "update", "query", "apart", "colliding", "frame",
    "over Medial" };
  for (const Column& column : answerColumns(question.question))
  {
    table.columns.push_back(column.second);
  }
  return table;
}

/// Which peers beat us, in frames apart or in those that collide.
Table lostTable(const std::vector<Row>& rows)
{
  Table table;
  table.title =
    "Where a peer is faster than Medial with the same question, ms a frame. FCL's distance is 0 "
    "where "
    "meshes collide, without a depth; contacts of pairs of triangles leave out the rest of all "
    "answers:";
  table.columns = { "pair and question", "frames", "peer", "it", "Medial" };
  for (const Row& row : rows)
  {
    for (const MethodRun& run : row.runs)
    {
      for (const std::string frames : { "apart", "colliding" })
      {
        const double ours = row.runs.front().figure(frames);
        if (run.figure(frames) < ours)
        {
          table.rows.push_back(
            { row.mesh, frames, run.name, milliseconds(run.figure(frames)), milliseconds(ours) });
        }
      }
    }
  }
  return table;
}

/// Milliseconds over frames, as in the paper's figure 4.
CurvePlot figure4(const std::vector<PairRun>& runs)
{
  CurvePlot plot;
  plot.name = "proximity-figure4";
  plot.title = "Two deforming bunnies of 2K triangles, update and query";
  plot.xLabel = "frame";
  plot.yLabel = "time (ms)";
  plot.logarithmicX = false;
  for (const PairRun& run : runs)
  {
    if (answers(run, PairQuestion::SeparationOrDepth) || run.id == kMedialAllId)
    {
      CurvePlot::Curve curve;
      curve.name = run.name;
      curve.bars = false;
      const std::vector<double> seconds = run.frameSeconds();
      for (std::size_t frame = 0; frame < seconds.size(); ++frame)
      {
        const double ms = 1e3 * seconds[frame];
        curve.points.push_back({ static_cast<double>(frame), ms, ms, ms });
      }
      plot.curves.push_back(curve);
    }
  }
  return plot;
}

std::vector<std::string> introduction(int frames)
{
  const std::string motion =
    "Two meshes come from a gap through first touch until their bounding boxes overlap by 30 %. "
    "Their longest side is 1. Both deform in every frame: they bend and twist, but the elastic cow "
    "has the frames of a simulation.";
  const std::string times = "Medians over " + std::to_string(frames) +
    " frames, in ms: update (the points, and trees except in Medial and VTK, whose queries do "
    "that), "
    "query, and both together in frames apart, in frames that collide, and in all. 'Over Medial' "
    "is "
    "the median over frames of the time over that of the table's first method.";
  const std::string answers =
    "'Wrong collisions' counts frames; 'off' is the greatest difference. Both compare with what "
    "Medial tells with all answers; CGAL, whose predicates are exact, and FCL's distance check "
    "that. "
    "'Depth over Medial's' is the median of the largest depth over the penetration depth of the "
    "surface: a contact of two triangles has another depth than a point inside.";
  const std::string paper =
    "The paper's figure 4 has 120 ms a frame for two deforming bunnies of 2K triangles, with the "
    "separation or the depth, on its machine; the plot is of bunny 2K.";
  return { "`scripts/benchmark proximity` makes this page.", motion, times, answers, paper };
}

class ProximityReport
{
public:
  explicit ProximityReport(const SuiteContext& context)
    : context_(context)
    , methods_(chosenMethods(context.options()))
  {
    report_.name = "proximity";
    report_.title = "Proximity of two meshes that deform";
    report_.usesRenderer = false;
    report_.rounds = std::min(context.options().repeats, kMaxRounds);
    report_.how = "Milliseconds are wall-clock; a method may use all cores, which Medial does.";
    report_.notes = introduction(context.options().quick ? kQuickFrames : kFrames);
    std::vector<std::string> built;
    for (const PairMethodEntry& entry : availablePairMethods())
    {
      built.push_back(entry.id);
    }
    SuiteContext::noteAbsent(knownPairMethodIds(), built, report_);
    for (const Question& question : questions())
    {
      report_.tables.push_back(emptyTable(question));
    }
    report_.tables.emplace_back();
  }

  void add(const ProvidedPair& input)
  {
    const std::vector<PairRun> runs = racePairs(input.pair, methods_, report_.rounds);
    const PairRun& truth = runOf(runs, kMedialAllId);
    const std::string colliding = std::to_string(collidingFrames(truth)) + " of " +
      std::to_string(truth.answers.size()) + " frames collide";
    report_.notes.push_back(pairText(input) + ": " +
      thousands(static_cast<std::int64_t>(input.pair.a.triangles.size())) + " triangles a mesh, " +
      colliding + ".");
    std::cerr << input.pair.name << ": " << colliding << "; ms a frame\n";
    for (const PairRun& run : runs)
    {
      std::cerr << "  " << run.name << ": " << milliseconds(median(run.frameSeconds())) << '\n';
    }
    for (std::size_t i = 0; i < questions().size(); ++i)
    {
      report_.rows.push_back(rowOf(input, questions()[i], runs));
      const Row& row = report_.rows.back();
      for (const MethodRun& run : row.runs)
      {
        report_.tables[i].rows.push_back(cells(input, questions()[i].question, run));
      }
    }
    if (input.pair.name == kFigure4Pair)
    {
      report_.curves = { figure4(runs) };
      fields_ = raceFields(input.pair, report_.rounds, context_.options().quick);
    }
    report_.tables[questions().size()] = lostTable(report_.rows);
    if (!fields_.rows.empty())
    {
      report_.tables.resize(questions().size() + 1);
      report_.tables.push_back(fields_);
    }
    context_.publish(report_);
  }

private:
  const SuiteContext& context_;
  std::vector<PairMethodEntry> methods_;
  Table fields_; ///< of the paper's way
  SuiteReport report_;
};

} // namespace

void runProximity(const SuiteContext& context)
{
  const bool quick = context.options().quick;
  ProximityReport report(context);
  for (const MeshRequest& request : requests())
  {
    if (context.wantsMesh(request.name))
    {
      report.add(provideDeforming(request, quick));
    }
  }
  if (context.wantsMesh("elastic cow"))
  {
    report.add(provideAnimated(quick));
  }
}

} // namespace medial::benchmark
