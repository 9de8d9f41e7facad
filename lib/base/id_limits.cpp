#include "base/id_limits.h"

#include "medial/error.h"

namespace medial
{

void requireCount(const std::string& subject, std::int64_t count, const std::string& elements,
  std::int64_t max)
{
  if (count > max)
  {
    throw Error(ErrorCode::InvalidInput,
      subject + " has " + std::to_string(count) + " " + elements + ", more than " +
        std::to_string(max));
  }
}

} // namespace medial
