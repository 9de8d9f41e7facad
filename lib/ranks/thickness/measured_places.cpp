#include "ranks/thickness/measured_places.h"

#include "ranks/thickness/asked_surface.h"
#include "thickness/place_values.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace medial
{
namespace
{

constexpr auto kRow = static_cast<int>(kPlacesInRow);

/// A place whose search has begun.
struct Search
{
  int place; ///< in its row
  std::vector<SurfaceAnswer> known;
  OpenQuestion open;
};

/// A row of places.
class Row
{
public:
  /// @param first, count its places, numbers in the whole.
  Row(bool ofFaces, int first, int count)
    : ofFaces_(ofFaces)
    , first_(first)
    , values_(static_cast<std::size_t>(count))
  {
    searches_.push_back({ 0, {}, {} });
  }

  bool ofFaces() const { return ofFaces_; }
  std::vector<PlaceValue>& values() { return values_; }
  /// Those that wait for answers.
  std::vector<Search>& searches() { return searches_; }

  /// Goes on until every search waits for answers.
  void advance(const ThicknessPart& part)
  {
    std::vector<Search> waiting;
    while (!searches_.empty())
    {
      Search search = std::move(searches_.back());
      searches_.pop_back();
      const std::optional<SideThickness::Value> value = this->tryPlace(part, search);
      if (!value)
      {
        waiting.push_back(std::move(search));
        continue;
      }
      this->finish(search.place, *value);
    }
    searches_ = std::move(waiting);
  }

private:
  std::optional<SideThickness::Value> tryPlace(const ThicknessPart& part, Search& search) const
  {
    const int number = first_ + search.place;
    const int here = ofFaces_ ? part.faceOf(number) : part.pointOf(number);
    if (here < 0)
    {
      return SideThickness::Value{ std::numeric_limits<double>::quiet_NaN() }; // of no triangle
    }
    AskedSurface surface(part, search.known, search.open);
    const double guess = guesses_[guessedFrom(static_cast<std::size_t>(search.place))];
    try
    {
      return ofFaces_ ? part.thickness().atTriangle(here, guess, surface)
                      : part.thickness().atPoint(here, guess, surface);
    }
    catch (const Unanswered&)
    {
      return std::nullopt;
    }
  }

  /// Begins with the places whose guess this one is.
  void finish(int place, const SideThickness::Value& value)
  {
    const auto at = static_cast<std::size_t>(place);
    values_[at] = { first_ + place, static_cast<float>(value.thickness),
      static_cast<char>(value.atEdge ? 1 : 0), static_cast<char>(value.opens) };
    guesses_[at] = value.thickness > 0.0 ? value.thickness : guesses_[guessedFrom(at)];
    for (std::size_t step = 1; step < kPlacesInRow && (at & step) == 0; step *= 2)
    {
      if (at + step < values_.size())
      {
        searches_.push_back({ static_cast<int>(at + step), {}, {} });
      }
    }
  }

  bool ofFaces_;
  int first_;
  std::vector<PlaceValue> values_;
  std::array<double, kPlacesInRow> guesses_{};
  std::vector<Search> searches_;
};

std::vector<Row> rowsOf(const ThicknessPart& part)
{
  std::vector<Row> rows;
  const auto add = [&](const std::vector<int>& list, bool ofFaces, int places)
  {
    for (const int row : list)
    {
      rows.emplace_back(ofFaces, kRow * row, std::min(kRow, places - kRow * row));
    }
  };
  add(part.rows().points, false, part.pointCount());
  add(part.rows().faces, true, part.faceCount());
  return rows;
}

/// Calls visit(search) for all that wait, in a fixed order.
template <typename Visit>
void forWaiting(std::vector<Row>& rows, const Visit& visit)
{
  for (Row& row : rows)
  {
    std::for_each(row.searches().begin(), row.searches().end(), visit);
  }
}

/// Lets other ranks answer what this one cannot answer alone.
/// @return whether any rank waits for answers.
bool exchangeAnswers(Communicator& communicator, const ThicknessPart& part, const Run& run,
  std::vector<Row>& rows)
{
  RankLists<SurfaceQuestion> questions = listsFor<SurfaceQuestion>(communicator);
  bool waits = false;
  forWaiting(rows,
    [&](const Search& search)
    {
      waits = true;
      for (const int rank : search.open.ranks)
      {
        questions[rank].push_back(search.open.question);
      }
    });
  for (std::vector<SurfaceQuestion>& list : questions)
  {
    list.insert(list.end(), waits ? 1 : 0, SurfaceQuestion{}); // so that all go on
  }
  questions = exchanged(communicator, std::move(questions));
  if (std::all_of(questions.begin(), questions.end(),
        [](const std::vector<SurfaceQuestion>& list) { return list.empty(); }))
  {
    return false;
  }
  RankLists<SurfaceAnswer> answers = listsFor<SurfaceAnswer>(communicator);
  run.onThreads(
    [&]
    {
      for (std::size_t rank = 0; rank < questions.size(); ++rank)
      {
        const std::vector<SurfaceQuestion>& list = questions[rank];
        answers[rank].resize(list.empty() ? 0 : list.size() - 1);
        tbb::parallel_for(std::size_t{ 0 }, answers[rank].size(),
          [&](std::size_t i) { answers[rank][i] = part.answer(list[i]); });
      }
    });
  answers = exchanged(communicator, std::move(answers));
  std::vector<std::size_t> next(answers.size(), 0);
  forWaiting(rows,
    [&](Search& search)
    {
      for (const int rank : search.open.ranks)
      {
        search.open.answer.add(answers[rank][next[rank]++]);
      }
      search.known.push_back(search.open.answer);
    });
  return true;
}

} // namespace

MeasuredPlaces measurePlaces(Communicator& communicator, const ThicknessPart& part, const Run& run)
{
  std::vector<Row> rows = rowsOf(part);
  do
  {
    run.onThreads(
      [&]
      {
        tbb::parallel_for(std::size_t{ 0 }, rows.size(),
          [&](std::size_t row) { rows[row].advance(part); });
      });
    const auto waiting =
      std::count_if(rows.begin(), rows.end(), [](Row& row) { return !row.searches().empty(); });
    run.report(rows.empty() ? 1.0
                            : 1.0 - static_cast<double>(waiting) / static_cast<double>(rows.size()),
      "thickness");
  } while (exchangeAnswers(communicator, part, run, rows));
  MeasuredPlaces result;
  for (Row& row : rows)
  {
    std::vector<PlaceValue>& list = row.ofFaces() ? result.faces : result.points;
    list.insert(list.end(), row.values().begin(), row.values().end());
  }
  return result;
}

} // namespace medial
