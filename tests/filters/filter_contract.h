#pragma once

#include "filter_support.h"

#include <gtest/gtest.h>

#include <vtkMedialAxis.h>
#include <vtkMeshDistanceField.h>

// The filters over a grid, for tests that apply to both.
namespace medial::test
{

template <typename Filter>
class FilterContract : public testing::Test
{
protected:
  static vtkSmartPointer<Filter> make(vtkPolyData* mesh)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputData(mesh);
    filter->SetResolution(14);
    return filter;
  }

  /// After `spoil` the error message contains `words`; after `repair` the filter works again.
  static void expectError(const std::function<void(Filter*)>& spoil,
    const std::function<void(Filter*)>& repair, const std::string& words)
  {
    auto filter = make(boxPolyData());
    expectErrorAndRecovery(
      filter, [&] { spoil(filter); }, [&] { repair(filter); }, words);
    EXPECT_EQ(textFigure(filter->GetOutput(), "Engine"), "Processor") << words;
  }

  static void expectBadMesh(const std::function<void(vtkPolyData*)>& spoil,
    const std::string& words)
  {
    expectError([&](Filter* filter) { filter->SetInputData(spoiledBox(spoil)); },
      [](Filter* filter) {
        filter->SetInputData(boxPolyData({ 1.0, 1.0, 1.0 }));
      },
      words);
  }
};

using GridFilters = testing::Types<vtkMeshDistanceField, vtkMedialAxis>;

} // namespace medial::test
