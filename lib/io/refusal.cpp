#include "io/refusal.h"

#include "medial/error.h"

namespace medial
{

void refuse(const std::string& why)
{
  throw Error(ErrorCode::InvalidInput, why);
}

void refuseLine(int line, const std::string& why)
{
  refuse(line > 0 ? "line " + std::to_string(line) + ": " + why : why);
}

} // namespace medial
