// SPDX-License-Identifier: MIT
#include "render/scene/description/meter.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Meter, NamesReadBack) {
  ASSERT_EQ(meter_names().size(), static_cast<std::size_t>(kMeterCount));
  for (int i = 0; i < kMeterCount; ++i) {
    const auto meter = static_cast<Meter>(i);
    EXPECT_EQ(meter_from(name_of(meter)), meter);
    EXPECT_EQ(meter_names()[static_cast<std::size_t>(i)], name_of(meter));
  }
  EXPECT_FALSE(meter_from("speed"));
  EXPECT_FALSE(meter_from(""));
}

}  // namespace
}  // namespace polhode
