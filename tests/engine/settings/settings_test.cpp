// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/settings/settings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace sonde {
namespace {

/// Everything that is true of each table of settings.
template <class Target>
void check_table(std::span<const Setting> settings) {
  std::set<std::string> keys;
  for (const Setting& s : settings) {
    SCOPED_TRACE(s.key);
    EXPECT_TRUE(keys.insert(s.key).second) << "given twice";
    EXPECT_LT(s.minimum, s.maximum);
    EXPECT_TRUE(allowed(s, s.fallback));
    EXPECT_GT(std::string(s.doc).size(), 10u);
    EXPECT_NE(*s.label, 0);
    if (s.logarithmic) {
      EXPECT_GT(s.minimum, 0);
    }
    EXPECT_EQ(find_setting(settings, s.key), &s);
    EXPECT_EQ(get(Target{}, s.key), s.fallback) << "differs from the struct";

    Target changed;
    for (const double value : {s.minimum, s.maximum}) {
      set(changed, s.key, value);
      EXPECT_EQ(get(changed, s.key), value);
    }
    for (const Setting& other : settings)
      if (&other != &s) {
        EXPECT_EQ(get(changed, other.key), other.fallback) << "changed " << other.key;
      }
  }
}

TEST(Settings, coupling_table_agrees_with_the_struct) {
  check_table<Coupling>(coupling_settings());
  EXPECT_EQ(coupling_settings().size(), 7u);
}

TEST(Settings, servo_table_agrees_with_the_struct) {
  check_table<ServoSettings>(servo_settings());
  EXPECT_EQ(servo_settings().size(), 9u);
}

TEST(Settings, device_tables_agree_with_the_structs) {
  check_table<DeviceSettings>(device_settings());
  check_table<AxisSetting>(axis_settings());
  EXPECT_EQ(device_axes().size(), DeviceSettings{}.axes.axes.size());
}

TEST(Settings, set_brings_the_value_into_the_range) {
  Coupling coupling;
  const Setting& k = *find_setting(coupling_settings(), "k");
  set(coupling, "k", 1e300);
  EXPECT_EQ(coupling.k, k.maximum);
  set(coupling, "k", -5);
  EXPECT_EQ(coupling.k, k.minimum);
}

TEST(Settings, set_rounds_whole_numbers) {
  ServoSettings servo;
  set(servo, "budget_steps", 2.7);
  EXPECT_EQ(servo.budget.steps, 3);
}

TEST(Settings, unknown_keys_and_numbers_that_are_not_finite_throw) {
  Coupling coupling;
  EXPECT_THROW(get(coupling, "kk"), std::invalid_argument);
  EXPECT_THROW(set(coupling, "kk", 1), std::invalid_argument);
  EXPECT_THROW(set(coupling, "k", std::nan("")), std::invalid_argument);
  EXPECT_THROW(set(coupling, "k", std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_EQ(coupling.k, Coupling{}.k);
  EXPECT_EQ(find_setting(coupling_settings(), "kk"), nullptr);
}

TEST(Settings, allowed_knows_the_range_and_whole_numbers) {
  const Setting& steps = *find_setting(servo_settings(), "budget_steps");
  EXPECT_TRUE(allowed(steps, 3));
  EXPECT_FALSE(allowed(steps, 3.5));
  EXPECT_FALSE(allowed(steps, -1));
  EXPECT_FALSE(allowed(steps, std::nan("")));
  EXPECT_NE(range_text(steps).find("whole number"), std::string::npos);
}

TEST(Settings, coupling_modes_have_names) {
  EXPECT_EQ(coupling_modes().size(), 3u);
  for (const auto mode : {Coupling::Mode::object, Coupling::Mode::classic, Coupling::Mode::damped})
    EXPECT_EQ(coupling_mode(name_of(mode)), mode);
  EXPECT_STREQ(name_of(Coupling::Mode::object), "object");
  EXPECT_FALSE(coupling_mode("objekt"));
  for (const Setting& setting : coupling_settings()) {
    std::istringstream names(setting.coupling_modes);
    for (std::string name; names >> name;) EXPECT_TRUE(coupling_mode(name)) << setting.key;
  }
  using enum Coupling::Mode;
  const auto uses = [](Coupling::Mode mode, const char* key) {
    return is_used(*find_setting(coupling_settings(), key), mode);
  };
  EXPECT_TRUE(uses(object, "k") && uses(damped, "k") && !uses(classic, "k"));
  EXPECT_TRUE(uses(classic, "b_t") && uses(damped, "b_t") && !uses(object, "b_t"));
  EXPECT_TRUE(uses(classic, "k_r") && !uses(damped, "k_r") && !uses(damped, "b_r"));
  EXPECT_TRUE(uses(object, "max_force") && uses(damped, "max_force"));
}

TEST(Settings, models_have_names) {
  for (const auto model : {Model::automatic, Model::solid, Model::surface})
    EXPECT_EQ(model_named(name_of(model)), model);
  EXPECT_STREQ(name_of(Model::automatic), "auto");
  EXPECT_FALSE(model_named("automatic"));
}

}  // namespace
}  // namespace sonde
