// SPDX-License-Identifier: MIT
#include "app/session/saved/typed_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <tuple>

namespace polhode {
namespace {

using ::testing::HasSubstr;

/// The environment as it was, afterwards; null: without the variable.
class Setting {
 public:
  Setting(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    set(value);
  }
  ~Setting() { set(before_ ? before_->c_str() : nullptr); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  void set(const char* value) const { value ? setenv(name_, value, 1) : unsetenv(name_); }
  const char* name_;
  std::optional<std::string> before_;
};

TEST(TypedFolder, BeginsAtHome) {
  const Setting home("HOME", "/home/emmy");
  EXPECT_EQ(typed_folder("~").value(), "/home/emmy");
  EXPECT_EQ(typed_folder("~/talks/euler").value(), "/home/emmy/talks/euler");
  EXPECT_EQ(typed_folder("~/").value(), "/home/emmy/");
  for (const char* typed : {"$HOME/talks", "${HOME}/talks", "~//talks"})
    EXPECT_EQ(typed_folder(typed).value(), "/home/emmy/talks") << typed;
  EXPECT_EQ(typed_folder("$HOME").value(), "/home/emmy");
}

TEST(TypedFolder, TakesWhatTheEnvironmentHas) {
  const Setting talks("POLHODE_TALKS", "/srv/talks");
  EXPECT_EQ(typed_folder("$POLHODE_TALKS/euler").value(), "/srv/talks/euler");
  EXPECT_EQ(typed_folder("${POLHODE_TALKS}").value(), "/srv/talks");
}

TEST(TypedFolder, ANameEndsWhereItEndsInAShell) {
  const Setting talks("POLHODE_TALKS", "/srv/talks");
  EXPECT_EQ(typed_folder("$POLHODE_TALKS.d/x").value(), "/srv/talks.d/x");
  EXPECT_EQ(typed_folder("$POLHODE_TALKS-2025").value(), "/srv/talks-2025");
  EXPECT_EQ(typed_folder("${POLHODE_TALKS}2/x").value(), "/srv/talks2/x");
  for (const char* typed : {"$7/a", "${7}/a", "${POLHODE_TALKS/a", "${POLHODE-TALKS}/a", "$\xc3\xa9/a"})
    EXPECT_EQ(typed_folder(typed).value(), typed) << "no name of a variable";
}

TEST(TypedFolder, KnowsTheHomesOfUsers) {
  const passwd* user = getpwuid(getuid());
  if (!user) GTEST_SKIP() << "the system does not know who runs this";
  const std::string name = user->pw_name, home = user->pw_dir;
  EXPECT_EQ(typed_folder("~" + name).value(), home);
  EXPECT_EQ(typed_folder("~" + name + "/talks").value(), std::filesystem::path(home) / "talks");
  const Setting none("HOME", nullptr);
  EXPECT_EQ(typed_folder("~/talks").value(), std::filesystem::path(home) / "talks");
}

TEST(TypedFolder, IsOtherwiseWhatIsWritten) {
  const Setting home("HOME", "/home/emmy");
  for (const char* typed : {"/tmp/a", "talks", ".", "./~", "./~/talks", "a/~/b", "a/$HOME", "talks~",
                            "./$HOME", "$", "$/a", "${}", "$-x", "cost$5"})
    EXPECT_EQ(typed_folder(typed).value(), typed) << typed;
  EXPECT_EQ(typed_folder("").value(), ".");
}

TEST(TypedFolder, RefusesWhatNobodyKnows) {
  const Setting none("POLHODE_NOTHING", nullptr), empty("POLHODE_EMPTY", "");
  for (const auto& [typed, what, instead] :
       {std::tuple("~nobody-of-this-name/a", "no user called nobody-of-this-name", "./~nobody-of-this-name"),
        std::tuple("$POLHODE_NOTHING/a", "POLHODE_NOTHING is not set", "./$POLHODE_NOTHING"),
        std::tuple("$POLHODE_NOTHING.d/a", "POLHODE_NOTHING is not set", "./$POLHODE_NOTHING.d"),
        std::tuple("${POLHODE_EMPTY}/a", "POLHODE_EMPTY is not set", "./${POLHODE_EMPTY}")}) {
    const auto folder = typed_folder(typed);
    ASSERT_FALSE(folder) << typed;
    EXPECT_THAT(folder.error(), HasSubstr(what));
    EXPECT_THAT(folder.error(), HasSubstr(instead));
  }
}

}  // namespace
}  // namespace polhode
