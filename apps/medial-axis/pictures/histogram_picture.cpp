#include "pictures/histogram_picture.h"

#include "caption.h"
#include "number_text.h"
#include "scalar_bar.h"
#include "scene.h"
#include "vtk_messages.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace medial::app
{
namespace
{

constexpr int kDigits = 4;
constexpr int kFontSize = 28;
// Pixels.
constexpr float kWidth = 1600.0f;
constexpr float kHeight = 1200.0f;
constexpr float kMargin = 24.0f;
constexpr float kLineWidth = 4.0f;
/// Where the deviation is, as a share of the chart's height.
constexpr double kMarkHeight = 0.97;
/// The highest bin fills the chart up to here.
constexpr double kRoom = 1.1;
using Bytes = unsigned char[3];
constexpr Bytes kInk = { 38, 43, 51 };
constexpr Bytes kBars = { 49, 104, 142 };
constexpr Bytes kDeviation = { 240, 150, 20 };
constexpr Bytes kMean = { 180, 30, 30 };

// A table of two columns, for a plot.
vtkSmartPointer<vtkTable> tableOf(const std::vector<std::pair<double, double>>& points)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  vtkNew<vtkDoubleArray> shares;
  shares->SetName("share");
  for (const auto& [value, share] : points)
  {
    values->InsertNextValue(value);
    shares->InsertNextValue(share);
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(values);
  table->AddColumn(shares);
  return table;
}

// The middle of each bin, and the percentage of the points in it.
std::vector<std::pair<double, double>> barsOf(const LocalThicknessSummary& summary)
{
  std::vector<std::pair<double, double>> bars;
  const double width = summary.end / static_cast<double>(summary.histogram.size());
  for (std::size_t bin = 0; bin < summary.histogram.size(); ++bin)
  {
    bars.emplace_back((static_cast<double>(bin) + 0.5) * width,
      100.0 * static_cast<double>(summary.histogram[bin]) / static_cast<double>(summary.points));
  }
  return bars;
}

void setText(vtkTextProperty* text)
{
  text->SetFontSize(kFontSize);
  text->BoldOff();
  text->SetColor(kInk[0] / 255.0, kInk[1] / 255.0, kInk[2] / 255.0);
}

void setUpAxis(vtkAxis* axis, const std::string& title, double max,
  const std::vector<double>& marked)
{
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(0.0, max);
  axis->SetTitle(title);
  axis->GetGridPen()->SetColor(225, 225, 225);
  vtkNew<vtkDoubleArray> ticks;
  vtkNew<vtkStringArray> labels;
  for (const double tick : marked)
  {
    ticks->InsertNextValue(tick);
    labels->InsertNextValue(roundedText(tick, kDigits));
  }
  axis->SetCustomTickPositions(ticks, labels);
  setText(axis->GetTitleProperties());
  setText(axis->GetLabelProperties());
}

void addBars(vtkChartXY* chart, const std::vector<std::pair<double, double>>& bars)
{
  vtkPlot* plot = chart->AddPlot(vtkChart::BAR);
  plot->SetInputData(tableOf(bars), 0, 1);
  plot->GetBrush()->SetColor(kBars[0], kBars[1], kBars[2]);
  plot->GetPen()->SetColor(255, 255, 255);
}

void addLine(vtkChartXY* chart, const std::vector<std::pair<double, double>>& points,
  const Bytes& colour)
{
  vtkPlot* line = chart->AddPlot(vtkChart::LINE);
  line->SetInputData(tableOf(points), 0, 1);
  line->SetColor(colour[0], colour[1], colour[2], 255);
  line->SetWidth(kLineWidth);
}

// Marks the mean by an upright line, and the deviation by one across it.
void addMarks(vtkChartXY* chart, const LocalThicknessSummary& summary, double height)
{
  const double low = std::max(summary.mean - summary.standardDeviation, 0.0);
  const double high = std::min(summary.mean + summary.standardDeviation, summary.end);
  addLine(chart, { { low, kMarkHeight * height }, { high, kMarkHeight * height } }, kDeviation);
  addLine(chart, { { summary.mean, 0.0 }, { summary.mean, height } }, kMean);
}

std::string titleOf(const LocalThicknessSummary& summary)
{
  if (summary.points == 0)
  {
    return "no grid points";
  }
  return std::to_string(summary.points) + " grid points, mean " +
    roundedText(summary.mean, kDigits) + " (red), standard deviation " +
    roundedText(summary.standardDeviation, kDigits) + " (orange), max " +
    roundedText(summary.max, kDigits);
}

vtkSmartPointer<vtkChartXY> makeChart(const std::string& name, const LocalThicknessSummary& summary)
{
  auto chart = vtkSmartPointer<vtkChartXY>::New();
  double height = 1.0;
  if (summary.points > 0)
  {
    const auto bars = barsOf(summary);
    for (const auto& [value, share] : bars)
    {
      height = std::max(height, kRoom * share);
    }
    addBars(chart, bars);
    addMarks(chart, summary, height);
  }
  const double end = summary.points > 0 ? summary.end : 1.0;
  setUpAxis(chart->GetAxis(vtkAxis::BOTTOM), name + " (world units)", end, scaleTicks(end));
  std::vector<double> shares = scaleTicks(height);
  shares.pop_back(); // the end of the axis is no share of any bin
  setUpAxis(chart->GetAxis(vtkAxis::LEFT), "share of the grid points (%)", height, shares);
  chart->SetTitle(titleOf(summary));
  setText(chart->GetTitleProperties());
  chart->SetBarWidthFraction(1.0f);
  chart->SetAutoSize(false);
  chart->SetShowLegend(false);
  return chart;
}

} // namespace

void drawHistogram(const LocalThicknessStatistics& statistics,
  const std::vector<std::string>& caption, const std::filesystem::path& file)
{
  const VtkMessages messages;
  Scene scene;
  scene.addCaption(caption);
  std::vector<vtkSmartPointer<vtkChartXY>> charts;
  for (const auto& [name, summary] : { std::pair{ "local thickness", statistics.thickness },
         std::pair{ "separation", statistics.separation } })
  {
    if (summary)
    {
      charts.push_back(makeChart(name, *summary));
    }
  }
  const auto share = static_cast<float>(1.0 - shareOfLines(caption.size()));
  const float height = share * kHeight / static_cast<float>(charts.size());
  vtkNew<vtkContextActor> actor;
  float top = share * kHeight;
  for (const vtkSmartPointer<vtkChartXY>& chart : charts)
  {
    top -= height;
    chart->SetSize(
      vtkRectf(kMargin, top + kMargin, kWidth - 3.0f * kMargin, height - 2.0f * kMargin));
    actor->GetScene()->AddItem(chart);
  }
  scene.add(actor);
  scene.write(file);
}

} // namespace medial::app
