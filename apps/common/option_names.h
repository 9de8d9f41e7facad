#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/thickness.h"

#include <map>
#include <string>

namespace medial::app
{

/// The words that an option takes, with their values.
template <typename T>
using Names = std::map<std::string, T>;

///@{
/// The words that an option accepts, with the values that they stand for.
const Names<Side>& sideNames();
const Names<Representation>& representationNames();
const Names<Topology>& topologyNames();
const Names<SignMethod>& signNames();
const Names<Engine>& engineNames();
const Names<ThicknessMethod>& thicknessMethodNames();
///@}

///@{
/// The word for a value.
std::string nameOf(Side side);
std::string nameOf(Representation representation);
std::string nameOf(SignMethod method);
std::string nameOf(Engine engine);
std::string nameOf(Topology topology);
std::string nameOf(ThicknessMethod method);
///@}

} // namespace medial::app
