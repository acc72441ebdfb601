// What may have been meant by a misspelt name.
#include "program/scene_options.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

using thermoroll::nearest;

// This text is next to the middle of two doubles. By way of a long double, which rounds it to the
// middle, it is the even one of them, which is the farther.
TEST(SceneOptions, NumbersAreRoundedOnce) {
  thermoroll::SceneOptions options;
  CLI::App command;
  thermoroll::add_scene_options(command, options);
  command.parse("--friction 0.3 --traction 0.1 --heating 4.089949435078855 --peclet 1");
  EXPECT_EQ(thermoroll::read_scene(options).scene.heating, 4.089949435078855);
}

// Every word that is one letter away from a name leads to it, by any of the four mistakes, and no
// word that is further away than a fifth of its letters.
TEST(SceneOptions, NearestNameIsAnEditAway) {
  const std::vector<std::string> names{"friction", "traction", "peclet", "stick-slip-border"};
  for (const std::string& name : names)
    for (std::size_t i = 0; i < name.size(); ++i) {
      const std::string head = name.substr(0, i), tail = name.substr(i);
      EXPECT_EQ(nearest(head + tail.substr(1), names), name);
      EXPECT_EQ(nearest(head + 'x' + tail, names), name);
      EXPECT_EQ(nearest(head + 'x' + tail.substr(1), names), name);
      std::string swapped = name;
      std::swap(swapped[i], swapped[(i + 1) % name.size()]);
      if (i + 1 < name.size()) {
        EXPECT_EQ(nearest(swapped, names), name);
      }
    }
  EXPECT_EQ(nearest("peclet", names), "peclet");
  EXPECT_EQ(nearest("pecxxt", names), "");  // two of six
  EXPECT_EQ(nearest("stock-slop-bordar", names), "stick-slip-border");
  EXPECT_EQ(nearest("stock-slop-bardar", names), "");  // four of seventeen
  EXPECT_EQ(nearest(std::string(100000, 'x'), names), "");
  EXPECT_EQ(nearest("", names), "");
}

// The nearer name counts, the first of two that are as near, and no name of a word of two letters.
TEST(SceneOptions, NearestNameIsTheNearer) {
  EXPECT_EQ(nearest("speed-b", {"speed-ax", "speed-a", "speed-c"}), "speed-a");
  EXPECT_EQ(nearest("heating-two", {"heating-ty", "heating-too"}), "heating-too");
  EXPECT_EQ(nearest("xt", {"at"}), "");
  EXPECT_EQ(nearest("too", {"to"}), "to");
}
