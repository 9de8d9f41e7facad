#include "culling/group_tree.h"
#include "culling/site_query.h"
#include "sites/closest_point.h"

#include "support/brute_force.h"
#include "support/culling_test.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace medial::test
{
namespace
{

constexpr float kSlack = 1e-3f;

double exactDistance(const SiteSet& sites, const glm::dvec3& x)
{
  double min = std::numeric_limits<double>::infinity();
  for (int site = 0; site < sites.size(); ++site)
  {
    min = sites.active(site) ? std::min(min, glm::distance(closestPoint(sites, site, x).point, x))
                             : min;
  }
  return min;
}

class GroupTreeOf : public CullingTest
{
protected:
  /// Positions in the grid and as far around it.
  std::vector<glm::dvec3> positions() const
  {
    Bounds bounds{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const double size = grid_.dimensions[axis];
      bounds.min[axis] = -size;
      bounds.max[axis] = 2.0 * size;
    }
    return this->randomPositions(bounds, 2000, 3);
  }

  const GroupTree tree_{ sites_, connectivity_, kSlack };
};

} // namespace

TEST_P(GroupTreeOf, HoldsEveryActiveSiteOnce)
{
  std::vector<int> count(sites_.size(), 0);
  for (const SiteGroup& group : tree_.groups())
  {
    for (int lane = 0; lane < SiteGroup::kSize; ++lane)
    {
      for (int left = group.owned[lane]; left != 0; left &= left - 1)
      {
        ++count[siteOf(sites_, group, lane, __builtin_ctz(static_cast<unsigned>(left)))];
      }
    }
  }
  for (int site = 0; site < sites_.size(); ++site)
  {
    EXPECT_EQ(count[site], sites_.active(site) ? 1 : 0) << site;
  }
}

TEST_P(GroupTreeOf, FindsTheNearestElement)
{
  NearestElement last;
  for (const glm::dvec3& x : positions())
  {
    const double truth = exactDistance(sites_, x);
    const double tolerance = 1e-3 + 1e-5 * truth;
    const NearestElement nearest = tree_.nearest(x);
    EXPECT_NEAR(std::sqrt(nearest.squared), truth, tolerance);
    const int element = tree_.groups()[nearest.group].elements[nearest.lane];
    EXPECT_NEAR(glm::distance(closestPoint(sites_, element, x).point, x), truth, tolerance);
    if (last.group >= 0)
    {
      NearestElement start;
      start.tryGroup(tree_.groups(), last.group, x);
      EXPECT_EQ(tree_.nearest(x, start).squared, nearest.squared);
    }
    last = nearest;
  }
}

TEST_P(GroupTreeOf, AnswersQueriesExactly)
{
  const SiteQuery query(tree_);
  std::vector<SiteQuery::Question> questions;
  for (const glm::dvec3& x : positions())
  {
    const double truth = exactDistance(sites_, x);
    const SitePoint closest = query.closest(x);
    EXPECT_NEAR(glm::distance(closest.point, x), truth, 1e-12 * truth);
    EXPECT_TRUE(sites_.active(closest.site) || sites_.kind(closest.site) == SiteKind::Edge);
    // A known closest point stays, and any other is replaced.
    EXPECT_EQ(query.closest(x, closest).site, closest.site);
    questions.push_back({ x, closestPoint(sites_, sites_.size() - 1, x) });
  }
  query.closest(questions);
  for (const SiteQuery::Question& question : questions)
  {
    EXPECT_EQ(glm::distance(question.closest.point, question.x),
      glm::distance(query.closest(question.x).point, question.x));
  }
}

/// Positions of all distances from each other, known points or none, and in any order: the answer
/// is that of each question alone.
TEST_P(GroupTreeOf, AnswersManyQuestionsAsOne)
{
  const SiteQuery query(tree_);
  const std::vector<glm::dvec3> spread = positions();
  std::vector<SiteQuery::Question> questions;
  for (std::size_t i = 0; i < spread.size(); ++i)
  {
    // Around some of them, clusters of different sizes; some on the surface, where many sites tie.
    const glm::dvec3& centre = spread[i / 50 * 50];
    const double size = std::pow(10.0, static_cast<double>(i / 50 % 8) - 6.0);
    const bool onSurface = i % 7 == 0;
    const glm::dvec3 x = centre + size * (spread[i] - centre);
    const glm::dvec3 on = query.closest(x).point;
    questions.push_back({ onSurface ? on : x, {} });
    if (i % 3 == 0)
    {
      questions.back().closest =
        closestPoint(sites_, static_cast<int>(i) % sites_.size(), questions.back().x);
    }
  }
  questions.push_back({ glm::dvec3(1e30, 0.0, 0.0), {} });
  std::vector<SiteQuery::Question> answers = questions;
  query.closest(answers);
  std::vector<SiteQuery::Question> backwards(questions.rbegin(), questions.rend());
  query.closest(backwards);
  for (std::size_t i = 0; i < questions.size(); ++i)
  {
    const SitePoint alone = query.closest(questions[i].x);
    EXPECT_EQ(answers[i].closest.site, alone.site);
    EXPECT_EQ(answers[i].closest.point, alone.point);
    const SiteQuery::Question& back = backwards[questions.size() - 1 - i];
    EXPECT_EQ(back.closest.site, alone.site);
    EXPECT_EQ(back.closest.point, alone.point);
    const double truth = exactDistance(sites_, questions[i].x);
    EXPECT_NEAR(glm::distance(alone.point, questions[i].x), truth, 1e-12 * (1.0 + truth));
  }
}

/// A site that is no nearer than the known point need not be tried, whether that point is the
/// closest or not.
TEST_P(GroupTreeOf, AnswersWithoutTryingAFartherSite)
{
  const SiteQuery query(tree_);
  std::vector<SiteQuery::Question> questions;
  for (const glm::dvec3& x : positions())
  {
    const int first = static_cast<int>(questions.size()) % sites_.size();
    const int second = (7 * first + 3) % sites_.size();
    const SitePoint one = closestPoint(sites_, first, x);
    const SitePoint other = closestPoint(sites_, second, x);
    const bool oneFirst = glm::distance(one.point, x) < glm::distance(other.point, x);
    questions.push_back({ x, oneFirst ? one : other, oneFirst ? other.site : one.site });
    if (glm::distance(one.point, x) == glm::distance(other.point, x))
    {
      questions.back().other = -1;
    }
  }
  query.closest(questions);
  for (const SiteQuery::Question& question : questions)
  {
    const SitePoint alone = query.closest(question.x);
    EXPECT_EQ(question.closest.site, alone.site);
    EXPECT_EQ(question.closest.point, alone.point);
  }
}

/// Every group that holds the closest point of some position in a box is found.
TEST_P(GroupTreeOf, CollectsTheGroupsOfBoxes)
{
  for (const glm::dvec3& centre : positions())
  {
    const FrameBox box{ glm::vec3(centre), glm::vec3(3.0f, 2.0f, 4.0f) };
    const NearestElement nearest = tree_.nearest(centre);
    BoxReach reach(box, nearest, kSlack);
    addCorners(
      tree_, nearest,
      [&](const glm::dvec3& x, const NearestElement& start) { return tree_.nearest(x, start); },
      reach);
    GroupList groups;
    tree_.collect(reach, groups);
    EXPECT_TRUE(std::is_sorted(groups.groups().begin(), groups.groups().end()));
    for (int i = 0; i < FrameBox::kCorners; ++i)
    {
      const glm::dvec3 x = centre + 0.7 * glm::dvec3(box.corner(i));
      const double found = std::sqrt(groups.nearest(tree_.groups(), x, {}).squared);
      const double truth = exactDistance(sites_, x);
      EXPECT_NEAR(found, truth, 1e-3 + 1e-5 * truth);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, GroupTreeOf, testing::ValuesIn(cullingCases()), kNameOfParameter);

TEST(GroupTree, LooksAtFewGroupsOfASmoothSurface)
{
  const TriangleMesh mesh = torus(1.0, 0.4, 200, 100);
  const GridFrame frame(makeGrid(mesh.bounds(), 64, 0.1));
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const SiteSet sites(mesh, connectivity, frame);
  const GroupTree tree(sites, connectivity, kSlack);
  ASSERT_GE(tree.groups().size(), 5000u);
  // Amid a quarter of the tube, from where all of the tube around is about equally far.
  const glm::dvec3 x = frame.toLocal({ 1.05, 0.0, 0.0 });
  const NearestElement nearest = tree.nearest(x);
  int seen = 0;
  tree.visitNear(
    glm::vec3(x), [&] { return nearest.squared; }, [&](int) { ++seen; });
  EXPECT_GE(seen, 1);
  EXPECT_LE(seen, 20);
}

} // namespace medial::test
